// The equations by hand in fixed-size Eigen with LU, from angles and from (cos, sin), as entries of
// the derivative tasks.
#include <cmath>

#include "derivatives/derivative_methods.hpp"
#include "derivatives/eigen_by_hand.hpp"
#include "derivatives/solve_closure.hpp"

namespace assur::speed {

namespace {

using Sample = TetradSample<double>;

struct Directions {
  Eigen::Vector4d c, s;
};

Directions from_angles(const Sample& sample) {
  Directions result;
  for (int index = 0; index < 4; ++index) {
    result.c(index) = std::cos(sample.theta(index));
    result.s(index) = std::sin(sample.theta(index));
  }
  return result;
}

Directions as_given(const Sample& sample) {
  const auto& q = sample.g.q;
  return {{q.theta_BCG.cos, q.theta_EDF.cos, q.theta_CD.cos, q.theta_GF.cos},
          {q.theta_BCG.sin, q.theta_EDF.sin, q.theta_CD.sin, q.theta_GF.sin}};
}

template <Directions (*directions)(const Sample&)>
void add_by_hand(DerivativeTask& task, Wanted wanted, const std::string& method) {
  switch (wanted) {
    case Wanted::jacobian:
      task.add<double>(method, "double", [](const Sample& sample) {
        const Directions at = directions(sample);
        return JacobianAnswer<double>{HandVectors(sample.g.d, at.c, at.s).jacobian()};
      });
      return;
    case Wanted::closure:
      task.add<double>(method, "double", [](const Sample& sample) {
        const Directions at = directions(sample);
        ClosureAnswer<double> f;
        f.by_unknowns = HandVectors(sample.g.d, at.c, at.s).jacobian();
        hand_parameters(at.c, at.s, f);
        return f;
      });
      return;
    case Wanted::motion:
      task.add<double>(method + " + LU", "double", [](const Sample& sample) {
        const Directions at = directions(sample);
        const HandVectors vectors(sample.g.d, at.c, at.s);
        const auto& u_rate = sample.g.u_rate;
        const Eigen::Vector2d v = u_rate.head<2>() - u_rate.tail<2>();
        Eigen::Vector4d first;
        first << v, v;
        return solved_motion<double>(vectors.jacobian(), first, [&](const Eigen::Vector4d& w) {
          return vectors.second_derivative(w, sample.g.u_second_rate);
        });
      });
      return;
    case Wanted::derivatives:
      task.add<double>(method + " + LU", "double", [](const Sample& sample) {
        const Directions at = directions(sample);
        const HandVectors vectors(sample.g.d, at.c, at.s);
        ClosureAnswer<double> f;
        f.by_unknowns = vectors.jacobian();
        hand_parameters(at.c, at.s, f);
        return solved<double>(f, sample.g.u_rate, [&](const Eigen::Vector4d& w) {
          return vectors.second_derivative(w, sample.g.u_second_rate);
        });
      });
      return;
  }
}

}  // namespace

void add_eigen(DerivativeTask& task, Wanted wanted) {
  add_by_hand<from_angles>(task, wanted, "Eigen from angles");
  add_by_hand<as_given>(task, wanted, "Eigen");
}

}  // namespace assur::speed
