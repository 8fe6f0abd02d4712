// All configurations of a block of groups whose final polynomial has more than two roots; doubtful
// groups are reported.
#pragma once

#include <array>
#include <assur/assemblies.hpp>
#include <assur/detail/assembly_order.hpp>
#include <assur/detail/batch/pack_arcs.hpp>
#include <assur/detail/batch/pack_columns.hpp>
#include <assur/detail/batch/pack_roots.hpp>
#include <assur/detail/batch/pack_verdicts.hpp>
#include <assur/detail/batch/scaled_block.hpp>
#include <assur/detail/completion.hpp>
#include <assur/detail/polish.hpp>
#include <assur/detail/products.hpp>
#include <assur/detail/small_step.hpp>
#include <assur/support/displaced_frame.hpp>
#include <assur/support/scale.hpp>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>

namespace assur::detail::batch {

/// The search in general position for up to `capacity` groups, as `GeneralSearch` for one: a list
/// is certain if every root of the final polynomial is certainly simple and completes to a regular
/// configuration that closes.
template <typename Model, std::size_t Lanes>
class GeneralBlock {
  static constexpr std::size_t N = Model::polynomial_degree;
  static constexpr std::size_t most_roots = size(Model::max_configurations);
  using Pack = numeric::PackOf<double, Lanes>;
  using Truth = decltype(Pack() < Pack());
  template <typename Scalar>
  using Dimensions = typename Model::template Dimensions<Scalar>;
  template <typename Scalar>
  using Inputs = typename Model::template Inputs<Scalar>;
  template <typename Scalar>
  using Configuration = typename Model::template Configuration<Scalar>;
  using Places = std::array<std::size_t, Lanes>;

 public:
  static constexpr std::size_t capacity = 32;
  static_assert(capacity % Lanes == 0, "a block holds a whole number of packs");

  /// Searches the `count` groups from `first` on; `count` is a multiple of `Lanes`.
  void solve(const Columns<const Dimensions<double>>& dimensions,
             const Columns<const Inputs<double>>& inputs, std::size_t first, std::size_t count) {
    begin();
    for (std::size_t group = 0; group < count; group += Lanes) {
      add(load_groups<Dimensions<Pack>>(dimensions, first + group),
          load_groups<Inputs<Pack>>(inputs, first + group), {}, group);
    }
    search(count);
  }

  /// The same pack by pack: `begin`, then `add` for the indices 0, `Lanes`, ..., then `search` for
  /// all groups added. `displaced` bounds the displacement of the inputs by rounding.
  void begin() {
    arcs_.clear();
    groups_.clear();
  }
  void add(const Dimensions<Pack>& dimensions, const Inputs<Pack>& inputs,
           const support::DisplacementOf<Pack>& displaced, std::size_t group) {
    const unsigned usable = groups_.add(dimensions, inputs, displaced, group);
    for (std::size_t lane = 0; lane < Lanes; ++lane) {
      settled_[group + lane] = (usable >> lane & 1) != 0;
      counts_[group + lane] = 0;
    }
  }
  void search(std::size_t count) {
    const double error = groups_.error();
    for (std::size_t group = 0; group < count; group += Lanes) {
      add_arcs(group, Pack(error));
    }
    arcs_.isolate([this](std::size_t group) { settled_[group] = false; });
    for (std::size_t root = 0; root < arcs_.brackets().count; root += overlapped * Lanes) {
      find_roots(root, std::make_index_sequence<overlapped>());
    }
    for (std::size_t root = 0; root < arcs_.brackets().count; root += Lanes) {
      complete_roots(root);
    }
  }

  /// Whether the list of a group is complete.
  [[nodiscard]] bool is_settled(std::size_t group) const { return settled_[group]; }
  [[nodiscard]] std::size_t count(std::size_t group) const { return counts_[group]; }

