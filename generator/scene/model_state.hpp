// Turns a group's problem into the states of its links, for the generated models of one group.
#pragma once

#include <assur/displacement.hpp>
#include <assur/second_order.hpp>
#include <limits>
#include <tuple>
#include <utility>

#include "scene/model_values.hpp"

namespace assur::generator {

/// One model at one configuration, as states with gradients.
template <typename Model>
class ModelState {
 public:
  explicit ModelState(const GroupProblem& problem)
      : problem_(problem),
        dimension_values_(dimension_values(problem)),
        d_(filled<typename Model::template Dimensions<double>>(dimension_values_)),
        u_(filled<typename Model::template Inputs<double>>(problem.inputs)) {}

  [[nodiscard]] bool compatible() const {
    if constexpr (Model::compatibility_count > 0) {
      Matrix<double, Model::compatibility_count, 2> c;
      Model::compatibility(d_, u_, c);
      // Directions come from the scene's expressions, a few roundings each.
      constexpr double tolerance = 1e-12;
      return c.col(0).minCoeff() > 0 && c.col(1).cwiseAbs().maxCoeff() < tolerance;
    }
    return true;
  }

  [[nodiscard]] GroupSolution solve() {
    GroupSolution solution;
    if constexpr (Model::rigid) {
      const Assemblies<Model> found = assemblies<Model>(d_, u_);
      solution.status = found.status;
      solution.mobility = found.mobility;
      solution.undecided = found.undecided;
      for (int index = 0; index < found.count; ++index) {
        const auto slot = static_cast<std::size_t>(index);
        solution.states.push_back(state_of(found.configurations[slot], found.regularity[slot]));
      }
    }
    return solution;
  }

 private:
  /// Where the Jacobian has no inverse the rates and gradients are not numbers.
  GroupState state_of(const typename Model::template Configuration<double>& q, Status regularity) {
    q_ = q;
    GroupState state;
    Vector<double, Model::equation_count> f;
    Model::residual(d_, u_, q_, f);
    state.residual = f.cwiseAbs().maxCoeff();
    const Vector<double, Model::input_count> u1 = problem_.input_rates;
    const Vector<double, Model::input_count> u2 = problem_.input_second_rates;
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    Motion<Model, double> rates;
    Sensitivities<Model, double> sensitive;
    const Status moving = motion<Model, double>(d_, u_, q_, u1, u2, rates);
    if (moving != Status::ok && moving != Status::near_singular) {
      rates.velocity.setConstant(unknown);
      rates.acceleration.setConstant(unknown);
    }
    const Status following = sensitivities<Model, double>(d_, u_, q_, sensitive);
    if (following != Status::ok && following != Status::near_singular) {
      sensitive.to_dimensions.setConstant(unknown);
      sensitive.to_inputs.setConstant(unknown);
    }
    const DisplacedGroup<Model> among(d_, u_, problem_.displaced);
    const Status standing = among.regularity(d_, u_, q_).status;
    state.regularity = regularity == Status::ok && moving == Status::ok && standing == Status::ok
                           ? Status::ok
                           : Status::near_singular;
    Matrix<double, Model::unknown_count, Model::equation_count> J_inverse;
    J_inverse.setConstant(unknown);
    if (is_solvable(standing)) {
      Model::inverse_jacobian(d_, u_, q_, J_inverse);
    }
    state.displaced = among.displaced(J_inverse);
    describe(rates, sensitive, u1, u2, state);
    return state;
  }

  void describe(const Motion<Model, double>& rates, const Sensitivities<Model, double>& sensitive,
                const Vector<double, Model::input_count>& u1,
                const Vector<double, Model::input_count>& u2, GroupState& state) const {
    Poses<double, Model::link_count> poses;
    Model::link_poses(d_, u_, q_, poses);
    QuantityDerivatives q;
    QuantityDerivatives p;
    follow(sensitive, q, p);
    Matrix<double, Model::link_count, 3> v;
    Matrix<double, Model::link_count, 3> a;
    Model::link_velocities(d_, u_, q_, rates.velocity, u1, v);
    Model::link_accelerations(d_, u_, q_, rates.velocity, rates.acceleration, u1, u2, a);
    for (int link = 0; link < Model::link_count; ++link) {
      const Pose<double>& pose = poses[static_cast<std::size_t>(link)];
      LinkState frame = frame_of(pose, p, 3 * Eigen::Index{link});
      frame.velocity = v.row(link).transpose();
      frame.acceleration = a.row(link).transpose();
      state.frames.push_back(frame);
    }
    std::array<double, static_cast<std::size_t>(Model::unknown_count)> values{};
    std::apply(
        [&](const auto&... member) {
          std::size_t index = 0;
          ((values[index++] = length_or_zero(member)), ...);
        },
        q_.members());
    for (int index = 0; index < Model::unknown_count; ++index) {
      const ModelUnknown& unknown = Model::unknowns[static_cast<std::size_t>(index)];
      if (!unknown.is_angle) {
        state.slides.push_back({unknown.owner,
                                q.quantity(values[static_cast<std::size_t>(index)], index),
                                rates.velocity(index), rates.acceleration(index)});
      }
    }
  }

