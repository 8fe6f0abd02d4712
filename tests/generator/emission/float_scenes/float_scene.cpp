// Largest deviations of an emitted solver, ASSUR_SOLVER, in float from the same in double, over a
// turn of its first driver and close to its position in the scene.
#include ASSUR_HEADER
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <numeric>
#include <tuple>
#include <vector>

namespace {

using Solver = assur::scenes::ASSUR_SOLVER;
template <typename Scalar>
using States = std::array<Solver::State<Scalar>, Solver::max_configurations>;

/// The number of numbers in a state before its status. Eigen is told not to align, so none is
/// padding.
constexpr std::size_t numbers = sizeof(Solver::State<float>) / sizeof(float) - 1;
static_assert(numbers == sizeof(Solver::State<double>) / sizeof(double) - 1);

template <typename Scalar>
std::array<double, numbers> numbers_of(const Solver::State<Scalar>& state) {
  std::array<Scalar, numbers> own;
  std::memcpy(own.data(), &state, sizeof(own));
  std::array<double, numbers> result;
  std::copy(own.begin(), own.end(), result.begin());
  return result;
}

/// The same drivers in both scalars, the first of them moved away from its law.
struct Given {
  Solver::Drivers<float> narrow;
  Solver::Drivers<double> wide;

  explicit Given(double by) {
    const auto positions = narrow.positions();
    if (!positions.empty()) {
      *positions.front() += static_cast<float>(by);
    }
    const auto copy = [](const auto& from, const auto& to) {
      for (std::size_t index = 0; index < from.size(); ++index) {
        *to[index] = *from[index];
      }
    };
    copy(narrow.positions(), wide.positions());
    if constexpr (Solver::order > 0) {
      copy(narrow.rates(), wide.rates());
    }
  }
};

/// How far two states are apart: the largest difference of a direction of the reported links.
double distance(Solver::State<float> one, Solver::State<double> other) {
  double farthest = 0;
  const auto look = [&farthest](const auto& direction, const auto& truth) {
    farthest = std::fmax(farthest, std::abs(static_cast<double>(direction.cos) - truth.cos));
    farthest = std::fmax(farthest, std::abs(static_cast<double>(direction.sin) - truth.sin));
  };
  std::apply(
      [&](const auto&... link) {
        std::apply(
            [&](const auto&... truth) { (look(link.pose.direction, truth.pose.direction), ...); },
            other.links.members());
      },
      one.links.members());
  return farthest;
}

/// The angles of the reported links, which are all.
std::vector<double> angles_of(Solver::State<double> state) {
  std::vector<double> angles;
  std::apply(
      [&angles](const auto&... link) {
        (angles.push_back(std::atan2(link.pose.direction.sin, link.pose.direction.cos)), ...);
      },
      state.links.members());
  return angles;
}

/// The sort keys of configurations, from the angles of the links that groups place: the sums of the
/// cosines, of their squares and cubes, and of the sines of the angles between each two of them,
/// and each cosine and sine.
std::vector<double> keys_of(const std::vector<double>& angles) {
  std::vector<double> keys(4, 0);
  for (std::size_t one = 0; one < angles.size(); ++one) {
    for (std::size_t other = one + 1; other < angles.size(); ++other) {
      const double cosine = std::cos(angles[other] - angles[one]);
      const double sine = std::sin(angles[other] - angles[one]);
      keys[0] += cosine;
      keys[1] += cosine * cosine;
      keys[2] += cosine * cosine * cosine;
      keys[3] += sine;
      keys.push_back(cosine);
      keys.push_back(sine);
    }
  }
  return keys;
}

/// The least difference of the keys that are not equal but for rounding, relative to the key or
/// one.
double least_difference(const std::vector<double>& keys, const std::vector<double>& others) {
  double least = 2;
  for (std::size_t place = 0; place < keys.size(); ++place) {
    const double difference =
        std::abs(keys[place] - others[place]) / std::fmax(1, std::abs(keys[place]));
    least = difference > 1e-12 ? std::fmin(least, difference) : least;
  }
  return least;
}

/// Counts of what was compared, and the largest size of each number of a state.
struct Seen {
  int positions = 0, regular = 0, near_singular = 0, refused = 0, wrong = 0, reordered = 0;
  double worst = 0;
  double apart = 0;  ///< how far the keys of a pair that is reordered are apart, at most
  std::array<double, numbers> sizes{};
  /// The links that groups place, whose angle differs between configurations of the same drivers.
  std::vector<bool> turns;

