// All real roots of a trigonometric polynomial, with a certified count.
//
// The roots in [0, 2 pi) are those of T(th) = sum_{k=0..N} cosine[k] cos(k th) + sine[k] sin(k th),
// N <= 3. There is no heap allocation and no exception. Scalar is double, DoubleDouble, or any type
// with + - * /, comparisons, abs, sqrt, double() and numeric_limits::epsilon(), twice the largest
// relative error of those operations; rounding to nearest.
//
// Method. With (x, y) = (cos th/2, sin th/2), T is a form F of degree D = 2N in (x, y). Four charts
// of 90 degrees, centred at 0, 90, 180, 270 degrees, keep t = tan((th - centre)/2) within
// tan(pi/8), far from infinity. On each, F is written in Bernstein form between the unit vectors at
// the ends. By Descartes' rule the sign variations of the coefficients bound the number of roots
// inside, with multiplicity and with the right parity: 0 and 1 are exact; otherwise the arc is cut
// again. Arcs are only cut where the sign of T is certain, so no root is at an end, shared or lost;
// if T is too small at one of the first four cuts, all of them are turned.
//
// A sign is certain when the coefficient exceeds its error bound, derived in
// trigonometric_charts.hpp from the error of the given coefficients and all rounding. An uncertain
// coefficient may have either sign: the largest number of variations over all choices counts. The
// count depends on nothing else, in particular on no iteration.
#pragma once

#include <array>
#include <assur/numeric/double_double.hpp>
#include <assur/numeric/polynomial_bracket.hpp>
#include <assur/numeric/trigonometric_charts.hpp>
#include <cmath>
#include <limits>
#include <type_traits>

namespace assur::numeric {

enum class RootStatus {
  certified,  ///< `roots` holds every real root, and all of them are simple
  undecided,  ///< besides `roots` there are clusters: repeat with a more precise Scalar and
              ///< coefficients
  vanishing,  ///< T does not exceed its own error bound: no angle can be excluded
  invalid     ///< a coefficient is not finite, or coefficient_error is negative or not a number
};

/// The type of angles, which are only displayed and sorted: float for scalars made of floats,
/// double for all others.
template <class Scalar>
using AngleOf =
    std::conditional_t<std::is_same_v<typename PartOf<Scalar>::Type, float>, float, double>;

template <class Scalar>
struct TrigonometricRoot {
  AngleOf<Scalar> angle;  ///< in [0, 2 pi)
  Scalar cosine, sine;    ///< of the root, in the precision of Scalar
  Scalar slope;           ///< dT/dth there; the error of the root is about (error of T) / |slope|
};

/// An arc, angle +- half_width, of roots that could not be separated. It holds max_roots roots with
/// multiplicity, or fewer by an even number. T is certainly not zero at the ends of an arc inside
/// it that holds them all.
template <class Scalar>
struct RootCluster {
  AngleOf<Scalar> angle;  ///< where T is flattest: the nearly multiple root; in [0, 2 pi)
  AngleOf<Scalar> half_width;
  int max_roots;
};

template <class Scalar, std::size_t N>
struct TrigonometricRoots {
  RootStatus status = RootStatus::certified;
  std::size_t root_count = 0;
  std::size_t cluster_count = 0;
  std::array<TrigonometricRoot<Scalar>, 2 * N>
      roots;  ///< the first root_count are set, by ascending angle
  std::array<RootCluster<Scalar>, 2 * N> clusters;  ///< the first cluster_count are set
};

template <class Scalar, std::size_t N>
class TrigonometricRootSearch {
  static_assert(N >= 1 && N <= 3, "the error bounds are derived for N <= 3");
  static constexpr std::size_t D = 2 * N;
  static constexpr int max_depth = 128;  ///< two levels at least halve an arc
  using Angle = AngleOf<Scalar>;
  static constexpr Angle two_pi = static_cast<Angle>(6.28318530717958647693);
  // Sums between two to this power and its inverse are far from overflow and underflow.
  static constexpr int most_power =
      200 * std::numeric_limits<Scalar>::max_exponent / std::numeric_limits<double>::max_exponent;
  using Polynomial = std::array<Scalar, D + 1>;

