// Runs `track` of an emitted solver for every branch along a range of its first driver. For
// inclusion in a program of C++17 that includes solvers.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

namespace assur::test {

/// The solver's states at equal steps of its first driver.
template <typename Solver>
class Following {
  using Drivers = typename Solver::template Drivers<double>;
  using State = typename Solver::template State<double>;
  using States = std::array<State, Solver::max_configurations>;

 public:
  /// `numbers_of` gives a state's lengths and directions, `lengths` says which are lengths.
  template <typename NumbersOf>
  Following(double from, double to, int steps, const NumbersOf& numbers_of,
            const std::vector<bool>& lengths)
      : steps_(steps), lengths_(lengths) {
    for (int step = 0; step <= steps; ++step) {
      Drivers drivers;
      *drivers.positions()[0] = from + (to - from) * step / steps;
      drivers_.push_back(drivers);
      States states;
      const auto found = Solver::solve(drivers, states);
      auto& list = listed_.emplace_back();
      for (int index = 0; index < found.count; ++index) {
        list.push_back(numbers_of(states[static_cast<std::size_t>(index)]));
        for (std::size_t place = 0; place < lengths.size(); ++place) {
          size_ = lengths[place] ? std::max(size_, std::abs(list.back()[place])) : size_;
        }
      }
    }
  }

  /// Follows each configuration of the first step to its branch's end and back; prints the end, the
  /// listed configuration at each step, and the distance between start and return.
  template <typename NumbersOf>
  void print(const NumbersOf& numbers_of) const {
    const int count = static_cast<int>(listed_.front().size());
    std::printf("%d\n", count);
    for (int configuration = 0; configuration < count; ++configuration) {
      auto branch = Solver::branch(drivers_.front(), configuration);
      State state{};
      std::vector<int> places = {configuration};
      double farthest = 0;
      auto way = Solver::track(drivers_.front(), branch, state);
      int step = 1;
      for (; step <= steps_; ++step) {
        way = Solver::track(at(step), branch, state);
        if (!assur::is_solvable(way.status)) {
          break;
        }
        const auto [place, distance] = nearest(step, numbers_of(state));
        places.push_back(place);
        farthest = std::max(farthest, distance);
      }
      const int last = step - 1;
      // A branch that has ended does not go on.
      const bool stays =
          last == steps_ || Solver::track(at(step), branch, state).reached == way.reached;
      for (step = last - 1; step >= 0; --step) {
        const auto back = Solver::track(at(step), branch, state);
        if (!assur::is_solvable(back.status)) {
          farthest = std::numeric_limits<double>::infinity();
        }
      }
      const double missed =
          last == 0 ? 0
                    : distance_between(numbers_of(state),
                                       listed_[0][static_cast<std::size_t>(configuration)]);
      std::printf("%d %d %.17g %d %.3g %.3g", last, static_cast<int>(way.status), way.reached,
                  stays ? 1 : 0, farthest, missed);
      for (const int place : places) {
        std::printf(" %d", place + 1);
      }
      std::printf("\n");
    }
  }

  /// Prints for each configuration 1 if one call over the whole range follows it to its end, or 0.
  void print_at_once() const {
    for (std::size_t configuration = 0; configuration < listed_.front().size(); ++configuration) {
      auto branch = Solver::branch(drivers_.front(), static_cast<int>(configuration));
      State state{};
      const auto way = Solver::track(drivers_.back(), branch, state);
      std::printf("%d ", assur::is_solvable(way.status) ? 1 : 0);
    }
    std::printf("\n");
  }

 private:
  [[nodiscard]] const Drivers& at(int step) const {
    return drivers_[static_cast<std::size_t>(step)];
  }
  /// The largest difference of a number, of lengths relative to the largest length.
  [[nodiscard]] double distance_between(const std::vector<double>& one,
                                        const std::vector<double>& other) const {
    double largest = 0;
    for (std::size_t place = 0; place < one.size(); ++place) {
      const double difference = std::abs(one[place] - other[place]);
      largest = std::max(largest, difference / (lengths_[place] ? size_ : 1));
    }
    return largest;
  }
  /// The index of the nearest listed configuration, and its distance.
  [[nodiscard]] std::pair<int, double> nearest(int step, const std::vector<double>& numbers) const {
    std::pair<int, double> best{-1, std::numeric_limits<double>::infinity()};
    const auto& list = listed_[static_cast<std::size_t>(step)];
    for (std::size_t place = 0; place < list.size(); ++place) {
      const double distance = distance_between(numbers, list[place]);
      if (distance < best.second) {
        best = {static_cast<int>(place), distance};
      }
    }
    return best;
  }

  int steps_;
  std::vector<bool> lengths_;
  double size_ = 0;
  std::vector<Drivers> drivers_;
  std::vector<std::vector<std::vector<double>>> listed_;  ///< [step][configuration][number]
};

}  // namespace assur::test
