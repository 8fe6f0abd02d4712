// Splits tokens into rows, cells and the equations of a system.
#pragma once

#include "latex/tokens.hpp"

namespace assur::generator::latex {

[[nodiscard]] Tokens slice(const Tokens& tokens, std::size_t from, std::size_t to);
/// Returns the contents of the environment that begins before `at`, and moves `at` past its \end.
[[nodiscard]] Tokens take_environment(const Tokens& tokens, std::size_t& at,
                                      const std::string& name, const Token& opened);
/// The parts between line breaks outside groups and inner environments, without an empty last one,
/// \hline and widths of gaps.
[[nodiscard]] std::vector<Tokens> rows_of(const Tokens& tokens);
/// The parts between the `&` outside groups and inner environments.
[[nodiscard]] std::vector<Tokens> cells_of(const Tokens& row);
/// Whether a row continues the one before it: it begins with a relation or a sign.
[[nodiscard]] bool continues(const Tokens& row);
/// The statements of a displayed equation: the rows of a system (`cases`, `aligned`) and the parts
/// between \quad, without alignment marks and final punctuation.
[[nodiscard]] std::vector<Tokens> statements_of(const Tokens& equation);
/// The sides of a statement, between its `=` outside brackets. Throws FormulaError for other
/// relations.
[[nodiscard]] std::vector<Tokens> sides_of(const Tokens& statement);

}  // namespace assur::generator::latex
