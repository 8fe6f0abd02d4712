#include "foreign/drive_period.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace assur::mechanism::foreign {

namespace {

/// A turn has a step for each degree, as other programs show it.
constexpr int steps_of_turn = 360;
/// If drives of several speeds have a longer common period, each turn of the fastest keeps a step
/// for every six degrees, so that its path still looks like a curve,
constexpr int fewest_steps_of_turn = 60;
/// within this limit: a sweep of a large mechanism should take seconds.
constexpr int most_steps = 3600;
/// Speeds with a larger ratio have no common period of practical length.
constexpr double most_turns = 10000;

/// The greatest common divisor of speeds that are whole numbers; otherwise the smallest speed.
double common_cycles(const std::vector<double>& cycles) {
  const double least = std::ranges::max(cycles) / most_turns;
  long divisor = 0;
  for (const double each : cycles) {
    const double whole = std::round(each);
    if (std::abs(each - whole) > 1e-9 * each || whole < 1 || whole > 1e9) {
      return std::max(std::ranges::min(cycles), least);
    }
    divisor = std::gcd(divisor, std::lround(whole));
  }
  return std::max(static_cast<double>(divisor), least);
}

}  // namespace

double DrivePeriod::half() const { return cycles_.empty() ? 0 : 30 / common_cycles(cycles_); }

void DrivePeriod::add_hand(const std::string& parameter, double from, double to) {
  if (!hand_ && from < to) {
    hand_ = ForeignSweep{parameter, from, to, steps_of_turn + 1};
  }
}

std::optional<ForeignSweep> DrivePeriod::sweep(const ForeignMechanism& mechanism) const {
  if (mechanism.drives.empty()) {
    return std::nullopt;
  }
  if (cycles_.empty() || !mechanism.moves_in_time()) {
    return hand_;
  }
  const double turns = std::ranges::max(cycles_) / common_cycles(cycles_);
  const int steps = static_cast<int>(std::clamp(2 * std::ceil(fewest_steps_of_turn * turns / 2),
                                                double{steps_of_turn}, double{most_steps}));
  return ForeignSweep{"t", -half(), half(), steps + 1};
}

}  // namespace assur::mechanism::foreign
