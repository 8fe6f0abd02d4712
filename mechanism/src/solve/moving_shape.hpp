// Turns the motion of what a group's links carry into the motion of its dimensions.
#pragma once

#include <assur/mechanism/values.hpp>
#include <functional>
#include <optional>
#include <vector>

#include "models/model_kernel.hpp"
#include "models/series.hpp"

namespace assur::mechanism::solve {

/// How fast features that define a group's links move on them. The rate of a dimension may be less:
/// where a driver stretches a straight link, its length stands still while its end moves across.
struct ShapeSpeed {
  double along = 0, along_twice = 0;  ///< rates and second rates of lengths and shifts, in size
  double turn = 0, turn_twice = 0;    ///< of normal frames on their links, and of angles
};

/// The normal forms of a group's links as they move.
struct MovingShape {
  models::FlatSeries d;
  std::vector<Pose<models::Series>> own;  ///< the links' own frames, each in its normal frame
  std::vector<models::Series> across;     ///< of the points across held axes, in the axes' order
  ShapeSpeed speed;

  /// Whether its rates and second rates are known.
  [[nodiscard]] bool is_known() const;
};

/// What determines a group's shape: a feature in the frame of the link that has it, and a feature
/// of a carried link in the frame of the link that carries it.
struct MovingFeatures {
  std::function<LinkFeature<models::Series>(FeatureIndex, bool)> own;
  std::function<LinkFeature<models::Series>(const LinkFeature<models::Series>&, const CarriedLink&)>
      carried;
};

/// The shape of a group whose features move. Nothing where its links would not play the roles in
/// which the group was solved.
[[nodiscard]] std::optional<MovingShape> moving_shape(const Values& values, GroupIndex index,
                                                      const MovingFeatures& features);

}  // namespace assur::mechanism::solve
