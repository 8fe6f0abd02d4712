// Turns what is wanted of a mechanism into one object: results, a sweep, a covariance.
#pragma once

#include <assur/mechanism/mechanism.hpp>
#include <optional>
#include <vector>

namespace assur::mechanism {

/// Nothing that is not wanted is computed.
struct Want {
  bool position = true;
  bool velocity = true;
  bool acceleration = true;
  bool sensitivity = true;
};

/// `count` equally spaced values of one parameter, both ends among them.
struct Sweep {
  ParameterIndex parameter;
  NumberIndex from, to;
  int count = 0;
};

/// Variances and covariances of some parameters; the others do not vary.
struct Covariance {
  std::vector<ParameterIndex> parameters;
  std::vector<std::vector<NumberIndex>> matrix;  ///< square, in the order of `parameters`
};

struct Request {
  Want want;
  std::optional<Sweep> sweep;
  std::optional<Covariance> covariance;
};

}  // namespace assur::mechanism
