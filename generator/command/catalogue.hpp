// The catalogue of groups, kinds and models, compared with the tables of papers.
#pragma once

#include <string>

namespace assur::generator::command {

/// The JSON object of the tetrad, with those of the other groups in its list `other_groups`.
[[nodiscard]] std::string catalogue_json();
/// One table per group. Where a printed table disagrees with the derivation, both are shown.
[[nodiscard]] std::string catalogue_text();
[[nodiscard]] std::string catalogue_markdown();

}  // namespace assur::generator::command
