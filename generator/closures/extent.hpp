// Turns an expression into how large it becomes when it is multiplied out.
#pragma once

#include <map>

#include "closures/closure_system.hpp"

namespace assur::generator::closures {

/// The highest degree that formulas have: no mechanism needs a tenth of it, and numbers of a
/// thousand times their digits still take no time.
inline constexpr int max_degree = 1000;
/// More terms than this are not multiplied out, which would take minutes.
inline constexpr double max_terms = 50000;
/// The same of a value with roots of numbers, of which a comparison may ask for thousands.
inline constexpr double max_terms_of_value = 2000;
/// The same of what is emitted: the time that its code takes to derive grows with the square.
inline constexpr double max_terms_emitted = 5000;

/// Bounds from above, as real numbers: they may be larger than any integer type holds.
struct Extent {
  double degree = 0;  ///< in symbols and functions; long numbers count by their digits
  double terms = 1;
};

/// Measures expressions; what abbreviations stand for counts in full, and is measured once.
class ExtentMeter {
 public:
  /// Without a system there are no abbreviations.
  explicit ExtentMeter(const ClosureSystem* system = nullptr) : system_(system) {}

  [[nodiscard]] Extent of(const GiNaC::ex& expression);
  /// How many different symbols, functions and roots there were in what has been measured.
  [[nodiscard]] std::size_t atom_count() const { return atoms_.size(); }

 private:
  [[nodiscard]] Extent of_power(const GiNaC::ex& power);

  const ClosureSystem* system_;
  std::map<GiNaC::ex, Extent, GiNaC::ex_is_less> known_;  ///< of abbreviations
  GiNaC::exset atoms_;
};

/// Whether an expression without abbreviations has few enough terms to be multiplied out.
[[nodiscard]] bool can_be_multiplied_out(const GiNaC::ex& expression, double most = max_terms);

}  // namespace assur::generator::closures
