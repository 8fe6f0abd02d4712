// The C header of a solver, and its implementation by the C++ header.
#pragma once

#include <string>
#include <vector>

#include "emission/cpp/files.hpp"
#include "emission/cpp/page.hpp"

namespace assur::generator::emission::scene {

/// `header`.h in C99 and `header`.cpp, beside the C++ header `header`.hpp. `solver`: the view of
/// templates/scene.hpp.mustache; `parameters`: the names of the modelled parameters;
/// `branch_numbers`: how many numbers a branch has besides its status. `real`: the type of all
/// numbers, double or float. Every name of the header begins with the scene's, so that several may
/// be included and linked.
[[nodiscard]] std::vector<cpp::EmittedFile> c_interface(const std::filesystem::path& header,
                                                        cpp::View solver,
                                                        const std::vector<std::string>& parameters,
                                                        std::size_t branch_numbers,
                                                        const std::string& real);

}  // namespace assur::generator::emission::scene
