// Turns models into the C++ headers of generated/.
#pragma once

#include <assur/text/progress.hpp>
#include <vector>

#include "emission/cpp/files.hpp"
#include "structure/kind.hpp"

namespace assur::generator::emission::model {

/// The header of one model: `assur/tetrad/model_02.hpp`.
[[nodiscard]] cpp::EmittedFile emit_model(const structure::Model& model);
/// The headers of every model of every group, and the lists of models. Progress counts models.
[[nodiscard]] std::vector<cpp::EmittedFile> emit_all(const text::Progress& progress = {});

}  // namespace assur::generator::emission::model
