// Crank angles over a turn.
#pragma once

#include <cstddef>

namespace assur::speed {

/// A turn in equal steps; neither end is a special position.
class CrankAngles {
 public:
  explicit CrankAngles(std::size_t count) : count_(count) {}
  [[nodiscard]] double operator[](std::size_t index) const {
    constexpr double turn = 6.283185307179586;
    return turn * (static_cast<double>(index) + 0.5) / static_cast<double>(count_);
  }
  [[nodiscard]] std::size_t size() const { return count_; }

 private:
  std::size_t count_;
};

}  // namespace assur::speed
