// Phrases and formulas for lists, counts and series of a derivation.
#pragma once

#include <string>
#include <vector>

#include "document/derivation.hpp"

namespace assur::generator::document {

/// `U = P1*C2 - P2*C1 = (U_0_re + i*U_0_im) + ...`.
[[nodiscard]] std::string series_text(const DerivedSeries& series);
/// The formula, in brackets if it is a sum.
[[nodiscard]] std::string bracketed(const std::string& formula);
/// A clause with a capital letter and a full stop.
[[nodiscard]] std::string sentence(std::string text);

}  // namespace assur::generator::document
