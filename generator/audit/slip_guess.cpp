#include "audit/slip_guess.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <sstream>

#include "closures/formula_text.hpp"
#include "equations/symbols.hpp"

namespace assur::generator::audit {

namespace {

class Guesser {
 public:
  Guesser(const ComputedMatrix& matrix, std::size_t entry, const closures::ClosureSystem& system)
      : matrix_(matrix), entry_(entry), derived_(matrix.derived[entry]), system_(system) {}

  std::string run() const {
    using Group = std::string (Guesser::*)() const;
    constexpr std::array<Group, 10> groups = {&Guesser::multiples, &Guesser::places,
                                              &Guesser::terms,     &Guesser::angles,
                                              &Guesser::degrees,   &Guesser::symbols,
                                              &Guesser::factors,   &Guesser::constant_factor,
                                              &Guesser::stale,     &Guesser::single_precision};
    if (holds(derived_)) {
      return single_precision();  // too small a difference to distinguish slips
    }
    for (const Group group : groups) {
      if (std::string text = (this->*group)(); !text.empty()) {
        return text;
      }
    }
    return "";
  }

 private:
  /// Whether two numbers agree within the error of the guess, modulo `period` if not zero.
  [[nodiscard]] bool alike(double computed, const RoundedValue& guess, double period) const {
    const double off = computed - guess.value;
    return std::abs(period > 0 ? std::remainder(off, period) : off) <=
           matrix_.slack * (guess.error + std::abs(computed) * 1e-3);
  }

  [[nodiscard]] double turn(std::size_t entry) const {
    return matrix_.angles[entry] ? 2 * std::numbers::pi : 0;
  }

  /// Whether an entry is this expression at all points.
  [[nodiscard]] bool holds(std::size_t entry, const GiNaC::ex& guess, double period) const {
    try {
      for (std::size_t at = 0; at < matrix_.points.size(); ++at) {
        const RoundedValue value = rounded_value(guess, matrix_.points[at]);
        if (!std::isfinite(value.value) || !alike(matrix_.computed[at][entry], value, period)) {
          return false;
        }
      }
    } catch (const std::exception&) {
      return false;  // no value at some point
    }
    return true;
  }
  [[nodiscard]] bool holds(std::size_t entry, const GiNaC::ex& guess) const {
    return holds(entry, guess, turn(entry));
  }
  [[nodiscard]] bool holds(const GiNaC::ex& guess) const { return holds(entry_, guess); }

  [[nodiscard]] std::string name(std::size_t entry) const {
    return "(" + std::to_string(entry / matrix_.columns + 1) + "," +
           std::to_string(entry % matrix_.columns + 1) + ")";
  }

  [[nodiscard]] std::string multiples() const {
    if (holds(0)) {
      return "it is always zero";
    }
    if (holds(-derived_)) {
      return "the sign is wrong";
    }
    for (const auto& [above, below] : std::initializer_list<std::pair<int, int>>{
             {2, 1}, {1, 2}, {-2, 1}, {-1, 2}, {3, 1}, {1, 3}, {4, 1}, {1, 4}}) {
      const GiNaC::numeric factor(above, below);
      if (holds(factor * derived_)) {
        return "it is " + closures::formula_text(factor) + " times what it should be";
      }
    }
    return "";
  }

  /// The factors that a product may have too many or too few of.
  [[nodiscard]] std::vector<GiNaC::ex> factor_list() const {
    std::vector<GiNaC::ex> list;
    for (const closures::AuditSymbol& symbol : system_.symbols()) {
      if (!symbol.angle) {
        list.emplace_back(symbol.symbol);
      }
      if (symbol.moving) {
        list.emplace_back(symbol.rate);
        list.emplace_back(symbol.second_rate);
      }
    }
    for (const closures::AuditSymbol& symbol : system_.symbols()) {
      if (symbol.angle) {
        list.push_back(GiNaC::cos(symbol.symbol));
        list.push_back(GiNaC::sin(symbol.symbol));
      }
    }
    return list;
  }

  [[nodiscard]] std::string factors() const {
    for (const GiNaC::ex& factor : factor_list()) {
      for (const auto& [all, what] : std::initializer_list<std::pair<GiNaC::ex, std::string>>{
               {1 / factor, "the factor " + closures::formula_text(factor) + " is missing"},
               {factor, "the factor " + closures::formula_text(factor) + " is too many"},
               {1 / (factor * factor),
                "the factor " + closures::formula_text(factor * factor) + " is missing"}}) {
        if (holds(derived_ * all)) return what;
        if (holds(-derived_ * all)) return what + ", and the sign is wrong";
      }
    }
    return "";
  }

