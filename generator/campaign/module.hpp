// Turns the name of a function into that function of a module, which is loaded when it is needed.
#pragma once

#include <string>

namespace assur::generator::campaign {

/// The libraries for HDF5 and MPI take longer to load than most commands run: what needs them
/// stands in a module, in the folder of the program or in `../lib/assur`. Null where there is none.
[[nodiscard]] void* function_of_module(const std::string& module, const char* function);

}  // namespace assur::generator::campaign