  /// How the unknowns and the links' poses follow the parameters, by the chain rule.
  void follow(const Sensitivities<Model, double>& sensitive, QuantityDerivatives& q,
              QuantityDerivatives& p) const {
    const Dual& any = problem_.links[0].frame.x;
    const Eigen::Index count = any.derivatives().size();
    const QuantityDerivatives d = derivatives(dimension_values_, count);
    const QuantityDerivatives u = derivatives(problem_.inputs, count);
    q.gradients = sensitive.to_dimensions * d.gradients + sensitive.to_inputs * u.gradients;
    Matrix<double, 3 * Model::link_count, Model::unknown_count> p_q;
    Matrix<double, 3 * Model::link_count, Model::dimension_count> p_d;
    Matrix<double, 3 * Model::link_count, Model::input_count> p_u;
    Model::pose_jacobians(d_, u_, q_, p_q, p_d, p_u);
    p.gradients = p_q * q.gradients + p_d * d.gradients + p_u * u.gradients;
    if (any.has_hessian()) {
      follow_twice(d, u, q, p);
    }
  }

  void follow_twice(const QuantityDerivatives& d, const QuantityDerivatives& u,
                    QuantityDerivatives& q, QuantityDerivatives& p) const {
    const Eigen::Index count = d.gradients.cols();
    const SecondOrder<Model, double> order(d_, u_, q_);
    std::vector<FirstDerivative<Model, double>> along(static_cast<std::size_t>(count));
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    const Eigen::MatrixXd blank = Eigen::MatrixXd::Constant(count, count, unknown);
    q.hessians.assign(static_cast<std::size_t>(Model::unknown_count), blank);
    p.hessians.assign(static_cast<std::size_t>(3 * Model::link_count), blank);
    for (Eigen::Index i = 0; i < count; ++i) {
      const Status status =
          order.first(d.gradients.col(i), u.gradients.col(i), along[static_cast<std::size_t>(i)]);
      if (status != Status::ok && status != Status::near_singular) {
        return;
      }
    }
    for (Eigen::Index i = 0; i < count; ++i) {
      for (Eigen::Index j = 0; j <= i; ++j) {
        SecondDerivative<Model, double> second;
        if (is_solvable(order.second(along[static_cast<std::size_t>(i)],
                                     along[static_cast<std::size_t>(j)], d.mixed(i, j),
                                     u.mixed(i, j), second))) {
          q.set_mixed(i, j, second.q);
          p.set_mixed(i, j, second.p);
        }
      }
    }
  }

  static double length_or_zero(double length) { return length; }
  static double length_or_zero(const Direction<double>& /*angle*/) { return 0; }

  const GroupProblem& problem_;
  std::vector<DimensionValue<Dual>> dimension_values_;
  typename Model::template Dimensions<double> d_;
  typename Model::template Inputs<double> u_;
  typename Model::template Configuration<double> q_;
};

/// What can be asked of the models of one group, by number.
struct GroupFunctions {
  GroupSolution (*solve)(int model, const GroupProblem& problem);
  ModelVerdict (*verdict)(int model);
  bool (*is_compatible)(int model, const GroupProblem& problem);
};

/// Calls `use` with the model of a number; models are types, the number comes from the scene.
template <typename Models, typename Use>
void with_model(int number, Use use) {
  std::apply(
      [&](auto... model) { ((decltype(model)::number == number ? use(model) : void()), ...); },
      Models());
}

template <typename Models>
[[nodiscard]] GroupFunctions functions_of() {
  return {[](int number, const GroupProblem& problem) {
            GroupSolution solution;
            with_model<Models>(number, [&](auto model) {
              solution = ModelState<decltype(model)>(problem).solve();
            });
            return solution;
          },
          [](int number) {
            ModelVerdict verdict{};
            with_model<Models>(number, [&](auto model) {
              verdict = {decltype(model)::rigid, decltype(model)::mobility};
            });
            return verdict;
          },
          [](int number, const GroupProblem& problem) {
            bool compatible = false;
            with_model<Models>(number, [&](auto model) {
              compatible = ModelState<decltype(model)>(problem).compatible();
            });
            return compatible;
          }};
}

/// One group a source file: each instantiates all models of its group.
[[nodiscard]] GroupFunctions dyad_functions();
[[nodiscard]] GroupFunctions triad_functions();
[[nodiscard]] GroupFunctions tetrad_functions();

}  // namespace assur::generator
