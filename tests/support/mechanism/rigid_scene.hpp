// Poses, velocities and accelerations of a mechanism as rigid bodies with constraints, without
// Assur groups, loops or trees: the independent truth for mechanisms.
#pragma once

#include <Eigen/Dense>
#include <array>
#include <assur/mechanism/values.hpp>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "runtime/taylor.hpp"

namespace assur::test {

using Real = long double;
using RealVector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
using RealMatrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

/// The links of a mechanism at given parameter values. Coordinates are x, y, theta of every link
/// but the ground, in the mechanism's order; there are as many constraints.
class RigidScene {
 public:
  using Jet = Taylor<Real>;  ///< a quantity on the move; the first and second rates are used
  /// Whether rates given by a driver replace those of its law.
  enum class Laws : unsigned char { alone, with_given_rates };

  RigidScene(const mechanism::Mechanism& mechanism, const mechanism::Values& values)
      : mechanism_(mechanism) {
    for (const mechanism::ParameterIndex parameter : mechanism.parameters().keys()) {
      parameters_.add(Jet(values.parameter(parameter), 0, 0, 0));
    }
    // Parameters may be listed before those on which they depend.
    for (std::size_t round = 0; round < parameters_.size(); ++round) {
      for (const mechanism::ParameterIndex parameter : mechanism.parameters().keys()) {
        set_rates(parameter);
      }
    }
    for (const mechanism::Link& link : mechanism.links()) {
      body_of_.add(link.name == "ground" ? -1 : static_cast<int>(bodies_++));
    }
    for (const mechanism::Feature& feature : mechanism.features()) {
      Feature local{moved(feature.x), moved(feature.y), Jet(0), Jet(1), Jet(0)};
      if (feature.is_line) {
        const auto angle = [&](Real t) {
          return std::atan2(at_time(feature.along_y, t), at_time(feature.along_x, t));
        };
        // On the move it may pass half a turn, where the arctangent leaps.
        local.angle = differentiated([&, start = angle(0)](Real t) {
          return start + std::remainder(angle(t) - start, 2 * std::acos(-1.0L));
        });
        std::tie(local.cos, local.sin) = cos_and_sin(local.angle);
      }
      reach_ += std::hypot(local.x.c0, local.y.c0);
      features_.add(local);
    }
  }

  [[nodiscard]] Eigen::Index size() const { return 3 * bodies_; }
  /// Sum of the distances of all features from their links' origins.
  [[nodiscard]] Real reach() const { return reach_; }
  /// Whether it is one of the mechanism's own links, not a block of a slot.
  [[nodiscard]] bool has(mechanism::LinkIndex link) const { return link.place() < body_of_.size(); }
  /// The first coordinate of a link, or -1 for the ground.
  [[nodiscard]] Eigen::Index coordinate(mechanism::LinkIndex link) const {
    return 3L * body_of_[link];
  }

  /// Constraints and their rates at t = 0 along q + v t + a t^2 / 2: coincident points, points on
  /// lines, lines on lines of the same sense, and the laws of the drivers.
  [[nodiscard]] std::vector<Jet> constraints(const RealVector& q, const RealVector& v,
                                             const RealVector& a,
                                             Laws laws = Laws::with_given_rates) const {
    const std::vector<Pose> poses = moving_poses(q, v, a);
    std::vector<Jet> result;
    for (const mechanism::Joint& joint : mechanism_.joints()) {
      add_constraints(poses, joint, result);
    }
    for (const mechanism::Driver& driver : mechanism_.drivers()) {
      result.push_back(constraint(poses, driver, laws));
    }
    return result;
  }

