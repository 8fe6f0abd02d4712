// Runs one hot function of RRR-RRR 1000 times on fixed inputs, inside `measured`, for callgrind to
// count its instructions: hot_functions NAME.
#include <array>
#include <assur/assembly.hpp>
#include <assur/tetrad/model_01.hpp>
#include <assur/tracking.hpp>
#include <cstring>

namespace {

using Model = assur::tetrad::Model01;

constexpr int repetitions = 1000;

struct State {
  Model::Dimensions<double> d{1.5, 1.2, 0.8, 1.4, 1.1, -0.7, 1.3, 1.6};
  Model::Inputs<double> u{0.1, 0.2, 1.4, -0.3};
  Model::Configuration<double> q;
  assur::Vector<double, 4> u_rate{0.3, -0.4, 0.1, 0.2};
  assur::Vector<double, 4> u_second_rate{0.1, 0.5, -0.2, 0.3};
  assur::Matrix<double, 4, 4> matrix;
  assur::Sensitivities<Model, double> sensitivities;
  assur::Motion<Model, double> motion;
  double sum = 0;  ///< keeps results from being dropped
};

void jacobian(State& s) {
  Model::jacobian(s.d, s.u, s.q, s.matrix);
  s.sum += s.matrix(0, 0);
}
void inverse_jacobian(State& s) {
  Model::inverse_jacobian(s.d, s.u, s.q, s.matrix);
  s.sum += s.matrix(0, 0);
}
void motion(State& s) {
  Model::motion(s.d, s.u, s.q, s.u_rate, s.u_second_rate, s.motion.velocity, s.motion.acceleration);
  s.sum += s.motion.acceleration(0);
}
void sensitivities_and_motion(State& s) {
  s.sum += static_cast<double>(assur::sensitivities_and_motion<Model, double>(
      s.d, s.u, s.q, s.u_rate, s.u_second_rate, s.sensitivities, s.motion));
}
void assemblies(State& s) { s.sum += assur::assemblies<Model>(s.d, s.u).count; }
void track(State& s) {
  const assur::Vector<double, 4> steady = assur::Vector<double, 4>::Zero();
  const auto path = [&](double time) {
    assur::InputMotion<Model> moving{s.u, s.u_rate, steady};
    moving.u.x_B += time * s.u_rate(0);
    moving.u.y_B += time * s.u_rate(1);
    moving.u.x_E += time * s.u_rate(2);
    moving.u.y_E += time * s.u_rate(3);
    return moving;
  };
  const auto start = assur::branch_point<Model>(s.d, path(0), s.q);
  const auto way = assur::track<Model>(s.d, path, 0, 0.1, start);
  s.sum += static_cast<double>(way.status) + way.point.q.theta_BCG.cos;
}

struct Function {
  const char* name;
  void (*run)(State&);
};
constexpr std::array<Function, 6> functions = {{
    {"jacobian", jacobian},
    {"inverse_jacobian", inverse_jacobian},
    {"motion", motion},
    {"sensitivities_and_motion", sensitivities_and_motion},
    {"assemblies", assemblies},
    {"track", track},
}};

}  // namespace

extern "C" __attribute__((noinline)) void measured(void (*run)(State&), State& state) {
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    run(state);
  }
}

int main(int count, char** arguments) {
  State state;
  const auto found = assur::assemblies<Model>(state.d, state.u);
  if (found.count == 0) {
    return 2;
  }
  state.q = found.configurations[0];
  for (const Function& function : functions) {
    if (count == 2 && std::strcmp(arguments[1], function.name) == 0) {
      measured(function.run, state);
      return state.sum == 0.12345 ? 1 : 0;
    }
  }
  return 2;
}
