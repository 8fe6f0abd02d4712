// Lets CLN's rational and real numbers be scalars of Eigen's matrices, and so of generated code.
#pragma once

#include <cln/rational.h>
#include <cln/real.h>

#include <Eigen/Core>

namespace assur::test {

template <typename Number>
struct ClnTraits : Eigen::GenericNumTraits<Number> {
  using Real = Number;
  using NonInteger = Number;
  using Nested = Number;
  using Literal = Number;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = 10,
    AddCost = 100,
    MulCost = 100
  };
};

}  // namespace assur::test

namespace Eigen {
template <>
struct NumTraits<cln::cl_RA> : assur::test::ClnTraits<cln::cl_RA> {};
template <>
struct NumTraits<cln::cl_R> : assur::test::ClnTraits<cln::cl_R> {};
}  // namespace Eigen