  /// Newton's method with steps below one radian and the mechanism's size; true if it converges
  /// with every constraint at rounding.
  bool assemble(RealVector& q, int iterations = 60) const {
    for (int iteration = 0; iteration < iterations; ++iteration) {
      const RealVector f = values_of(q);
      const Eigen::FullPivLU<RealMatrix> lu(jacobian(q));
      RealVector change = lu.solve(-f);
      Real excess = 1;
      for (Eigen::Index index = 0; index < change.size(); ++index) {
        const Real limit = index % 3 == 2 ? 1 : reach_;
        excess = std::max(excess, std::abs(change(index)) / limit);
      }
      if (!change.allFinite()) {
        return false;
      }
      q += change / excess;
      if (change.cwiseAbs().maxCoeff() < 1e-16L * reach_) {
        return values_of(q).cwiseAbs().maxCoeff() < 1e-15L * reach_;
      }
    }
    return false;
  }

  [[nodiscard]] RealVector values_of(const RealVector& q) const {
    return part_of(constraints(q, still(), still()), 0);
  }
  /// The coordinates' rates at which the constraints' first rates vanish; these are affine in them.
  [[nodiscard]] RealVector velocity(const RealVector& q) const {
    return root_of([&](const RealVector& v) { return part_of(constraints(q, v, still()), 1); });
  }
  [[nodiscard]] RealVector acceleration(const RealVector& q, const RealVector& v) const {
    return root_of([&](const RealVector& a) { return part_of(constraints(q, v, a), 2); });
  }

  /// Coordinates of a point of a link on the move.
  [[nodiscard]] std::pair<Jet, Jet> point(mechanism::FeatureIndex feature, const RealVector& q,
                                          const RealVector& v, const RealVector& a) const {
    const Place at = place(moving_poses(q, v, a), feature);
    return {at.x, at.y};
  }
  /// Displacement of a prismatic or pin-in-slot joint on the move.
  [[nodiscard]] Jet displacement(const mechanism::Joint& joint, const RealVector& q,
                                 const RealVector& v, const RealVector& a) const {
    return displacement(moving_poses(q, v, a), joint);
  }

  /// Anywhere within the mechanism's reach, at any angle.
  [[nodiscard]] RealVector scattered(std::mt19937& engine) const {
    std::uniform_real_distribution<double> part(-1, 1);
    RealVector q(size());
    for (Eigen::Index index = 0; index < q.size(); ++index) {
      q(index) = part(engine) * (index % 3 == 2 ? std::acos(-1.0L) : reach_ / 4);
    }
    return q;
  }

  /// A column is the rate of the constraints along its coordinate; laws have their own rates here,
  /// not those given beside them. A joint is at rest while links move that it does not connect.
  [[nodiscard]] RealMatrix jacobian(const RealVector& q) const {
    std::vector<Pose> poses = moving_poses(q, still(), still());
    std::vector<RealMatrix> blocks;
    for (const mechanism::Joint& joint : mechanism_.joints()) {
      blocks.push_back(rates(q, poses, bodies_of(joint), [&] {
        std::vector<Jet> result;
        add_constraints(poses, joint, result);
        return result;
      }));
    }
    for (const mechanism::Driver& driver : mechanism_.drivers()) {
      std::set<Eigen::Index> bodies = bodies_of(mechanism_.joints()[driver.joint]);
      if (!mechanism_.numbers()[driver.position].formula.joints().empty()) {
        bodies = all_bodies();  // the law may read any joint, by way of other laws
      }
      blocks.push_back(rates(q, poses, bodies, [&] {
        return std::vector<Jet>{constraint(poses, driver, Laws::alone)};
      }));
    }
    Eigen::Index rows = 0;
    for (const RealMatrix& block : blocks) {
      rows += block.rows();
    }
    RealMatrix result(rows, size());
    for (const RealMatrix& block : blocks) {
      result.middleRows(result.rows() - rows, block.rows()) = block;
      rows -= block.rows();
    }
    return result;
  }

 private:
  struct Feature {
    Jet x, y, angle, cos, sin;
  };
  struct Pose {
    Jet x, y, theta, cos, sin;
  };
  struct Place {
    Jet x, y, angle, cos, sin;
  };

