// Computes what straight-line functions give, to see which parameters the columns of a matrix are
// derivatives by. It decides only what is proposed; the audit judges.
#pragma once

#include "audit/init/program_outline.hpp"

namespace assur::generator::audit::init {

/// Whether an entry can be computed at all.
[[nodiscard]] bool is_computable(const ProgramFunction& function, const Given& given);

/// The symbols that the columns of a matrix are derivatives of the position by, as far as most of
/// the entries say so; empty where a column is none.
[[nodiscard]] std::vector<std::string> derived_by(const ProgramFunction& of, const Given& position,
                                                  const ProgramFunction& derived,
                                                  const Given& matrix);

/// Whether half of the numbers that a function gives are, up to their signs, the first or second
/// derivatives of the position by the time, where `rates` are its parameters for the rates of the
/// moving symbols and then for their second rates.
[[nodiscard]] bool follows_rates(const ProgramFunction& of, const Given& position,
                                 const ProgramFunction& derived, const Given& column,
                                 const std::vector<std::string>& moving,
                                 const std::vector<std::string>& rates);

}  // namespace assur::generator::audit::init
