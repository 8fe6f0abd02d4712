// Turns the known groups into the catalogue of their kinds and models, beside what papers print.
#pragma once

#include <string>

namespace assur::generator {

/// One JSON object a group; a list of them if there are several groups.
[[nodiscard]] std::string catalogue_json();
/// A table a group. Where a printed table disagrees with the derivation, both are shown.
[[nodiscard]] std::string catalogue_text();
[[nodiscard]] std::string catalogue_markdown();

}  // namespace assur::generator
