#include "group_solver.hpp"

#include <algorithm>
#include <assur/support/redundant.hpp>
#include <cmath>
#include <limits>

#include "groups/derived_model.hpp"
#include "models/scaled_motion.hpp"
#include "plan/plan_data.hpp"
#include "solve/precision.hpp"

namespace assur::mechanism::solve {

namespace {

/// Adds a b to the result, for few rows and any number of columns. Zeros of `a` come from structure
/// and are skipped.
void add_product(const models::SmallMatrix& a, const ParameterRows<Eigen::Dynamic>& b,
                 ParameterRows<Eigen::Dynamic>& result) {
  const Eigen::Index columns = b.cols();
  const double* factor = a.data();
  for (Eigen::Index k = 0; k < a.cols(); ++k) {
    const double* const from = b.data() + k * columns;
    double* to = result.data();
    for (Eigen::Index row = 0; row < a.rows(); ++row, ++factor, to += columns) {
      for (Eigen::Index column = 0; *factor != 0 && column < columns; ++column) {
        to[column] += *factor * from[column];
      }
    }
  }
}

void add_product(const models::SmallMatrix& a, const std::vector<values::DimensionDerivative>& b,
                 ParameterRows<Eigen::Dynamic>& result) {
  for (const values::DimensionDerivative& entry : b) {
    for (Eigen::Index row = 0; row < a.rows(); ++row) {
      result(row, entry.parameter) += a(row, entry.dimension) * entry.value;
    }
  }
}

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Sets rates that are not all known to zero, and returns NaN for them, or one.
double known_part(models::SmallVector& rates) {
  if (rates.allFinite()) {
    return 1;
  }
  rates.setZero();
  return unknown;
}

/// The determinant by elimination with the largest pivot of each column, faster for small matrices
/// than Eigen's function.
double determinant_of(models::SmallMatrix& matrix) {
  double product = 1;
  for (Eigen::Index column = 0; column < matrix.cols(); ++column) {
    Eigen::Index pivot = column;
    for (Eigen::Index row = column + 1; row < matrix.rows(); ++row) {
      pivot = std::abs(matrix(row, column)) > std::abs(matrix(pivot, column)) ? row : pivot;
    }
    if (pivot != column) {
      matrix.row(pivot).swap(matrix.row(column));
      product = -product;
    }
    product *= matrix(column, column);
    for (Eigen::Index row = column + 1; row < matrix.rows() && product != 0; ++row) {
      const double factor = matrix(row, column) / matrix(column, column);
      for (Eigen::Index k = column + 1; k < matrix.cols(); ++k) {
        matrix(row, k) -= factor * matrix(column, k);
      }
    }
  }
  return product;
}

}  // namespace

GroupSolver::GroupSolver(const Values& values, GroupIndex group)
    : values_(values), group_(group), model_(*values.plan().structure.groups[group].model) {
  const auto inputs = static_cast<Eigen::Index>(model_.input_count);
  const auto parameters = static_cast<Eigen::Index>(values.columns().size());
  of_u_.first.resize(inputs, parameters);
  if (values.second_order()) {
    of_u_.second.assign(model_.input_count, Eigen::MatrixXd(parameters, parameters));
  }
  query_.input_rate.resize(inputs);
  query_.input_second_rate.resize(inputs);
}

void GroupSolver::hold(const PlacedLinks& placed) {
  Eigen::Index row = 0;
  double* to = u_.data();
  const auto take = [&](double rate, double second_rate, const auto& follows, Eigen::Index from) {
    query_.input_rate(row) = rate;
    query_.input_second_rate(row) = second_rate;
    of_u_.first.row(row) = follows.first.row(from);
    if (values_.second_order()) {
      of_u_.second[static_cast<std::size_t>(row)] = follows.second[static_cast<std::size_t>(from)];
    }
    ++row;
  };
  const support::Displacement& own = numbers().rounding;
  query_.displaced = own;
  for (const values::HeldJoint& joint : numbers().held) {
    const Frame& base = placed.links[joint.base];
    const Frame& feature = values_.frame(joint.feature);
    support::Displacement displaced = placed.displaced[joint.base].carries(
        feature.pose.x, feature.pose.y, values_.rounding(joint.feature));
    displaced.moved += own.moved;
    displaced.turned = joint.prismatic ? displaced.turned + own.turned : 0;
    query_.displaced = query_.displaced.worst_of(displaced);
    if (joint.prismatic) {
      compose(base, feature, line_);
      *to++ = line_.pose.x + joint.offset * line_.pose.direction.sin;
      *to++ = line_.pose.y - joint.offset * line_.pose.direction.cos;
      *to++ = line_.pose.direction.cos;
      *to++ = line_.pose.direction.sin;
      for (Eigen::Index from = 0; from < 3; ++from) {
        take(line_.velocity(from), line_.acceleration(from), line_.follows, from);
      }
    } else {
      carry(base, feature, point_);
      *to++ = point_.position.x();
      *to++ = point_.position.y();
      for (Eigen::Index from = 0; from < 2; ++from) {
        take(point_.velocity(from), point_.acceleration(from), point_.follows, from);
      }
    }
  }
  held_rates_ = known_part(query_.input_rate);
  held_second_rates_ = held_rates_ * known_part(query_.input_second_rate);
}

const models::GroupAssemblies& GroupSolver::assemble() {
  model_.kernel->assemble(numbers().d, u_, query_.displaced, found_);
  return found_;
}

Status GroupSolver::gap(double& result) const {
  return model_.kernel->gap(numbers().d, u_, result);
}

double GroupSolver::determinant() const {
  models::SmallMatrix inverse = motion_.inverse;
  for (Eigen::Index row = 0; row < inverse.rows(); ++row) {
    if (model_.unknowns[static_cast<std::size_t>(row)].is_angle) {
      inverse.row(row) *= motion_.size;
    }
  }
  return 1 / determinant_of(inverse);
}

GroupProof GroupSolver::proof(const Table<LinkIndex, Frame>& links) const {
  const Structure& structure = values_.plan().structure;
  const FoundGroup& group = structure.groups[group_];
  const RoleAssignment& roles = *values_.group(group_).roles;
  std::vector<ModelJoint> joints = group.model->group->joints;
  std::vector<groups::JointFeatures<double>> features(joints.size());
  const double* held = u_.data();
  for (std::size_t index = 0; index < joints.size(); ++index) {
    ModelJoint& joint = joints[index];
    joint.prismatic = group.model->prismatic[index];
    const ElementaryJoint& at = structure.linkage.joints[roles.joints[index]];
    const auto on = [&](int link) {
      const LinkFeature<Dual> feature =
          values_.feature(at, roles.links[static_cast<std::size_t>(link)]);
      return LinkFeature<double>{joint.prismatic,
                                 feature.x.value(),
                                 feature.y.value(),
                                 {feature.along.cos.value(), feature.along.sin.value()}};
    };
    features[index].on_second = on(joint.second);
    if (joint.first != base_link) {
      features[index].on_first = on(joint.first);
      continue;
    }
    features[index].on_first = {joint.prismatic, held[0], held[1], {1, 0}};
    held += 2;
    if (joint.prismatic) {
      features[index].on_first.along = {held[0], held[1]};
      held += 2;
    }
  }
  std::vector<Direction<double>> directions;
  for (const LinkIndex link : roles.links) {
    const Direction<double>& own = links[link].pose.direction;
    directions.push_back(
        group.base.exists() ? turned(own, reversed(links[group.base].pose.direction)) : own);
  }
  return groups::proof_of(joints, features, directions);
}

void GroupSolver::stand(std::size_t configuration, Table<LinkIndex, Frame>& links) const {
  models::GroupPoses poses;
  model_.kernel->stand(numbers().d, u_, found_.configurations[configuration], poses);
  for (std::size_t link = 0; link < numbers().links.size(); ++link) {
    links[numbers().links[link]].pose = support::pose_in(poses[link], numbers().own[link].pose);
  }
}

void GroupSolver::place(std::size_t configuration, std::size_t first_slide, PlacedLinks& placed) {
  const models::FlatVariables& q = found_.configurations[configuration];
  const bool links_change = numbers().d_rate.size() > 0;
  query_.derivatives = of_u_.first.cols() > 0 || links_change;
  models::move_in_any_unit(model_, numbers().d, u_, q, query_, motion_);
  find_across(q);
  if (links_change) {
    add_rates_of_links(q);
  }
  follow();
  if (values_.second_order()) {
    follow_twice(q);
  }
  const Precision precision = precision_of(model_, numbers().d, u_, q, query_, motion_);
  const Precision of_shape = precision_of_shape(numbers().firmness);
  double rates = held_rates_;
  double second_rates = held_second_rates_;
  if (precision.regularity != Status::ok && is_at_rest()) {
    motion_.rate.setZero();
    motion_.second_rate.setZero();
    motion_.velocities.setZero();
    motion_.accelerations.setZero();
  } else if (placed.forgets_unknown_rates) {
    rates *= precision.derivatives_known && of_shape.derivatives_known ? 1 : unknown;
    second_rates *= precision.second_rates_known && of_shape.second_rates_known ? 1 : unknown;
  }
  scale_rates(rates, second_rates);
  place_links(placed);
  place_slides(q, first_slide, placed);
  if (precision.regularity != Status::ok || of_shape.regularity != Status::ok) {
    placed.regularity = Status::near_singular;
  }
  placed.derivatives_known =
      placed.derivatives_known && precision.derivatives_known && of_shape.derivatives_known;
  placed.path_known = placed.path_known && precision.path_known && of_shape.path_known;
  placed.rates_known =
      placed.rates_known && precision.second_rates_known && of_shape.second_rates_known;
  placed.residual = std::max(placed.residual, motion_.residual);
  for (const LinkIndex link : numbers().links) {
    placed.displaced[link] = motion_.displaced;
  }
}

/// Whether neither the links that hold the group move nor its own dimensions change.
bool GroupSolver::is_at_rest() const {
  return held_second_rates_ == 1 && query_.input_rate.isZero(0) &&
         query_.input_second_rate.isZero(0) && numbers().d_rate.isZero(0) &&
         numbers().d_second_rate.isZero(0) &&
         std::ranges::none_of(numbers().across,
                              [](const values::AcrossAxis& axis) { return axis.moves(); });
}

void GroupSolver::scale_rates(double of_first, double of_second) {
  motion_.rate *= of_first;
  motion_.velocities *= of_first;
  motion_.second_rate *= of_second;
  motion_.accelerations *= of_second;
}

void GroupSolver::find_across(const models::FlatVariables& q) {
  across_.resize(numbers().across.size());
  for (std::size_t place = 0; place < across_.size(); ++place) {
    const values::AcrossAxis& axis = numbers().across[place];
    if (axis.moves() || axis.follows_parameters()) {
      across_[place] = across_columns(model_, numbers().d, u_, q, motion_.inverse, axis);
    }
  }
}

/// Calls `add(axis, columns, value)` for each held axis with a `value_of(axis)` that is not zero.
template <typename ValueOf, typename Add>
void GroupSolver::across(const ValueOf& value_of, const Add& add) const {
  for (std::size_t place = 0; place < across_.size(); ++place) {
    const values::AcrossAxis& axis = numbers().across[place];
    if (const double value = value_of(axis); value != 0) {
      add(axis, across_[place], value);
    }
  }
}

/// Adds the rates in time. With f(q, d, u) = 0 and p(q, d, u), along the motion (q', d', u'):
/// q' = q_u u' + q_d d', J q'' = -f''(q', d', u') - F_u u'' - F_d d'', and likewise for p.
/// A point (x + i y) e^(i theta) that moves across its axis, y = 0, adds i y' to the first and
/// i y'' - 2 theta' y' to the second derivative: x'' is then smaller by 2 theta' y'.
void GroupSolver::add_rates_of_links(const models::FlatVariables& q) {
  const auto& d_rate = numbers().d_rate;
  models::SmallVector d_second_rate = numbers().d_second_rate;
  models::GroupMotion& motion = motion_;
  models::SmallVector poses_across = models::SmallVector::Zero(motion.p_q.rows());
  const auto rate_of = [](const values::AcrossAxis& axis) { return axis.rate; };
  motion.rate = motion.q_u * query_.input_rate + motion.q_d * d_rate;
  across(rate_of, [&](const auto&, const AcrossColumns& columns, double rate) {
    motion.rate += rate * columns.q;
    poses_across += rate * columns.p;
  });
  models::SmallVector velocities = motion.p_q * motion.rate + motion.p_d * d_rate +
                                   motion.p_u * query_.input_rate + poses_across;
  models::Curvature curvature;
  model_.kernel->bend(numbers().d, u_, q, motion.rate, d_rate, query_.input_rate, curvature);
  across(rate_of, [&](const values::AcrossAxis& axis, const auto&, double rate) {
    d_second_rate(axis.dimension_row) -= 2 * motion.rate(axis.angle_row) * rate;
  });
  motion.second_rate = motion.inverse * curvature.closures + motion.q_u * query_.input_second_rate +
                       motion.q_d * d_second_rate;
  poses_across.setZero();
  across([](const values::AcrossAxis& axis) { return axis.second_rate; },
         [&](const auto&, const AcrossColumns& columns, double second_rate) {
           motion.second_rate += second_rate * columns.q;
           poses_across += second_rate * columns.p;
         });
  models::SmallVector accelerations = motion.p_q * motion.second_rate + motion.p_d * d_second_rate +
                                      motion.p_u * query_.input_second_rate + curvature.poses +
                                      poses_across;
  for (Eigen::Index link = 0; link < motion.velocities.rows(); ++link) {
    motion.velocities.row(link) = velocities.segment<3>(3 * link).transpose();
    motion.accelerations.row(link) = accelerations.segment<3>(3 * link).transpose();
  }
}

/// Sets the first derivatives q_a = q_d d_a + q_u u_a and p_a = p_q q_a + p_d d_a + p_u u_a for
/// every parameter a. A point that moves across a held axis adds its part.
void GroupSolver::follow() {
  of_q_.first.setZero(motion_.rate.size(), of_u_.first.cols());
  of_p_.first.setZero(3 * static_cast<Eigen::Index>(model_.group->link_count()),
                      of_u_.first.cols());
  if (of_u_.first.cols() > 0) {
    add_product(motion_.q_d, numbers().nonzero_of_d, of_q_.first);
    add_product(motion_.q_u, of_u_.first, of_q_.first);
    for (Eigen::Index column = 0; column < of_u_.first.cols(); ++column) {
      across([column](const values::AcrossAxis& axis) { return axis.first(column); },
             [&](const auto&, const AcrossColumns& columns, double value) {
               of_q_.first.col(column) += value * columns.q;
               of_p_.first.col(column) += value * columns.p;
             });
    }
    add_product(motion_.p_q, of_q_.first, of_p_.first);
    add_product(motion_.p_d, numbers().nonzero_of_d, of_p_.first);
    add_product(motion_.p_u, of_u_.first, of_p_.first);
  }
}

/// Sets the second derivatives from J q_ab = -f''(a, b) - F_d d_ab - F_u u_ab. There f'' is
/// bilinear in the first derivatives along a and b, and equals (Q(a + b) - Q(a - b)) / 4 with the
/// quadratic form Q that the kernel computes. If a were much longer than b, that difference would
/// lose digits, so both are scaled to one length.
void GroupSolver::follow_twice(const models::FlatVariables& q) {
  const Eigen::Index count = of_q_.first.cols();
  const Eigen::MatrixXd blank = Eigen::MatrixXd::Constant(count, count, unknown);
  of_q_.second.assign(static_cast<std::size_t>(of_q_.first.rows()), blank);
  of_p_.second.assign(static_cast<std::size_t>(of_p_.first.rows()), blank);
  const auto& q_a = of_q_.first;
  const auto& d_a = numbers().of_d.first;
  const auto& u_a = of_u_.first;
  if (!q_a.allFinite()) {
    return;
  }
  const auto longest = [](const auto& matrix, Eigen::Index column) {
    return matrix.rows() == 0 ? 0.0 : matrix.col(column).cwiseAbs().maxCoeff();
  };
  const auto length = [&](Eigen::Index i) {
    return std::max({longest(q_a, i), longest(d_a, i), longest(u_a, i)});
  };
  const auto curvature = [&](Eigen::Index i, double a, Eigen::Index j, double b) {
    models::Curvature result;
    model_.kernel->bend(numbers().d, u_, q, models::SmallVector(a * q_a.col(i) + b * q_a.col(j)),
                        models::SmallVector(a * d_a.col(i) + b * d_a.col(j)),
                        models::SmallVector(a * u_a.col(i) + b * u_a.col(j)), result);
    return result;
  };
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index j = 0; j <= i; ++j) {
      models::SmallVector d_ab = numbers().of_d.mixed(i, j);
      for (const values::AcrossAxis& axis : numbers().across) {  // as in the second rates
        d_ab(axis.dimension_row) -=
            q_a(axis.angle_row, i) * axis.first(j) + q_a(axis.angle_row, j) * axis.first(i);
      }
      const models::SmallVector u_ab = of_u_.mixed(i, j);
      models::SmallVector q_ab = motion_.q_d * d_ab + motion_.q_u * u_ab;
      models::SmallVector p_ab = motion_.p_d * d_ab + motion_.p_u * u_ab;
      across([i, j](const values::AcrossAxis& axis) { return axis.second(i, j); },
             [&](const auto&, const AcrossColumns& columns, double value) {
               q_ab += value * columns.q;
               p_ab += value * columns.p;
             });
      const double length_i = length(i);
      const double length_j = length(j);
      if (length_i > 0 && length_j > 0) {
        const models::Curvature sum = curvature(i, 1 / length_i, j, 1 / length_j);
        const models::Curvature difference = curvature(i, 1 / length_i, j, -1 / length_j);
        const double weight = length_i * length_j / 4;
        q_ab +=
            motion_.inverse * models::SmallVector(weight * (sum.closures - difference.closures));
        p_ab += weight * (sum.poses - difference.poses);
      }
      p_ab += motion_.p_q * q_ab;
      const auto set = [i, j](values::ParameterDerivatives& target,
                              const models::SmallVector& column) {
        for (Eigen::Index row = 0; row < column.size(); ++row) {
          Eigen::MatrixXd& matrix = target.second[static_cast<std::size_t>(row)];
          matrix(i, j) = matrix(j, i) = column(row);
        }
      };
      set(of_q_, q_ab);
      set(of_p_, p_ab);
    }
  }
}

