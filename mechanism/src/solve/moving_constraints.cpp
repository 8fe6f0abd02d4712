#include "moving_constraints.hpp"

#include <algorithm>
#include <array>
#include <assur/directions.hpp>
#include <assur/support/redundant.hpp>
#include <cmath>

#include "models/series_functions.hpp"
#include "moving_laws.hpp"
#include "plan/plan_data.hpp"
#include "relative_frames.hpp"

namespace assur::mechanism::solve {

namespace {

using models::Series;

/// A frame as seen from another one.
Pose<Series> seen_from(const Pose<Series>& frame, const Pose<Series>& other) {
  const auto& [cosine, sine] = frame.direction;
  const Series x = other.x - frame.x;
  const Series y = other.y - frame.y;
  return {cosine * x + sine * y, cosine * y - sine * x,
          turned(other.direction, reversed(frame.direction))};
}

Pose<Series> moving_pose(const Values& values, FeatureIndex index) {
  const LinkFeature<Series> feature =
      moving_feature(values, index, values.plan().mechanism.features()[index].is_line);
  return {feature.x, feature.y, feature.along};
}

}  // namespace

MovingConstraints::MovingConstraints(const Values& values,
                                     const std::vector<RedundantJoint>& left_out,
                                     const Configuration& configuration,
                                     const Table<DriverIndex, models::Series>& motions)
    : values_(values),
      mechanism_(values.plan().mechanism),
      configuration_(configuration),
      constraints_(values, left_out),
      poses_(poses_of(configuration.links)) {
  const PlanData& plan = values.plan();
  for (const DriverIndex driver : mechanism_.drivers().keys()) {
    laws_.add(std::nullopt);
    if (!plan.evaluation.reads_links[driver]) {
      laws_[driver] = motions[driver];
      laws_[driver]->c[0] = values.motion(driver).position.value();
    }
  }
  for (const FeatureIndex feature : mechanism_.features().keys()) {
    features_.add(moving_pose(values, feature));
  }
  constraints_.measure(poses_);
  add_rows();
  choose_unit_of_time();
}

void MovingConstraints::add_rows() {
  blocks_ = constraints_.blocks();
  rows_of_.resize(constraints_.moving().size());
  constraints_.body().for_each_row([&](int row, int coordinate, std::size_t index) {
    const HeldPair& pair = constraints_.pairs()[index];
    rows_.push_back({index, coordinate});
    const bool reads = pair.driver.exists() && pair.driven == coordinate && !laws_[pair.driver];
    if (reads) {
      reading_.push_back(row);
    }
    for (const FeatureIndex feature : {pair.first, pair.second}) {
      const LinkIndex link = mechanism_.features()[feature].link;
      if (!reads && constraints_.column_of(link) >= 0) {
        rows_of_[static_cast<std::size_t>(constraints_.column_of(link) / 3)].push_back(row);
      }
    }
  });
  // The law of a driver may read joints of any link.
  for (std::vector<Eigen::Index>& of : rows_of_) {
    of.insert(of.end(), reading_.begin(), reading_.end());
  }
}

void MovingConstraints::choose_unit_of_time() {
  const Parts still = at_rest(Eigen::VectorXd::Zero(unknowns()));
  const double first = coefficient(1, still).norm();
  const double second = std::sqrt(coefficient(2, still).norm());
  double fastest = std::max(first, second);
  // A feature that moves along its own joint leaves F unchanged to first order.
  const auto consider = [&](const Series& moving, double size) {
    fastest =
        std::max({fastest, std::abs(moving.c[1]) / size, std::sqrt(std::abs(moving.c[2]) / size)});
  };
  for (const Pose<Series>& feature : features_) {
    consider(feature.x, constraints_.size());
    consider(feature.y, constraints_.size());
    consider(feature.direction.cos, 1);
    consider(feature.direction.sin, 1);
  }
  unit_ = fastest > 0 && std::isfinite(fastest) ? 1 / fastest : 1;
}

MovingConstraints::Links MovingConstraints::links(const Parts& parts) const {
  Links result;
  for (const Pose<double>& pose : poses_) {
    result.add(models::at_rest(pose));
  }
  for (std::size_t place = 0; place < constraints_.moving().size(); ++place) {
    result[constraints_.moving()[place]] = moved(place, parts);
  }
  return result;
}

Pose<Series> MovingConstraints::moved(std::size_t place, const Parts& parts) const {
  const Pose<double>& pose = poses_[constraints_.moving()[place]];
  const auto row = 3 * static_cast<Eigen::Index>(place);
  const double turn = parts(row + 2, 0);
  const Direction<double> start =
      turned(pose.direction, Direction<double>{std::cos(turn), std::sin(turn)});
  std::array<Series, 3> step{parts(row, 0), parts(row + 1, 0), Series()};
  for (Eigen::Index order = 1; order <= highest_order; ++order) {
    const double unit = std::pow(unit_, -static_cast<double>(order));
    for (Eigen::Index of = 0; of < 3; ++of) {
      step[static_cast<std::size_t>(of)].c[static_cast<std::size_t>(order)] =
          parts(row + of, order) * unit;
    }
  }
  const Direction<Series> direction = turning(start, step[2]);
  const Eigen::Vector2d pivot = constraints_.body().pivot_of(static_cast<int>(place));
  const Pose<double> about = support::pose_in(pose, {pivot.x(), pivot.y(), {1, 0}});
  return {about.x + constraints_.size() * step[0] - direction.cos * pivot.x() +
              direction.sin * pivot.y(),
          about.y + constraints_.size() * step[1] - direction.sin * pivot.x() -
              direction.cos * pivot.y(),
          direction};
}

Pose<Series> MovingConstraints::placed(FeatureIndex feature, const Links& links) const {
  return composed(links[mechanism_.features()[feature].link], features_[feature]);
}

Series MovingConstraints::coordinate(JointIndex joint, const Links& links) const {
  if (mechanism_.joints()[joint].type == JointType::revolute) {
    return moving_angle(links, configuration_, joint);
  }
  const SlideFeatures at = features_of_slide(mechanism_, joint);
  return seen_from(placed(at.line, links), placed(at.other, links)).x;
}

Series MovingConstraints::law(DriverIndex driver, const Links& links) const {
  if (laws_[driver]) {
    return *laws_[driver];
  }
  return moving_law(values_, driver, [&](JointIndex joint) {
    const DriverIndex other = mechanism_.driver_of(joint);
    return other.exists() ? law(other, links) : coordinate(joint, links);
  });
}

double MovingConstraints::coefficient(const Row& row, Eigen::Index order,
                                      const Links& links) const {
  const HeldPair& pair = constraints_.pairs()[row.pair];
  const Pose<Series> at = seen_from(placed(pair.first, links), placed(pair.second, links));
  const bool is_driven = pair.driver.exists() && pair.driven == row.coordinate;
  Series wanted = is_driven ? law(pair.driver, links) : Series();
  Series miss;
  if (row.coordinate == 2) {
    const double start = wanted.value();
    wanted.c[0] = 0;
    const Direction<Series> back = turning({std::cos(start), -std::sin(start)}, -wanted);
    miss = turned(at.direction, back).sin;
  } else {
    miss = (1 / constraints_.size()) * ((row.coordinate == 0 ? at.x : at.y) - wanted);
  }
  return std::pow(unit_, static_cast<double>(order)) * miss.c[static_cast<std::size_t>(order)];
}

Eigen::VectorXd MovingConstraints::coefficient(Eigen::Index order, const Parts& parts) const {
  const Links moving = links(parts);
  Eigen::VectorXd result(rows());
  for (Eigen::Index row = 0; row < rows(); ++row) {
    result(row) = coefficient(rows_[static_cast<std::size_t>(row)], order, moving);
  }
  return result;
}

MovingConstraints::Parts MovingConstraints::at_rest(const Eigen::VectorXd& q) const {
  Parts parts = Parts::Zero(unknowns(), highest_order + 1);
  parts.col(0) = q;
  return parts;
}

Eigen::MatrixXd MovingConstraints::jacobian(const Eigen::VectorXd& q) const {
  AllConstraints::Poses poses = poses_;
  constraints_.move(q, poses);
  Eigen::MatrixXd result = constraints_.jacobian(poses);
  if (reading_.empty()) {
    return result;
  }
  Parts parts = at_rest(q);
  const Eigen::VectorXd alone = coefficient(1, parts);
  for (Eigen::Index column = 0; column < unknowns(); ++column) {
    parts(column, 1) = 1;
    const Links moving = links(parts);
    for (const Eigen::Index row : reading_) {
      result(row, column) =
          coefficient(rows_[static_cast<std::size_t>(row)], 1, moving) - alone(row);
    }
    parts(column, 1) = 0;
  }
  return result;
}

Eigen::MatrixXd MovingConstraints::bends(const Eigen::VectorXd& q, const Eigen::VectorXd& v) const {
  const Parts alone = at_rest(q);
  Parts with_v = alone;
  with_v.col(1) = v;
  const Eigen::VectorXd difference = coefficient(2, alone) - coefficient(2, with_v);
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(rows(), unknowns());
  const auto add = [&](Parts parts, double sign) {
    Links moving = links(parts);
    for (Eigen::Index column = 0; column < unknowns(); ++column) {
      const auto place = static_cast<std::size_t>(column / 3);
      const Pose<Series> before = moving[constraints_.moving()[place]];
      parts(column, 1) += 1;
      moving[constraints_.moving()[place]] = moved(place, parts);
      for (const Eigen::Index row : rows_of_[place]) {
        result(row, column) += sign * coefficient(rows_[static_cast<std::size_t>(row)], 2, moving);
      }
      parts(column, 1) -= 1;
      moving[constraints_.moving()[place]] = before;
    }
  };
  add(with_v, 1);
  add(alone, -1);
  for (Eigen::Index column = 0; column < unknowns(); ++column) {
    for (const Eigen::Index row : rows_of_[static_cast<std::size_t>(column / 3)]) {
      result(row, column) += difference(row);
    }
  }
  return result;
}

}  // namespace assur::mechanism::solve