  static Real at(const Jet& jet, Real t) { return jet.c0 + t * (jet.c1 + t * jet.c2); }
  /// A function of time with its first two derivatives at t = 0, from nine of its values. These are
  /// the closer together, the faster its arguments move.
  template <typename Function>
  static Jet differentiated(const Function& f, Real speed = 1) {
    const Real h = 1 / (256 * speed);
    constexpr std::array<Real, 4> first = {4 / 5.0L, -1 / 5.0L, 4 / 105.0L, -1 / 280.0L};
    constexpr std::array<Real, 4> second = {8 / 5.0L, -1 / 5.0L, 8 / 315.0L, -1 / 560.0L};
    const Real here = f(0);
    Real rate = 0;
    Real second_rate = 0;
    for (std::size_t step = 0; step < first.size(); ++step) {
      const Real t = h * static_cast<Real>(step + 1);
      const Real before = f(-t);
      const Real after = f(t);
      rate += first[step] * (after - before) / h;
      second_rate += second[step] * ((after - here) - (here - before)) / (h * h);
    }
    return {here, rate, second_rate / 2, 0};
  }
  /// A number of the mechanism at a time, while its parameters and the joints that it reads move.
  template <typename CoordinateOf>
  [[nodiscard]] Real at_time(mechanism::NumberIndex number, Real t,
                             const CoordinateOf& coordinate_of) const {
    return mechanism_.numbers()[number].formula.template evaluate<Real>(
        [&](mechanism::ParameterIndex parameter) { return at(parameters_[parameter], t); },
        [&](mechanism::JointIndex joint) { return at(coordinate_of(joint), t); });
  }
  [[nodiscard]] Real at_time(mechanism::NumberIndex number, Real t) const {
    return at_time(number, t, [](mechanism::JointIndex) { return Jet(0); });
  }
  [[nodiscard]] Jet moved(mechanism::NumberIndex number) const {
    return differentiated([&](Real t) { return at_time(number, t); });
  }
  void set_rates(mechanism::ParameterIndex index) {
    const mechanism::Parameter& parameter = mechanism_.parameters()[index];
    const Jet follows = moved(parameter.value);
    Jet& jet = parameters_[index];
    jet.c1 = parameter.velocity.exists() ? at_time(parameter.velocity, 0) : follows.c1;
    jet.c2 = parameter.acceleration.exists() ? at_time(parameter.acceleration, 0) / 2 : follows.c2;
  }

  /// The coordinate of a joint of two links.
  [[nodiscard]] Jet coordinate(const std::vector<Pose>& poses, mechanism::JointIndex index) const {
    const mechanism::Joint& joint = mechanism_.joints()[index];
    if (joint.type == mechanism::JointType::revolute) {
      return pose_of_owner(poses, joint.between[1]).theta -
             pose_of_owner(poses, joint.between[0]).theta;
    }
    return displacement(poses, joint);
  }
  /// The coordinate by a driver's law. If the law reads a driven joint, that joint's law is used.
  [[nodiscard]] Jet wanted(const std::vector<Pose>& poses, const mechanism::Driver& driver,
                           Laws laws) const {
    const auto read = [&](mechanism::JointIndex joint) {
      for (const mechanism::Driver& other : mechanism_.drivers()) {
        if (other.joint == joint) {
          return wanted(poses, other, laws);
        }
      }
      const Jet coordinate_read = coordinate(poses, joint);
      return mechanism_.joints()[joint].type == mechanism::JointType::revolute
                 ? above_half_a_turn(coordinate_read)
                 : coordinate_read;
    };
    Real speed = 1;
    std::map<mechanism::JointIndex, Jet> moving;  // each once, as laws read laws
    for (const mechanism::JointIndex joint :
         mechanism_.numbers()[driver.position].formula.joints()) {
      const Jet& jet = moving.emplace(joint, read(joint)).first->second;
      speed += std::abs(jet.c1) + std::sqrt(std::abs(jet.c2));
    }
    const auto read_before = [&](mechanism::JointIndex joint) { return moving.at(joint); };
    Jet law =
        differentiated([&](Real t) { return at_time(driver.position, t, read_before); }, speed);
    if (laws == Laws::with_given_rates && driver.velocity.exists()) {
      law.c1 = at_time(driver.velocity, 0);
    }
    if (laws == Laws::with_given_rates && driver.acceleration.exists()) {
      law.c2 = at_time(driver.acceleration, 0) / 2;
    }
    return law;
  }