  /// A number that is the same at all points, computed where the entry is largest.
  [[nodiscard]] std::string constant_factor() const {
    double largest = 0;
    double factor = 0;
    for (std::size_t at = 0; at < matrix_.points.size(); ++at) {
      const double value = value_at(at).value;
      if (std::abs(value) > largest) {
        largest = std::abs(value);
        factor = matrix_.computed[at][entry_] / value;
      }
    }
    constexpr int most_digits = 20;
    for (int below = 1; below <= most_digits; ++below) {
      const double above = std::round(factor * below);
      if (above != 0 && std::abs(above) <= most_digits) {
        const GiNaC::numeric simple(static_cast<int>(above), below);
        if (holds(simple * derived_)) {
          return "it is " + closures::formula_text(simple) + " times what it should be";
        }
      }
    }
    if (largest == 0 || matrix_.angles[entry_] || !holds(GiNaC::numeric(factor) * derived_)) {
      return "";
    }
    std::ostringstream text;
    text.precision(8);
    text << factor;
    return "it is " + text.str() + " times what it should be, at all points";
  }

  /// The derived value; with infinite error where there is none.
  [[nodiscard]] RoundedValue value_at(std::size_t at) const {
    try {
      return rounded_value(derived_, matrix_.points[at]);
    } catch (const std::exception&) {
      return {0, std::numeric_limits<double>::infinity()};
    }
  }

  /// Names single precision if the errors have its size, above that of double; else empty.
  [[nodiscard]] std::string single_precision() const {
    constexpr double unit = 0x1p-24;
    constexpr double in_double = 1e-10;
    constexpr double in_single = 1e-5;
    constexpr double other_orders = 16;
    double largest = 0;
    double off = 0;
    for (std::size_t at = 0; at < matrix_.points.size(); ++at) {
      const RoundedValue value = value_at(at);
      const double difference = matrix_.computed[at][entry_] - value.value;
      const double here =
          std::abs(matrix_.angles[entry_] ? std::remainder(difference, turn(entry_)) : difference);
      if (!(here <= value.error * unit * other_orders)) {
        return "";
      }
      largest = std::max(largest, std::abs(value.value));
      off = std::max(off, here);
    }
    if (off <= in_double * largest || off > in_single * largest) {
      return "";
    }
    const double unit_of_digit = std::pow(10, std::floor(std::log10(off)));
    std::ostringstream text;
    text.precision(1);
    text << std::ceil(off / unit_of_digit) * unit_of_digit;
    return "it agrees to " + text.str() +
           " at all points: is it computed in single precision "
           "(float)?";
  }

  /// Whether each affected entry has the expected value of another place, given by `other`.
  [[nodiscard]] bool all_hold(const std::vector<std::size_t>& affected,
                              const std::function<std::size_t(std::size_t)>& other) const {
    return std::ranges::all_of(
        affected, [&](std::size_t entry) { return holds(entry, matrix_.derived[other(entry)]); });
  }

  [[nodiscard]] std::string places() const {
    const std::size_t columns = matrix_.columns;
    const std::size_t row = entry_ / columns;
    const std::size_t column = entry_ % columns;
    std::vector<std::size_t> all;
    std::vector<std::size_t> in_row;
    std::vector<std::size_t> in_column;
    for (std::size_t entry = 0; entry < matrix_.derived.size(); ++entry) {
      all.push_back(entry);
      if (entry / columns == row) in_row.push_back(entry);
      if (entry % columns == column) in_column.push_back(entry);
    }
    const auto turned = [&](std::size_t entry) {
      return entry % columns * columns + entry / columns;
    };
    if (matrix_.rows == columns && all_hold(all, turned)) {
      return "the matrix is transposed";
    }
    for (std::size_t other = 0; other < matrix_.rows; ++other) {
      if (columns > 1 && other != row &&
          all_hold(in_row, [&](std::size_t entry) { return other * columns + entry % columns; })) {
        return "row " + std::to_string(row + 1) + " is what row " + std::to_string(other + 1) +
               " should be";
      }
    }
    for (std::size_t other = 0; other < columns; ++other) {
      if (matrix_.rows > 1 && other != column && all_hold(in_column, [&](std::size_t entry) {
            return entry / columns * columns + other;
          })) {
        return "column " + std::to_string(column + 1) + " is what column " +
               std::to_string(other + 1) + " should be";
      }
    }
    for (const std::size_t other : all) {
      if (other != entry_ && !matrix_.derived[other].is_zero() && holds(matrix_.derived[other])) {
        const bool exchanged = holds(other, derived_);
        return (exchanged ? "it is exchanged with " : "it is what should stand at ") + name(other);
      }
    }
    return "";
  }

