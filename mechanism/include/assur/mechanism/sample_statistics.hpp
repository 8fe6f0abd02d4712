// Means, deviations, extremes and histograms of a point's positions in many samples.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace assur::mechanism {

/// A histogram of a coordinate with a fixed number of bins. Their width is a power of two, which
/// doubles until all numbers lie inside, so that the result depends on the numbers but not on their
/// order.
class Histogram {
 public:
  /// Bins on either side of the middle.
  static constexpr std::int64_t half = 2048;

  /// A histogram about a middle; `scale` is a width not larger than the range of the numbers.
  Histogram(double middle, double scale);
  void add(double number);

  /// The number of values in a range.
  struct Bar {
    double from, to;
    std::uint64_t count;
  };
  /// The counts from the least number to the greatest, in `most` bars or fewer.
  [[nodiscard]] std::vector<Bar> bars(std::size_t most) const;

 private:
  void widen();

  double middle_, width_;
  std::vector<std::uint64_t> counts_;
};

/// Mean, deviation and extremes of a point's coordinates about a nominal position, in one pass.
class PointStatistics {
 public:
  explicit PointStatistics(const Eigen::Vector2d& nominal);
  void add(const Eigen::Vector2d& position);

  [[nodiscard]] std::uint64_t count() const { return count_; }
  /// The mean of the deviations from the nominal position.
  [[nodiscard]] const Eigen::Vector2d& mean_shift() const { return mean_; }
  /// The covariance of the sample, divided by count - 1; zero for fewer than two points.
  [[nodiscard]] Eigen::Matrix2d covariance() const;
  /// The least and the greatest coordinates of the positions.
  [[nodiscard]] const Eigen::Vector2d& least() const { return least_; }
  [[nodiscard]] const Eigen::Vector2d& greatest() const { return greatest_; }
  [[nodiscard]] const Histogram& histogram(std::size_t coordinate) const {
    return histograms_[coordinate];
  }

 private:
  Eigen::Vector2d nominal_;
  std::uint64_t count_ = 0;
  Eigen::Vector2d mean_ = Eigen::Vector2d::Zero();
  Eigen::Matrix2d moments_ = Eigen::Matrix2d::Zero();
  Eigen::Vector2d least_, greatest_;
  std::array<Histogram, 2> histograms_;
};

}  // namespace assur::mechanism
