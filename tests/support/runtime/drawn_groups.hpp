// Random groups in general position and on a lattice.
#pragma once

#include <assur/directions.hpp>
#include <assur/variables.hpp>
#include <cmath>
#include <random>

namespace assur::test {

/// Random groups: in general position, or with joints on a lattice, links in a row and slides along
/// few directions.
template <typename Scalar>
class DrawnGroups {
 public:
  DrawnGroups(unsigned start, bool on_lattice) : random_(start), on_lattice_(on_lattice) {}

  template <typename Variables>
  [[nodiscard]] Variables variables() {
    Variables result;
    for_each_member(result, [this](auto& member, std::size_t) { this->draw(member); });
    return result;
  }

 private:
  void draw(Scalar& length) {
    length = on_lattice_ ? static_cast<Scalar>(std::uniform_int_distribution<int>(-3, 3)(random_))
                         : std::uniform_real_distribution<Scalar>(-2, 2)(random_);
  }
  void draw(Direction<Scalar>& angle) {
    constexpr double pi = 3.14159265358979;
    double theta = std::uniform_real_distribution<double>(-pi, pi)(random_);
    if (on_lattice_) {
      const int quarter = std::uniform_int_distribution<int>(0, 3)(random_);
      const bool is_pythagorean = std::uniform_int_distribution<int>(0, 3)(random_) == 0;
      theta = quarter * pi / 2 + (is_pythagorean ? std::atan2(3.0, 4.0) : 0);
    }
    angle = direction_of(static_cast<Scalar>(theta));
    if (on_lattice_) {
      for (Scalar* part : {&angle.cos, &angle.sin}) {
        *part = std::abs(*part) < Scalar(1e-3) ? Scalar(0) : *part;
      }
    }
  }

  std::mt19937 random_;
  bool on_lattice_;
};

}  // namespace assur::test