  [[nodiscard]] RealVector still() const { return RealVector::Zero(size()); }
  /// An angle as laws read it: above -pi, by more than rounding.
  static Jet above_half_a_turn(Jet angle) {
    angle = wrapped(angle);
    angle.c0 += angle.c0 < 1e-9L - std::acos(-1.0L) ? 2 * std::acos(-1.0L) : 0;
    return angle;
  }
  /// A difference of angles, brought between -pi and pi.
  static Jet wrapped(Jet angle) {
    angle.c0 = std::remainder(angle.c0, 2 * std::acos(-1.0L));
    return angle;
  }
  /// The n-th derivative of every constraint.
  static RealVector part_of(const std::vector<Jet>& jets, int n) {
    RealVector part(static_cast<Eigen::Index>(jets.size()));
    for (std::size_t index = 0; index < jets.size(); ++index) {
      const Jet& jet = jets[index];
      part(static_cast<Eigen::Index>(index)) = n == 0 ? jet.c0 : n == 1 ? jet.c1 : 2 * jet.c2;
    }
    return part;
  }
  /// The matrix of an affine function of the coordinates, and of their rates.
  template <typename Affine>
  [[nodiscard]] RealMatrix matrix_of(const Affine& affine) const {
    const RealVector resting = affine(still());
    RealMatrix result(resting.size(), size());
    for (Eigen::Index column = 0; column < size(); ++column) {
      result.col(column) = affine(RealVector::Unit(size(), column)) - resting;
    }
    return result;
  }
  template <typename Affine>
  [[nodiscard]] RealVector root_of(const Affine& affine) const {
    return matrix_of(affine).fullPivLu().solve(-affine(still()));
  }

  /// What coincides where the joint closes.
  void add_constraints(const std::vector<Pose>& poses, const mechanism::Joint& joint,
                       std::vector<Jet>& result) const {
    if (joint.type == mechanism::JointType::revolute) {
      const Place hub = place(poses, joint.between[0]);
      for (std::size_t part = 1; part < joint.between.size(); ++part) {
        const Place other = place(poses, joint.between[part]);
        result.push_back(other.x - hub.x);
        result.push_back(other.y - hub.y);
      }
      return;
    }
    const auto [line, other] = line_first(poses, joint);
    result.push_back(line.cos * (other.y - line.y) - line.sin * (other.x - line.x));
    if (joint.type == mechanism::JointType::prismatic) {
      result.push_back(wrapped(other.angle - line.angle));
    }
  }
  [[nodiscard]] Jet constraint(const std::vector<Pose>& poses, const mechanism::Driver& driver,
                               Laws laws) const {
    const Jet miss = coordinate(poses, driver.joint) - wanted(poses, driver, laws);
    const bool turns = mechanism_.joints()[driver.joint].type == mechanism::JointType::revolute;
    return turns ? wrapped(miss) : miss;
  }
  [[nodiscard]] std::set<Eigen::Index> bodies_of(const mechanism::Joint& joint) const {
    std::set<Eigen::Index> bodies;
    for (const mechanism::FeatureIndex feature : joint.between) {
      bodies.insert(body_of_[mechanism_.features()[feature].link]);
    }
    bodies.erase(-1);
    return bodies;
  }
  [[nodiscard]] std::set<Eigen::Index> all_bodies() const {
    std::set<Eigen::Index> bodies;
    for (Eigen::Index body = 0; body < bodies_; ++body) {
      bodies.insert(body);
    }
    return bodies;
  }
  /// First rates of some constraints along the coordinates of some bodies, one column for each
  /// coordinate; the poses, which the constraints read, rest before and after.
  template <typename Constraints>
  [[nodiscard]] RealMatrix rates(const RealVector& q, std::vector<Pose>& poses,
                                 const std::set<Eigen::Index>& bodies,
                                 const Constraints& constraints) const {
    const RealVector resting = part_of(constraints(), 1);
    RealMatrix result = RealMatrix::Zero(resting.size(), size());
    for (const Eigen::Index body : bodies) {
      Pose& pose = poses[static_cast<std::size_t>(body)];
      const Pose rest = pose;
      for (Eigen::Index column = 3 * body; column < 3 * body + 3; ++column) {
        pose = moving_pose(body, q, RealVector::Unit(size(), column), still());
        result.col(column) = part_of(constraints(), 1) - resting;
      }
      pose = rest;
    }
    return result;
  }

