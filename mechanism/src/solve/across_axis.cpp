#include "across_axis.hpp"

namespace assur::mechanism::solve {

namespace {

/// The unknowns with one link turned by a right angle.
models::FlatSeries turned_square(const models::FlatSeries& q, std::size_t angle) {
  models::FlatSeries result = q;
  result[angle] = -q[angle + 1];
  result[angle + 1] = q[angle];
  return result;
}

models::FlatSeries at_rest(const models::FlatVariables& values) {
  models::FlatSeries result;
  for (std::size_t place = 0; place < result.size(); ++place) {
    result[place] = values[place];
  }
  return result;
}

}  // namespace

AcrossColumns across_columns(const GroupModel& model, const models::FlatVariables& d,
                             const models::FlatVariables& u, const models::FlatVariables& q,
                             const models::SmallMatrix& inverse, const values::AcrossAxis& axis) {
  models::FlatSeries moving_d = at_rest(d);
  moving_d[axis.dimension].c[1] = 1;
  models::MovingGroup moving;
  model.kernel->expand(moving_d, at_rest(u), turned_square(at_rest(q), axis.angle), moving);
  models::SmallVector closures(inverse.cols());
  for (Eigen::Index row = 0; row < closures.size(); ++row) {
    closures(row) = moving.closures[static_cast<std::size_t>(row)].rate();
  }
  AcrossColumns result;
  result.q = -inverse * closures;
  result.p.setZero(3 * static_cast<Eigen::Index>(model.group->link_count()));
  for (std::size_t link = 0; link < model.group->link_count(); ++link) {
    const auto row = 3 * static_cast<Eigen::Index>(link);
    result.p(row) = moving.poses[link].x.rate();
    result.p(row + 1) = moving.poses[link].y.rate();
  }
  return result;
}

}  // namespace assur::mechanism::solve
