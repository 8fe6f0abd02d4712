// Turns a configuration into the key by which configurations are put in order.
#pragma once

#include <array>
#include <assur/model.hpp>
#include <assur/variables.hpp>
#include <cmath>
#include <tuple>
#include <type_traits>

namespace assur::detail {

/// Cosines, then sines, of the angles between each two links; then the lengths among the unknowns.
/// The cosines do not change under rigid motion and reflection.
template <typename Model>
class AssemblyOrder {
  static constexpr std::size_t pairs = static_cast<std::size_t>(Model::link_count) *
                                       static_cast<std::size_t>(Model::link_count - 1) / 2;
  static constexpr std::size_t size = 2 * pairs + static_cast<std::size_t>(Model::unknown_count);

 public:
  using Key = std::array<double, size>;

  static Key key(const typename Model::template Dimensions<double>& d,
                 const typename Model::template Inputs<double>& u,
                 const typename Model::template Configuration<double>& q) {
    Poses<double, Model::link_count> poses;
    Model::link_poses(d, u, q, poses);
    Key result{};
    std::size_t place = 0;
    for (std::size_t one = 0; one < poses.size(); ++one) {
      for (std::size_t other = one + 1; other < poses.size(); ++other) {
        const Direction<double> between =
            turned(poses[other].direction, reversed(poses[one].direction));
        result[place] = between.cos;
        result[pairs + place] = between.sin;
        ++place;
      }
    }
    place = 2 * pairs;
    const auto append = [&](const auto& member) {
      if constexpr (std::is_same_v<std::decay_t<decltype(member)>, double>) {
        result[place++] = member;
      }
    };
    std::apply([&](const auto&... member) { (append(member), ...); }, q.members());
    return result;
  }

  /// Entries that differ by rounding alone count as equal.
  static bool before(const Key& left, const Key& right) {
    for (std::size_t place = 0; place < size; ++place) {
      const double difference = left[place] - right[place];
      if (std::abs(difference) > 1e-9 * (1 + std::abs(left[place]))) {
        return difference < 0;
      }
    }
    return false;
  }
};

}  // namespace assur::detail