void GroupSolver::place_links(PlacedLinks& placed) {
  for (std::size_t link = 0; link < numbers().links.size(); ++link) {
    const auto row = static_cast<Eigen::Index>(link);
    frame_.pose = motion_.poses[link];
    frame_.velocity = motion_.velocities.row(row).transpose();
    frame_.acceleration = motion_.accelerations.row(row).transpose();
    frame_.follows.first = of_p_.first.middleRows<3>(3 * row);
    if (values_.second_order()) {
      frame_.follows.second.assign(of_p_.second.begin() + 3 * row,
                                   of_p_.second.begin() + 3 * row + 3);
    }
    compose(frame_, numbers().own[link], placed.links[numbers().links[link]]);
  }
}

void GroupSolver::place_slides(const models::FlatVariables& q, std::size_t first_slide,
                               PlacedLinks& placed) const {
  for (std::size_t index = 0; index < numbers().slides.size(); ++index) {
    const values::MeasuredSlide& measured = numbers().slides[index];
    const auto row = static_cast<Eigen::Index>(measured.unknown);
    std::size_t flat =
        0;  // index of a displacement in the flat variables, where an angle takes two places
    for (int unknown = 0; unknown < measured.unknown; ++unknown) {
      flat += model_.unknowns[static_cast<std::size_t>(unknown)].is_angle ? 2 : 1;
    }
    SlideState& slide = placed.slides[first_slide + index];
    slide.joint = measured.joint;
    slide.displacement = measured.sense * (q[flat] + measured.shift.value());
    slide.velocity = measured.sense * (motion_.rate(row) + measured.shift_rate);
    slide.acceleration = measured.sense * (motion_.second_rate(row) + measured.shift_second_rate);
    slide.follows.first = measured.sense * of_q_.first.row(row);
    if (measured.shift.derivatives().size() > 0) {
      slide.follows.first += measured.sense * measured.shift.derivatives().transpose();
    }
    if (values_.second_order()) {
      slide.follows.second = {measured.sense *
                              of_q_.second[static_cast<std::size_t>(measured.unknown)]};
      if (measured.shift.has_hessian()) {
        slide.follows.second[0] += measured.sense * measured.shift.hessian();
      }
    }
  }
}

}  // namespace assur::mechanism::solve
