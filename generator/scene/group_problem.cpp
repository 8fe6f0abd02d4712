#include "scene/group_problem.hpp"

#include <assur/assembly.hpp>
#include <assur/kinematics.hpp>
#include <assur/second_order.hpp>
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

/// Some quantities as functions of the parameters: gradients, one row a quantity, and a Hessian for
/// each where they are carried.
struct Derivatives {
  Eigen::MatrixXd gradients;
  std::vector<Eigen::MatrixXd> hessians;

  /// The Hessians' entries for parameters i and j, a column in the order of the quantities.
  [[nodiscard]] Eigen::VectorXd mixed(Eigen::Index i, Eigen::Index j) const {
    Eigen::VectorXd column(gradients.rows());
    for (Eigen::Index row = 0; row < column.size(); ++row) {
      column(row) = hessians[static_cast<std::size_t>(row)](i, j);
    }
    return column;
  }
  void set_mixed(Eigen::Index i, Eigen::Index j, const Eigen::VectorXd& column) {
    for (Eigen::Index row = 0; row < column.size(); ++row) {
      Eigen::MatrixXd& hessian = hessians[static_cast<std::size_t>(row)];
      hessian(i, j) = hessian(j, i) = column(row);
    }
  }
  [[nodiscard]] Dual quantity(double value, Eigen::Index row) const {
    const auto slot = static_cast<std::size_t>(row);
    return {value, gradients.row(row).transpose(),
            hessians.empty() ? Eigen::MatrixXd() : hessians[slot]};
  }
};

/// The derivatives of a model's dimensions or inputs; of an angle, those of the angle in radians.
Derivatives derivatives(const std::vector<DimensionValue<Dual>>& values, Eigen::Index count) {
  Derivatives result{Eigen::MatrixXd(static_cast<Eigen::Index>(values.size()), count), {}};
  for (std::size_t row = 0; row < values.size(); ++row) {
    const Dual quantity = values[row].is_angle ? angle_of(values[row].angle) : values[row].length;
    result.gradients.row(static_cast<Eigen::Index>(row)) = quantity.derivatives().transpose();
    if (quantity.has_hessian()) {
      result.hessians.push_back(quantity.hessian());
    }
  }
  return result;
}

/// A link's frame from its pose and the derivatives of (x, y, theta), which stand from `row` on.
LinkState frame_of(const Pose<double>& pose, const Derivatives& p, Eigen::Index row) {
  const Dual turning = p.quantity(0.0, row + 2);
  LinkState frame;
  frame.x = p.quantity(pose.x, row);
  frame.y = p.quantity(pose.y, row + 1);
  frame.direction = turned({Dual(pose.direction.cos), Dual(pose.direction.sin)},
                           Direction<Dual>{cos(turning), sin(turning)});
  return frame;
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
    Poses<double, Model::link_count> poses;
    Model::link_poses(d_, u_, q_, poses);
    Derivatives q;
    Derivatives p;
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
  void follow(const Sensitivities<Model, double>& sensitive, Derivatives& q, Derivatives& p) const {
    const Dual& any = problem_.links[0].frame.x;
    const Eigen::Index count = any.derivatives().size();
    const Derivatives d = derivatives(dimension_values_, count);
    const Derivatives u = derivatives(problem_.inputs, count);
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

  void follow_twice(const Derivatives& d, const Derivatives& u, Derivatives& q,
                    Derivatives& p) const {
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
        (void)order.second(along[static_cast<std::size_t>(i)], along[static_cast<std::size_t>(j)],
                           d.mixed(i, j), u.mixed(i, j), second);
        q.set_mixed(i, j, second.q);
        p.set_mixed(i, j, second.p);
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