  struct Arc {
    Polynomial bernstein;
    Scalar left, right;  ///< in t
    Scalar error;        ///< of every Bernstein coefficient
    int max_roots, depth;
    bool wide;  ///< whether it is more than half of the arc from which it was cut
  };

  const ChartTables<Scalar, N>& tables;
  TrigonometricRoots<Scalar, N>& result;
  Scalar sum, error, unscale{1};
  Harmonics<Scalar, N> harmonics;
  Harmonic<Scalar> turn_back{Scalar(1), Scalar(0)};
  Angle turn_angle = 0;
  std::array<Polynomial, 4> bernstein, power;  ///< by chart
  std::array<Bracket<Scalar>, D> brackets;
  std::size_t bracket_count = 0;

 public:
  TrigonometricRootSearch(const ChartTables<Scalar, N>& shared_tables,
                          TrigonometricRoots<Scalar, N>& roots)
      : tables(shared_tables), result(roots) {}

  void run(const TrigonometricPolynomial<Scalar, N>& polynomial, Scalar coefficient_error) {
    result.status = prepare(polynomial, coefficient_error);
    if (result.status != RootStatus::certified) return;
    if (!choose_cuts()) return report_cluster(two_pi / 2, two_pi / 2, static_cast<int>(D));
    using std::sqrt;
    const Scalar edge = sqrt(Scalar(2)) - Scalar(1);  // tan(pi/8)
    for (std::size_t chart = 0; chart < 4; ++chart) {
      const int max_roots = count_variations(bernstein[chart], error);
      if (max_roots == 0) continue;
      power[chart] = tables.power.apply(harmonics, chart);
      isolate(chart, {bernstein[chart], -edge, edge, error, max_roots, 0, false});
    }
    refine();
  }

 private:
  /// Copies and scales the coefficients.
  RootStatus prepare(const TrigonometricPolynomial<Scalar, N>& polynomial,
                     Scalar coefficient_error) {
    for (std::size_t k = 0; k <= N; ++k) {
      harmonics[k] = {polynomial.cosine[k], k == 0 ? Scalar(0) : polynomial.sine[k]};
    }
    Scalar not_finite(0);
    for (const Harmonic<Scalar>& h : harmonics) {
      not_finite += h.cosine * Scalar(0) + h.sine * Scalar(0);
    }
    if (!(not_finite == Scalar(0)) || !(coefficient_error >= Scalar(0))) return RootStatus::invalid;
    add_up();
    // All further steps are linear in T, except ratios of degree four: keep these far from overflow
    // and underflow. (The sum itself may have overflowed.)
    using Part = typename PartOf<Scalar>::Type;
    constexpr Part most = power_of_two<Part>(most_power);
    constexpr Part least = power_of_two<Part>(-most_power);
    if (!(sum < Scalar(most)) || sum < Scalar(least)) {
      const bool large = !(sum < Scalar(1));
      constexpr Part scales = power_of_two<Part>(3 * most_power);
      const Scalar scale(large ? 1 / scales : scales);
      unscale = Scalar(large ? scales : 1 / scales);
      for (Harmonic<Scalar>& h : harmonics) h = {h.cosine * scale, h.sine * scale};
      coefficient_error *= scale;
      add_up();
    }
    error = transform_error<Scalar, N>(coefficient_error, sum);
    return sum > error ? RootStatus::certified : RootStatus::vanishing;
  }

  void add_up() {
    sum = Scalar(0);
    for (const Harmonic<Scalar>& h : harmonics) sum += magnitude(h.cosine) + magnitude(h.sine);
  }

  /// Finds charts, as they are or turned by 2 atan(attempt / 16), at whose ends the sign is
  /// certain. A root spoils only one attempt unless T is close to zero along a good part of the
  /// circle.
  bool choose_cuts() {
    if (cut_circle()) return true;
    const Harmonics<Scalar, N> original = harmonics;
    error += turn_error(sum);
    for (int attempt = 1; attempt <= 6; ++attempt) {
      const auto norm = Scalar(256 + attempt * attempt);
      const Harmonic<Scalar> turn{Scalar(256 - attempt * attempt) / norm,
                                  Scalar(32 * attempt) / norm};
      turn_back = {turn.cosine, -turn.sine};
      turn_angle = 2 * std::atan(static_cast<Angle>(attempt) / 16);
      Harmonic<Scalar> multiple = turn;
      for (std::size_t k = 1; k <= N; ++k) {
        harmonics[k] = original[k].less(multiple);
        multiple = multiple.less(turn_back);
      }
      if (cut_circle()) return true;
    }
    return false;
  }

