// Functions of modules, which are loaded when they are needed.
#pragma once

#include <string>

namespace assur::generator::campaign {

/// The libraries for HDF5 and MPI take longer to load than most commands run, so the code that uses
/// them is in a module, in the folder of the program or in `../lib/assur`. Null if there is none.
[[nodiscard]] void* function_of_module(const std::string& module, const char* function);

}  // namespace assur::generator::campaign
