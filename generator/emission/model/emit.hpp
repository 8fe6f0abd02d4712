// Turns models into the C++ headers of generated/.
#pragma once

#include <assur/text/progress.hpp>
#include <vector>

#include "emission/cpp/files.hpp"
#include "structure/kind.hpp"

namespace assur::generator::emission::model {

/// What a header holds beside the functions of every model.
struct ModelContents {
  bool forces = false;  ///< the forces in the joints under given loads; only of a rigid model
};

/// The header of one model: `assur/tetrad/model_02.hpp`. Throws InputError where the model cannot
/// have the contents.
[[nodiscard]] cpp::EmittedFile emit_model(const structure::Model& model,
                                          const ModelContents& contents = {});
/// The headers of every model of every group, and the lists of models. Progress counts models.
[[nodiscard]] std::vector<cpp::EmittedFile> emit_all(const text::Progress& progress = {});

}  // namespace assur::generator::emission::model
