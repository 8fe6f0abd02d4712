// Renders a derivation as an annotated audit file, a LaTeX document, or JSON.
#pragma once

#include <string>

#include "document/derivation.hpp"

namespace assur::generator::document {

/// Text that is also an audit file: names, closures and matrices are statements, everything else
/// comments.
[[nodiscard]] std::string derivation_text(const Derivation& derivation);
/// A complete LaTeX document.
[[nodiscard]] std::string derivation_latex(const Derivation& derivation);
[[nodiscard]] std::string derivation_json(const Derivation& derivation);

}  // namespace assur::generator::document
