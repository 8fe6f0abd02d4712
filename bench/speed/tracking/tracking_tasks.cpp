// The tracking tasks: single steps of driven tetrads.
#include <benchmark/benchmark.h>

#include <Eigen/LU>
#include <memory>

#include "positions/position_samples.hpp"
#include "tasks.hpp"
#include "tracking/tracking_methods.hpp"

namespace assur::speed {

namespace {

TrackingAnswer generated(const TrackingSample& sample) {
  const auto path = [&](double angle) { return sample.at(angle); };
  const auto way = track<Model01>(sample.d, path, sample.from, sample.to, sample.start);
  return {way.status != Status::ok, way.point.q};
}

/// Newton's method from the previous configuration, with the generated elimination in place of LU.
TrackingAnswer generated_newton(const TrackingSample& sample) {
  TrackingAnswer answer{false, sample.start.q};
  const Status status = refine<Model01, double>(sample.d, sample.at(sample.to).u, answer.q);
  answer.reported = !is_solvable(status);
  return answer;
}

/// All configurations, of which the nearest is taken.
TrackingAnswer nearest_of_all(const TrackingSample& sample) {
  const auto set = assemblies<Model01>(sample.d, sample.at(sample.to).u);
  TrackingAnswer answer{true, sample.start.q};
  double least = 10;
  for (int index = 0; index < set.count; ++index) {
    const auto& q = set.configurations[static_cast<std::size_t>(index)];
    if (const double distance = apart(q, sample.start.q); distance < least) {
      least = distance;
      answer = {false, q};
    }
  }
  return answer;
}

TrackingAnswer newton_with_lu(const TrackingSample& sample) {
  const TrackingClosure closure(sample);
  Eigen::Vector4d theta = sample.theta;
  for (int iteration = 0; iteration < 25; ++iteration) {
    const HandVectors vectors = closure.vectors(theta.data());
    const Eigen::Vector4d step = Eigen::PartialPivLU<Eigen::Matrix4d>(vectors.jacobian())
                                     .solve(-vectors.closure(closure.inputs()));
    theta += step;
    if (step.cwiseAbs().maxCoeff() < 1e-8) {  // the step just taken has squared this error
      return at_angles(theta.data());
    }
  }
  return {true, {}};
}

class TrackingTask {
 public:
  TrackingTask(std::string name, TrackingSamples samples)
      : samples_(std::make_shared<const TrackingSamples>(std::move(samples))),
        task_{std::move(name), samples_->list.size(), {}} {}

  template <typename Follow>
  void add(const std::string& method, Follow follow) {
    Entry entry;
    entry.row.task = task_.name;
    entry.row.method = method;
    ErrorTally tally;
    std::size_t unreported = 0;
    for (std::size_t index = 0; index < samples_->list.size(); ++index) {
      const TrackingAnswer answer = follow(samples_->list[index]);
      const auto& end = samples_->ends[index];
      if (answer.reported) {
        // Reporting failure is right where the branch ends; elsewhere it is a missing answer.
        end ? tally.add_failure() : tally.add(0);
        continue;
      }
      const double error = end ? apart(answer.q, *end) : 10;
      tally.add(error);
      unreported += error > 1e-4 ? 1 : 0;
    }
    tally.write_to(entry.row);
    entry.row.unreported = unreported;
    entry.run = [samples = samples_, follow](std::size_t first, std::size_t last) {
      for (std::size_t index = first; index < last; ++index) {
        auto answer = follow(samples->list[index]);
        benchmark::DoNotOptimize(answer);
      }
    };
    task_.entries.push_back(std::move(entry));
  }
  [[nodiscard]] Task take() { return std::move(task_); }

 private:
  std::shared_ptr<const TrackingSamples> samples_;
  Task task_;
};

Task tracking_task(const std::string& name, std::size_t inputs, double step) {
  TrackingTask task(name, random_steps(inputs, step));
  // Functions as lambdas, so that each is inlined into its own loop.
  task.add("generated", [](const TrackingSample& sample) { return generated(sample); });
  task.add("generated, Newton from the neighbour",
           [](const TrackingSample& sample) { return generated_newton(sample); });
  task.add("generated, the nearest of all configurations",
           [](const TrackingSample& sample) { return nearest_of_all(sample); });
  task.add("Newton with Eigen's LU",
           [](const TrackingSample& sample) { return newton_with_lu(sample); });
#ifdef ASSUR_KINSOL
  task.add("KINSOL", track_by_kinsol);
#endif
#ifdef ASSUR_GSL
  task.add("GSL hybridsj", track_by_gsl);
#endif
#ifdef ASSUR_MINPACK
  task.add("MINPACK hybrj", track_by_minpack);
#endif
#ifdef ASSUR_SOLVESPACE
  task.add("SolveSpace", track_by_solvespace);
#endif
  return task.take();
}

}  // namespace

std::vector<Task> tracking_tasks(const TaskSizes& sizes) {
  std::vector<Task> tasks;
  tasks.push_back(tracking_task("tracking, steps of 0.1 rad", sizes.inputs, 0.1));
  tasks.push_back(tracking_task("tracking, steps of 0.3 rad", sizes.inputs, 0.3));
  return tasks;
}

}  // namespace assur::speed
