// What a batch follows: a branch that begins with a number, with the reference, or where an earlier
// result ends.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "given.hpp"
#include "plan.hpp"

namespace assur::python {

/// A configuration, by the values at which it is one and its number there, from 1.
struct Place {
  Replaced replaced;
  std::size_t number;
};

/// A configuration of the first item that has it: the one with a number, or the one nearest to the
/// reference; or that which continues an earlier one.
struct NearestToReference {};
using Following = std::variant<std::size_t, NearestToReference, Place>;

/// Takes the keywords `branch`, `nearest` and `from_` out of the parameters' ones. Nothing where
/// none of them is given; throws ShapeError for more than one, and for values that they cannot
/// have.
[[nodiscard]] std::optional<Following> following_given(const PlannedScene& planned,
                                                       py::kwargs& keywords);

}  // namespace assur::python
