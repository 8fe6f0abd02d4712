#include <assur/tetrad/models.hpp>

#include "scene/model_state.hpp"

namespace assur::generator {

GroupFunctions tetrad_functions() { return functions_of<tetrad::Models>(); }

}  // namespace assur::generator
