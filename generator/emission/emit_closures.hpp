// Turns closures that a user typed into a C++ header, as emit_model does those of a model.
#pragma once

#include "closures/typed_closures.hpp"
#include "emission/emit.hpp"

namespace assur::generator {

/// The header of a user's own closures: `assur/closures/gear_five_bar.hpp`. Throws InputError,
/// with the closure's name, for one that is no polynomial in sines, cosines and square roots.
[[nodiscard]] EmittedFile emit_closures(const TypedClosures& closures);

}  // namespace assur::generator
