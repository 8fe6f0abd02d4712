#include <assur/dyad/models.hpp>

#include "scene/model_state.hpp"

namespace assur::generator {

GroupFunctions dyad_functions() { return functions_of<dyad::Models>(); }

}  // namespace assur::generator
