// The order of a group's configurations, invariant under rigid motion, reflection and change of
// units.
#pragma once

#include <array>
#include <assur/assemblies.hpp>
#include <assur/detail/closed_form.hpp>
#include <assur/detail/index.hpp>
#include <assur/detail/members.hpp>
#include <assur/detail/numbers.hpp>
#include <assur/model.hpp>
#include <assur/numeric/order.hpp>
#include <assur/numeric/pair.hpp>
#include <assur/support/scale.hpp>
#include <assur/variables.hpp>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace assur::detail {

/// Whether a model's configurations may come in any order, because the caller sorts them, as
/// solvers of whole mechanisms do.
template <typename Model, typename = void>
inline constexpr bool comes_in_any_order = false;
template <typename Model>
inline constexpr bool comes_in_any_order<Model, std::void_t<decltype(Model::in_any_order)>> =
    Model::in_any_order;

/// One of the two groups or configurations whose variables are stored as pairs of numbers.
template <typename To, typename From>
[[nodiscard]] To lane_of(const From& from, std::size_t index) {
  To result;
  for_each_pair(result, from, [index](auto& target, const auto& source) {
    target = numeric::lane(source, index);
  });
  return result;
}

/// Joins the first `count` numbers of two lists of variables, entry by entry, into pairs.
template <typename Scalar>
void pair_numbers(const void* one, const void* other, std::size_t count, void* pairs) {
  for (std::size_t place = 0; place < count; ++place) {
    put_number(
        pairs, place,
        numeric::PairOf<Scalar>(number_at<Scalar>(one, place), number_at<Scalar>(other, place)));
  }
}

template <typename Model, typename Scalar>
[[nodiscard]] typename Model::template Configuration<numeric::PairOf<Scalar>> pair_of(
    const typename Model::template Configuration<Scalar>& first,
    const typename Model::template Configuration<Scalar>& second) {
  typename Model::template Configuration<numeric::PairOf<Scalar>> result;
  pair_numbers<Scalar>(&first, &second,
                       SortsOf<typename Model::template Configuration<Scalar>>::count, &result);
  return result;
}

/// The cosine and sine of the angle from one direction to another.
template <typename Scalar>
[[nodiscard]] Scalar cosine_between(const Direction<Scalar>& one, const Direction<Scalar>& other) {
  return one.cos * other.cos + one.sin * other.sin;
}
template <typename Scalar>
[[nodiscard]] Scalar sine_between(const Direction<Scalar>& one, const Direction<Scalar>& other) {
  return one.cos * other.sin - one.sin * other.cos;
}

/// Calls `use` with every sort key of a configuration, its index from 0, and whether it is a
/// length: first the cosines, then the sines, of the angles between each two links; then the
/// lengths among the unknowns. The cosines are invariant under rigid motion and reflection.
template <typename Both, std::size_t Links, typename Use>
void for_each_key_of(const std::array<Pose<Both>, Links>& links, Use& use, int& place) {
  using Link = Pose<Both>;
  const auto use_links = [&](auto key_of) {
    visit(links, [&](const Link& one, std::size_t first) {
      visit(links, [&](const Link& other, std::size_t second) {
        if (first < second) {
          use(key_of(one.direction, other.direction), place++, false);
        }
      });
    });
  };
  use_links(cosine_between<Both>);
  use_links(sine_between<Both>);
}
template <typename Model, typename Both, typename Use>
void for_each_key(const typename Model::template Dimensions<Both>& d,
                  const typename Model::template Inputs<Both>& u,
                  const typename Model::template Configuration<Both>& q, Use use) {
  Poses<Both, Model::link_count> links;
  Model::link_poses(d, u, q, links);
  int place = 0;
  for_each_key_of(links, use, place);
  for_each_member(q, [&](const auto& member, std::size_t) {
    if constexpr (std::is_same_v<std::decay_t<decltype(member)>, Both>) {
      use(member, place++, true);
    }
  });
}

/// The source of a key: two links, or an unknown that is a length.
struct KeySource {
  std::size_t first, second;
};
template <typename Model>
[[nodiscard]] constexpr KeySource key_source(int place) {
  constexpr int pairs = Model::link_count * (Model::link_count - 1) / 2;
  if (place >= 2 * pairs) {
    int unknown = -1;
    for (int length = 2 * pairs; length <= place; ++length) {
      do {
        ++unknown;
      } while (is_angle<Model>(unknown));
    }
    return {size(unknown), 0};
  }
  int first = 0;
  int second = 1 + place % pairs;
  for (; second >= Model::link_count; ++first) {
    second -= Model::link_count - first - 2;
  }
  return {size(first), size(second)};
}

