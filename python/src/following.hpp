// The branch that a batch follows: given by a configuration's number, by the reference, or by the
// end of an earlier result.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "given.hpp"
#include "plan.hpp"

namespace assur::python {

/// A configuration: parameter values, and its number at these values, from 1.
struct Place {
  Replaced replaced;
  std::size_t number;
};

/// The first configuration of the branch: the one with a number, or the one nearest to the
/// reference, at the first item where it exists; or the continuation of an earlier one.
struct NearestToReference {};
using Following = std::variant<std::size_t, NearestToReference, Place>;

/// Removes the keywords `branch`, `nearest` and `from_` from those of the parameters. Empty if none
/// of them is given; throws ShapeError for more than one, and for invalid values.
[[nodiscard]] std::optional<Following> following_given(const PlannedScene& planned,
                                                       py::kwargs& keywords);

}  // namespace assur::python
