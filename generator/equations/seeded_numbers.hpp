// Random rational numbers and points of the unit circle, equal on every machine for equal seeds.
#pragma once

#include <ginac/ginac.h>

#include <random>

#include "equations/variable.hpp"

namespace assur::generator::equations {

/// Random numbers from a fixed seed, one after the other.
class SeededNumbers {
 public:
  explicit SeededNumbers(unsigned seed) : engine_(seed) {}

  // std::uniform_int_distribution differs between libraries; derivations and verdicts must not.
  int integer(int low, int high) {
    return low + static_cast<int>(engine_() % static_cast<unsigned>(high - low + 1));
  }
  GiNaC::numeric number() { return quotient(-60, 60); }
  /// A rational point of the unit circle, other than (1, 0).
  Vector2 direction() {
    const GiNaC::numeric t = quotient(1, 60);
    const GiNaC::numeric scale = GiNaC::numeric(1) / (GiNaC::numeric(1) + t * t);
    const GiNaC::numeric sign = integer(0, 1) == 0 ? -1 : 1;
    return {(GiNaC::numeric(1) - t * t) * scale, sign * 2 * t * scale};
  }

 private:
  // Compilers evaluate the operands of a quotient in different orders, so each has its statement.
  GiNaC::numeric quotient(int low, int high) {
    const GiNaC::numeric divisor = integer(1, 30);
    const GiNaC::numeric dividend = integer(low, high);
    return dividend / divisor;
  }

  std::mt19937 engine_;
};

}  // namespace assur::generator::equations
