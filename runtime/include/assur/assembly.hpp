// Finds every assembly configuration of a generated model in closed form, with a certified count.
#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <assur/assembly_order.hpp>
#include <assur/bounded.hpp>
#include <assur/double_double.hpp>
#include <assur/kinematics.hpp>
#include <assur/second_unknown.hpp>
#include <assur/trigonometric_roots.hpp>
#include <cmath>

namespace assur {

enum class AssemblyStatus : unsigned char {
  ok,          ///< all configurations are listed; none if the links cannot reach
  degenerate,  ///< the final polynomial vanishes: no configurations, or infinitely many
  not_finite   ///< an input is NaN or infinite, or the lengths differ by too many powers of ten
};

/// The assembly configurations of a model, in an order that rigid motion, reflection and change of
/// units keep.
template <typename Model>
struct Assemblies {
  static constexpr auto capacity = static_cast<std::size_t>(Model::max_configurations);

  AssemblyStatus status = AssemblyStatus::ok;
  int count = 0;
  std::array<typename Model::template Configuration<double>, capacity> configurations;
  /// ok, or near_singular: the derivatives may keep fewer than six digits, or two configurations
  /// meet so closely that double-double arithmetic cannot tell whether they are two, one or none.
  std::array<Status, capacity> regularity{};
  /// Nearly multiple roots of the final polynomial that double-double could not exclude and from
  /// which no closed configuration came: each may hide two that meet, or none.
  int undecided = 0;
  /// For a degenerate group: freedom where it was found assembled, or zero if it was not.
  int mobility = 0;
};

namespace detail {

/// The same variables in another scalar, lengths multiplied by a power of two.
template <typename To, typename From, typename Scale>
[[nodiscard]] To scaled_to(const From& from, Scale scale) {
  To result;
  const auto assign = [&](auto& target, const auto& source) {
    if constexpr (std::is_same_v<std::decay_t<decltype(source)>, double>) {
      target = std::decay_t<decltype(target)>(source * scale);
    } else {
      using Scalar = std::decay_t<decltype(target.cos)>;
      target = {Scalar(source.cos), Scalar(source.sin)};
    }
  };
  std::apply(
      [&](const auto&... source) {
        std::apply([&](auto&... target) { (assign(target, source), ...); }, result.members());
      },
      from.members());
  return result;
}

inline double to_double(double value) { return value; }
inline double to_double(const DoubleDouble& value) { return static_cast<double>(value); }
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
  static constexpr bool first_is_angle =
      Model::unknowns[static_cast<std::size_t>(Model::first_unknown)].is_angle;
  static constexpr bool last_precision = std::is_same_v<Work, DoubleDouble>;

 public:
  AssemblySearch(const Dimensions<double>& d, const Inputs<double>& u, Assemblies<Model>& result)
      : d_(d), u_(u), result_(result) {}

  /// False if this precision does not tell the configurations apart.
  [[nodiscard]] bool run() {
    result_.count = 0;
    result_.undecided = 0;
    result_.status = AssemblyStatus::ok;
    work_d_ = scaled_to<Dimensions<Work>>(d_, 1.0);
    work_u_ = scaled_to<Inputs<Work>>(u_, 1.0);
    bool decided = false;
    if constexpr (first_is_angle) {
      decided = find_angles();
    } else {
      decided = find_displacements();
    }
    return decided && (last_precision || !has_twins());
  }

 private:
  [[nodiscard]] bool find_angles() {
    constexpr std::size_t degree = Model::polynomial_degree;
    using Certified = Bounded<Work>;
    TrigonometricPolynomial<Certified, degree> bounded;
    Model::position_polynomial(scaled_to<Dimensions<Certified>>(d_, 1.0),
                               scaled_to<Inputs<Certified>>(u_, 1.0), bounded);
    TrigonometricPolynomial<Work, degree> polynomial;
    double error = 0;
    for (std::size_t k = 0; k <= degree; ++k) {
      polynomial.cosine[k] = bounded.cosine[k].value;
      polynomial.sine[k] = bounded.sine[k].value;
      error = std::max({error, bounded.cosine[k].certain_bound(), bounded.sine[k].certain_bound()});
    }
    const auto roots = trigonometric_roots<Work, degree>(polynomial, Work(error));
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
      std::get<static_cast<std::size_t>(Model::first_unknown)>(q.members()) = {
          roots.roots[root].cosine, roots.roots[root].sine};
      accept_best(q);
    }
    for (std::size_t cluster = 0; cluster < roots.cluster_count; ++cluster) {
      Configuration<Work> q;
      std::get<static_cast<std::size_t>(Model::first_unknown)>(q.members()) = {
          Work(std::cos(roots.clusters[cluster].angle)),
          Work(std::sin(roots.clusters[cluster].angle))};
      accept_cluster(q, roots.clusters[cluster].max_roots);
    }
    return true;
  }

