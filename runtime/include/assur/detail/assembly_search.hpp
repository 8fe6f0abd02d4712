// Turns a group's dimensions and inputs into its configurations at one precision of arithmetic.
#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <assur/assemblies.hpp>
#include <assur/detail/index.hpp>
#include <assur/detail/members.hpp>
#include <assur/kinematics.hpp>
#include <assur/numeric/bounded.hpp>
#include <assur/numeric/double_double.hpp>
#include <assur/numeric/second_unknown.hpp>
#include <assur/numeric/trigonometric_roots.hpp>
#include <assur/support/position_polynomial.hpp>
#include <assur/support/scale.hpp>
#include <assur/variables.hpp>
#include <cmath>
#include <limits>
#include <tuple>
#include <type_traits>

namespace assur::detail {

[[nodiscard]] inline double to_double(double value) { return value; }
[[nodiscard]] inline double to_double(const numeric::DoubleDouble& value) {
  return static_cast<double>(value);
}
template <typename Scalar>
[[nodiscard]] Direction<double> to_double(const Direction<Scalar>& value) {
  return normalised(Direction<double>{to_double(value.cos), to_double(value.sin)});
}

/// One search at one precision of the final polynomial and its roots.
template <typename Model, typename Work>
class AssemblySearch {
  template <typename Scalar>
  using Dimensions = typename Model::template Dimensions<Scalar>;
  template <typename Scalar>
  using Inputs = typename Model::template Inputs<Scalar>;
  template <typename Scalar>
  using Configuration = typename Model::template Configuration<Scalar>;
  static constexpr bool first_is_angle = is_angle<Model>(Model::first_unknown);
  static constexpr bool last_precision = std::is_same_v<Work, numeric::DoubleDouble>;

 public:
  AssemblySearch(const Dimensions<double>& d, const Inputs<double>& u, Assemblies<Model>& result)
      : d_(d), u_(u), result_(result) {}

  /// False if this precision does not tell the configurations apart.
  [[nodiscard]] bool run() {
    result_.count = 0;
    result_.undecided = 0;
    result_.status = AssemblyStatus::ok;
    work_d_ = support::scaled_to<Dimensions<Work>>(d_, 1.0);
    work_u_ = support::scaled_to<Inputs<Work>>(u_, 1.0);
    bool decided = false;
    if constexpr (first_is_angle) {
      decided = find_angles();
    } else {
      decided = find_displacements();
    }
    return decided && (last_precision || !has_twins());
  }

 private:
  /// The unknown of the final polynomial, and the one that the second equations then give.
  template <typename Unknowns>
  [[nodiscard]] static auto& first_of(Unknowns& q) {
    return std::get<static_cast<std::size_t>(Model::first_unknown)>(q.members());
  }
  template <typename Unknowns>
  [[nodiscard]] static auto& second_of(Unknowns& q) {
    return std::get<static_cast<std::size_t>(Model::second_unknown)>(q.members());
  }

  [[nodiscard]] bool find_angles() {
    const auto polynomial = support::position_polynomial<Model, Work>(d_, u_);
    const auto roots = numeric::trigonometric_roots<Work, Model::polynomial_degree>(
        polynomial.value, Work(polynomial.error));
    using numeric::RootStatus;
    if (roots.status == RootStatus::invalid) {
      result_.status = AssemblyStatus::not_finite;
      return true;
    }
    if (!last_precision && roots.status != RootStatus::certified) {
      return false;
    }
    if (roots.status == RootStatus::vanishing) {
      describe_degenerate();
      return true;
    }
    for (std::size_t root = 0; root < roots.root_count; ++root) {
      Configuration<Work> q;
      first_of(q) = {roots.roots[root].cosine, roots.roots[root].sine};
      accept_best(q);
    }
    for (std::size_t cluster = 0; cluster < roots.cluster_count; ++cluster) {
      Configuration<Work> q;
      first_of(q) = {Work(std::cos(roots.clusters[cluster].angle)),
                     Work(std::sin(roots.clusters[cluster].angle))};
      accept_cluster(q, roots.clusters[cluster].max_roots);
    }
    return true;
  }