  /// Sorts the configurations of a settled group. False if their order is not certain.
  [[nodiscard]] bool put_in_order(std::size_t group) {
    if constexpr (comes_in_any_order<Model>) {
      return are_apart(group);
    }
    const std::size_t count = counts_[group];
    const std::array<std::size_t, most_roots> list = lists_[group];
    std::array<double, most_roots> keys;
    std::array<std::size_t, most_roots> ranks{};
    bool apart = true;
    for (std::size_t one = 0; one < count; ++one) {
      keys[one] = keys_[list[one]];
      for (std::size_t other = 0; other < one; ++other) {
        const bool is_after = keys[other] < keys[one];
        ranks[one] += is_after ? 1 : 0;
        ranks[other] += is_after ? 0 : 1;
        apart &= numeric::are_apart(keys[one], keys[other]);
      }
    }
    for (std::size_t place = 0; place < count; ++place) {
      lists_[group][ranks[place]] = list[place];
    }
    return apart;
  }
  /// One configuration of each group of a pack, loaded number by number. A group that has no
  /// configuration of that index is given an arbitrary one.
  [[nodiscard]] Configuration<Pack> configuration(std::size_t group, std::size_t index) const {
    Places roots;
    for (std::size_t lane = 0; lane < Lanes; ++lane) {
      roots[lane] = index < counts_[group + lane] ? lists_[group + lane][index] : 0;
    }
    const Pack units = groups_.units(group);
    constexpr auto lengths = SortsOf<Configuration<double>>::lengths;
    Configuration<Pack> q;
    for_each_number(q, [&](Pack& number, std::size_t place) {
      number = Pack::gather(roots_[place].data(), roots);
      number = lengths[place] ? number * units : number;
    });
    return q;
  }
  /// Writes one configuration of a group, in the unit of its inputs, to the columns of a batch.
  void put(std::size_t group, std::size_t index, const Columns<Configuration<double>>& to,
           std::size_t at) const {
    constexpr auto lengths = SortsOf<Configuration<double>>::lengths;
    const std::size_t root = lists_[group][index];
    for (std::size_t place = 0; place < lengths.size(); ++place) {
      to.data[place * to.stride + at] =
          roots_[place][root] * (lengths[place] ? groups_.unit(group) : 1.0);
    }
  }

 private:
  /// Whether the first unknowns of all configurations of a group differ by more than 1e-7, the
  /// error to which a root is known.
  [[nodiscard]] bool are_apart(std::size_t group) const {
    constexpr std::size_t place = number_of_first_unknown();
    bool apart = true;
    for (std::size_t one = 1; one < counts_[group]; ++one) {
      for (std::size_t other = 0; other < one; ++other) {
        const std::size_t left = lists_[group][one];
        const std::size_t right = lists_[group][other];
        apart &= std::abs(roots_[place][left] - roots_[place][right]) > 1e-7 ||
                 std::abs(roots_[place + 1][left] - roots_[place + 1][right]) > 1e-7;
      }
    }
    return apart;
  }
  [[nodiscard]] static constexpr std::size_t number_of_first_unknown() {
    constexpr auto angles = SortsOf<Configuration<double>>::angles;
    std::size_t place = 0;
    for (std::size_t unknown = 0; unknown < size(Model::first_unknown); ++unknown) {
      place += angles[unknown] ? 2 : 1;
    }
    return place;
  }

  /// Adds the arcs of the final polynomials of a pack of groups, whose coefficients have this
  /// error.
  void add_arcs(std::size_t group, const Pack& error) {
    TrigonometricPolynomial<Pack, N> T;
    Model::position_polynomial(groups_.dimensions(group), groups_.inputs(group), T);
    numeric::Harmonics<Pack, N> harmonics;
    Pack sum(0);
    for (std::size_t k = 0; k <= N; ++k) {
      harmonics[k].cosine = T.cosine[k];
      harmonics[k].sine = k == 0 ? Pack(0) : T.sine[k];
      sum = sum + abs(harmonics[k].cosine) + abs(harmonics[k].sine);
    }
    // This is the bound of `numeric::transform_error`, far from overflow and underflow.
    constexpr double u = std::numeric_limits<double>::epsilon() / 2;
    const Truth usable = (sum < Pack(0x1p200)) & (Pack(0x1p-200) < sum);
    const unsigned certain =
        arcs_.add(harmonics,
                  select(usable, error * Pack(1 + 1.4143 * N) + Pack(12 * u) * sum,
                         Pack(std::numeric_limits<double>::infinity())),
                  group);
    (Pack(u) * sum).store(&noise_[group]);
    for (std::size_t lane = 0; lane < Lanes; ++lane) {
      settled_[group + lane] = settled_[group + lane] && (certain >> lane & 1) != 0;
    }
  }
  /// Finds the roots in the brackets of several packs together: each step depends on the previous
  /// one, but the processor can overlap the steps of different packs.
  template <std::size_t... Number>
  void find_roots(std::size_t first, std::index_sequence<Number...>) {
    std::array<PackBracket<Pack, 2 * N + 1>, sizeof...(Number)> brackets = {
        bracket(first + Number * Lanes)...};
    constexpr int most_steps = 24;
    for (int step = 0; step < most_steps && (brackets[Number].is_open() || ...); ++step) {
      (brackets[Number].improve(step), ...);
    }
    (put_roots(brackets[Number], first + Number * Lanes), ...);
  }
  [[nodiscard]] PackBracket<Pack, 2 * N + 1> bracket(std::size_t first) const {
    const auto& brackets = arcs_.brackets();
    std::array<Pack, 2 * N + 1> bernstein;
    for (std::size_t i = 0; i <= 2 * N; ++i) {
      bernstein[i] = Pack::load(&brackets.bernstein[i][first]);
    }
    const Pack noise = Pack::gather(noise_.data(), groups_of(first));
    const Pack places = Pack::counted(static_cast<double>(first));
    return {bernstein, noise, places < Pack(static_cast<double>(brackets.count))};
  }
  /// The groups to which the brackets of a pack belong; beyond the last bracket, arbitrary groups.
  [[nodiscard]] Places groups_of(std::size_t first) const {
    Places groups;
    for (std::size_t lane = 0; lane < Lanes; ++lane) {
      groups[lane] = static_cast<std::size_t>(arcs_.brackets().owner[first + lane]) / 4;
    }
    return groups;
  }
  void put_roots(const PackBracket<Pack, 2 * N + 1>& bracket, std::size_t first) {
    const Pack left = Pack::load(&arcs_.brackets().left[first]);
    const Pack right = Pack::load(&arcs_.brackets().right[first]);
    const Pack t = (left + right) * Pack(0.5) + (right - left) * Pack(0.5) * bracket.roots();
    // A root that was not found within the allowed steps cannot be completed.
    select(bracket.open(), Pack(std::numeric_limits<double>::quiet_NaN()), t).store(&found_[first]);
  }

