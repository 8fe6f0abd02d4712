// Isolation of the roots of several trigonometric polynomials at once: arcs of the circle that hold
// one root each.
//
// The method and its bounds are those of `numeric::TrigonometricRootSearch` for one polynomial:
// four charts in Bernstein form, Descartes' rule, and arcs that are cut in the middle. The arcs of
// all polynomials of a block are cut together, level by level, so that packs stay full however
// different the polynomials are. A polynomial with an uncertain sign is left to the search for one
// polynomial.
#pragma once

#include <algorithm>
#include <array>
#include <assur/numeric/pack.hpp>
#include <assur/numeric/trigonometric_charts.hpp>
#include <cstddef>
#include <limits>

namespace assur::detail::batch {

/// Computes the Bernstein coefficients on one of four charts from `numeric::ChartTables`. In
/// reverse order, the cosine terms are the same and the sine terms have the opposite sign.
template <std::size_t Chart, std::size_t N, typename Pack>
[[gnu::always_inline]] inline void put_bernstein(const numeric::Harmonics<Pack, N>& harmonics,
                                                 std::array<Pack, 2 * N + 1>& bernstein) {
  constexpr const auto& table = numeric::chart_tables<double, N>.bernstein;
  for (std::size_t i = 0; i <= N; ++i) {
    Pack even = harmonics[0].cosine * Pack(table.cosine[0][i]);
    Pack odd(0);
    for (std::size_t k = 1; k <= N; ++k) {
      // This is the harmonic as seen from the turned chart: see `Harmonic::less_quarters`.
      const bool is_across = k * Chart % 2 == 1;
      const double sign = k * Chart % 4 == 1 || k * Chart % 4 == 0 ? 1 : -1;
      const double sign_across = k * Chart % 4 == 1 || k * Chart % 4 == 2 ? -1 : 1;
      const auto& [cosine, sine] = harmonics[k];
      even += (is_across ? sine : cosine) * Pack(sign * table.cosine[k][i]);
      odd += (is_across ? cosine : sine) * Pack(sign_across * table.sine[k][i]);
    }
    bernstein[i] = even + odd;
    bernstein[2 * N - i] = even - odd;
  }
}

/// Sets of arcs, a bit each: those with one sign variation of their coefficients, and those with
/// more.
struct Variations {
  unsigned one = 0;
  unsigned more = 0;
  unsigned certain = 0;  ///< arcs in which every sign is certain
};
template <typename Pack, std::size_t Size>
[[nodiscard]] Variations variations_of(const std::array<Pack, Size>& bernstein, const Pack& error) {
  unsigned some = 0;
  unsigned more = 0;
  Pack least = abs(bernstein[0]);
  unsigned sign = bernstein[0].signs();
  for (std::size_t i = 1; i < Size; ++i) {
    const unsigned next = bernstein[i].signs();
    const unsigned varies = next ^ sign;
    more |= some & varies;
    some |= varies;
    sign = next;
    least = min EIGEN_NOT_A_MACRO(least, abs(bernstein[i]));
  }
  return {some & ~more, more, (least > error).bits()};
}

/// Arcs that hold roots, several side by side.
template <typename Pack, std::size_t Size>
struct PackArcs {
  std::array<Pack, Size> bernstein;
  Pack left, right;  ///< in t
  Pack error;        ///< of every coefficient
  Pack owner;        ///< index of the polynomial, times four, plus that of the chart
};

/// A list of such arcs, stored by columns. After `end`, packs can be read beyond the last arc.
template <std::size_t Size, std::size_t Capacity>
struct ArcList {
  /// The largest number of packs that are read at once.
  static constexpr std::size_t most_packs = 4;
  static constexpr std::size_t room = Capacity + most_packs * numeric::most_lanes;
  std::size_t count = 0;
  std::array<std::array<double, room>, Size> bernstein;
  std::array<double, room> left, right, error, owner;

  [[nodiscard]] bool has_room_for(std::size_t arcs) const { return count + arcs <= Capacity; }
  template <typename Pack>
  [[nodiscard]] PackArcs<Pack, Size> arcs(std::size_t first) const {
    PackArcs<Pack, Size> result;
    for (std::size_t i = 0; i < Size; ++i) {
      result.bernstein[i] = Pack::load(&bernstein[i][first]);
    }
    result.left = Pack::load(&left[first]);
    result.right = Pack::load(&right[first]);
    result.error = Pack::load(&error[first]);
    result.owner = Pack::load(&owner[first]);
    return result;
  }
  /// Adds the arcs whose bits are set, without a branch, which could not be predicted.
  template <typename Pack>
  [[gnu::always_inline]] void add(const PackArcs<Pack, Size>& arcs, unsigned which) {
    for (std::size_t i = 0; i < Size; ++i) {
      arcs.bernstein[i].store_some(which, &bernstein[i][count]);
    }
    arcs.left.store_some(which, &left[count]);
    arcs.right.store_some(which, &right[count]);
    arcs.error.store_some(which, &error[count]);
    arcs.owner.store_some(which, &owner[count]);
    count += static_cast<std::size_t>(__builtin_popcount(which));
  }
  /// Sets the entries that packs may read beyond the last arc to zero.
  template <typename Pack>
  void end() {
    for (std::size_t place = count; place < count + most_packs * Pack::lanes;
         place += Pack::lanes) {
      for (std::size_t i = 0; i < Size; ++i) {
        Pack(0).store(&bernstein[i][place]);
      }
      Pack(0).store(&left[place]);
      Pack(0).store(&right[place]);
      Pack(0).store(&error[place]);
      Pack(0).store(&owner[place]);
    }
  }
};

/// Both halves of arcs, by de Casteljau.
template <typename Pack, std::size_t Size>
void halve(const std::array<Pack, Size>& whole, std::array<Pack, Size>& before,
           std::array<Pack, Size>& after) {
  std::array<Pack, Size> edge;
  for (std::size_t i = 0; i < Size; ++i) {
    Pack x = whole[i];
    for (std::size_t k = 0; k < i; ++k) {
      const Pack next = (edge[k] + x) * Pack(0.5);
      edge[k] = x;
      x = next;
    }
    before[i] = edge[i] = x;
  }
  for (std::size_t i = 0; i < Size; ++i) {
    after[i] = edge[Size - 1 - i];
  }
}

/// The search for arcs with one root each of the polynomials of up to `Block` owners.
template <std::size_t N, std::size_t Lanes, std::size_t Block>
class ArcSearch {
  static constexpr std::size_t size = 2 * N + 1;
  using Pack = numeric::PackOf<double, Lanes>;
  using Arcs = PackArcs<Pack, size>;

