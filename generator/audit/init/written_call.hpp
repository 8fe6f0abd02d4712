// Turns a function and the names of symbols into the rows of an audit file that call it.
#pragma once

#include <functional>

#include "audit/init/program_outline.hpp"

namespace assur::generator::audit::init {

/// How a function is called, and what its results are called then.
struct WrittenCall {
  std::vector<std::string> before;   ///< statements in front of the result
  std::vector<std::string> results;  ///< an expression for each of what it gives
};

/// `name_of` gives the name of a symbol in the audit file; `taken` are names that variables of the
/// rows may not have, and becomes more.
[[nodiscard]] WrittenCall written_call(
    const ProgramFunction& function, const ProgramOutline& outline, Language language,
    const std::function<std::string(const std::string&)>& name_of, std::set<std::string>& taken);

}  // namespace assur::generator::audit::init
