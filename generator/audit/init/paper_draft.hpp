// Turns a paper in LaTeX into a draft of the map of its notation.
#pragma once

#include <string>

namespace assur::generator::audit::init {

/// Throws InputError where no displayed equation has a symbol.
[[nodiscard]] std::string paper_draft(const std::string& paper, const std::string& file);

}  // namespace assur::generator::audit::init
