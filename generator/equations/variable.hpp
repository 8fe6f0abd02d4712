// Variables of equations: symbols of unknowns, link dimensions and inputs with their rates.
#pragma once

#include <ginac/ginac.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace assur::generator::equations {

/// A vector in the plane, or the (cos, sin) pair of an angle.
struct Vector2 {
  GiNaC::ex x;
  GiNaC::ex y;
};

/// A length or an angle. An angle never occurs itself: equations contain its cosine and sine as two
/// symbols, so that every equation is a polynomial and exact at rational points of the circle.
struct Variable {
  enum class Quantity : unsigned char { length, angle };

  Variable(std::string name, Quantity quantity, std::string meaning);

  [[nodiscard]] bool is_angle() const { return quantity == Quantity::angle; }
  /// (cos, sin) of an angle.
  [[nodiscard]] Vector2 direction() const { return {cosine, sine}; }

  std::string name;     ///< `theta_BCG`, `s_C`, `BC`, `x_B`: an identifier of the emitted code
  Quantity quantity;    ///< a length in the user's unit, or an angle in radians
  std::string meaning;  ///< one descriptive phrase
  GiNaC::symbol value;  ///< for a length
  GiNaC::symbol size;   ///< |value|, for bounds
  GiNaC::symbol cosine, sine;  ///< for an angle
  GiNaC::symbol rate;          ///< first time derivative: `omega_BCG`, `v_s_C`
  GiNaC::symbol second_rate;   ///< second time derivative: `alpha_BCG`, `a_s_C`
  GiNaC::symbol third_rate;    ///< third time derivative: `jerk_BCG`, `j_s_C`
};

using VariableList = std::vector<const Variable*>;

/// d(expression)/d(variable), where for an angle d cos = -sin and d sin = cos.
[[nodiscard]] GiNaC::ex partial(const GiNaC::ex& expression, const Variable& variable);

/// A formal sum of angles, in which angles can cancel before the sum becomes cosines and sines.
class AngleSum {
 public:
  AngleSum() = default;
  explicit AngleSum(const Variable& angle) { add(angle, 1); }

  AngleSum& add(const Variable& angle, int factor);
  friend AngleSum operator+(AngleSum left, const AngleSum& right);
  friend AngleSum operator-(AngleSum left, const AngleSum& right);

  /// (cos, sin) of the sum, expanded by the addition theorems.
  [[nodiscard]] Vector2 direction() const;
  /// The factor of one angle: d(sum)/d(angle).
  [[nodiscard]] int factor(const Variable& angle) const;
  /// The angles with their factors, by name.
  [[nodiscard]] std::vector<std::pair<const Variable*, int>> terms() const;
  /// `theta_BCG + psi_G_BCG`; `0` if empty.
  [[nodiscard]] std::string text() const;

 private:
  struct Entry {
    const Variable* angle;
    int factor;
  };
  std::map<std::string, Entry> terms_;  // by name, so that the order is the same in every process
};

}  // namespace assur::generator::equations