  [[nodiscard]] bool find_displacements() {
    using Certified = numeric::Bounded<Work>;
    constexpr int degree = static_cast<int>(Model::polynomial_degree);
    Vector<Certified, degree + 1> bounded;
    Model::position_polynomial(support::scaled_to<Dimensions<Certified>>(d_, 1.0),
                               support::scaled_to<Inputs<Certified>>(u_, 1.0), bounded);
    for (int power = 0; power <= degree; ++power) {
      if (!std::isfinite(bounded(power).size())) {
        result_.status = AssemblyStatus::not_finite;
        return true;
      }
    }
    const Certified& leading = bounded(degree);
    if (!leading.sign_is_certain()) {
      if (!last_precision) {
        return false;
      }
      // The slides that the leading coefficient compares are parallel. A linear rest has a root.
      if (degree == 1 || !bounded(1).sign_is_certain()) {
        describe_degenerate();
      } else {
        accept_displacement(-bounded(0).value / bounded(1).value);
      }
      return true;
    }
    if constexpr (degree == 1) {
      accept_displacement(-bounded(0).value / leading.value);
      return true;
    } else {
      const Certified discriminant = bounded(1) * bounded(1) - Certified(4) * leading * bounded(0);
      if (!discriminant.sign_is_certain()) {
        if (!last_precision) {
          return false;
        }
        if (accept_displacement(-bounded(1).value / (Work(2) * leading.value))) {
          entry(result_.regularity, result_.count - 1) = Status::near_singular;
        }
        return true;
      }
      if (discriminant.value < Work(0)) {
        return true;
      }
      using std::sqrt;
      const Work root = sqrt(discriminant.value);
      const Work b = bounded(1).value;
      const Work q = b > Work(0) ? -(b + root) / Work(2) : -(b - root) / Work(2);
      accept_displacement(q / leading.value);
      accept_displacement(q == Work(0) ? -q / leading.value : bounded(0).value / q);
      return true;
    }
  }

  /// The first unknown is free or impossible: looks for an assembly at samples of it, and takes the
  /// freedom from the rank of the Jacobian there.
  void describe_degenerate() {
    result_.status = AssemblyStatus::degenerate;
    result_.count = 0;
    constexpr int samples = 32;
    for (int sample = 0; sample < samples && result_.mobility == 0; ++sample) {
      Configuration<Work> q;
      auto& first = first_of(q);
      const double part = (sample + 0.3) / samples;  // no angle or length that a design would have
      if constexpr (first_is_angle) {
        first = {Work(std::cos(6.2831853 * part)), Work(std::sin(6.2831853 * part))};
      } else {
        first = Work(4 * part - 2);
      }
      Configuration<double> found;
      if (!completed(q, found)) {
        continue;
      }
      Vector<double, Model::equation_count> f;
      Model::residual(d_, u_, found, f);
      if (f.cwiseAbs().maxCoeff() > 1e-9) {
        continue;
      }
      Matrix<double, Model::equation_count, Model::unknown_count> jacobian;
      Model::jacobian(d_, u_, found, jacobian);
      Eigen::FullPivLU<decltype(jacobian)> factors(jacobian);
      factors.setThreshold(1e-9);
      result_.mobility = Model::unknown_count - static_cast<int>(factors.rank());
    }
  }

  /// The configuration with the best second value; false if there is none in finite numbers.
  [[nodiscard]] bool completed(Configuration<Work> work, Configuration<double>& q) const {
    if constexpr (Model::second_unknown >= 0) {
      const auto list = candidates(work);
      if (list.count == 0) {
        return false;
      }
      second_of(work) = list.list[0].value;
    }
    Model::complete(work_d_, work_u_, work);
    for_each_pair(q, work, [](auto& target, const auto& source) { target = to_double(source); });
    return is_finite(q);
  }

  bool accept_displacement(const Work& value) {
    Configuration<Work> q;
    first_of(q) = value;
    return accept_best(q);
  }

  [[nodiscard]] auto candidates(const Configuration<Work>& q) const {
    Matrix<Work, 2, 3> e;
    Model::second_equations(work_d_, work_u_, q, e);
    using Unknown = std::decay_t<decltype(second_of(q))>;
    return numeric::second_candidates<Unknown>(e);
  }

  /// Completes the configuration at a simple root, where one second value fits.
  bool accept_best(Configuration<Work> q) {
    if constexpr (Model::second_unknown >= 0) {
      const auto list = candidates(q);
      if (list.count == 0) {
        return false;
      }
      second_of(q) = list.list[0].value;
    }
    return accept(q);
  }

