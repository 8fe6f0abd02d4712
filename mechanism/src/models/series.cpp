#include "models/series.hpp"

#include <assur/directions.hpp>

namespace assur::mechanism::models {

Series operator+(const Series& a, const Series& b) {
  Series sum;
  for (std::size_t k = 0; k <= Series::order; ++k) {
    sum.c[k] = a.c[k] + b.c[k];
  }
  return sum;
}

Series operator-(const Series& a, const Series& b) { return a + -b; }

Series operator-(const Series& a) {
  Series negative;
  for (std::size_t k = 0; k <= Series::order; ++k) {
    negative.c[k] = -a.c[k];
  }
  return negative;
}

Series operator*(const Series& a, const Series& b) {
  Series product;
  for (std::size_t k = 0; k <= Series::order; ++k) {
    for (std::size_t i = 0; i <= k; ++i) {
      product.c[k] += a.c[i] * b.c[k - i];
    }
  }
  return product;
}

// From cos' = -sin angle' and sin' = cos angle', coefficient by coefficient.
Direction<Series> turning(const Direction<double>& start, const Series& angle) {
  Direction<Series> moving{start.cos, start.sin};
  for (std::size_t k = 1; k <= Series::order; ++k) {
    for (std::size_t i = 1; i <= k; ++i) {
      const double part = static_cast<double>(i) / static_cast<double>(k) * angle.c[i];
      moving.cos.c[k] -= part * moving.sin.c[k - i];
      moving.sin.c[k] += part * moving.cos.c[k - i];
    }
  }
  return moving;
}

double turning_rate(const Direction<Series>& direction) {
  return direction.cos.value() * direction.sin.rate() -
         direction.sin.value() * direction.cos.rate();
}

double second_turning_rate(const Direction<Series>& direction) {
  return direction.cos.value() * direction.sin.second_rate() -
         direction.sin.value() * direction.cos.second_rate();
}

Pose<Series> composed(const Pose<Series>& frame, const Pose<Series>& inner) {
  const auto& [cosine, sine] = frame.direction;
  return {frame.x + cosine * inner.x - sine * inner.y, frame.y + sine * inner.x + cosine * inner.y,
          turned(frame.direction, inner.direction)};
}

Pose<Series> at_rest(const Pose<double>& pose) {
  return {pose.x, pose.y, {pose.direction.cos, pose.direction.sin}};
}

}  // namespace assur::mechanism::models
