// Turns a group of a mechanism into the normal forms of its links.
#pragma once

#include <assur/mechanism/values.hpp>

namespace assur::mechanism::values {

/// The group with its links in normal form under the first assignment of roles that has one.
[[nodiscard]] GroupGeometry group_geometry(const Values& values, GroupIndex group);

}  // namespace assur::mechanism::values