  /// At a nearly multiple root either configurations meet, or several regular ones share the first
  /// unknown and differ in the second: then each of them polishes to a regular one of its own. The
  /// candidates' misses say nothing here: the first unknown is not known that well.
  void accept_cluster(Configuration<Work> q, int max_roots) {
    const int before = result_.count;
    if constexpr (Model::second_unknown >= 0) {
      const auto list = candidates(q);
      for (std::size_t index = 0; index < list.count && result_.count - before < max_roots;
           ++index) {
        second_of(q) = list.list[index].value;
        accept_in_cluster(q);
      }
    } else {
      accept_in_cluster(q);
    }
    const int found = result_.count - before;
    for (int index = before; index < result_.count && found < max_roots; ++index) {
      entry(result_.regularity, index) = Status::near_singular;
    }
    result_.undecided += found == 0 ? 1 : 0;
  }

  /// Lists what polishes to a closed configuration near where it started, and is new.
  void accept_in_cluster(Configuration<Work> q) {
    constexpr int steps = 30;
    const auto start = to_double(first_of(q));
    if (!accept(q, steps)) {
      return;
    }
    const int index = result_.count - 1;
    const auto& polished = entry(result_.configurations, index);
    Vector<double, Model::equation_count> f;
    Model::residual(d_, u_, polished, f);
    const bool closed = f.cwiseAbs().maxCoeff() < 1e-12;
    const bool strayed = apart(first_of(polished), start) > 1e-3;
    if (!closed || strayed || repeats_earlier(index)) {
      --result_.count;
    }
  }

  [[nodiscard]] bool repeats_earlier(int index) const {
    for (int other = 0; other < index; ++other) {
      if (distance(index, other) < 1e-7) {
        return true;
      }
    }
    return false;
  }

  /// Fills in the other unknowns, polishes on the loop equations and lists the configuration.
  bool accept(Configuration<Work>& work, int polishing_steps = 3) {
    Model::complete(work_d_, work_u_, work);
    Configuration<double> q;
    for_each_pair(q, work, [](auto& target, const auto& source) { target = to_double(source); });
    if (!is_finite(q) || result_.count == Model::max_configurations) {
      return false;
    }
    const Status regularity = polish(q, polishing_steps);
    entry(result_.configurations, result_.count) = q;
    entry(result_.regularity, result_.count) = regularity;
    ++result_.count;
    return true;
  }

  /// Newton's steps as long as they lessen a residual above rounding. The longest length is near
  /// one; where a displacement is longer, its rounding ends the steps.
  Status polish(Configuration<double>& q, int steps) const {
    Vector<double, Model::equation_count> f;
    Model::residual(d_, u_, q, f);
    double miss = f.cwiseAbs().maxCoeff();
    const InverseJacobian<Model, double> jacobian(d_, u_, q);
    constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
    for (int step = 0; step < steps && miss > rounding && jacobian.solvable(); ++step) {
      Configuration<double> next = q;
      nudge(next, jacobian.solve(Vector<double, Model::equation_count>(-f)));
      Model::residual(d_, u_, next, f);
      const double next_miss = f.cwiseAbs().maxCoeff();
      if (!(next_miss < miss)) {
        break;
      }
      q = next;
      miss = next_miss;
    }
    return jacobian.status() == Status::ok ? Status::ok : Status::near_singular;
  }

  /// A small step without trigonometric functions.
  static void nudge(Configuration<double>& q, const Vector<double, Model::unknown_count>& step) {
    for_each_member(q, [&step](auto& member, std::size_t index) {
      const double by = step(static_cast<Eigen::Index>(index));
      if constexpr (std::is_same_v<std::decay_t<decltype(member)>, double>) {
        member += by;
      } else {
        member = normalised(
            Direction<double>{member.cos - by * member.sin, member.sin + by * member.cos});
      }
    });
  }

  /// Largest difference of two configurations, lengths against one.
  [[nodiscard]] double distance(int one, int other) const {
    double largest = 0;
    for_each_pair(
        entry(result_.configurations, one), entry(result_.configurations, other),
        [&largest](const auto& a, const auto& b) { largest = std::max(largest, apart(a, b)); });
    return largest;
  }

  /// Two roots that polish to one configuration: one of them was completed wrongly.
  [[nodiscard]] bool has_twins() const {
    if constexpr (Assemblies<Model>::capacity == 1) {
      return false;
    }
    for (int index = 1; index < result_.count; ++index) {
      if (repeats_earlier(index)) {
        return true;
      }
    }
    return false;
  }

  const Dimensions<double>& d_;
  const Inputs<double>& u_;
  Assemblies<Model>& result_;
  Dimensions<Work> work_d_;
  Inputs<Work> work_u_;
};

}  // namespace assur::detail
