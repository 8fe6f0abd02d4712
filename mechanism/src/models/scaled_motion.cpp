#include "models/scaled_motion.hpp"

#include <algorithm>
#include <assur/support/scale.hpp>
#include <cmath>

namespace assur::mechanism::models {

namespace {

using Sorts = std::vector<bool>;  ///< whether each variable is an angle, in the order of the model

Sorts sorts_of(const std::vector<ModelUnknown>& unknowns) {
  Sorts result;
  for (const ModelUnknown& unknown : unknowns) {
    result.push_back(unknown.is_angle);
  }
  return result;
}

bool is_angle(bool sort) { return sort; }
bool is_angle(const ModelUnknown& unknown) { return unknown.is_angle; }

/// A row (x, y, theta) per link.
Sorts sorts_of_poses(std::size_t link_count) {
  Sorts result;
  for (std::size_t link = 0; link < link_count; ++link) {
    result.insert(result.end(), {false, false, true});
  }
  return result;
}

template <typename Sort>
double longest(const FlatVariables& variables, const std::vector<Sort>& sorts) {
  double result = 0;
  std::size_t place = 0;
  for (const auto& sort : sorts) {
    result = is_angle(sort) ? result : std::max(result, std::abs(variables[place]));
    place += is_angle(sort) ? 2 : 1;
  }
  return result;
}

FlatVariables scaled(FlatVariables variables, const Sorts& angles, double scale) {
  std::size_t place = 0;
  for (const bool angle : angles) {
    variables[place] *= angle ? 1 : scale;
    place += angle ? 2 : 1;
  }
  return variables;
}

/// Multiplies rows of lengths by a scale, and divides columns that belong to lengths by it.
void scale_entries(SmallMatrix& matrix, const Sorts& angles_of_rows, const Sorts& angles_of_columns,
                   double scale) {
  for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
    for (Eigen::Index column = 0; column < matrix.cols(); ++column) {
      matrix(row, column) *= (angles_of_rows[static_cast<std::size_t>(row)] ? 1 : scale) /
                             (angles_of_columns[static_cast<std::size_t>(column)] ? 1 : scale);
    }
  }
}

void scale_entries(SmallVector& vector, const Sorts& angles, double scale) {
  for (Eigen::Index row = 0; row < vector.size(); ++row) {
    vector(row) *= angles[static_cast<std::size_t>(row)] ? 1 : scale;
  }
}

void scale_motion(const GroupModel& model, const Sorts& unknowns, double unit,
                  GroupMotion& motion) {
  motion.residual *= unit;
  motion.size *= unit;
  motion.held *= unit;
  motion.displaced = motion.displaced.scaled(unit);
  for (std::size_t link = 0; link < model.group->link_count(); ++link) {
    motion.poses[link].x *= unit;
    motion.poses[link].y *= unit;
  }
  scale_entries(motion.rate, unknowns, unit);
  scale_entries(motion.second_rate, unknowns, unit);
  motion.velocities.leftCols<2>() *= unit;
  motion.accelerations.leftCols<2>() *= unit;
  const Sorts closures(unknowns.size(), false);
  const Sorts poses = sorts_of_poses(model.group->link_count());
  scale_entries(motion.inverse, unknowns, closures, unit);
  scale_entries(motion.q_d, unknowns, model.dimension_is_angle, unit);
  scale_entries(motion.q_u, unknowns, model.input_is_angle, unit);
  scale_entries(motion.p_q, poses, unknowns, unit);
  scale_entries(motion.p_d, poses, model.dimension_is_angle, unit);
  scale_entries(motion.p_u, poses, model.input_is_angle, unit);
}

}  // namespace

void move_in_any_unit(const GroupModel& model, const FlatVariables& d, const FlatVariables& u,
                      const FlatVariables& q, const MotionQuery& query, GroupMotion& motion) {
  constexpr double far = 0x1p64;
  const double size = std::max({longest(d, model.dimension_is_angle),
                                longest(u, model.input_is_angle), longest(q, model.unknowns)});
  if (size < far && size * far > 1) {
    model.kernel->move(d, u, q, query, motion);
    return;
  }
  const Sorts unknowns = sorts_of(model.unknowns);
  const double scale = support::scale_of(size);
  MotionQuery of_scaled = query;
  scale_entries(of_scaled.input_rate, model.input_is_angle, scale);
  scale_entries(of_scaled.input_second_rate, model.input_is_angle, scale);
  of_scaled.displaced = query.displaced.scaled(scale);
  model.kernel->move(scaled(d, model.dimension_is_angle, scale),
                     scaled(u, model.input_is_angle, scale), scaled(q, unknowns, scale), of_scaled,
                     motion);
  scale_motion(model, unknowns, 1 / scale, motion);
}

}  // namespace assur::mechanism::models