 public:
  using List = ArcList<size, 2 * N * Block>;

  void clear() {
    brackets_.count = 0;
    open_[0].count = 0;
  }
  /// Adds the charts of several polynomials whose Bernstein coefficients have the given errors. The
  /// first polynomial is that of `owner`. Returns a bit for each lane, set where all signs are
  /// certain; no bit is set if there is no room for the charts.
  [[nodiscard]] unsigned add(const numeric::Harmonics<Pack, N>& harmonics, const Pack& error,
                             std::size_t owner) {
    constexpr double edge = 1.4142135623730951 - 1;  // tan(pi/8)
    const Pack first_chart = Pack(4) * Pack::counted(static_cast<double>(owner));
    std::array<Arcs, 4> charts;
    std::array<Variations, 4> variations;
    put_bernstein<0, N>(harmonics, charts[0].bernstein);
    put_bernstein<1, N>(harmonics, charts[1].bernstein);
    put_bernstein<2, N>(harmonics, charts[2].bernstein);
    put_bernstein<3, N>(harmonics, charts[3].bernstein);
    unsigned certain = ~0U;
    for (std::size_t chart = 0; chart < 4; ++chart) {
      charts[chart].left = Pack(-edge);
      charts[chart].right = Pack(edge);
      charts[chart].error = error;
      charts[chart].owner = first_chart + Pack(static_cast<double>(chart));
      variations[chart] = variations_of(charts[chart].bernstein, error);
      certain &= variations[chart].certain;
    }
    if (!brackets_.has_room_for(4 * Lanes) || !open_[0].has_room_for(4 * Lanes)) {
      return 0;
    }
    for (std::size_t chart = 0; chart < 4; ++chart) {
      brackets_.add(charts[chart], certain & variations[chart].one);
      open_[0].add(charts[chart], certain & variations[chart].more);
    }
    return certain;
  }

  /// Cuts arcs until each holds one root; calls `give_up` with the owners for which that fails.
  template <typename GiveUp>
  void isolate(const GiveUp& give_up) {
    constexpr std::size_t most_levels = 24;
    std::size_t level = 0;
    for (; level < most_levels && open_[level % 2].count > 0; ++level) {
      open_[(level + 1) % 2].count = 0;
      open_[level % 2].template end<Pack>();
      for (std::size_t first = 0; first < open_[level % 2].count; first += Lanes) {
        cut(open_[level % 2], first, open_[(level + 1) % 2], give_up);
      }
    }
    const List& left = open_[level % 2];
    for (std::size_t arc = 0; arc < left.count; ++arc) {
      give_up(static_cast<std::size_t>(left.owner[arc]) / 4);
    }
    brackets_.template end<Pack>();
  }

  [[nodiscard]] const List& brackets() const { return brackets_; }

 private:
  template <typename GiveUp>
  void cut(const List& open, std::size_t first, List& next, const GiveUp& give_up) {
    const Arcs whole = open.template arcs<Pack>(first);
    Pack largest(0);
    for (const Pack& coefficient : whole.bernstein) {
      largest = max EIGEN_NOT_A_MACRO(largest, abs(coefficient));
    }
    constexpr double of_cut = 2.0 * (size - 1) * std::numeric_limits<double>::epsilon();
    const Pack error = whole.error + Pack(of_cut) * largest;
    const Pack middle = (whole.left + whole.right) * Pack(0.5);
    Arcs before{{}, whole.left, middle, error, whole.owner};
    Arcs after{{}, middle, whole.right, error, whole.owner};
    halve(whole.bernstein, before.bernstein, after.bernstein);
    const Variations of_before = variations_of(before.bernstein, error);
    const Variations of_after = variations_of(after.bernstein, error);
    const std::size_t count = (std::min)(Lanes, open.count - first);
    const unsigned given = (1U << count) - 1;
    const bool has_room = brackets_.has_room_for(2 * Lanes) && next.has_room_for(2 * Lanes);
    const unsigned sure = has_room ? given & of_before.certain & of_after.certain : 0;
    for (std::size_t lane = 0; (given & ~sure) >> lane != 0; ++lane) {
      if (((given & ~sure) >> lane & 1) != 0) {
        give_up(static_cast<std::size_t>(whole.owner[lane]) / 4);
      }
    }
    brackets_.add(before, sure & of_before.one);
    next.add(before, sure & of_before.more);
    brackets_.add(after, sure & of_after.one);
    next.add(after, sure & of_after.more);
  }

  List brackets_;
  std::array<List, 2> open_;  // arcs of one level and of the next
};

}  // namespace assur::detail::batch