  [[nodiscard]] bool find_displacements() {
    using Certified = Bounded<Work>;
    constexpr int degree = static_cast<int>(Model::polynomial_degree);
    Vector<Certified, degree + 1> bounded;
    Model::position_polynomial(scaled_to<Dimensions<Certified>>(d_, 1.0),
                               scaled_to<Inputs<Certified>>(u_, 1.0), bounded);
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
          result_.regularity[static_cast<std::size_t>(result_.count - 1)] = Status::near_singular;
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
      auto& first = std::get<static_cast<std::size_t>(Model::first_unknown)>(q.members());
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
      std::get<static_cast<std::size_t>(Model::second_unknown)>(work.members()) =
          list.list[0].value;
    }
    Model::complete(work_d_, work_u_, work);
    std::apply(
        [&](const auto&... source) {
          std::apply([&](auto&... target) { ((target = to_double(source)), ...); }, q.members());
        },
        work.members());
    return is_finite(q);
  }

  bool accept_displacement(const Work& value) {
    Configuration<Work> q;
    std::get<static_cast<std::size_t>(Model::first_unknown)>(q.members()) = value;
    return accept_best(q);
  }

  [[nodiscard]] auto candidates(const Configuration<Work>& q) const {
    Matrix<Work, 2, 3> e;
    Model::second_equations(work_d_, work_u_, q, e);
    constexpr auto second = static_cast<std::size_t>(Model::second_unknown);
    using Unknown = std::decay_t<std::tuple_element_t<second, decltype(q.members())>>;
    return second_candidates<Unknown>(e);
  }

  /// Completes the configuration at a simple root, where one second value fits.
  bool accept_best(Configuration<Work> q) {
    if constexpr (Model::second_unknown >= 0) {
      const auto list = candidates(q);
      if (list.count == 0) {
        return false;
      }
      std::get<static_cast<std::size_t>(Model::second_unknown)>(q.members()) = list.list[0].value;
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
      for (int index = 0; index < list.count && result_.count - before < max_roots; ++index) {
        std::get<static_cast<std::size_t>(Model::second_unknown)>(q.members()) =
            list.list[static_cast<std::size_t>(index)].value;
        accept_in_cluster(q);
      }
    } else {
      accept_in_cluster(q);
    }
    const int found = result_.count - before;
    for (int index = before; index < result_.count && found < max_roots; ++index) {
      result_.regularity[static_cast<std::size_t>(index)] = Status::near_singular;
    }
    result_.undecided += found == 0 ? 1 : 0;
  }

  /// Lists what polishes to a closed configuration near where it started, and is new.
  void accept_in_cluster(Configuration<Work> q) {
    constexpr int steps = 30;
    constexpr auto first = static_cast<std::size_t>(Model::first_unknown);
    const auto start = to_double(std::get<first>(q.members()));
    if (!accept(q, steps)) {
      return;
    }
    const int index = result_.count - 1;
    const auto& polished = result_.configurations[static_cast<std::size_t>(index)];
    Vector<double, Model::equation_count> f;
    Model::residual(d_, u_, polished, f);
    const bool closed = f.cwiseAbs().maxCoeff() < 1e-12;
    const bool strayed = apart(std::get<first>(polished.members()), start) > 1e-3;
    if (!closed || strayed || repeats_earlier(index, 0)) {
      --result_.count;
    }
  }

  [[nodiscard]] bool repeats_earlier(int index, int from) const {
    for (int other = from; other < index; ++other) {
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
    std::apply(
        [&](const auto&... source) {
          std::apply([&](auto&... target) { ((target = to_double(source)), ...); }, q.members());
        },
        work.members());
    if (!is_finite(q) || result_.count == Model::max_configurations) {
      return false;
    }
    const Status regularity = polish(q, polishing_steps);
    const auto slot = static_cast<std::size_t>(result_.count++);
    result_.configurations[slot] = q;
    result_.regularity[slot] = regularity;
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
    const auto move = [](auto& member, double by) {
      if constexpr (std::is_same_v<std::decay_t<decltype(member)>, double>) {
        member += by;
      } else {
        member = normalised(
            Direction<double>{member.cos - by * member.sin, member.sin + by * member.cos});
      }
    };
    std::apply(
        [&](auto&... member) {
          Eigen::Index index = 0;
          (move(member, step(index++)), ...);
        },
        q.members());
  }

  [[nodiscard]] static double apart(double a, double b) { return std::abs(a - b); }
  [[nodiscard]] static double apart(const Direction<double>& a, const Direction<double>& b) {
    return std::max(std::abs(a.cos - b.cos), std::abs(a.sin - b.sin));
  }

  /// Largest difference of two configurations, lengths against one.
  [[nodiscard]] double distance(int one, int other) const {
    double largest = 0;
    std::apply(
        [&](const auto&... a) {
          std::apply([&](const auto&... b) { ((largest = std::max(largest, apart(a, b))), ...); },
                     result_.configurations[static_cast<std::size_t>(other)].members());
        },
        result_.configurations[static_cast<std::size_t>(one)].members());
    return largest;
  }

  /// Two roots that polish to one configuration: one of them was completed wrongly.
  [[nodiscard]] bool has_twins() const {
    if constexpr (Assemblies<Model>::capacity == 1) {
      return false;
    }
    for (int index = 1; index < result_.count; ++index) {
      if (repeats_earlier(index, 0)) {
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

template <typename Model>
void sort_assemblies(const typename Model::template Dimensions<double>& d,
                     const typename Model::template Inputs<double>& u, Assemblies<Model>& result) {
  using Order = AssemblyOrder<Model>;
  std::array<typename Order::Key, Assemblies<Model>::capacity> keys;
  const auto count = static_cast<std::size_t>(result.count);
  for (std::size_t index = 0; index < count; ++index) {
    keys[index] = Order::key(d, u, result.configurations[index]);
  }
  for (std::size_t last = 1; last < count; ++last) {
    for (std::size_t at = last; at > 0 && Order::before(keys[at], keys[at - 1]); --at) {
      std::swap(keys[at], keys[at - 1]);
      std::swap(result.configurations[at], result.configurations[at - 1]);
      std::swap(result.regularity[at], result.regularity[at - 1]);
    }
  }
}

/// The power of two that brings the longest length of a group near one. Only differences of the
/// external joints' places count, not where the group is.
template <typename Model>
[[nodiscard]] double unit_scale(const typename Model::template Dimensions<double>& d,
                                const typename Model::template Inputs<double>& u) {
  if constexpr (Model::dimension_count == 0) {  // folded, and in units of the longest already
    return 1;
  }
  typename Model::template Configuration<double> q;
  Vector<double, Model::equation_count> f;
  Model::residual(typename Model::template Dimensions<double>{}, u, q, f);
  const double size = std::max(longest_length(d), f.cwiseAbs().maxCoeff());
  return size > 0 && std::isfinite(size) ? std::ldexp(1.0, -std::ilogb(size)) : 1.0;
}

}  // namespace detail

/// Every assembly configuration for given dimensions and inputs. The final polynomial's real roots
/// are isolated with a bound of all rounding; what double precision leaves open is repeated in
/// double-double, and what that leaves open is listed once and marked near_singular. Directions
/// among the inputs and dimensions must be unit vectors.
template <typename Model>
[[nodiscard]] Assemblies<Model> assemblies(
    const typename Model::template Dimensions<double>& dimensions,
    const typename Model::template Inputs<double>& inputs) {
  static_assert(Model::rigid, "a degenerate model has no closed form");
  using Dimensions = typename Model::template Dimensions<double>;
  using Inputs = typename Model::template Inputs<double>;
  Assemblies<Model> result;
  if (!is_finite(dimensions) || !is_finite(inputs)) {
    result.status = AssemblyStatus::not_finite;
    return result;
  }
  const double scale = detail::unit_scale<Model>(dimensions, inputs);
  const auto d = detail::scaled_to<Dimensions>(dimensions, scale);
  const auto u = detail::scaled_to<Inputs>(inputs, scale);
  if (!detail::AssemblySearch<Model, double>(d, u, result).run()) {
    (void)detail::AssemblySearch<Model, DoubleDouble>(d, u, result).run();
  }
  if (result.count > 1) {
    detail::sort_assemblies<Model>(d, u, result);
  }
  for (int index = 0; index < result.count; ++index) {
    auto& q = result.configurations[static_cast<std::size_t>(index)];
    q = detail::scaled_to<std::decay_t<decltype(q)>>(q, 1 / scale);
  }
  return result;
}

}  // namespace assur
