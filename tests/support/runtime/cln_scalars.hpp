// CLN's rational and real numbers as scalars of Eigen's matrices, and so of generated code.
#pragma once

#include <cln/rational.h>
#include <cln/real.h>

#include "runtime/number_traits.hpp"

namespace Eigen {
template <>
struct NumTraits<cln::cl_RA> : assur::test::NumberTraits<cln::cl_RA> {};
template <>
struct NumTraits<cln::cl_R> : assur::test::NumberTraits<cln::cl_R> {};
}  // namespace Eigen
