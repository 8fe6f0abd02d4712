// Emits the C++ headers of models in generated/.
#pragma once

#include <assur/text/progress.hpp>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "emission/cpp/files.hpp"
#include "structure/kind.hpp"

namespace assur::generator::emission::model {

/// The functions that a header contains only on request, by the word that requests them.
[[nodiscard]] const std::map<std::string, std::set<std::string>>& functions_on_request();

/// The header of one model, `assur/tetrad/model_02.hpp`, with the functions requested by these
/// words. Throws InputError if the model cannot have them.
[[nodiscard]] cpp::EmittedFile emit_model(const structure::Model& model,
                                          const std::set<std::string>& with = {});
/// The headers of every model of every group, and the lists of models. Progress counts models.
[[nodiscard]] std::vector<cpp::EmittedFile> emit_all(const std::set<std::string>& with = {},
                                                     const text::Progress& progress = {});

}  // namespace assur::generator::emission::model
