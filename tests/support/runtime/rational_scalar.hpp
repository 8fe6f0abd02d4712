// Rational numbers as a scalar of Eigen's matrices, and so of generated code.
#pragma once

#include <Eigen/Core>

#include "runtime/number_traits.hpp"
#include "runtime/rational.hpp"

namespace Eigen {
template <>
struct NumTraits<assur::test::Rational> : assur::test::NumberTraits<assur::test::Rational> {};
}  // namespace Eigen
