// Turns arithmetic on one number into the same arithmetic on two numbers at once.
#pragma once

#include <algorithm>
#include <assur/model.hpp>
#include <assur/numeric/precision.hpp>
#include <cmath>
#include <cstddef>
#include <type_traits>

namespace assur::numeric {

/// What holds or does not of each of two numbers; of both, as a bool.
template <typename Both>
struct PairTruth {
  Both both;

  explicit operator bool() const { return (both[0] & both[1]) != 0; }
  friend PairTruth operator&(const PairTruth& a, const PairTruth& b) { return {a.both & b.both}; }
};

/// Two numbers as compilers have them side by side.
template <typename Scalar>
struct TwoOf;
template <>
struct TwoOf<double> {
  typedef double Type __attribute__((vector_size(2 * sizeof(double))));
};
template <>
struct TwoOf<float> {
  typedef float Type __attribute__((vector_size(2 * sizeof(float))));
};

/// Two numbers, for what is computed alike of both. A comparison does not hold where one of them is
/// no number.
template <typename Scalar>
class PairOf {
  using Both = typename TwoOf<Scalar>::Type;
  using Truth = PairTruth<decltype(Both() < Both())>;
  Both both_{};

  explicit PairOf(Both both) : both_(both) {}

 public:
  PairOf() = default;
  PairOf(Scalar one) : both_{one, one} {}
  PairOf(Scalar first, Scalar second) : both_{first, second} {}
  /// A constant of generated code.
  template <
      typename Number,
      std::enable_if_t<std::is_same_v<Number, double> && !std::is_same_v<Scalar, double>, int> = 0>
  PairOf(Number one) : PairOf(static_cast<Scalar>(one)) {}

  [[nodiscard]] Scalar operator[](std::size_t lane) const { return both_[lane]; }

  friend PairOf operator+(const PairOf& a, const PairOf& b) { return PairOf(a.both_ + b.both_); }
  friend PairOf operator-(const PairOf& a, const PairOf& b) { return PairOf(a.both_ - b.both_); }
  friend PairOf operator-(const PairOf& a) { return PairOf(-a.both_); }
  friend PairOf operator*(const PairOf& a, const PairOf& b) { return PairOf(a.both_ * b.both_); }
  friend PairOf operator/(const PairOf& a, const PairOf& b) { return PairOf(a.both_ / b.both_); }

  // Without a branch: what is larger is as good as random.
  friend PairOf max EIGEN_NOT_A_MACRO(const PairOf& a, const PairOf& b) {
    return PairOf(a.both_ < b.both_ ? b.both_ : a.both_);
  }
  friend PairOf abs(const PairOf& a) { return max EIGEN_NOT_A_MACRO(a, -a); }

  friend Truth operator==(const PairOf& a, const PairOf& b) { return {a.both_ == b.both_}; }
  friend Truth operator<(const PairOf& a, const PairOf& b) { return {a.both_ < b.both_}; }
  friend Truth operator<=(const PairOf& a, const PairOf& b) { return {a.both_ <= b.both_}; }
};

using Pair = PairOf<double>;

template <typename Scalar>
struct PartOf<PairOf<Scalar>> {
  using Type = Scalar;
};

/// One number of a pair, or a number that is one.
template <typename Scalar>
[[nodiscard]] Scalar lane(const PairOf<Scalar>& pair, std::size_t index) {
  return pair[index];
}
template <typename Scalar, std::enable_if_t<std::is_floating_point_v<Scalar>, int> = 0>
[[nodiscard]] Scalar lane(Scalar number, std::size_t /*index*/) {
  return number;
}
template <typename Scalar>
[[nodiscard]] auto lane(const Direction<Scalar>& direction, std::size_t index) {
  const auto cos = lane(direction.cos, index);
  return Direction<std::decay_t<decltype(cos)>>{cos, lane(direction.sin, index)};
}

/// The first of a pair, and another number as the second.
[[nodiscard]] inline Pair paired(const Pair& first, double second) { return {first[0], second}; }
[[nodiscard]] inline Direction<Pair> paired(const Direction<Pair>& first,
                                            const Direction<double>& second) {
  return {paired(first.cos, second.cos), paired(first.sin, second.sin)};
}

}  // namespace assur::numeric