  bool cut_circle() {
    bool certain = true;
    for (std::size_t chart = 0; chart < 4; ++chart) {
      bernstein[chart] = tables.bernstein.apply(harmonics, chart);
      certain &= magnitude(bernstein[chart][0]) > error && magnitude(bernstein[chart][D]) > error;
    }
    return certain;
  }

  void isolate(std::size_t chart, const Arc& arc) {
    if (arc.max_roots == 1) return bracket(chart, arc);
    const Scalar width = arc.right - arc.left;
    bool hopeless = arc.depth == max_depth;
    // Halving soon isolates separate roots. The remaining ones are nearly multiple: cut where T is
    // flattest or, if T is too small there, at the distance on either side where it should exceed
    // its error. Such a cut may remove very little, again and again: then halving comes first.
    if (arc.wide && !hopeless && cut(chart, arc, Scalar(0.5))) return;
    if (arc.depth >= 2 && !hopeless) {
      const auto [t, coefficient] = flattest(chart, arc);
      if (cut(chart, arc, (t - arc.left) / width)) return;
      const Scalar reach(3 * std::pow(std::abs(Angle(arc.error / coefficient)),
                                      1 / static_cast<Angle>(arc.max_roots)));
      const bool left_near = t - arc.left < Scalar(2) * reach;
      const bool right_near = arc.right - t < Scalar(2) * reach;
      if (!left_near && cut(chart, arc, (t - reach - arc.left) / width)) return;
      if (!right_near && cut(chart, arc, (t + reach - arc.left) / width)) return;
      hopeless = arc.max_roots == 2 && left_near && right_near;
    }
    for (const double lambda : {0.5, 0.375, 0.6875}) {
      if (!hopeless && cut(chart, arc, Scalar(lambda))) return;
    }
    const Scalar t = flattest(chart, arc)[0];
    const Scalar reach = t - arc.left > arc.right - t ? t - arc.left : arc.right - t;
    report_cluster(angle_at(chart, t), 2 * Angle(reach), arc.max_roots);
  }

  void report_cluster(Angle angle, Angle half_width, int max_roots) {
    result.status = RootStatus::undecided;
    if (result.cluster_count < D) {
      result.clusters[result.cluster_count++] = {angle, half_width, max_roots};
    }
  }

  /// Searches both parts of the arc, cut at the fraction lambda, unless the sign there is
  /// uncertain.
  bool cut(std::size_t chart, const Arc& arc, Scalar lambda) {
    const Scalar middle = arc.left + lambda * (arc.right - arc.left);
    if (!(lambda > Scalar(0) && lambda < Scalar(1) && middle > arc.left && middle < arc.right)) {
      return false;
    }
    Arc left;
    Arc right;
    cut_at(lambda, arc.bernstein, left.bernstein, right.bernstein);
    left.error = right.error = arc.error + cut_error(arc.bernstein);
    if (!(magnitude(right.bernstein[0]) > right.error)) return false;
    // The parts together hold no more roots than the whole, and an odd number is at least one.
    const int on_left = count_variations(left.bernstein, left.error);
    const int on_right = count_variations(right.bernstein, right.error);
    const int most_left = arc.max_roots - on_right % 2;
    const int most_right = arc.max_roots - on_left % 2;
    left.max_roots = on_left < most_left ? on_left : most_left;
    right.max_roots = on_right < most_right ? on_right : most_right;
    left.left = arc.left;
    left.right = right.left = middle;
    right.right = arc.right;
    left.depth = right.depth = arc.depth + 1;
    left.wide = lambda > Scalar(0.5);
    right.wide = lambda < Scalar(0.5);
    if (left.max_roots > 0) isolate(chart, left);
    if (right.max_roots > 0) isolate(chart, right);
    return true;
  }

