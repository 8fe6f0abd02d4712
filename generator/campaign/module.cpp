#include "campaign/module.hpp"

#include <dlfcn.h>

#include <filesystem>

namespace assur::generator::campaign {

void* function_of_module(const std::string& module, const char* function) {
  std::error_code error;
  const std::filesystem::path folder =
      std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
  for (const std::filesystem::path& place : {folder, folder.parent_path() / ASSUR_MODULES}) {
    const std::string file = (place / (module + ".so")).string();
    if (void* const library = dlopen(file.c_str(), RTLD_NOW | RTLD_GLOBAL)) {
      return dlsym(library, function);
    }
  }
  return nullptr;
}

}  // namespace assur::generator::campaign
