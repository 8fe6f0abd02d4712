#include "table/targets.hpp"

namespace assur::speed {

const std::vector<Target>& targets() {
  constexpr const char* derivatives = "sensitivities, velocity, acceleration";
  constexpr const char* closure = "Jacobian and parameter derivatives";
  constexpr const char* positions = "all configurations";
  constexpr const char* six_links = "six-link group, all configurations";
  constexpr const char* six_bar = "six-bar, worst case of M, positions known";
  constexpr const char* six_bar_from_crank = "six-bar, worst case of M, from the crank's angle";
  static const std::vector<Target> list = [&] {
    std::vector<Target> made = {
        {derivatives, "generated", "Eigen from angles + LU", Measure::time, 0.17},
        {derivatives, "generated", "Eigen + LU", Measure::time, 0.17},
        {derivatives, "generated", "Ceres Jet + LU", Measure::time, 0.10},
        {derivatives, "generated", "Ceres Jet from angles + LU", Measure::time, 0.10},
        {derivatives, "generated", "central differences, step 6e-06", Measure::time, 0.03},
        {derivatives, "generated", "central differences, step 6e-06", Measure::error, 0.001},
        {closure, "generated", "Eigen from angles", Measure::time, 0.35},
        {closure, "generated", "Ceres Jet", Measure::time, 0.12},
        {closure, "generated", "Ceres Jet from angles", Measure::time, 0.12},
        {positions, "generated", "companion eigenvalues", Measure::time, 0.10},
        {positions, "generated", "half angle, Eigen's polynomial solver", Measure::time, 0.25},
        {positions, "generated", "64-start Newton", Measure::time, 0.006},
        {positions, "generated", "PHCpack, solving alone", Measure::time, 0.0001},
        {positions, "generated", "PHCpack, the whole process", Measure::time, 0.0001},
        {six_links, "emitted", "Eigen, complex eigenproblem 20 x 20", Measure::time, 3},
        {six_links, "emitted", "200-start Newton", Measure::time, 0.05},
        {six_links, "emitted", "PHCpack, solving alone", Measure::time, 0.02},
    };
    for (const char* everyday :
         {"dyad RRR, all configurations", "dyad RRP, all configurations",
          "dyad RPR, all configurations", "slider-crank, position of the slider",
          "four-bar, position of a coupler point", "four-bar, position, velocity, acceleration"}) {
      made.push_back({everyday, "generated", "by hand", Measure::time, 2.5});
    }
    made.push_back({"four-bar, torque and all forces", "generated", "by hand", Measure::time, 2});
    for (const char* forces : {"dyad RRR, forces", "RRR-RRR, forces"}) {
      made.push_back({forces, "generated", "dense LU", Measure::time, 0.06});
    }
    for (const char* tracking : {"tracking, steps of 0.1 rad", "tracking, steps of 0.3 rad"}) {
      made.push_back({tracking, "generated", "Newton with Eigen's LU", Measure::time, 0.45});
      made.push_back({tracking, "generated", "KINSOL", Measure::time, 0.12});
      made.push_back({tracking, "generated", "MINPACK hybrj", Measure::time, 0.12});
    }
    made.push_back(
        {"all configurations, batch", "generated, batch", "generated", Measure::time, 0.2});
    for (const char* dyad :
         {"dyad RRR, all configurations, batch", "dyad RRP, all configurations, batch",
          "dyad RPR, all configurations, batch"}) {
      made.push_back({dyad, "generated, batch", "generated", Measure::time, 0.3});
    }
    made.push_back({"sensitivities, velocity, acceleration, batch", "generated, batch", "generated",
                    Measure::time, 0.35});
    made.push_back({six_bar, "generated", "Ceres Jet + LU", Measure::time, 0.1});
    made.push_back({"sweep of a scene", "assur solve", "emitted", Measure::time, 5});
    made.push_back(
        {six_bar_from_crank, "generated, tracked", "Ceres Jet + LU", Measure::time, 0.1});
    return made;
  }();
  return list;
}

const Row* find_row(const std::vector<Task>& tasks, const std::string& task,
                    const std::string& method) {
  for (const Task& each : tasks) {
    for (const Entry& entry : each.entries) {
      const Row& row = entry.row;
      if (row.task == task && row.method == method && row.scalar == "double") {
        return &row;
      }
    }
  }
  return nullptr;
}

}  // namespace assur::speed
