// Compares two sets of values, or two solutions, number by number: nothing may differ in any bit.
#pragma once

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>

#include "mechanism/solved.hpp"

namespace assur::test {

/// Whether all bits are the same, NaN and the sign of zero included.
inline bool same_bits(double one, double other) {
  return std::bit_cast<std::uint64_t>(one) == std::bit_cast<std::uint64_t>(other);
}

template <typename Derived, typename Other>
bool same_matrix(const Eigen::MatrixBase<Derived>& one, const Eigen::MatrixBase<Other>& other) {
  if (one.rows() != other.rows() || one.cols() != other.cols()) {
    return false;
  }
  for (Eigen::Index row = 0; row < one.rows(); ++row) {
    for (Eigen::Index column = 0; column < one.cols(); ++column) {
      if (!same_bits(one(row, column), other(row, column))) {
        return false;
      }
    }
  }
  return true;
}

inline bool same_dual(const mechanism::Dual& one, const mechanism::Dual& other) {
  return same_bits(one.value(), other.value()) &&
         same_matrix(one.derivatives(), other.derivatives()) &&
         same_matrix(one.hessian(), other.hessian());
}

template <int Coordinates>
bool same_derivatives(const mechanism::Derivatives<Coordinates>& one,
                      const mechanism::Derivatives<Coordinates>& other) {
  bool same = same_matrix(one.first, other.first) && one.second.size() == other.second.size();
  for (std::size_t row = 0; same && row < one.second.size(); ++row) {
    same = same_matrix(one.second[row], other.second[row]);
  }
  return same;
}

inline bool same_frame(const mechanism::Frame& one, const mechanism::Frame& other) {
  return same_bits(one.pose.x, other.pose.x) && same_bits(one.pose.y, other.pose.y) &&
         same_bits(one.pose.direction.cos, other.pose.direction.cos) &&
         same_bits(one.pose.direction.sin, other.pose.direction.sin) &&
         same_matrix(one.velocity, other.velocity) &&
         same_matrix(one.acceleration, other.acceleration) &&
         same_derivatives(one.follows, other.follows);
}

inline bool same_point(const mechanism::Point& one, const mechanism::Point& other) {
  return same_matrix(one.position, other.position) && same_matrix(one.velocity, other.velocity) &&
         same_matrix(one.acceleration, other.acceleration) &&
         same_derivatives(one.follows, other.follows);
}

inline bool same_slide(const mechanism::SlideState& one, const mechanism::SlideState& other) {
  return one.joint == other.joint && same_bits(one.displacement, other.displacement) &&
         same_bits(one.velocity, other.velocity) &&
         same_bits(one.acceleration, other.acceleration) &&
         same_derivatives(one.follows, other.follows);
}

inline void expect_same_solution(const Solution& one, const Solution& other) {
  EXPECT_EQ(one.status, other.status);
  EXPECT_EQ(one.mobility, other.mobility);
  EXPECT_EQ(one.reason, other.reason);
  ASSERT_EQ(one.configurations.size(), other.configurations.size());
  for (std::size_t index = 0; index < one.configurations.size(); ++index) {
    SCOPED_TRACE("configuration " + std::to_string(index + 1));
    const Configuration& a = one.configurations[index];
    const Configuration& b = other.configurations[index];
    ASSERT_EQ(a.links.size(), b.links.size());
    for (const mechanism::LinkIndex link : a.links.keys()) {
      EXPECT_TRUE(same_frame(a.links[link], b.links[link])) << "link " << link.place();
    }
    ASSERT_EQ(a.slides.size(), b.slides.size());
    for (std::size_t slide = 0; slide < a.slides.size(); ++slide) {
      EXPECT_TRUE(same_slide(a.slides[slide], b.slides[slide])) << "slide " << slide;
    }
    ASSERT_EQ(a.outputs.size(), b.outputs.size());
    for (const mechanism::OutputIndex output : a.outputs.keys()) {
      EXPECT_TRUE(same_point(a.outputs[output], b.outputs[output])) << "output " << output.place();
    }
    EXPECT_EQ(a.regularity, b.regularity);
    EXPECT_TRUE(same_bits(a.residual, b.residual));
  }
}

/// Expects equal parameters, numbers and variations of the parameters.
inline void expect_same_values(const Values& one, const Values& other,
                               const mechanism::Mechanism& mechanism) {
  for (const mechanism::ParameterIndex parameter : mechanism.parameters().keys()) {
    EXPECT_TRUE(same_bits(one.parameter(parameter), other.parameter(parameter)))
        << mechanism.parameters()[parameter].name;
  }
  // The number that is a parameter's formula is evaluated as the parameter.
  mechanism::Table<mechanism::NumberIndex, bool> is_formula(mechanism.numbers().size(), false);
  for (const mechanism::Parameter& parameter : mechanism.parameters()) {
    is_formula[parameter.value] = true;
  }
  for (const mechanism::NumberIndex number : mechanism.numbers().keys()) {
    if (!is_formula[number]) {
      EXPECT_TRUE(same_dual(one.number(number), other.number(number)))
          << mechanism.numbers()[number].part;
    }
  }
  EXPECT_TRUE(same_matrix(one.spread().tolerances, other.spread().tolerances));
  EXPECT_TRUE(same_matrix(one.spread().covariance, other.spread().covariance));
}

}  // namespace assur::test
