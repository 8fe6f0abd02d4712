// Random assembled RRR-RRR tetrads in motion, with derivatives in 60 digits.
#pragma once

#include <assur/tetrad/model_01.hpp>
#include <vector>

#include "precise.hpp"
#include "stability/problem.hpp"

namespace assur::speed {

using tetrad::Model01;

/// A group as the methods receive it: every number of the assembled configuration rounded once,
/// angles as directions and in radians.
template <typename Scalar>
struct TetradSample {
  stability::Geometry<Model01, Scalar> g;
  Vector<Scalar, 4> theta;  ///< BCG, EDF, CD, GF
};

/// The exact derivatives at the assembled configuration of a sample's d and u.
struct TetradTruth {
  Matrix<Precise, 4, 4> by_unknowns;                ///< J
  Matrix<Precise, 4, 12> by_dimensions_and_inputs;  ///< F
  Matrix<Precise, 4, 12> sensitivities;
  Vector<Precise, 4> velocity;
  Vector<Precise, 4> acceleration;
};

struct TetradSamples {
  std::vector<TetradSample<double>> list;
  std::vector<TetradTruth> truth;

  /// The same in another scalar, the dimensions and inputs rounded from double.
  template <typename Scalar>
  [[nodiscard]] std::vector<TetradSample<Scalar>> in() const {
    std::vector<TetradSample<Scalar>> result;
    for (const TetradSample<double>& sample : list) {
      result.push_back(
          {stability::converted<Scalar>(sample.g), sample.theta.template cast<Scalar>()});
    }
    return result;
  }
};

/// Groups with random dimensions and ends, one of their configurations each.
[[nodiscard]] TetradSamples random_tetrads(std::size_t count);

/// Groups whose two configurations meet if a length changes by 1e-2 ... 1e-10 of itself.
[[nodiscard]] TetradSamples near_singular_tetrads(std::size_t count);

}  // namespace assur::speed
