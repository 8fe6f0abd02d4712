// The rows of an audit file that call a function.
#pragma once

#include <functional>

#include "audit/init/program_outline.hpp"

namespace assur::generator::audit::init {

/// The call of a function, and the expressions of its results.
struct WrittenCall {
  std::vector<std::string> before;   ///< statements before the result
  std::vector<std::string> results;  ///< an expression for each result
};

/// `name_of` returns the name of a symbol in the audit file; `taken` holds the names that variables
/// of the rows may not have, and grows.
[[nodiscard]] WrittenCall written_call(
    const ProgramFunction& function, const ProgramOutline& outline, Language language,
    const std::function<std::string(const std::string&)>& name_of, std::set<std::string>& taken);

}  // namespace assur::generator::audit::init
