// Comparison of an emitted solver's batches with single calls at the same driver positions.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <type_traits>
#include <vector>

namespace batch_scenes {

using Given = assur::support::GivenColumns;

/// A fixed sequence, the same on every machine: multiples of 2^-20 in [0, 1).
class Sequence {
  std::uint64_t state_ = 20261123;

 public:
  double next() {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    return static_cast<double>(state_ >> 44) * 0x1p-20;
  }
};

/// Drivers near the scene's own; far from them; at multiples of 15 degrees and of a quarter, where
/// mechanisms are flat; and some that are not finite.
template <typename Solver>
typename Solver::template Drivers<double> drivers_at(std::size_t instance, Sequence& sequence) {
  typename Solver::template Drivers<double> drivers;
  for (double* position : drivers.positions()) {
    const double part = sequence.next();
    constexpr double step = 3.14159265358979323846 / 12;
    if (instance % 4 == 1) {
      *position = 40 * part - 20;
    } else if (instance % 4 == 2) {
      *position = std::floor(48 * part - 24) * (instance % 8 == 2 ? step : 0.25);
    } else {
      *position *= 0.8 + 0.4 * part;
    }
    if (instance % 101 == 100) {
      *position = instance % 2 == 0 ? std::numeric_limits<double>::quiet_NaN()
                                    : std::numeric_limits<double>::infinity();
    }
  }
  return drivers;
}

/// How many verdicts differ between a batch and single calls, how many configurations were
/// compared, and the largest difference of a number relative to the largest of its configuration.
struct Differences {
  long verdicts = 0, configurations = 0;
  double largest = 0;
};

template <typename Solver, std::size_t Lanes>
Differences compare(std::size_t instances, std::size_t& alone) {
  using assur::Status;
  using Drivers = typename Solver::template Drivers<double>;
  using State = typename Solver::template State<double>;
  constexpr auto most = static_cast<std::size_t>(Solver::max_configurations);
  constexpr std::size_t numbers = assur::support::column_count<State>;
  const std::size_t stride = instances + 3;
  std::vector<Drivers> drivers;
  std::vector<double> given(assur::support::column_count<Drivers> * stride + 1);
  Sequence sequence;
  for (std::size_t instance = 0; instance < instances; ++instance) {
    drivers.push_back(drivers_at<Solver>(instance, sequence));
    assur::support::for_each_column(drivers.back(), [&](double number, std::size_t column) {
      given[column * stride + instance] = number;
    });
  }
  std::vector<assur::AssemblyStatus> status(instances);
  std::vector<int> count(instances), families(instances), mobility(instances), left_out(instances);
  std::vector<Status> regularity(most * stride);
  std::vector<double> states(most * numbers * stride + 1);
  const typename Solver::BatchSolutions result{status.data(),   count.data(),    families.data(),
                                               mobility.data(), left_out.data(), regularity.data(),
                                               states.data(),   stride};
  alone = Solver::template solve_batch<Lanes>(instances, Given{given.data(), stride}, result);

  Differences differ;
  std::array<State, most> found;
  for (std::size_t instance = 0; instance < instances; ++instance) {
    const auto solution = Solver::solve(drivers[instance], found);
    bool same = solution.status == status[instance] && solution.count == count[instance] &&
                solution.families == families[instance] && solution.mobility == mobility[instance];
    if constexpr (!std::is_same_v<typename Solver::Solution, assur::support::Solution>) {
      same = same && solution.left_out == left_out[instance];
    }
    differ.verdicts += same ? 0 : 1;
    for (std::size_t index = 0; same && index < static_cast<std::size_t>(solution.count); ++index) {
      ++differ.configurations;
      differ.verdicts += found[index].regularity == regularity[index * stride + instance] ? 0 : 1;
      double size = 0;
      double largest = 0;
      assur::support::for_each_column(found[index], [&](double number, std::size_t column) {
        const double other = result.column(index, column)[instance];
        if (std::isnan(number) != std::isnan(other)) {
          ++differ.verdicts;
        } else if (!std::isnan(number)) {
          size = (std::max)(size, std::abs(number));
          largest = (std::max)(largest, std::abs(number - other));
        }
      });
      differ.largest = (std::max)(differ.largest, size > 0 ? largest / size : largest);
    }
  }
  return differ;
}

/// The number of rows of a followed batch that differ from single calls of `track`. The positions
/// wander; some are beyond the end of the branch or NaN.
template <typename Solver>
long tracks_that_differ(std::size_t places) {
  using Drivers = typename Solver::template Drivers<double>;
  using State = typename Solver::template State<double>;
  constexpr std::size_t numbers = assur::support::column_count<State>;
  Drivers drivers;
  typename Solver::Branch one_by_one = Solver::branch(drivers, 0);
  typename Solver::Branch together = one_by_one;
  std::vector<Drivers> all;
  std::vector<double> given(assur::support::column_count<Drivers> * places + 1);
  Sequence sequence;
  for (std::size_t place = 0; place < places; ++place) {
    for (double* position : drivers.positions()) {
      *position += (sequence.next() - 0.4) * 0.1 * (1 + std::abs(*position));
    }
    all.push_back(drivers);
    if (place % 7 == 3) {
      *all.back().positions()[0] = std::numeric_limits<double>::quiet_NaN();
    }
    assur::support::for_each_column(all.back(), [&](double number, std::size_t column) {
      given[column * places + place] = number;
    });
  }
  std::vector<assur::Status> statuses(places);
  std::vector<double> states(numbers * places + 1);
  const std::size_t reached = assur::support::track_batch<Solver>(
      places, Given{given.data(), places}, together, {statuses.data(), states.data(), places});
  long differ = 0;
  std::size_t expected = 0;
  for (std::size_t place = 0; place < places; ++place) {
    State state;
    const auto way = Solver::track(all[place], one_by_one, state);
    bool is_row = assur::is_solvable(way.status);
    if constexpr (!std::is_same_v<typename Solver::Track, assur::support::Track>) {
      is_row = is_row && way.within_limits;
    }
    expected += is_row ? 1 : 0;
    differ += is_row == assur::is_solvable(statuses[place]) ? 0 : 1;
    assur::support::for_each_column(state, [&](double number, std::size_t column) {
      const double other = states[column * places + place];
      const bool same =
          is_row ? number == other || (std::isnan(number) && std::isnan(other)) : std::isnan(other);
      differ += same ? 0 : 1;
    });
  }
  return differ + (reached == expected ? 0 : 1) + (places > 1 && expected == 0 ? 1 : 0);
}

/// Prints what differs, for several sizes of batches and packs.
template <typename Solver>
void print_differences(const char* name) {
  Differences all;
  std::size_t alone = 0;
  const auto add = [&](const Differences& some) {
    all.verdicts += some.verdicts;
    all.configurations += some.configurations;
    all.largest = (std::max)(all.largest, some.largest);
  };
  for (const std::size_t instances : {std::size_t{0}, std::size_t{1}, std::size_t{5}}) {
    add(compare<Solver, 4>(instances, alone));
  }
  add(compare<Solver, 4>(ASSUR_INSTANCES, alone));
  all.verdicts += tracks_that_differ<Solver>(0) + tracks_that_differ<Solver>(100);
  std::printf("%s %ld %ld %.3g %zu\n", name, all.verdicts, all.configurations, all.largest, alone);
}

}  // namespace batch_scenes
