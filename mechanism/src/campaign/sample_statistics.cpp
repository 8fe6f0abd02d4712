// Histogram, mean, covariance and extremes, in one pass.
#include <algorithm>
#include <assur/mechanism/sample_statistics.hpp>
#include <cmath>

namespace assur::mechanism {

Histogram::Histogram(double middle, double scale)
    : middle_(middle),
      width_(std::ldexp(1.0, std::max(-1000, std::ilogb(scale == 0 ? 1e-300 : scale)) - 12)),
      counts_(2 * half) {}

void Histogram::widen() {
  std::vector<std::uint64_t> wider(counts_.size());
  for (std::int64_t place = -half; place < half; ++place) {
    const std::int64_t twice_as_wide = place >> 1;  // rounded down, on either side of the middle
    wider[static_cast<std::size_t>(twice_as_wide + half)] +=
        counts_[static_cast<std::size_t>(place + half)];
  }
  counts_ = std::move(wider);
  width_ *= 2;
}

void Histogram::add(double number) {
  const double away = number - middle_;
  while (!(away >= -width_ * half && away < width_ * half)) {
    widen();
  }
  ++counts_[static_cast<std::size_t>(static_cast<std::int64_t>(std::floor(away / width_)) + half)];
}

std::vector<Histogram::Bar> Histogram::bars(std::size_t most) const {
  const auto is_used = [](std::uint64_t count) { return count > 0; };
  const auto first = std::ranges::find_if(counts_, is_used) - counts_.begin();
  const auto last =
      std::find_if(counts_.rbegin(), counts_.rend(), is_used).base() - counts_.begin();
  const auto most_bars = static_cast<std::ptrdiff_t>(most);
  const std::ptrdiff_t together =
      std::max<std::ptrdiff_t>(1, (last - first + most_bars - 1) / most_bars);
  std::vector<Bar> bars;
  for (std::ptrdiff_t from = first; from < last; from += together) {
    const std::ptrdiff_t to = std::min(from + together, last);
    std::uint64_t count = 0;
    for (std::ptrdiff_t place = from; place < to; ++place) {
      count += counts_[static_cast<std::size_t>(place)];
    }
    bars.push_back({middle_ + width_ * static_cast<double>(from - half),
                    middle_ + width_ * static_cast<double>(to - half), count});
  }
  return bars;
}

PointStatistics::PointStatistics(const Eigen::Vector2d& nominal)
    : nominal_(nominal),
      least_(Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity())),
      greatest_(-least_),
      histograms_{Histogram(nominal.x(), nominal.norm() * 1e-12),
                  Histogram(nominal.y(), nominal.norm() * 1e-12)} {}

void PointStatistics::add(const Eigen::Vector2d& position) {
  ++count_;
  const Eigen::Vector2d away = position - nominal_;
  const Eigen::Vector2d from_old_mean = away - mean_;
  mean_ += from_old_mean / static_cast<double>(count_);
  moments_ += from_old_mean * (away - mean_).transpose();
  least_ = least_.cwiseMin(position);
  greatest_ = greatest_.cwiseMax(position);
  histograms_[0].add(position.x());
  histograms_[1].add(position.y());
}

Eigen::Matrix2d PointStatistics::covariance() const {
  if (count_ < 2) {
    return Eigen::Matrix2d::Zero();
  }
  const Eigen::Matrix2d sum = (moments_ + moments_.transpose()) / 2;
  return sum / static_cast<double>(count_ - 1);
}

}  // namespace assur::mechanism
