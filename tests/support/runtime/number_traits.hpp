// Eigen's traits for scalars that own their digits.
#pragma once

#include <Eigen/Core>

namespace assur::test {

template <typename Number>
struct NumberTraits : Eigen::GenericNumTraits<Number> {
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
