// The tasks of larger groups: turns of a crank that carries a six-link group or a row of dyads.
#include <benchmark/benchmark.h>

#include <Eigen/Eigenvalues>
#include <assur/scenes/one_dyad.hpp>
#include <assur/scenes/three_dyads.hpp>
#include <assur/scenes/three_pairs.hpp>
#include <assur/scenes/two_dyads.hpp>
#include <memory>
#include <random>
#include <vector>

#include "groups/pinned_bodies.hpp"
#ifdef ASSUR_PHC
#include "phcpack.hpp"
#endif
#include "scenes/crank_angles.hpp"
#include "tasks.hpp"

namespace assur::speed {

namespace {

using SixLinks = scenes::ThreePairs;
using Bodies = PinnedBodies<double>;
using Precise = PinnedBodies<long double>;
using Found = std::vector<Bodies::Coordinates>;

template <typename Solver>
using States = std::array<typename Solver::template State<double>, Solver::max_configurations>;

/// The largest difference of coordinates; angles modulo a turn.
template <typename One, typename Other>
double apart(const One& one, const Other& other) {
  double result = 0;
  for (Eigen::Index place = 0; place < one.size(); ++place) {
    const auto gap = static_cast<long double>(one(place)) - static_cast<long double>(other(place));
    const auto by = place % 3 == 2 ? 2 * std::sin(gap / 2) : gap;
    result = std::max(result, static_cast<double>(std::abs(by)));
  }
  return result;
}

/// Distinct configurations differ by more than this, in radians or units of length.
constexpr double distinct = 1e-6;

template <typename List, typename Coordinates>
void add_new(List& list, const Coordinates& q) {
  const bool is_new = std::none_of(list.begin(), list.end(),
                                   [&](const auto& other) { return apart(other, q) < distinct; });
  if (is_new) {
    list.push_back(q);
  }
}

Found emitted(double crank) {
  States<SixLinks> states;
  SixLinks::Drivers<double> drivers;
  drivers.A.position = crank;
  const SixLinks::Solution solution = SixLinks::solve(drivers, states);
  Found result;
  for (std::size_t index = 0; solution.complete && index < static_cast<std::size_t>(solution.count);
       ++index) {
    const auto& links = states[index].links;
    Bodies::Coordinates q;
    Eigen::Index first = 0;
    for (const auto* link :
         {&links.one, &links.two, &links.three, &links.bar_a, &links.bar_b, &links.bar_c}) {
      const auto& pose = link->pose;
      q.segment<3>(first) << pose.x, pose.y, std::atan2(pose.direction.sin, pose.direction.cos);
      first += 3;
    }
    result.push_back(q);
  }
  return result;
}

/// The solutions that Newton's method reaches from 200 starts, the same for every crank angle.
Found many_starts(double crank) {
  constexpr int starts = 200;
  static const std::vector<Bodies::Coordinates> all = [] {
    std::mt19937 engine(16180);
    std::uniform_real_distribution<double> place(-4, 12);
    std::uniform_real_distribution<double> angle(-3.14, 3.14);
    std::vector<Bodies::Coordinates> made(starts);
    for (Bodies::Coordinates& start : made) {
      for (Eigen::Index at = 0; at < start.size(); ++at) {
        start(at) = at % 3 == 2 ? angle(engine) : place(engine);
      }
    }
    return made;
  }();
  const Bodies bodies(crank);
  Found result;
  for (const Bodies::Coordinates& start : all) {
    Bodies::Coordinates q = start;
    if (bodies.assemble(q)) {
      add_new(result, q);
    }
  }
  return result;
}

/// The union of the configurations that both methods find, each closed by Newton's method in long
/// double.
std::vector<Precise::Coordinates> truth_at(double crank) {
  const Precise bodies(crank);
  std::vector<Precise::Coordinates> result;
  for (const auto& found : {emitted(crank), many_starts(crank)}) {
    for (const Bodies::Coordinates& near : found) {
      Precise::Coordinates q = near.cast<long double>();
      if (bodies.assemble(q)) {
        add_new(result, q);
      }
    }
  }
  return result;
}

/// The largest distance from a true configuration to the nearest found one; a failure where their
/// numbers differ.
double error_of(const Found& found, const std::vector<Precise::Coordinates>& truth) {
  double largest = found.size() == truth.size() ? 0 : std::numeric_limits<double>::infinity();
  for (const Precise::Coordinates& exact : truth) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Bodies::Coordinates& q : found) {
      nearest = std::min(nearest, apart(q, exact));
    }
    largest = std::max(largest, nearest);
  }
  return largest;
}

