// Outcomes of solving sets of parameter values, and the columns of a campaign's table.
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace assur::mechanism {

/// The outcome of solving one set of values.
enum class Outcome : unsigned char {
  regular,
  near_singular,  ///< there is a configuration; the loop Jacobian is nearly singular
  ambiguous,      ///< samples only: the runner-up is less than three times as far from the nominal
  beyond_limits,  ///< there are configurations, and none within the limits of joints
  no_assembly,    ///< the links cannot reach
  degenerate,     ///< there are families only
  refused         ///< a formula has no value there, or the solver throws MechanismError
};
/// The words of the outcomes in a table, in the order of `Outcome`.
inline constexpr std::array<std::string_view, 7> outcome_words = {
    "regular",     "near-singular", "ambiguous", "beyond-limits",
    "no-assembly", "degenerate",    "refused"};

/// A column of a campaign's table: its name, and the kind of its numbers.
struct Column {
  enum class Kind : unsigned char { whole, outcome, real };
  std::string name;
  Kind kind;
};

}  // namespace assur::mechanism
