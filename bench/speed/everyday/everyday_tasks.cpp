// The everyday tasks, random dyads and a turn of two cranks: every configuration with certainty
// against code by hand that reports only that a linkage does not close.
#include <benchmark/benchmark.h>

#include <assur/scenes/four_bar_forces.hpp>
#include <assur/scenes/four_bar_motion.hpp>
#include <assur/scenes/four_bar_point.hpp>
#include <assur/scenes/slider_position.hpp>
#include <memory>

#include "everyday/by_hand.hpp"
#include "everyday/four_bar_forces.hpp"
#include "positions/position_error.hpp"
#include "scenes/crank_angles.hpp"
#include "tasks.hpp"

namespace assur::speed {

namespace {

template <typename Model>
Found<Model> listed(const Assemblies<Model>& answer) {
  Found<Model> found;
  for (int index = 0; index < answer.count; ++index) {
    found.add(answer.configurations[static_cast<std::size_t>(index)]);
  }
  return found;
}

template <typename Model>
Found<Model> listed(const Pair<typename Model::template Configuration<double>>& answer) {
  Found<Model> found;
  for (int index = 0; index < answer.count; ++index) {
    found.add(answer.list[static_cast<std::size_t>(index)]);
  }
  return found;
}

template <typename Dyad, typename Find>
void add_dyads(Task& task, const std::shared_ptr<const PositionSamples<Dyad>>& samples,
               const std::string& method, Find find) {
  Entry entry;
  entry.row.task = task.name;
  entry.row.method = method;
  ErrorTally tally;
  for (std::size_t index = 0; index < samples->list.size(); ++index) {
    tally.add(
        position_error<Dyad>(listed<Dyad>(find(samples->list[index])), samples->truth[index]));
  }
  tally.write_to(entry.row);
  entry.run = [samples, find](std::size_t first, std::size_t last) {
    for (std::size_t index = first; index < last; ++index) {
      auto answer = find(samples->list[index]);
      benchmark::DoNotOptimize(answer);
    }
  };
  task.entries.push_back(std::move(entry));
}

template <typename ByHand>
Task dyad_task(const std::string& kind, std::size_t inputs) {
  using Dyad = typename ByHand::Model;
  const auto samples =
      std::make_shared<const PositionSamples<Dyad>>(random_positions<Dyad>(inputs));
  Task task{"dyad " + kind + ", all configurations", inputs, {}};
  add_dyads(task, samples, "generated", [](const PositionSample<Dyad>& sample) {
    return assemblies<Dyad>(sample.d, sample.u);
  });
  add_dyads(task, samples, "by hand",
            [](const PositionSample<Dyad>& sample) { return ByHand()(sample.d, sample.u); });
  return task;
}

/// The largest relative error of the vectors of a configuration.
template <std::size_t Numbers>
double error_of(const std::array<double, Numbers>& found,
                const std::array<Precise, Numbers>& exact) {
  constexpr std::size_t axes = Numbers == 1 ? 1 : 2;
  double largest = 0;
  for (std::size_t first = 0; first < Numbers; first += axes) {
    double off = 0;
    double length = 0;
    for (std::size_t place = first; place < first + axes; ++place) {
      off = std::hypot(off, cln::double_approx(precise(found[place]) - exact[place]));
      length = std::hypot(length, cln::double_approx(exact[place]));
    }
    largest = std::max(largest, off / length);
  }
  return largest;
}

/// The largest error of the listed configuration nearest to each exact one; infinite if fewer are
/// listed.
template <std::size_t Numbers>
double error_of(const Listed<double, Numbers>& found, const Listed<Precise, Numbers>& exact) {
  double largest = found.count == exact.count ? 0.0 : std::numeric_limits<double>::infinity();
  for (int place = 0; place < exact.count; ++place) {
    double nearest = std::numeric_limits<double>::infinity();
    for (int index = 0; index < found.count; ++index) {
      nearest = std::min(nearest, error_of(found.list[static_cast<std::size_t>(index)],
                                           exact.list[static_cast<std::size_t>(place)]));
    }
    largest = std::max(largest, nearest);
  }
  return largest;
}

/// A turn of a crank, and the exact answer at each of its angles.
template <std::size_t Numbers>
struct Turn {
  CrankAngles angles;
  std::vector<Listed<Precise, Numbers>> truth;