Entry entry_of(const std::string& task, const std::string& method) {
  Entry entry;
  entry.row.task = task;
  entry.row.method = method;
  return entry;
}

template <typename Find>
Entry found_by(const std::string& task, const std::string& method, const CrankAngles& angles,
               const std::vector<std::vector<Precise::Coordinates>>& truth, Find find) {
  Entry entry = entry_of(task, method);
  ErrorTally tally;
  for (std::size_t index = 0; index < angles.size(); ++index) {
    tally.add(error_of(find(angles[index]), truth[index]));
  }
  tally.write_to(entry.row);
  entry.run = [angles, find](std::size_t first, std::size_t last) {
    for (std::size_t index = first; index < last; ++index) {
      auto found = find(angles[index]);
      benchmark::DoNotOptimize(found);
    }
  };
  return entry;
}

using Matrix20 = Eigen::Matrix<std::complex<double>, 20, 20>;

/// A yardstick, not a method: the eigenvalues and eigenvectors of a full random matrix as large as
/// the largest matrix of a six-link group.
Entry eigenproblems(const std::string& task, std::size_t inputs) {
  Entry entry = entry_of(task, "Eigen, complex eigenproblem 20 x 20");
  std::mt19937 engine(16180);
  std::normal_distribution<double> number;
  std::vector<Matrix20> made(inputs);
  ErrorTally tally;
  for (Matrix20& matrix : made) {
    for (Eigen::Index place = 0; place < matrix.size(); ++place) {
      const double real = number(engine);
      matrix(place) = {real, number(engine)};
    }
    const Eigen::ComplexEigenSolver<Matrix20> solved(matrix);
    const Matrix20 left =
        matrix * solved.eigenvectors() - solved.eigenvectors() * solved.eigenvalues().asDiagonal();
    tally.add(left.cwiseAbs().maxCoeff() / matrix.cwiseAbs().maxCoeff());
  }
  tally.write_to(entry.row);
  entry.run = [matrices = std::make_shared<const std::vector<Matrix20>>(std::move(made))](
                  std::size_t first, std::size_t last) {
    for (std::size_t index = first; index < last; ++index) {
      const Eigen::ComplexEigenSolver<Matrix20> solved((*matrices)[index]);
      Matrix20 vectors = solved.eigenvectors();
      benchmark::DoNotOptimize(vectors);
    }
  };
  return entry;
}

#ifdef ASSUR_PHC
void add_phc(Task& task, const CrankAngles& angles,
             const std::vector<std::vector<Precise::Coordinates>>& truth, std::size_t inputs) {
  const auto closures = [&](std::size_t input) {
    std::vector<SquaredClosure> result;
    for (const Bodies::Bar& bar : Bodies(angles[input]).bars()) {
      result.push_back({bar.first + 1, bar.second + 1, bar.b, bar.g, bar.f, bar.length});
    }
    return result;
  };
  const auto error = [&](std::size_t input, const std::vector<LinkDirections>& answer) {
    const Bodies bodies(angles[input]);
    Found found;
    for (const LinkDirections& z : answer) {
      Bodies::Coordinates q = bodies.standing({z[0], z[1], z[2]});
      if (bodies.assemble(q)) {
        add_new(found, q);
      }
    }
    return error_of(found, truth[input]);
  };
  add_phc_rows(task, inputs, {closures, error});
}
#endif

