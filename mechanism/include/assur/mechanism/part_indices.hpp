// The indices of a mechanism's parts, each of a type of its own.
#pragma once

#include <assur/mechanism/formula.hpp>

namespace assur::mechanism {

using NumberIndex = Index<struct Number>;
using FeatureIndex = Index<struct Feature>;
using LinkIndex = Index<struct Link>;
using DriverIndex = Index<struct Driver>;
using OutputIndex = Index<struct Output>;

}  // namespace assur::mechanism
