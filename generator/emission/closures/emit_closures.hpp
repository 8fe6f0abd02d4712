// Emits a C++ header for closures that a user typed.
#pragma once

#include "closures/typed_closures.hpp"
#include "emission/cpp/files.hpp"

namespace assur::generator::emission::closures {

/// The header of a user's closures: `assur/closures/gear_five_bar.hpp`. Throws InputError with the
/// closure's name for a closure that is not a polynomial in sines, cosines and square roots.
[[nodiscard]] cpp::EmittedFile emit_closures(const generator::closures::TypedClosures& closures);

/// Warnings, one line each, if the closures do not determine the unknowns. A header is emitted all
/// the same, with `rigid` false. Throws as `emit_closures` does.
[[nodiscard]] std::vector<std::string> closure_warnings(
    const generator::closures::TypedClosures& closures);

}  // namespace assur::generator::emission::closures
