// Turns configurations into a list whose order rigid motion, reflection and change of units keep.
#pragma once

#include <array>
#include <assur/assemblies.hpp>
#include <assur/detail/index.hpp>
#include <assur/model.hpp>
#include <assur/numeric/order.hpp>
#include <assur/support/scale.hpp>
#include <assur/variables.hpp>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace assur::detail {

/// Whether whoever asks for a model's configurations puts them in an order of his own, as solvers of
/// whole mechanisms do.
template <typename Model, typename = void>
inline constexpr bool comes_in_any_order = false;
template <typename Model>
inline constexpr bool comes_in_any_order<Model, std::void_t<decltype(Model::in_any_order)>> =
    Model::in_any_order;

/// Cosines, then sines, of the angles between each two links; then the lengths among the unknowns.
/// The cosines do not change under rigid motion and reflection.
template <typename Model>
class AssemblyOrder {
  static constexpr std::size_t pairs =
      detail::size(Model::link_count * (Model::link_count - 1) / 2);
  static constexpr std::size_t size = 2 * pairs + detail::size(Model::unknown_count);

 public:
  using Key = std::array<double, size>;

  [[nodiscard]] static Key key(const typename Model::template Dimensions<double>& d,
                               const typename Model::template Inputs<double>& u,
                               const typename Model::template Configuration<double>& q) {
    Poses<double, Model::link_count> poses;
    Model::link_poses(d, u, q, poses);
    Key result{};
    std::size_t place = 0;
    for (std::size_t one = 0; one < poses.size(); ++one) {
      for (std::size_t other = one + 1; other < poses.size(); ++other) {
        const Direction<double> between =
            turned(poses[other].direction, reversed(poses[one].direction));
        result[place] = between.cos;
        result[pairs + place] = between.sin;
        ++place;
      }
    }
    place = 2 * pairs;
    for_each_member(q, [&](const auto& member, std::size_t) {
      if constexpr (std::is_same_v<std::decay_t<decltype(member)>, double>) {
        result[place++] = member;
      }
    });
    return result;
  }
};

/// Puts a model's configurations in the order of their keys.
template <typename Model>
void put_in_order(const typename Model::template Dimensions<double>& d,
                  const typename Model::template Inputs<double>& u, Assemblies<Model>& result) {
  using Order = AssemblyOrder<Model>;
  std::array<typename Order::Key, Assemblies<Model>::capacity> keys;
  const std::size_t count = size(result.count);
  for (std::size_t index = 0; index < count; ++index) {
    keys[index] = Order::key(d, u, result.configurations[index]);
  }
  numeric::insertion_sort(
      count,
      [&keys](std::size_t one, std::size_t other) {
        return numeric::comes_before(keys[one], keys[other]);
      },
      [&keys, &result](std::size_t one, std::size_t other) {
        std::swap(keys[one], keys[other]);
        std::swap(result.configurations[one], result.configurations[other]);
        std::swap(result.regularity[one], result.regularity[other]);
      });
}

/// Puts the configurations of a group whose lengths are near one in order, and gives them in the
/// unit of which these lengths are multiples.
template <typename Model>
void list_in(const typename Model::template Dimensions<double>& d,
             const typename Model::template Inputs<double>& u, double unit,
             Assemblies<Model>& result) {
  if constexpr (comes_in_any_order<Model>) {
    // Their keys need frames of all links, which such a model does not have.
  } else if (result.count == 2) {
    if (numeric::comes_before(AssemblyOrder<Model>::key(d, u, result.configurations[1]),
                              AssemblyOrder<Model>::key(d, u, result.configurations[0]))) {
      std::swap(result.configurations[0], result.configurations[1]);
      std::swap(result.regularity[0], result.regularity[1]);
    }
  } else if (result.count > 2) {
    put_in_order<Model>(d, u, result);
  }
  for (int index = 0; index < result.count; ++index) {
    auto& q = entry(result.configurations, index);
    q = support::scaled_to<std::decay_t<decltype(q)>>(q, unit);
  }
}

}  // namespace assur::detail