  static std::pair<Jet, Jet> cos_and_sin(const Jet& angle) {
    const Direction<Real> start{std::cos(angle.c0), std::sin(angle.c0)};
    const Direction<Jet> turn = moving<Real>(start, angle.c1, 2 * angle.c2, 0);
    return {turn.cos, turn.sin};
  }
  [[nodiscard]] static Pose moving_pose(Eigen::Index body, const RealVector& q, const RealVector& v,
                                        const RealVector& a) {
    const auto jet = [&](Eigen::Index axis) -> Jet {
      const Eigen::Index index = 3 * body + axis;
      return moving<Real>(q(index), v(index), a(index), 0);
    };
    const Jet theta = jet(2);
    const auto [cos, sin] = cos_and_sin(theta);
    return {jet(0), jet(1), theta, cos, sin};
  }
  [[nodiscard]] std::vector<Pose> moving_poses(const RealVector& q, const RealVector& v,
                                               const RealVector& a) const {
    std::vector<Pose> poses;
    for (Eigen::Index body = 0; body < bodies_; ++body) {
      poses.push_back(moving_pose(body, q, v, a));
    }
    return poses;
  }
  [[nodiscard]] Pose pose_of_owner(const std::vector<Pose>& poses,
                                   mechanism::FeatureIndex feature) const {
    const int body = body_of_[mechanism_.features()[feature].link];
    return body < 0 ? Pose{0, 0, 0, 1, 0} : poses[static_cast<std::size_t>(body)];
  }
  [[nodiscard]] Place place(const std::vector<Pose>& poses, mechanism::FeatureIndex feature) const {
    const Feature& local = features_[feature];
    const Pose at = pose_of_owner(poses, feature);
    return {at.x + at.cos * local.x - at.sin * local.y, at.y + at.sin * local.x + at.cos * local.y,
            at.theta + local.angle, at.cos * local.cos - at.sin * local.sin,
            at.sin * local.cos + at.cos * local.sin};
  }
  /// The two features of a sliding joint; of a point and a line the line first.
  [[nodiscard]] std::pair<Place, Place> line_first(const std::vector<Pose>& poses,
                                                   const mechanism::Joint& joint) const {
    const std::size_t line = mechanism_.features()[joint.between[0]].is_line ? 0 : 1;
    return {place(poses, joint.between[line]), place(poses, joint.between[1 - line])};
  }
  [[nodiscard]] Jet displacement(const std::vector<Pose>& poses,
                                 const mechanism::Joint& joint) const {
    const auto [line, other] = line_first(poses, joint);
    return line.cos * (other.x - line.x) + line.sin * (other.y - line.y);
  }

  const mechanism::Mechanism& mechanism_;
  Eigen::Index bodies_ = 0;
  mechanism::Table<mechanism::LinkIndex, int> body_of_;
  mechanism::Table<mechanism::ParameterIndex, Jet> parameters_;
  mechanism::Table<mechanism::FeatureIndex, Feature> features_;
  Real reach_ = 0;
};

}  // namespace assur::test
