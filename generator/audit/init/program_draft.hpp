// Turns the outline of a program into a draft of its audit file.
#pragma once

#include "audit/init/program_words.hpp"

namespace assur::generator::audit::init {

/// `named` is the file in the statements. Throws InputError where nothing can be audited.
[[nodiscard]] std::string program_draft(const std::string& code, Language language,
                                        const std::string& file, const std::string& named);

}  // namespace assur::generator::audit::init