  /// With m = max_roots, finds a zero of p^(m-1) in the arc from the middle on, and p^(m)/m! there.
  [[nodiscard]] std::array<Scalar, 2> flattest(std::size_t chart, const Arc& arc) const {
    const std::size_t order = static_cast<std::size_t>(arc.max_roots) - 1;
    Scalar t = (arc.left + arc.right) / Scalar(2);
    Scalar slope(0);
    for (int step = 0; step < 6; ++step) {
      Scalar value(0);
      slope = Scalar(0);
      for (std::size_t i = D + 1; i-- > order;) {
        slope = slope * t + value;
        value = value * t + power[chart][i] * Scalar(binomial(i, order));
      }
      const Scalar next = t - value / slope;
      if (!(next > arc.left && next < arc.right)) break;
      t = next;
    }
    return {t, slope / Scalar(arc.max_roots)};
  }

  /// Returns a first guess: where the control polygon crosses zero. Its sign changes once, apart
  /// from uncertain coefficients.
  void bracket(std::size_t chart, const Arc& arc) {
    const Polynomial& b = arc.bernstein;
    std::size_t i = 1;
    for (std::size_t j = 1; j < D; ++j) i += negative(b[j]) == negative(b[0]);
    Scalar crossing = (Scalar(static_cast<int>(i) - 1) + b[i - 1] / (b[i - 1] - b[i])) /
                      Scalar(static_cast<int>(D));
    if (!(crossing > Scalar(0) && crossing < Scalar(1))) crossing = Scalar(0.5);
    const Scalar guess = arc.left + crossing * (arc.right - arc.left);
    brackets[bracket_count++] = {chart, negative(b[0]), arc.left, arc.right, guess};
  }

  /// All roots advance in turn by one step, so that the processor can overlap them.
  void refine() {
    const Scalar noise = std::numeric_limits<Scalar>::epsilon() / Scalar(2) * sum;
    bool open = bracket_count > 0;
    for (int iteration = 0; open && iteration < 300; ++iteration) {
      open = false;
      for (std::size_t r = 0; r < bracket_count; ++r) {
        if (!brackets[r].done) improve(brackets[r], power[brackets[r].chart], noise, iteration);
        open |= !brackets[r].done;
      }
    }
    for (std::size_t r = 0; r < bracket_count; ++r) store(brackets[r].chart, brackets[r].t);
  }

  [[nodiscard]] Angle angle_at(std::size_t chart, Scalar t) const {
    Angle angle = 2 * std::atan(Angle(t)) + (static_cast<Angle>(chart) * (two_pi / 4) + turn_angle);
    if (angle < 0) angle += two_pi;
    return angle < two_pi ? angle : angle - two_pi;
  }

  void store(std::size_t chart, Scalar t) {
    Scalar slope(0);
    for (std::size_t i = D; i > 0; --i) {
      slope = slope * t + power[chart][i] * Scalar(static_cast<int>(i));
    }
    const Scalar square = t * t;
    const Scalar norm = Scalar(1) + square;
    for (std::size_t k = 1; k < N; ++k) slope = slope / norm;
    const Harmonic<Scalar> local{(Scalar(1) - square) / norm, (t + t) / norm};
    const Harmonic<Scalar> point = local.less_quarters(4 - chart).less(turn_back);
    const Angle angle = angle_at(chart, t);
    std::size_t place = result.root_count++;
    for (; place > 0 && result.roots[place - 1].angle > angle; --place) {
      result.roots[place] = result.roots[place - 1];
    }
    result.roots[place] = {angle, point.cosine, point.sine, slope * unscale / Scalar(2)};
  }
};

/// Returns the real roots of a trigonometric polynomial. `coefficient_error` bounds the absolute
/// error of every given coefficient; it is 0 if they are exact.
template <class Scalar, std::size_t N>
[[nodiscard]] TrigonometricRoots<Scalar, N> trigonometric_roots(
    const TrigonometricPolynomial<Scalar, N>& polynomial, Scalar coefficient_error) {
  TrigonometricRoots<Scalar, N> result;
  TrigonometricRootSearch<Scalar, N>(chart_tables<Scalar, N>, result)
      .run(polynomial, coefficient_error);
  return result;
}

}  // namespace assur::numeric