  /// Completes several roots to configurations.
  [[gnu::flatten]] void complete_roots(std::size_t first) {
    const auto& brackets = arcs_.brackets();
    const std::size_t count = (std::min)(Lanes, brackets.count - first);
    const Places groups = groups_of(first);
    Places charts;
    for (std::size_t lane = 0; lane < Lanes; ++lane) {
      charts[lane] = static_cast<std::size_t>(brackets.owner[first + lane]) % 4;
    }
    static constexpr std::array<double, 5> cosine = {1, 0, -1, 0, 1};
    const Direction<Pack> centre{Pack::gather(cosine.data(), charts),
                                 -Pack::gather(cosine.data() + 1, charts)};
    const auto d = groups_.dimensions(groups);
    const auto u = groups_.inputs(groups);
    Configuration<Pack> q;
    first_of<Model>(q) = direction_on_chart(Pack::load(&found_[first]), centre);
    const Truth complete = complete_simple<Model, Pack>(d, u, q);
    const unsigned kept =
        (complete & settles(d, u, groups_.longest(groups), groups_.unsure(groups), q)).bits();
    for_each_number(
        q, [&](const Pack& number, std::size_t place) { number.store(&roots_[place][first]); });
    if constexpr (!comes_in_any_order<Model>) {
      key_at<Model, 0, Pack>(d, u, q).store(&keys_[first]);
    }
    for (std::size_t lane = 0; lane < count; ++lane) {
      const std::size_t group = groups[lane];
      if ((kept >> lane & 1) == 0 || counts_[group] == most_roots) {
        settled_[group] = false;
      } else {
        lists_[group][counts_[group]++] = first + lane;
      }
    }
  }

  /// The lanes whose configurations close and are regular after one step of `polish`. Three roots
  /// in five need the step, so nearly every pack does.
  [[nodiscard]] static Truth settles(const Dimensions<Pack>& d, const Inputs<Pack>& u,
                                     const Pack& longest, const Pack& unsure,
                                     Configuration<Pack>& q) {
    constexpr int size = Model::unknown_count;
    Vector<Pack, size> f;
    Model::residual(d, u, q, f);
    const Pack miss = largest_of(f);
    Matrix<Pack, size, size> inverse;
    Model::inverse_jacobian(d, u, q, inverse);
    Configuration<Pack> next = q;
    nudge<Model, Pack>(next, product(inverse, Vector<Pack, size>(-f)));
    Model::residual(d, u, next, f);
    const Pack next_miss = largest_of(f);
    exchange_where(next_miss < miss, q, next);
    const Pack left = select(next_miss < miss, next_miss, miss);
    const Pack length = longest_lengths(q);
    return (left <= Pack(polished_rounding(1.0)) * max EIGEN_NOT_A_MACRO(length, longest)) &
           (length < Pack(farthest_configuration<double>)) &
           are_surely_regular<Model>(d, u, q, unsure);
  }
  template <int Size>
  [[nodiscard]] static Pack largest_of(const Vector<Pack, Size>& f) {
    Pack largest(0);
    for (int index = 0; index < Size; ++index) {
      largest = max EIGEN_NOT_A_MACRO(largest, abs(f(index)));
    }
    return largest;
  }

  ScaledBlock<Model, Lanes, capacity> groups_;
  ArcSearch<N, Lanes, capacity> arcs_;
  std::array<double, capacity> noise_;
  std::array<bool, capacity> settled_;
  std::array<std::size_t, capacity> counts_;
  std::array<std::array<std::size_t, most_roots>, capacity> lists_;
  static constexpr std::size_t overlapped = ArcSearch<N, Lanes, capacity>::List::most_packs;
  static constexpr std::size_t room = 2 * N * capacity + overlapped * Lanes;
  std::array<std::array<double, room>, Columns<Configuration<double>>::count> roots_;
  std::array<double, room> found_, keys_;
};

}  // namespace assur::detail::batch