Task configurations_task(std::size_t inputs, std::size_t phc_inputs) {
  const CrankAngles angles(inputs);
  std::vector<std::vector<Precise::Coordinates>> truth;
  for (std::size_t index = 0; index < angles.size(); ++index) {
    truth.push_back(truth_at(angles[index]));
  }
  Task task{"six-link group, all configurations", inputs, {}};
  task.entries.push_back(found_by(task.name, "emitted", angles, truth, emitted));
  task.entries.push_back(found_by(task.name, "200-start Newton", angles, truth, many_starts));
  task.entries.push_back(eigenproblems(task.name, inputs));
#ifdef ASSUR_PHC
  add_phc(task, angles, truth, std::min(inputs, phc_inputs));
#else
  (void)phc_inputs;
#endif
  return task;
}

/// The start of a branch, and the angle to which it is followed.
template <typename Solver>
struct Step {
  typename Solver::Branch branch;
  double to;
};

template <typename Solver>
auto followed(const Step<Solver>& step, typename Solver::template State<double>& state) {
  typename Solver::template Drivers<double> drivers;
  drivers.A.position = step.to;
  typename Solver::Branch branch = step.branch;
  return Solver::track(drivers, branch, state).status;
}

/// Steps of 0.02 radians around the turn along the first branch at each crank angle.
template <typename Solver>
Entry followed_by(const std::string& task, const std::string& method, std::size_t inputs) {
  constexpr double step = 0.02;
  const CrankAngles angles(4 * inputs);  // some angles have no branch
  auto steps = std::make_shared<std::vector<Step<Solver>>>();
  States<Solver> states;
  typename Solver::template State<double> reached;
  ErrorTally tally;
  for (std::size_t index = 0; index < angles.size() && steps->size() < inputs; ++index) {
    typename Solver::template Drivers<double> drivers;
    drivers.A.position = angles[index];
    if (Solver::solve(drivers, states).count == 0) {
      continue;
    }
    const Step<Solver> made{Solver::branch(drivers, 0), angles[index] + step};
    drivers.A.position = made.to;
    const auto there = Solver::solve(drivers, states);
    if (!is_solvable(followed(made, reached)) || there.count == 0) {
      continue;  // the branch ends
    }
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t other = 0; other < static_cast<std::size_t>(there.count); ++other) {
      const auto& at = states[other].outputs;
      nearest = std::min(nearest, std::max((at.S.position - reached.outputs.S.position).norm(),
                                           (at.T.position - reached.outputs.T.position).norm()));
    }
    tally.add(nearest);
    steps->push_back(made);
  }
  if (steps->size() < inputs) {
    throw std::runtime_error(method + ": too few steps");
  }
  Entry entry = entry_of(task, method);
  tally.write_to(entry.row);
  entry.run = [steps](std::size_t first, std::size_t last) {
    typename Solver::template State<double> state;
    for (std::size_t index = first; index < last; ++index) {
      auto status = followed<Solver>((*steps)[index], state);
      benchmark::DoNotOptimize(status);
      benchmark::DoNotOptimize(state);
    }
  };
  return entry;
}

}  // namespace

std::vector<Task> group_tasks(const TaskSizes& sizes) {
  const std::size_t inputs = std::max<std::size_t>(64, sizes.inputs / 50);
  Task following{"six links, following a branch", inputs, {}};
  following.entries.push_back(
      followed_by<SixLinks>(following.name, "emitted, six-link group", inputs));
  following.entries.push_back(
      followed_by<scenes::ThreeDyads>(following.name, "emitted, three dyads", inputs));
  // Rows of fewer links show how the time grows with their number.
  following.entries.push_back(
      followed_by<scenes::TwoDyads>(following.name, "emitted, two dyads", inputs));
  following.entries.push_back(
      followed_by<scenes::OneDyad>(following.name, "emitted, one dyad", inputs));
  return {configurations_task(inputs, sizes.phc_inputs), following};
}

}  // namespace assur::speed
