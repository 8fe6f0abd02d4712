// The path of a coupler point in all configurations of a four-bar that is built in C++.
#include <assur/mechanism/plan.hpp>
#include <cstdio>

using namespace assur::mechanism;

/// Hoeken's crank-rocker, millimetres, as in examples/four_bar_coupler_curve.json.
Mechanism crank_rocker() {
  Mechanism made("Hoeken's crank-rocker");
  made.add_parameter("crank", 40);
  made.add_parameter("phi", "60*deg");

  made.add_link("ground");
  made.add_point("ground.A", 0, 0);
  made.add_point("ground.D", "2*crank", 0);
  made.add_link("crank");
  made.add_point("crank.A", 0, 0);
  made.add_point("crank.B", "crank", 0);
  made.add_link("coupler");
  made.add_point("coupler.B", 0, 0);
  made.add_point("coupler.C", 100, 0);
  made.add_point("coupler.P", 200, 0);
  made.add_link("rocker");
  made.add_point("rocker.D", 0, 0);
  made.add_point("rocker.C", 100, 0);

  made.add_joint("A", JointType::revolute, {"ground.A", "crank.A"});
  made.add_joint("B", JointType::revolute, {"crank.B", "coupler.B"});
  made.add_joint("C", JointType::revolute, {"coupler.C", "rocker.C"});
  made.add_joint("D", JointType::revolute, {"ground.D", "rocker.D"});
  made.add_driver("A", "phi", 10);  // rad/s
  made.add_output("P", "coupler.P");
  return made;
}

int main() try {
  Request request;
  request.want = {.position = true, .velocity = true, .acceleration = false, .sensitivity = false};
  const Plan plan(crank_rocker(), request);

  // The structure is planned; from here on only numbers change.
  Values values = plan.values();
  const ParameterIndex phi = plan.mechanism().parameter_named("phi", "");
  constexpr double degree = 3.14159265358979323846 / 180;
  for (int turned = 0; turned < 360; turned += 30) {
    values.set(phi, turned * degree);
    const Solution solution = plan.solve(values);
    std::printf("%3d deg:", turned);
    for (const Configuration& configuration : solution.configurations) {
      const Point& point = configuration.output("P");
      std::printf("  P (%8.3f, %8.3f) mm, %8.2f mm/s", point.position.x(), point.position.y(),
                  point.velocity.norm());
    }
    std::printf("\n");
  }
  return 0;
} catch (const MechanismError& error) {
  (void)std::fprintf(stderr, "error: %s\n", error.what());
  return 1;
}