  template <typename Exact>
  Turn(std::size_t count, const Exact& exact) : angles(count) {
    for (std::size_t index = 0; index < count; ++index) {
      truth.push_back(exact(precise(angles[index])));
    }
  }
};

template <std::size_t Numbers, typename Find>
void add(Task& task, const Turn<Numbers>& turn, const std::string& method, Find find) {
  Entry entry;
  entry.row.task = task.name;
  entry.row.method = method;
  ErrorTally tally;
  for (std::size_t index = 0; index < turn.truth.size(); ++index) {
    const Listed<double, Numbers> answer = find(turn.angles[index]);
    tally.add(error_of(answer, turn.truth[index]));
  }
  tally.write_to(entry.row);
  entry.run = [angles = turn.angles, find](std::size_t first, std::size_t last) {
    for (std::size_t index = first; index < last; ++index) {
      auto answer = find(angles[index]);
      benchmark::DoNotOptimize(answer);
    }
  };
  task.entries.push_back(std::move(entry));
}

/// The requested quantities of the configurations that a solver lists.
template <typename Solver, std::size_t Numbers, typename Numbered>
Listed<double, Numbers> solved(double crank, const Numbered& numbers_of) {
  typename Solver::template Drivers<double> drivers;
  drivers.A.position = crank;
  std::array<typename Solver::template State<double>, Solver::max_configurations> states;
  Listed<double, Numbers> found;
  found.count = Solver::solve(drivers, states).count;
  for (std::size_t index = 0; index < static_cast<std::size_t>(found.count); ++index) {
    found.list[index] = numbers_of(states[index]);
  }
  return found;
}

/// The dimensions of slider_position.json.
template <typename Scalar>
by_hand::SliderCrank<Scalar> slider_crank() {
  return {Scalar(50), Scalar(160), Scalar(12)};
}

/// The dimensions of four_bar_point.json and four_bar_motion.json.
template <typename Scalar>
by_hand::FourBar<Scalar> four_bar() {
  return {Scalar(80), Scalar(40), Scalar(100), Scalar(100), Scalar(200)};
}
constexpr int crank_velocity = 10;
constexpr int crank_acceleration = 50;

Task slider_task(std::size_t inputs) {
  const Turn<1> turn(inputs, slider_crank<Precise>());
  Task task{"slider-crank, position of the slider", inputs, {}};
  add(task, turn, "generated", [](double angle) {
    using Solver = scenes::SliderPosition;
    return solved<Solver, 1>(angle, [](const Solver::State<double>& state) {
      return std::array<double, 1>{state.slides.S.displacement};
    });
  });
  add(task, turn, "by hand",
      [lengths = slider_crank<double>()](double angle) { return lengths(angle); });
  return task;
}

Task point_task(std::size_t inputs) {
  const Turn<2> turn(inputs,
                     [](const Precise& angle) { return four_bar<Precise>().position(angle); });
  Task task{"four-bar, position of a coupler point", inputs, {}};
  add(task, turn, "generated", [](double angle) {
    using Solver = scenes::FourBarPoint;
    return solved<Solver, 2>(angle, [](const Solver::State<double>& state) {
      const auto& P = state.outputs.P.position;
      return std::array<double, 2>{P(0), P(1)};
    });
  });
  add(task, turn, "by hand",
      [lengths = four_bar<double>()](double angle) { return lengths.position(angle); });
  return task;
}

Task motion_task(std::size_t inputs) {
  const Turn<6> turn(inputs, [](const Precise& angle) {
    return four_bar<Precise>().motion(angle, crank_velocity, crank_acceleration);
  });
  Task task{"four-bar, position, velocity, acceleration", inputs, {}};
  add(task, turn, "generated", [](double angle) {
    using Solver = scenes::FourBarMotion;
    return solved<Solver, 6>(angle, [](const Solver::State<double>& state) {
      const auto& P = state.outputs.P;
      return std::array<double, 6>{P.position(0), P.position(1),     P.velocity(0),
                                   P.velocity(1), P.acceleration(0), P.acceleration(1)};
    });
  });
  const double velocity = crank_velocity;
  const double acceleration = crank_acceleration;
  add(task, turn, "by hand", [lengths = four_bar<double>(), velocity, acceleration](double angle) {
    return lengths.motion(angle, velocity, acceleration);
  });
  return task;
}

/// The numbers of four_bar_forces.json.
template <typename Scalar>
by_hand::LoadedFourBar<Scalar> loaded_four_bar() {
  const auto tenth = [](int number) { return Scalar(number) / Scalar(10); };
  return {four_bar<Scalar>(),
          {tenth(4), Scalar(20), Scalar(0), Scalar(60)},
          {tenth(9), Scalar(50), Scalar(10), Scalar(800)},
          {tenth(8), Scalar(50), Scalar(0), Scalar(700)},
          Scalar(-9810),
          Scalar(200000),
          Scalar(crank_velocity),
          Scalar(crank_acceleration)};
}

Task forces_task(std::size_t inputs) {
  const Turn<14> turn(inputs, loaded_four_bar<Precise>());
  Task task{"four-bar, torque and all forces", inputs, {}};
  add(task, turn, "generated", [](double angle) {
    using Solver = scenes::FourBarForces;
    return solved<Solver, 14>(angle, [](const Solver::State<double>& state) {
      const auto& F = state.forces;
      const auto& ground = state.ground;
      return std::array<double, 14>{
          state.efforts.A, 200000, ground.moment, 200000, F.A(0), F.A(1),          F.B(0),
          F.B(1),          F.C(0), F.C(1),        F.D(0), F.D(1), ground.force(0), ground.force(1)};
    });
  });
  add(task, turn, "by hand",
      [four_bar = loaded_four_bar<double>()](double angle) { return four_bar(angle); });
  return task;
}

}  // namespace

std::vector<Task> everyday_tasks(const TaskSizes& sizes) {
  std::vector<Task> tasks;
  tasks.push_back(dyad_task<by_hand::TwoBars>("RRR", sizes.inputs));
  tasks.push_back(dyad_task<by_hand::BarAndBlock>("RRP", sizes.inputs));
  tasks.push_back(dyad_task<by_hand::Cylinder>("RPR", sizes.inputs));
  tasks.push_back(slider_task(2 * sizes.inputs));
  tasks.push_back(point_task(2 * sizes.inputs));
  tasks.push_back(motion_task(2 * sizes.inputs));
  tasks.push_back(forces_task(2 * sizes.inputs));
  return tasks;
}

}  // namespace assur::speed