/// The key at one index alone.
template <typename Model, int Place, typename Both>
[[nodiscard]] Both key_at(const typename Model::template Dimensions<Both>& d,
                          const typename Model::template Inputs<Both>& u,
                          const typename Model::template Configuration<Both>& q) {
  constexpr int pairs = Model::link_count * (Model::link_count - 1) / 2;
  constexpr KeySource source = key_source<Model>(Place);
  if constexpr (Place >= 2 * pairs) {
    return std::get<source.first>(q.members());
  } else {
    Poses<Both, Model::link_count> links;
    Model::link_poses(d, u, q, links);
    const auto& one = links[source.first].direction;
    const auto& other = links[source.second].direction;
    return Place < pairs ? cosine_between(one, other) : sine_between(one, other);
  }
}

/// Whether the first of two configurations comes before the second, by all keys.
template <typename Model, typename Scalar>
[[nodiscard, gnu::noinline, gnu::cold]] bool comes_before_by_keys(
    const typename Model::template Dimensions<numeric::PairOf<Scalar>>& d,
    const typename Model::template Inputs<numeric::PairOf<Scalar>>& u,
    const typename Model::template Configuration<numeric::PairOf<Scalar>>& q, Scalar square) {
  constexpr std::size_t turning = size(Model::link_count) * size(Model::link_count - 1);
  std::array<Scalar, turning + size(Model::unknown_count)> first{};
  std::array<Scalar, turning + size(Model::unknown_count)> second{};
  for_each_key<Model, numeric::PairOf<Scalar>>(
      d, u, q, [&](const numeric::PairOf<Scalar>& key, int place, bool /*is_length*/) {
        entry(first, place) = key[0];
        entry(second, place) = key[1];
      });
  return numeric::comes_before(first, second, turning, std::sqrt(square));
}

/// Whether the first of two configurations comes before the second. `square` is the square of the
/// unit of lengths. If the formula certifies the roots, one key distinguishes them, however close
/// they are.
template <typename Model, typename Scalar>
[[nodiscard]] bool comes_before(
    const typename Model::template Dimensions<numeric::PairOf<Scalar>>& d,
    const typename Model::template Inputs<numeric::PairOf<Scalar>>& u,
    const typename Model::template Configuration<numeric::PairOf<Scalar>>& q, Scalar square) {
  if constexpr (vouches_for_roots<Model, Scalar>) {
    const numeric::PairOf<Scalar> key =
        key_at<Model, Model::first_key, numeric::PairOf<Scalar>>(d, u, q);
    return key[0] < key[1];
  } else {
    if constexpr (Model::link_count > 1) {
      const numeric::PairOf<Scalar> key = key_at<Model, 0, numeric::PairOf<Scalar>>(d, u, q);
      if (numeric::are_apart(key[0], key[1])) {
        return key[0] < key[1];
      }
    }
    return comes_before_by_keys<Model, Scalar>(d, u, q, square);
  }
}

/// Sorts a model's configurations.
template <typename Model, typename Scalar>
void put_in_order(const typename Model::template Dimensions<Scalar>& dimensions,
                  const typename Model::template Inputs<Scalar>& inputs,
                  Assemblies<Model, Scalar>& result) {
  using Pair = numeric::PairOf<Scalar>;
  const auto d = support::scaled_to<typename Model::template Dimensions<Pair>>(dimensions, 1);
  const auto u = support::scaled_to<typename Model::template Inputs<Pair>>(inputs, 1);
  numeric::insertion_sort(
      size(result.count),
      [&](std::size_t one, std::size_t other) {
        return comes_before<Model, Scalar>(
            d, u, pair_of<Model, Scalar>(result.configurations[one], result.configurations[other]),
            1);
      },
      [&result](std::size_t one, std::size_t other) {
        std::swap(result.configurations[one], result.configurations[other]);
        std::swap(result.regularity[one], result.regularity[other]);
      });
}

/// Sorts the configurations of a group whose lengths are near one, and multiplies their lengths by
/// `unit`.
template <typename Model, typename Scalar>
void list_in(const typename Model::template Dimensions<Scalar>& d,
             const typename Model::template Inputs<Scalar>& u, Scalar unit,
             Assemblies<Model, Scalar>& result) {
  if constexpr (!comes_in_any_order<Model> && Model::max_configurations > 1) {
    put_in_order<Model, Scalar>(d, u, result);
  }
  for (int index = 0; index < result.count; ++index) {
    auto& q = entry(result.configurations, index);
    q = support::scaled_to<std::decay_t<decltype(q)>>(q, unit);
  }
}

}  // namespace assur::detail