  [[nodiscard]] std::string terms() const {
    const GiNaC::ex expanded = derived_.expand();
    if (!GiNaC::is_a<GiNaC::add>(expanded)) {
      return "";
    }
    for (const GiNaC::ex& term : closures::ordered_operands(expanded)) {
      const std::string text = closures::formula_text(term);
      if (holds(derived_ - term)) return "the term " + text + " is missing";
      if (holds(derived_ - 2 * term)) return "the term " + text + " has the wrong sign";
      if (holds(derived_ + term)) return "the term " + text + " occurs twice";
      if (holds(derived_ - term / 2)) return "the term " + text + " lacks a factor of 2";
    }
    return "";
  }

  [[nodiscard]] std::vector<GiNaC::symbol> used(bool angles) const {
    const GiNaC::exset occurring = equations::symbols_of(derived_);
    std::vector<GiNaC::symbol> list;
    for (const closures::AuditSymbol& symbol : system_.symbols()) {
      if (symbol.angle == angles && occurring.contains(symbol.symbol)) {
        list.push_back(symbol.symbol);
      }
    }
    return list;
  }

  [[nodiscard]] std::string angles() const {
    for (const GiNaC::symbol& angle : used(true)) {
      const GiNaC::ex quarter = GiNaC::Pi / 2;
      const std::string name = angle.get_name();
      // sin(x + pi/2) is cos x, and cos(pi/2 - x) is sin x.
      const GiNaC::exmap exchanged = {{GiNaC::sin(angle), GiNaC::cos(angle)},
                                      {GiNaC::cos(angle), GiNaC::sin(angle)}};
      if (holds(derived_.subs(exchanged)) || holds(derived_.subs(angle == quarter - angle))) {
        return "sine and cosine of " + name + " are exchanged";
      }
      if (holds(derived_.subs(angle == -angle))) {
        return "the angle " + name + " has the wrong sense";
      }
    }
    return "";
  }

  [[nodiscard]] std::string degrees() const {
    GiNaC::exmap all;
    if (matrix_.angles[entry_]) {
      if (holds(entry_, derived_ * 180 / GiNaC::Pi, 360)) {
        return "the angle is in degrees and should be in radians";
      }
      for (const int quarters : {1, 2, 3}) {
        if (holds(derived_ + quarters * GiNaC::Pi / 2)) {
          return "the angle is " + std::to_string(90 * quarters) + " degrees too large";
        }
      }
    }
    for (const auto& [factor, what] : std::initializer_list<std::pair<GiNaC::ex, const char*>>{
             {GiNaC::Pi / 180, " is taken to be in degrees where it is in radians"},
             {180 / GiNaC::Pi, " is taken to be in radians where it is converted to degrees"}}) {
      for (const GiNaC::symbol& angle : used(true)) {
        all[angle] = angle * factor;
        if (holds(derived_.subs(angle == angle * factor)) ||
            holds(derived_.subs(angle == angle * factor) * factor)) {
          return angle.get_name() + what;
        }
      }
      if (holds(derived_.subs(all))) {
        return std::string("every angle") + what;
      }
      if (holds(derived_ * factor)) {
        return "it is per degree and not per radian, or the other way round";
      }
    }
    return "";
  }

  [[nodiscard]] std::string symbols() const {
    for (const bool angle : {true, false}) {
      for (const GiNaC::symbol& one : used(angle)) {
        for (const closures::AuditSymbol& other : system_.symbols()) {
          if (other.angle != angle || other.symbol.is_equal(one)) {
            continue;
          }
          if (holds(derived_.subs(one == other.symbol))) {
            return other.name + " stands where " + one.get_name() + " should";
          }
          if (holds(derived_.subs(GiNaC::exmap{{one, other.symbol}, {other.symbol, one}}))) {
            return one.get_name() + " and " + other.name + " are exchanged";
          }
        }
        if (holds(derived_.subs(one == 0))) {
          return one.get_name() + " is left out, as if it were zero";
        }
      }
    }
    return "";
  }

  [[nodiscard]] std::string stale() const {
    for (std::size_t at = 1; at < matrix_.points.size(); ++at) {
      const double computed = matrix_.computed[at][entry_];
      if (!alike(computed, value_at(at - 1), turn(entry_)) &&
          !alike(computed, value_at(0), turn(entry_))) {
        return "";
      }
    }
    return "it keeps a value from an earlier call";
  }

  const ComputedMatrix& matrix_;
  std::size_t entry_;
  GiNaC::ex derived_;
  const closures::ClosureSystem& system_;
};

}  // namespace

std::string guessed_slip(const ComputedMatrix& matrix, std::size_t entry,
                         const closures::ClosureSystem& system) {
  return Guesser(matrix, entry, system).run();
}

}  // namespace assur::generator::audit
