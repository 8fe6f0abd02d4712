// Which quantities of a program are derivatives, and of which positions.
#pragma once

#include "audit/init/program_quantities.hpp"

namespace assur::generator::audit::init {

/// A derivative and the position that it is the derivative of.
struct DerivativePair {
  Quantity position;
  Quantity derived;
  std::vector<std::string> by;      ///< parameters; empty for rates
  std::vector<std::string> moving;  ///< whose rates the derivative takes
  int order = 1;                    ///< of the rate
  bool guessed = false;             ///< from numbers of names alone
};

/// By the values that the functions compute; where these say nothing, by names and numbers of
/// columns.
[[nodiscard]] std::vector<DerivativePair> derivative_pairs(const ProgramQuantities& quantities);

/// What no pair has, and no other function of the file calls: its closures are not in the file.
[[nodiscard]] std::vector<Quantity> without_pair(const ProgramQuantities& quantities,
                                                 const std::vector<DerivativePair>& pairs);

}  // namespace assur::generator::audit::init
