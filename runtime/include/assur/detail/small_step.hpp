// Small steps of a configuration without trigonometric functions.
#pragma once

#include <assur/directions.hpp>
#include <assur/model.hpp>
#include <assur/variables.hpp>
#include <cstddef>
#include <type_traits>

namespace assur::detail {

/// Adds the step to lengths, and turns angles by nearly the step.
template <typename Model, typename Scalar>
void nudge(typename Model::template Configuration<Scalar>& q,
           const Vector<Scalar, Model::unknown_count>& step) {
  for_each_member(q, [&step](auto& member, std::size_t index) {
    const Scalar by = step(static_cast<Eigen::Index>(index));
    if constexpr (std::is_same_v<std::decay_t<decltype(member)>, Scalar>) {
      member += by;
    } else {
      member =
          normalised(Direction<Scalar>{member.cos - by * member.sin, member.sin + by * member.cos});
    }
  });
}

}  // namespace assur::detail
