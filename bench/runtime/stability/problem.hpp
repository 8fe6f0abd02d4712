// The input and the answer of a method: a group in motion and its derivatives, in either scalar.
#pragma once

#include <assur/kinematics.hpp>
#include <limits>
#include <tuple>

#include "real.hpp"

namespace assur::stability {

/// A group, one of its configurations, and the motion of its inputs.
template <typename Model, typename Scalar>
struct Geometry {
  typename Model::template Dimensions<Scalar> d;
  typename Model::template Inputs<Scalar> u;
  typename Model::template Configuration<Scalar> q;
  Vector<Scalar, Model::input_count> u_rate;
  Vector<Scalar, Model::input_count> u_second_rate;
  Scalar size{1};  ///< a typical length of the links
};

/// A method may leave out the sensitivities. Set where the status is ok or near_singular.
template <typename Model>
struct Answer {
  /// All NaN until computed.
  Answer() {
    const double nothing = std::numeric_limits<double>::quiet_NaN();
    sensitivities.to_dimensions.setConstant(nothing);
    sensitivities.to_inputs.setConstant(nothing);
    motion.velocity.setConstant(nothing);
    motion.acceleration.setConstant(nothing);
  }

  Status status = Status::ok;
  bool has_sensitivities = true;
  Sensitivities<Model, double> sensitivities;
  Motion<Model, double> motion;
};

template <typename To, typename From>
void convert_into(To& to, const From& from) {
  to = static_cast<To>(from);
}
template <typename To, typename From>
void convert_into(Direction<To>& to, const Direction<From>& from) {
  to = {static_cast<To>(from.cos), static_cast<To>(from.sin)};
}

/// The same variables in another scalar; to double this rounds each number once.
template <typename To, typename From>
[[nodiscard]] To converted(const From& from) {
  To result;
  for_each_pair(result, from,
                [](auto& target, const auto& source) { convert_into(target, source); });
  return result;
}

template <typename To, typename Model, typename From>
[[nodiscard]] Geometry<Model, To> converted(const Geometry<Model, From>& from) {
  return {converted<typename Model::template Dimensions<To>>(from.d),
          converted<typename Model::template Inputs<To>>(from.u),
          converted<typename Model::template Configuration<To>>(from.q),
          from.u_rate.template cast<To>(),
          from.u_second_rate.template cast<To>(),
          static_cast<To>(from.size)};
}

}  // namespace assur::stability
