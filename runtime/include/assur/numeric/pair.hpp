// Turns arithmetic on one number into the same arithmetic on two numbers at once.
#pragma once

#include <algorithm>
#include <assur/model.hpp>
#include <cmath>
#include <cstddef>

namespace assur::numeric {

/// What holds or does not of each of two numbers; of both, as a bool.
struct PairTruth {
  typedef long long Both __attribute__((vector_size(2 * sizeof(long long))));
  Both both;

  explicit operator bool() const { return (both[0] & both[1]) != 0; }
  friend PairTruth operator&(const PairTruth& a, const PairTruth& b) { return {a.both & b.both}; }
};

/// Two numbers, for what is computed alike of both. A comparison does not hold where one of them is
/// no number.
class Pair {
  typedef double Both __attribute__((vector_size(2 * sizeof(double))));
  Both both_{};

  explicit Pair(Both both) : both_(both) {}

 public:
  Pair() = default;
  Pair(double one) : both_{one, one} {}
  Pair(double first, double second) : both_{first, second} {}

  [[nodiscard]] double operator[](std::size_t lane) const { return both_[lane]; }

  friend Pair operator+(const Pair& a, const Pair& b) { return Pair(a.both_ + b.both_); }
  friend Pair operator-(const Pair& a, const Pair& b) { return Pair(a.both_ - b.both_); }
  friend Pair operator-(const Pair& a) { return Pair(-a.both_); }
  friend Pair operator*(const Pair& a, const Pair& b) { return Pair(a.both_ * b.both_); }
  friend Pair operator/(const Pair& a, const Pair& b) { return Pair(a.both_ / b.both_); }

  // Without a branch: what is larger is as good as random.
  friend Pair max EIGEN_NOT_A_MACRO(const Pair& a, const Pair& b) {
    return Pair(a.both_ < b.both_ ? b.both_ : a.both_);
  }
  friend Pair abs(const Pair& a) { return max EIGEN_NOT_A_MACRO(a, -a); }

  friend PairTruth operator==(const Pair& a, const Pair& b) {
    return {PairTruth::Both(a.both_ == b.both_)};
  }
  friend PairTruth operator<(const Pair& a, const Pair& b) {
    return {PairTruth::Both(a.both_ < b.both_)};
  }
  friend PairTruth operator<=(const Pair& a, const Pair& b) {
    return {PairTruth::Both(a.both_ <= b.both_)};
  }
};

/// One number of a pair, or a number that is one.
[[nodiscard]] inline double lane(const Pair& pair, std::size_t index) { return pair[index]; }
[[nodiscard]] inline double lane(double number, std::size_t /*index*/) { return number; }
template <typename Scalar>
[[nodiscard]] Direction<double> lane(const Direction<Scalar>& direction, std::size_t index) {
  return {lane(direction.cos, index), lane(direction.sin, index)};
}

/// The first of a pair, and another number as the second.
[[nodiscard]] inline Pair paired(const Pair& first, double second) { return {first[0], second}; }
[[nodiscard]] inline Direction<Pair> paired(const Direction<Pair>& first,
                                            const Direction<double>& second) {
  return {paired(first.cos, second.cos), paired(first.sin, second.sin)};
}

}  // namespace assur::numeric
