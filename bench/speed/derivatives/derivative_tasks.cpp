// The derivative tasks: random and near-singular tetrads.
#include "derivatives/derivative_methods.hpp"
#include "tasks.hpp"

namespace assur::speed {

namespace {

Task derivative_task(const TetradSamples& samples, const std::string& name, Wanted wanted) {
  DerivativeTask made{samples, {name, samples.list.size(), {}}};
  add_generated(made, wanted);
  add_eigen(made, wanted);
#ifdef ASSUR_CERES
  add_ceres_jet(made, wanted);
#endif
#ifdef ASSUR_ADOL_C
  add_adol_c(made, wanted);
#endif
  add_differences(made, wanted);
  add_complex_step(made, wanted);
  return std::move(made.task);
}

}  // namespace

std::vector<Task> derivative_tasks(const TaskSizes& sizes) {
  const TetradSamples random = random_tetrads(sizes.inputs);
  const TetradSamples singular = near_singular_tetrads(sizes.near_singular);
  std::vector<Task> tasks;
  tasks.push_back(derivative_task(random, "Jacobian", Wanted::jacobian));
  tasks.push_back(derivative_task(random, "Jacobian and parameter derivatives", Wanted::closure));
  tasks.push_back(derivative_task(random, "velocity and acceleration", Wanted::motion));
  tasks.push_back(
      derivative_task(random, "sensitivities, velocity, acceleration", Wanted::derivatives));
  tasks.push_back(derivative_task(singular, "sensitivities, velocity, acceleration, near singular",
                                  Wanted::derivatives));
  return tasks;
}

}  // namespace assur::speed
