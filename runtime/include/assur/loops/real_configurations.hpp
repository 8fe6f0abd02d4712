// Real configurations of a group among its complex ones, and the mobility of its families in
// special position.
#pragma once

#include <algorithm>
#include <assur/loops/enclosure.hpp>
#include <cmath>

namespace assur::loops {

/// The real configurations of a group.
template <typename Of>
struct RealConfigurations {
  BoundedList<ComplexConfiguration<Of>, Of::configurations> list;
  int complex_count = 0;  ///< the number of enclosed complex configurations
  int mobility = 0;       ///< the greatest of a family
};

/// Real configurations among those that are not enclosed, and the mobility of families.
template <typename Of>
class UnprovenConfigurations {
 public:
  UnprovenConfigurations(const LoopEquations<Of>& equations, const AllConfigurations<Of>& all,
                         RealConfigurations<Of>& result)
      : equations_(equations), all_(all), size_(equations.size()), result_(result) {
    for (const ComplexConfiguration<Of>& at : all.unproven) {
      include(made_real(at));
    }
  }

 private:
  /// A configuration that is not enclosed is displaced by the square root of epsilon, or more if
  /// more than two meet.
  [[nodiscard]] static double apart() { return std::cbrt(epsilon); }

  [[nodiscard]] double gap_between(const ComplexConfiguration<Of>& one,
                                   const ComplexConfiguration<Of>& other) const {
    return (std::max)(norm_of(one.theta - other.theta), norm_of(one.s - other.s) / size_);
  }

  void include(const ComplexConfiguration<Of>& near) {
    if (!near.theta.allFinite() || !near.s.allFinite() || result_.list.is_full()) {
      return;
    }
    const ComplexConfiguration<Of> at = settled(equations_, near);
    const RealClosures<Of> here = real_closures(equations_, at);
    // A complex point of a family may be far from its real ones.
    const bool is_near = gap_between(at, near) <= apart() * 100;
    if (!(here.f.norm() <= rounding_of(equations_, at)) || (!is_near && result_.mobility > 0)) {
      return;
    }
    const double unsure = displacement_at(at, here);
    for (const ComplexConfiguration<Of>& other : result_.list) {
      if (gap_between(at, other) <= unsure) {
        return;
      }
    }
    for (const Enclosed<Of>& other : all_.enclosed) {
      if (gap_between(at, other.at) <= unsure) {
        return;
      }
    }
    if (const int freedoms = mobility_at(at, here); freedoms > 0) {
      result_.mobility = (std::max)(result_.mobility, freedoms);
    } else if (is_near) {
      result_.list.push_back(at);
    }
  }

  /// The displacement of a configuration by the residual that rounding leaves of the closures: the
  /// square root of epsilon where two configurations meet, since J is then as small, and more where
  /// more than two do.
  [[nodiscard]] double displacement_at(const ComplexConfiguration<Of>& at,
                                       const RealClosures<Of>& here) const {
    const typename Of::Square one = Of::Square::Identity(here.j.rows(), here.j.cols());
    typename Of::Square inverse = solved<Of>(here.j, one);
    inverse.bottomRows(equations_.slide_count()) /= size_;
    const double by = norm_of(inverse) * rounding_of(equations_, at);
    return by <= apart() * 100 ? by : apart() * 100;  // also where J has no inverse
  }

  /// The number of null directions that lead to other closed configurations.
  [[nodiscard]] int mobility_at(const ComplexConfiguration<Of>& at,
                                const RealClosures<Of>& here) const {
    constexpr double step = 0x1p-7;  // radians: the residual of an isolated one grows as its square
    const Eigen::Index angles = equations_.angle_count();
    typename Of::Square in_size = here.j;
    in_size.leftCols(angles) /= size_;
    const Eigen::Index unknowns = in_size.cols();
    ClosureSystem<Of, double> system(unknowns, unknowns);
    system.put(0, in_size);
    (void)system.eliminate_above(apart(), unknowns);
    int result = 0;
    for (Eigen::Index free = 0; free < unknowns; ++free) {
      if (system.row_of(free) >= 0) {
        continue;
      }
      typename Of::Closures along(unknowns);
      for (Eigen::Index unknown = 0; unknown < unknowns; ++unknown) {
        const int row = system.row_of(unknown);
        along(unknown) = row >= 0 ? -system.entry(row, free) : unknown == free ? 1.0 : 0.0;
      }
      along *= step / along.norm();
      along.tail(unknowns - angles) *= size_;
      const ComplexConfiguration<Of> there =
          settled(equations_, made_real(stepped<Of>(at, along.template cast<Complex>())));
      const bool closes =
          real_closures(equations_, there).f.norm() <= rounding_of(equations_, there);
      result += closes && gap_between(there, at) > step / 4 ? 1 : 0;
    }
    return result;
  }

  const LoopEquations<Of>& equations_;
  const AllConfigurations<Of>& all_;
  double size_;
  RealConfigurations<Of>& result_;
};

/// The real configurations of a group with `complex_count` complex ones in general position.
template <typename Of, typename Ways>
[[nodiscard]] RealConfigurations<Of> real_configurations(const LoopEquations<Of>& equations,
                                                         const Ways& ways, int complex_count) {
  const AllConfigurations<Of> all = all_configurations(equations, ways, complex_count);
  RealConfigurations<Of> result;
  result.complex_count = all.count();
  for (const Enclosed<Of>& one : all.enclosed) {
    if (one.is_real) {
      result.list.push_back(made_real(one.at));
    }
  }
  if (all.count() < complex_count) {
    UnprovenConfigurations<Of>(equations, all, result);
  }
  return result;
}

}  // namespace assur::loops
