// Turns what may become of a set of parameters' values into columns and words of a table.
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace assur::mechanism {

/// What becomes of one set of values.
enum class Outcome : unsigned char {
  regular,
  near_singular,  ///< there is a configuration; the loop Jacobian is nearly singular
  ambiguous,      ///< of a sample: the next configuration is less than three times as far
  beyond_limits,  ///< there are configurations, and none within the limits of joints
  no_assembly,    ///< the links cannot reach
  degenerate,     ///< there are families only
  refused         ///< a formula has no value there, or the solver throws MechanismError
};
/// The words of the outcomes in a table, in the order of `Outcome`.
inline constexpr std::array<std::string_view, 7> outcome_words = {
    "regular",     "near-singular", "ambiguous", "beyond-limits",
    "no-assembly", "degenerate",    "refused"};

/// A column of a campaign's table: what its numbers are.
struct Column {
  enum class Kind : unsigned char { whole, outcome, real };
  std::string name;
  Kind kind;
};

}  // namespace assur::mechanism
