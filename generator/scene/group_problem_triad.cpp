#include <assur/triad/models.hpp>

#include "scene/model_state.hpp"

namespace assur::generator {

GroupFunctions triad_functions() { return functions_of<triad::Models>(); }

}  // namespace assur::generator
