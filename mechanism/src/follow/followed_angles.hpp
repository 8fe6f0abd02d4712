// Angles between links that loads and springs read, continued along the branches of a sweep.
#pragma once

#include <assur/mechanism/solution.hpp>
#include <assur/mechanism/values.hpp>
#include <map>
#include <vector>

namespace assur::mechanism::follow {

/// Continues the angles between links whose joint no driver moves, and at which a spring acts or
/// which a load reads. From one configuration of a branch to the next, an angle moves by at most
/// half a turn.
class FollowedAngles {
 public:
  explicit FollowedAngles(const Mechanism& mechanism);

  [[nodiscard]] bool is_needed() const { return !angles_.empty(); }
  /// The next configuration of a branch, at these values, with its `followed` angles; valid until
  /// the next call. The configurations of a branch must come in their order.
  [[nodiscard]] const Configuration& on(int branch, const Configuration& state,
                                        const Values& values);

 private:
  std::vector<FollowedAngle> angles_;  ///< of a branch that begins
  std::map<int, std::vector<FollowedAngle>> on_branches_;
  Configuration followed_;
};

}  // namespace assur::mechanism::follow
