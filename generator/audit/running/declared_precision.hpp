// Turns the text of a C or C++ file and a call into the precision that the file declares for it.
#pragma once

#include <string>

namespace assur::generator::audit::running {

/// Whether the file declares a function that the code calls with a parameter of type float.
[[nodiscard]] bool has_single_parameters(const std::string& file_text, const std::string& code);

}  // namespace assur::generator::audit::running
