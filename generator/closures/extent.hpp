// Bounds on the size of an expression after it is multiplied out.
#pragma once

#include <ginac/ginac.h>

#include <map>

namespace assur::generator::closures {

/// The largest accepted degree, of numerator and denominator together: no mechanism needs a tenth
/// of it, and a number of few digits to this power is computed quickly.
inline constexpr int max_degree = 1000;
/// The largest number of parts of an expression with its abbreviations expanded; comparing it takes
/// seconds.
inline constexpr std::size_t max_parts = 500'000;
/// The largest number of parts of all abbreviations, which are kept in memory.
inline constexpr std::size_t max_parts_in_all = 5'000'000;
/// The largest accepted length of a number, in words of 64 bits.
inline constexpr int max_words = 1024;
/// The largest number of terms that are multiplied out; more would take minutes.
inline constexpr double max_terms = 50000;
/// The limit of terms for the cosine of a sum of angles, which multiplies other terms.
inline constexpr double max_terms_of_direction = 5000;
/// The limit of terms for values with roots of numbers, since one comparison may multiply out
/// thousands of them.
inline constexpr double max_terms_of_value = 2000;
/// The limit of terms for emitted closures: the time to derive their code grows with its square.
inline constexpr double max_terms_emitted = 5000;
/// The limit of nested roots in emitted closures: each derivative of the outermost root contains
/// those of all others.
inline constexpr int max_nesting_emitted = 12;

/// Whether an expression is itself a root, or an angle whose cosine or sine is a root.
[[nodiscard]] bool is_root(const GiNaC::ex& expression);

/// Upper bounds, as floating-point numbers, since they may exceed any integer type. A number of
/// terms beyond all limits may be underestimated, but stays beyond them.
struct Extent {
  double degree = 0;  ///< in symbols and functions, of numerator and denominator together
  double words = 0;   ///< words of 64 bits in the longest number; shorter ones count nothing
  double terms = 1;
  int nesting = 0;  ///< of roots and inverse functions
};

/// The extents of abbreviations, by their symbols.
using Extents = std::map<GiNaC::ex, Extent, GiNaC::ex_is_less>;

/// Measures expressions. An abbreviation counts as its definition.
class ExtentMeter {
 public:
  explicit ExtentMeter(const Extents* abbreviations = nullptr) : abbreviations_(abbreviations) {}

  [[nodiscard]] Extent of(const GiNaC::ex& expression);
  /// The number of different symbols, functions and roots that this meter has measured.
  [[nodiscard]] std::size_t atom_count() const { return atoms_.size(); }

 private:
  [[nodiscard]] Extent of_power(const GiNaC::ex& power);

  const Extents* abbreviations_;
  GiNaC::exset atoms_;
};

/// The number of numbers, symbols and operations in an expression; `most + 1` if there are more.
[[nodiscard]] std::size_t part_count(const GiNaC::ex& expression, std::size_t most = max_parts);

/// Whether an expression without abbreviations has few enough terms to be multiplied out.
[[nodiscard]] bool can_be_multiplied_out(const GiNaC::ex& expression, double most = max_terms);

}  // namespace assur::generator::closures
