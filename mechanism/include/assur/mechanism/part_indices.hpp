// Indices of a mechanism's parts, each kind of part with its own type.
#pragma once

#include <assur/mechanism/formula.hpp>

namespace assur::mechanism {

using NumberIndex = Index<struct Number>;
using FeatureIndex = Index<struct Feature>;
using LinkIndex = Index<struct Link>;
using DriverIndex = Index<struct Driver>;
using OutputIndex = Index<struct Output>;

}  // namespace assur::mechanism
