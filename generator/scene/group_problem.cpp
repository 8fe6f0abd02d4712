#include "scene/group_problem.hpp"

#include <assur/assembly.hpp>
#include <assur/kinematics.hpp>
#include <assur/tetrad/models.hpp>
#include <limits>
#include <utility>

namespace assur::generator {

namespace {

/// Calls `use` with the model of a number; models are types, the number comes from the scene.
template <typename Use>
void with_tetrad(int number, Use use) {
  std::apply(
      [&](auto... model) { ((decltype(model)::number == number ? use(model) : void()), ...); },
      tetrad::Models());
}

DimensionValue<double> plain(const DimensionValue<Dual>& value) {
  return {value.is_angle, value.length.value(), {value.angle.cos.value(), value.angle.sin.value()}};
}

std::vector<DimensionValue<Dual>> dimension_values(const GroupProblem& problem) {
  std::vector<DimensionValue<Dual>> values;
  for (const NormalForm<Dual>& link : problem.links) {
    values.insert(values.end(), link.dimensions.begin(),
                  link.dimensions.begin() + link.dimension_count);
  }
  return values;
}

template <typename Variables>
Variables filled(const std::vector<DimensionValue<Dual>>& values) {
  Variables result;
  std::apply(
      [&](auto&... member) {
        std::size_t index = 0;
        (detail::take_value(member, plain(values[index++])), ...);
      },
      result.members());
  return result;
}

/// d(values)/d(parameters), one row a value; an angle's row is that of the angle.
Eigen::MatrixXd gradients(const std::vector<DimensionValue<Dual>>& values, Eigen::Index count) {
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(values.size()), count);
  for (std::size_t row = 0; row < values.size(); ++row) {
    const Eigen::VectorXd gradient =
        values[row].is_angle ? angle_gradient(values[row].angle) : values[row].length.derivatives();
    rows.row(static_cast<Eigen::Index>(row)) = gradient.transpose();
  }
  return rows;
}

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
    state.regularity =
        regularity == Status::ok && moving == Status::ok ? Status::ok : Status::near_singular;
    describe(rates, sensitive, u1, u2, state);
    return state;
  }

  void describe(const Motion<Model, double>& rates, const Sensitivities<Model, double>& sensitive,
                const Vector<double, Model::input_count>& u1,
                const Vector<double, Model::input_count>& u2, GroupState& state) const {
    const Eigen::Index count = problem_.links[0].frame.x.derivatives().size();
    const Eigen::MatrixXd d_gradient = gradients(dimension_values_, count);
    const Eigen::MatrixXd u_gradient = gradients(problem_.inputs, count);
    const Eigen::MatrixXd q_gradient =
        sensitive.to_dimensions * d_gradient + sensitive.to_inputs * u_gradient;

    Poses<double, Model::link_count> poses;
    Model::link_poses(d_, u_, q_, poses);
    Matrix<double, 3 * Model::link_count, Model::unknown_count> p_q;
    Matrix<double, 3 * Model::link_count, Model::dimension_count> p_d;
    Matrix<double, 3 * Model::link_count, Model::input_count> p_u;
    Model::pose_jacobians(d_, u_, q_, p_q, p_d, p_u);
    const Eigen::MatrixXd p_gradient = p_q * q_gradient + p_d * d_gradient + p_u * u_gradient;
    Matrix<double, Model::link_count, 3> v;
    Matrix<double, Model::link_count, 3> a;
    Model::link_velocities(d_, u_, q_, rates.velocity, u1, v);
    Model::link_accelerations(d_, u_, q_, rates.velocity, rates.acceleration, u1, u2, a);
    for (int link = 0; link < Model::link_count; ++link) {
      const Pose<double>& pose = poses[static_cast<std::size_t>(link)];
      const Eigen::Index row = 3 * Eigen::Index{link};
      const Eigen::VectorXd turning = p_gradient.row(row + 2);
      LinkState frame;
      frame.x = Dual(pose.x, p_gradient.row(row).transpose());
      frame.y = Dual(pose.y, p_gradient.row(row + 1).transpose());
      frame.direction = {Dual(pose.direction.cos, -pose.direction.sin * turning),
                         Dual(pose.direction.sin, pose.direction.cos * turning)};
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
        state.slides.push_back(
            {unknown.owner,
             Dual(values[static_cast<std::size_t>(index)], q_gradient.row(index).transpose()),
             rates.velocity(index), rates.acceleration(index)});
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

}  // namespace

GroupSolution solve_tetrad(int model, const GroupProblem& problem) {
  GroupSolution solution;
  with_tetrad(model,
              [&](auto chosen) { solution = ModelState<decltype(chosen)>(problem).solve(); });
  return solution;
}

ModelVerdict tetrad_verdict(int model) {
  ModelVerdict verdict{};
  with_tetrad(model, [&](auto chosen) {
    verdict = {decltype(chosen)::rigid, decltype(chosen)::mobility};
  });
  return verdict;
}

bool tetrad_is_compatible(int model, const GroupProblem& problem) {
  bool compatible = false;
  with_tetrad(
      model, [&](auto chosen) { compatible = ModelState<decltype(chosen)>(problem).compatible(); });
  return compatible;
}

}  // namespace assur::generator
