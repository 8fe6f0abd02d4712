// Turns trigonometric polynomials into arcs of the circle that hold one root each, several at once.
//
// What `numeric::TrigonometricRootSearch` does of one polynomial (four charts in Bernstein form,
// Descartes' rule, arcs that are cut in the middle), with the same bounds. Arcs of all polynomials
// of a block are cut together, level by level: however different the polynomials are, packs are
// full. Where a sign is not certain, the polynomial is left to those who look at one alone.
#pragma once

#include <array>
#include <assur/numeric/pack.hpp>
#include <assur/numeric/trigonometric_charts.hpp>
#include <cstddef>
#include <limits>

namespace assur::detail::batch {

/// The Bernstein coefficients of `numeric::ChartTables` on one of four charts. The cosines' part is
/// the same from both ends, the sines' the opposite.
template <std::size_t Chart, std::size_t N, typename Pack>
[[gnu::always_inline]] inline void put_bernstein(const numeric::Harmonics<Pack, N>& harmonics,
                                                 std::array<Pack, 2 * N + 1>& bernstein) {
  constexpr const auto& table = numeric::chart_tables<double, N>.bernstein;
  for (std::size_t i = 0; i <= N; ++i) {
    Pack even = harmonics[0].cosine * Pack(table.cosine[0][i]);
    Pack odd(0);
    for (std::size_t k = 1; k <= N; ++k) {
      // Seen from a chart that is turned by right angles, as `less_quarters` has it.
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

/// How many sign variations the coefficients of several arcs have: a bit for each arc.
struct Variations {
  unsigned one = 0;
  unsigned more = 0;
  unsigned certain = 0;  ///< where every sign is certain
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

/// Arcs that hold roots, by columns; some more than there are can be read.
template <std::size_t Size, std::size_t Capacity>
struct ArcList {
  static constexpr std::size_t room = Capacity + 2 * numeric::most_lanes;
  std::size_t count = 0;
  std::array<std::array<double, room>, Size> bernstein{};
  std::array<double, room> left{}, right{};  ///< in t
  std::array<double, room> error{};          ///< of every coefficient
  std::array<std::size_t, room> owner{};     ///< whose arc it is, and on which of four charts

  [[nodiscard]] bool has_room_for(std::size_t arcs) const { return count + arcs <= Capacity; }
  /// Writes one of several arcs that are given side by side behind the last; it is one of the list
  /// if the count is raised.
  template <typename Pack>
  void write(const std::array<Pack, Size>& coefficients, std::size_t lane, double from, double to,
             double within, std::size_t whose) {
    for (std::size_t i = 0; i < Size; ++i) {
      bernstein[i][count] = coefficients[i][lane];
    }
    left[count] = from;
    right[count] = to;
    error[count] = within;
    owner[count] = whose;
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
  using Polynomial = std::array<Pack, size>;

 public:
  using Arcs = ArcList<size, 2 * N * Block>;

  void clear() {
    brackets_.count = 0;
    open_[0].count = 0;
  }
  /// The charts of several polynomials, the first of which is that of `owner`, whose Bernstein
  /// coefficients have such errors. False, of a lane, where a sign is not certain.
  [[nodiscard]] unsigned add(const numeric::Harmonics<Pack, N>& harmonics, const Pack& error,
                             std::size_t owner) {
    constexpr double edge = 1.4142135623730951 - 1;  // tan(pi/8)
    std::array<Polynomial, 4> charts;
    std::array<Variations, 4> variations;
    put_bernstein<0, N>(harmonics, charts[0]);
    put_bernstein<1, N>(harmonics, charts[1]);
    put_bernstein<2, N>(harmonics, charts[2]);
    put_bernstein<3, N>(harmonics, charts[3]);
    unsigned certain = ~0U;
    for (std::size_t chart = 0; chart < 4; ++chart) {
      variations[chart] = variations_of(charts[chart], error);
      certain &= variations[chart].certain;
    }
    if (!brackets_.has_room_for(4 * Lanes) || !open_[0].has_room_for(4 * Lanes)) {
      return 0;
    }
    for (std::size_t chart = 0; chart < 4; ++chart) {
      const unsigned one = certain & variations[chart].one;
      const unsigned more = certain & variations[chart].more;
      for (std::size_t lane = 0; (one | more) >> lane != 0; ++lane) {
        const std::size_t whose = 4 * (owner + lane) + chart;
        if ((one >> lane & 1) != 0) {
          brackets_.write(charts[chart], lane, -edge, edge, error[lane], whose);
          ++brackets_.count;
        } else if ((more >> lane & 1) != 0) {
          open_[0].write(charts[chart], lane, -edge, edge, error[lane], whose);
          ++open_[0].count;
        }
      }
    }
    return certain;
  }

  /// Cuts arcs until each holds one root; calls `give_up` with owners of which that fails.
  template <typename GiveUp>
  void isolate(const GiveUp& give_up) {
    constexpr std::size_t most_levels = 24;
    std::size_t level = 0;
    for (; level < most_levels && open_[level % 2].count > 0; ++level) {
      open_[(level + 1) % 2].count = 0;
      for (std::size_t first = 0; first < open_[level % 2].count; first += Lanes) {
        cut(open_[level % 2], first, open_[(level + 1) % 2], give_up);
      }
    }
    const Arcs& left = open_[level % 2];
    for (std::size_t arc = 0; arc < left.count; ++arc) {
      give_up(left.owner[arc] / 4);
    }
  }

  [[nodiscard]] const Arcs& brackets() const { return brackets_; }

 private:
  template <typename GiveUp>
  void cut(const Arcs& open, std::size_t first, Arcs& next, const GiveUp& give_up) {
    Polynomial whole;
    Pack largest(0);
    for (std::size_t i = 0; i < size; ++i) {
      whole[i] = Pack::load(&open.bernstein[i][first]);
      largest = max EIGEN_NOT_A_MACRO(largest, abs(whole[i]));
    }
    std::array<Polynomial, 2> halves;
    halve(whole, halves[0], halves[1]);
    const Pack left = Pack::load(&open.left[first]);
    const Pack right = Pack::load(&open.right[first]);
    constexpr double of_cut = 2.0 * (size - 1) * std::numeric_limits<double>::epsilon();
    const Pack error = Pack::load(&open.error[first]) + Pack(of_cut) * largest;
    const Pack middle = (left + right) * Pack(0.5);
    const std::array<Variations, 2> variations = {variations_of(halves[0], error),
                                                  variations_of(halves[1], error)};
    const unsigned sure = variations[0].certain & variations[1].certain;
    const bool has_room = brackets_.has_room_for(2 * Lanes) && next.has_room_for(2 * Lanes);
    for (std::size_t lane = 0; lane < Lanes && first + lane < open.count; ++lane) {
      const std::size_t owner = open.owner[first + lane];
      if (!has_room || (sure >> lane & 1) == 0) {
        give_up(owner / 4);
        continue;
      }
      // Every half is written, and most of them stay: a branch would be as good as random.
      for (std::size_t half = 0; half < 2; ++half) {
        const unsigned one = variations[half].one >> lane & 1;
        const unsigned more = variations[half].more >> lane & 1;
        const double from = half == 0 ? left[lane] : middle[lane];
        const double to = half == 0 ? middle[lane] : right[lane];
        Arcs& list = one != 0 ? brackets_ : next;
        list.write(halves[half], lane, from, to, error[lane], owner);
        brackets_.count += one;
        next.count += more;
      }
    }
  }

  Arcs brackets_;
  std::array<Arcs, 2> open_;  // those of one level and of the next
};

}  // namespace assur::detail::batch