  void measure(const Solver::State<double>& state, const Solver::State<double>& first) {
    const std::vector<double> angles = angles_of(state);
    const std::vector<double> first_angles = angles_of(first);
    turns.resize(angles.size(), false);
    for (std::size_t link = 0; link < angles.size(); ++link) {
      turns[link] = turns[link] || std::abs(angles[link] - first_angles[link]) > 1e-9;
    }
    const auto exact = numbers_of(state);
    for (std::size_t index = 0; index < numbers; ++index) {
      sizes[index] = std::fmax(sizes[index], std::abs(exact[index]));
    }
  }
  /// A number that is zero but for rounding is held against the largest of all.
  void settle_sizes() {
    const double largest = *std::max_element(sizes.begin(), sizes.end());
    for (double& size : sizes) {
      size = size < 1e-9 * largest ? 1e-2 * largest : size;
    }
  }
  /// The largest difference of a number, relative to that number's largest size.
  double difference(const Solver::State<float>& state, const Solver::State<double>& truth) const {
    const auto found = numbers_of(state);
    const auto exact = numbers_of(truth);
    double largest = 0;
    for (std::size_t index = 0; index < numbers; ++index) {
      const double error = std::abs(found[index] - exact[index]);
      largest =
          sizes[index] > 0 && !(error / sizes[index] <= largest) ? error / sizes[index] : largest;
    }
    return largest;
  }
  void compare(const Solver::State<float>& state, const Solver::State<double>& truth) {
    if (state.regularity != assur::Status::ok) {
      ++near_singular;
      return;
    }
    ++regular;
    const double error = difference(state, truth);
    worst = std::fmax(worst, error);
    wrong += std::isnan(error) ? 1 : 0;
  }
  std::vector<double> keys(const Solver::State<double>& state) const {
    const std::vector<double> all = angles_of(state);
    std::vector<double> turning;
    for (std::size_t link = 0; link < all.size(); ++link) {
      if (turns[link]) {
        turning.push_back(all[link]);
      }
    }
    return keys_of(turning);
  }
  /// Compares each state with the nearest truth that is left; the orders may differ where keys of
  /// the order do not differ by more than docs/method/positions.md says.
  void compare(const States<float>& states, const States<double>& truths, int count) {
    std::vector<std::size_t> left(static_cast<std::size_t>(count));
    std::iota(left.begin(), left.end(), 0U);
    for (std::size_t index = 0; index < left.size(); ++index) {
      const auto from = left.begin() + static_cast<std::ptrdiff_t>(index);
      const auto nearest = std::min_element(from, left.end(), [&](auto one, auto other) {
        return distance(states[index], truths[one]) < distance(states[index], truths[other]);
      });
      std::rotate(from, nearest, nearest + 1);  // the others keep their order
      compare(states[index], truths[*from]);
      for (auto passed = from + 1; passed <= nearest; ++passed) {
        ++reordered;
        apart = std::fmax(apart, least_difference(keys(truths[*from]), keys(truths[*passed])));
      }
    }
  }
};

bool is_alike(const Solver::Solution& one, const Solver::Solution& other) {
  return one.status == other.status && one.count == other.count && one.families == other.families;
}

void solve_at(double by, bool measures, Seen& seen) {
  const Given given(by);
  static States<float> narrow;
  static States<double> wide;
  const auto truth = Solver::solve(given.wide, wide);
  if (measures) {
    for (int index = 0; index < truth.count; ++index) {
      seen.measure(wide[static_cast<std::size_t>(index)], wide[0]);
    }
    return;
  }
  ++seen.positions;
  const auto alone = Solver::solve<assur::Unresolved::refuse>(given.narrow, narrow);
  if (alone.status == assur::AssemblyStatus::unresolved) {
    ++seen.refused;
  } else if (!is_alike(alone, truth)) {
    std::printf("  %.9g off: %d configurations, not %d\n", by, alone.count, truth.count);
    ++seen.wrong;
    return;
  }
  if (!is_alike(Solver::solve(given.narrow, narrow), truth)) {
    std::printf("  %.9g off: double was asked, and answers otherwise\n", by);
    ++seen.wrong;
    return;
  }
  seen.compare(narrow, wide, truth.count);
}

/// Follows the first branch, which float must not leave.
void follow(double step, Seen& seen) {
  const Given start(0);
  auto narrow = Solver::branch(start.narrow, 0);
  auto wide = Solver::branch(start.wide, 0);
  Solver::State<float> narrow_state{};
  Solver::State<double> wide_state{};
  for (int steps = 1; steps <= 72; ++steps) {
    const Given given(steps * step);
    const auto found = Solver::track(given.narrow, narrow, narrow_state);
    const auto truth = Solver::track(given.wide, wide, wide_state);
    if (!assur::is_solvable(found.status) || !assur::is_solvable(truth.status)) {
      return;
    }
    seen.compare(narrow_state, wide_state);
  }
}

}  // namespace

int main() {
  std::vector<double> places;
  Given given(0);
  const auto positions = given.wide.positions();
  const double turn =
      ASSUR_TURNS || positions.empty() ? 6.283185307179586 : 0.2 * *positions.front();
  for (int step = 0; step < 360; ++step) {
    places.push_back(step * turn / 360);
  }
  for (double by = 0.1; by > 1e-8; by /= 10) {
    places.push_back(by);
    places.push_back(-by);
  }
  Seen seen;
  for (const bool measures : {true, false}) {
    for (const double by : places) {
      solve_at(by, measures, seen);
    }
    seen.settle_sizes();
  }
  Seen followed = seen;
  followed.worst = 0;
  followed.regular = 0;
  follow(turn / 72, followed);
  std::printf(
      "positions %d, refused %d, regular %d, near-singular %d, worst %.2g, reordered %d by %.2g, "
      "followed %d: %.2g\n",
      seen.positions, seen.refused, seen.regular, seen.near_singular, seen.worst, seen.reordered,
      seen.apart, followed.regular, followed.worst);
  const bool is_right = seen.wrong == 0 && followed.wrong == 0 && seen.worst < 5e-4 &&
                        followed.worst < 5e-4 && seen.apart < 2e-3;
  return is_right ? 0 : 1;
}
