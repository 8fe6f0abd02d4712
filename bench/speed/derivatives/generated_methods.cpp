// The generated functions in three scalars, and special points, as entries of the derivative tasks.
#include <assur/special_points.hpp>

#include "derivatives/derivative_methods.hpp"

namespace assur::speed {

namespace {

template <typename Scalar>
void add_in(DerivativeTask& task, Wanted wanted, const std::string& scalar) {
  using Sample = TetradSample<Scalar>;
  const char* name = "generated";
  switch (wanted) {
    case Wanted::jacobian:
      task.add<Scalar>(name, scalar, [](const Sample& sample) {
        JacobianAnswer<Scalar> answer;
        Model01::jacobian(sample.g.d, sample.g.u, sample.g.q, answer.by_unknowns);
        return answer;
      });
      return;
    case Wanted::closure:
      task.add<Scalar>(name, scalar, [](const Sample& sample) {
        ClosureAnswer<Scalar> answer;
        Model01::jacobian(sample.g.d, sample.g.u, sample.g.q, answer.by_unknowns);
        Model01::dimension_jacobian(sample.g.d, sample.g.u, sample.g.q, answer.by_dimensions);
        Model01::input_jacobian(sample.g.d, sample.g.u, sample.g.q, answer.by_inputs);
        return answer;
      });
      return;
    case Wanted::motion:
      task.add<Scalar>(name, scalar, [](const Sample& sample) {
        MotionAnswer<Scalar> answer;
        const auto& g = sample.g;
        Model01::motion(g.d, g.u, g.q, g.u_rate, g.u_second_rate, answer.motion.velocity,
                        answer.motion.acceleration);
        return answer;
      });
      return;
    case Wanted::derivatives:
      task.add<Scalar>(name, scalar, [](const Sample& sample) {
        DerivativesAnswer<Scalar> answer;
        const auto& g = sample.g;
        Model01::sensitivities_and_motion(
            g.d, g.u, g.q, g.u_rate, g.u_second_rate, answer.sensitivities.to_dimensions,
            answer.sensitivities.to_inputs, answer.motion.velocity, answer.motion.acceleration);
        return answer;
      });
      return;
  }
}

}  // namespace

void add_generated(DerivativeTask& task, Wanted wanted) {
  add_in<double>(task, wanted, "double");
  add_in<float>(task, wanted, "float");
  add_in<long double>(task, wanted, "long double");
  using Sample = TetradSample<double>;
  if (wanted == Wanted::derivatives) {
    task.add<double>("generated, with status", "double", [](const Sample& sample) {
      DerivativesAnswer<double> answer;
      const auto& g = sample.g;
      answer.status = sensitivities_and_motion<Model01, double>(
          g.d, g.u, g.q, g.u_rate, g.u_second_rate, answer.sensitivities, answer.motion);
      return answer;
    });
  }
  if (wanted == Wanted::motion) {
    task.add<double>("special points", "double", [](const Sample& sample) {
      MotionAnswer<double> answer;
      const auto& g = sample.g;
      answer.status = special_point_motion<Model01, double>(g.d, g.u, g.q, g.u_rate,
                                                            g.u_second_rate, answer.motion);
      return answer;
    });
  }
}

}  // namespace assur::speed
