// Exact fractions of small integers.
#pragma once

#include <numeric>

namespace assur::test {

class Fraction {
 public:
  Fraction() = default;
  Fraction(long long number) : above_(number) {}  // NOLINT: whole numbers are fractions

  [[nodiscard]] double value() const {
    return static_cast<double>(above_) / static_cast<double>(below_);
  }

  friend Fraction operator+(const Fraction& a, const Fraction& b) {
    return {a.above_ * b.below_ + b.above_ * a.below_, a.below_ * b.below_};
  }
  friend Fraction operator-(const Fraction& a, const Fraction& b) {
    return {a.above_ * b.below_ - b.above_ * a.below_, a.below_ * b.below_};
  }
  friend Fraction operator*(const Fraction& a, const Fraction& b) {
    return {a.above_ * b.above_, a.below_ * b.below_};
  }
  friend Fraction operator/(const Fraction& a, const Fraction& b) {
    return {a.above_ * b.below_, a.below_ * b.above_};
  }
  friend bool operator==(const Fraction& a, const Fraction& b) {
    return a.above_ == b.above_ && a.below_ == b.below_;
  }
  friend bool operator<(const Fraction& a, const Fraction& b) {
    return a.above_ * b.below_ < b.above_ * a.below_;
  }

 private:
  Fraction(long long above, long long below) : above_(above), below_(below) {
    const long long common = std::gcd(above, below);
    const long long sign = below < 0 ? -1 : 1;
    above_ /= sign * common;
    below_ /= sign * common;
  }

  long long above_ = 0;
  long long below_ = 1;
};

}  // namespace assur::test
