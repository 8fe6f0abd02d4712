// Comparison of the library's answer to a scene on a lattice with the exact one: lost, invented and
// misjudged configurations.
#pragma once

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <ostream>
#include <string>
#include <vector>

#include "mechanism/lattice_scene.hpp"
#include "mechanism/lattice_truth.hpp"
#include "mechanism/named_counts.hpp"
#include "mechanism/solved.hpp"

namespace assur::test {

/// A listed configuration, with an independent assessment.
struct ListedConfiguration {
  std::vector<Eigen::Isometry2d> poses;  ///< of the group's links, in the order of the scene
  bool regular = false;                  ///< as the library says
  double residual = 0;                   ///< the largest miss of a joint
  double smallest = 0;                   ///< singular value of the joints' velocity equations
};

/// The library's answer for a scene, as read by `lattice_answer`.
struct LatticeAnswer {
  bool has_family = false;
  int mobility = 0;
  std::vector<ListedConfiguration> configurations;
};

/// What is wrong with an answer.
struct LatticeFaults {
  int lost = 0;             ///< isolated configurations that are not listed
  int hidden = 0;           ///< lost, but nothing is listed because there is also a family
  int invented = 0;         ///< listed ones that are none, do not close or are listed twice
  int open = 0;             ///< invented ones that do not close
  int twice = 0;            ///< invented ones that repeat an earlier one
  int called_regular = 0;   ///< that are singular in truth
  int called_singular = 0;  ///< that are regular in truth and well conditioned
  int no_family = 0;        ///< there is a family and the answer does not say so
  int false_family = 0;     ///< the answer reports a family and there is none
  int wrong_mobility = 0;
  int renumbered = 0;  ///< another listing has another answer
  int exchanged = 0;   ///< the same, with the two links of joints exchanged
  int refused = 0;     ///< the library throws
  int tolerated = 0;   ///< called near singular, regular in truth, badly conditioned: no fault

  [[nodiscard]] int verdicts() const {
    return called_regular + called_singular + no_family + false_family;
  }
  [[nodiscard]] bool any() const {
    return serious() || wrong_mobility + renumbered + exchanged != 0;
  }
  /// Configurations or verdicts are wrong, not only a number of freedoms or an order.
  [[nodiscard]] bool serious() const {
    return lost + hidden + invented + verdicts() + refused != 0;
  }
  void add(const LatticeFaults& other) {
    lost += other.lost;
    hidden += other.hidden;
    invented += other.invented;
    open += other.open;
    twice += other.twice;
    called_regular += other.called_regular;
    called_singular += other.called_singular;
    no_family += other.no_family;
    false_family += other.false_family;
    wrong_mobility += other.wrong_mobility;
    renumbered += other.renumbered;
    exchanged += other.exchanged;
    refused += other.refused;
    tolerated += other.tolerated;
  }
};

inline std::ostream& operator<<(std::ostream& out, const LatticeFaults& faults) {
  const std::array<NamedCount, 14> named = {
      {{"lost", faults.lost},
       {"hidden behind a family", faults.hidden},
       {"invented", faults.invented},
       {"of them open", faults.open},
       {"of them listed twice", faults.twice},
       {"singular called regular", faults.called_regular},
       {"regular called near singular", faults.called_singular},
       {"family not told", faults.no_family},
       {"family invented", faults.false_family},
       {"wrong mobility", faults.wrong_mobility},
       {"answered otherwise in another listing", faults.renumbered},
       {"answered otherwise with the links of joints exchanged", faults.exchanged},
       {"refused", faults.refused},
       {"badly conditioned and called near singular", faults.tolerated}}};
  return print_counts(out, named);
}

/// A joint's feature on one of its links, placed.
struct PlacedFeature {
  Eigen::Vector2d point;
  Eigen::Vector2d along;
};

inline PlacedFeature placed_feature(const LatticeScene& scene, const LatticeJoint& joint, int link,
                                    const std::vector<Eigen::Isometry2d>& poses) {
  const std::size_t side = joint.first == link ? 0 : 1;
  const int step = joint.prismatic ? joint.steps[side] : 0;
  Eigen::Vector2d point(joint.at.x + step * joint.along.x, joint.at.y + step * joint.along.y);
  Eigen::Vector2d along = Eigen::Vector2d(joint.along.x, joint.along.y).normalized();
  if (link == base_link) {
    return {point, along};
  }
  const auto index = static_cast<std::size_t>(link);
  const LatticeFrame& frame = scene.frames()[index];
  Eigen::Matrix2d turn;
  turn << frame.c, -frame.s, frame.s, frame.c;
  turn /= frame.size;
  point = turn.transpose() * (point - Eigen::Vector2d(frame.origin.x, frame.origin.y));
  along = turn.transpose() * along;
  return {poses[index] * point, poses[index].linear() * along};
}

/// The gaps of the joints, and their derivatives with respect to the links' velocities. A link's
/// velocity is that of its point at the origin of the ground, and its angular velocity.
struct ClosureEquations {
  Eigen::VectorXd miss;
  Eigen::MatrixXd jacobian;
};

inline ClosureEquations closure_equations(const LatticeScene& scene,
                                          const std::vector<Eigen::Isometry2d>& poses) {
  const auto cross = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
  };
  const auto size = static_cast<Eigen::Index>(2 * scene.joints().size());
  ClosureEquations result{Eigen::VectorXd::Zero(size), Eigen::MatrixXd::Zero(size, size)};
  Eigen::Index row = 0;
  for (const LatticeJoint& joint : scene.joints()) {
    const PlacedFeature first = placed_feature(scene, joint, joint.first, poses);
    const PlacedFeature second = placed_feature(scene, joint, joint.second, poses);
    const Eigen::Vector2d apart = second.point - first.point;
    // The angle between the senses of two slides, as their sense matters.
    const double turned =
        std::atan2(cross(first.along, second.along), first.along.dot(second.along));
    result.miss.segment<2>(row) =
        joint.prismatic ? Eigen::Vector2d(cross(first.along, apart), turned) : apart;
    for (const int link : {joint.first, joint.second}) {
      if (link == base_link) {
        continue;
      }
      const double sense = link == joint.first ? -1 : 1;
      const Eigen::Index column = Eigen::Index{3} * link;
      if (joint.prismatic) {
        const Eigen::Vector2d normal(-first.along.y(), first.along.x());
        result.jacobian.block<1, 2>(row, column) = sense * normal.transpose();
        result.jacobian(row, column + 2) = sense * cross(second.point, normal);
        result.jacobian(row + 1, column + 2) = sense;
      } else {
        const Eigen::Vector2d at = link == joint.first ? first.point : second.point;
        result.jacobian.block<2, 2>(row, column) = sense * Eigen::Matrix2d::Identity();
        result.jacobian.block<2, 1>(row, column + 2) = sense * Eigen::Vector2d(-at.y(), at.x());
      }
    }
    row += 2;
  }
  return result;
}

/// The residual and the smallest singular value of a configuration.
inline void examine(const LatticeScene& scene, ListedConfiguration& configuration) {
  const ClosureEquations equations = closure_equations(scene, configuration.poses);
  configuration.residual = equations.miss.cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
  for (const Eigen::Isometry2d& pose : configuration.poses) {
    // A direction must be a unit vector; distant joints close only to their rounding.
    const double miss = std::max(std::abs(pose.linear().determinant() - 1),
                                 1e-16 * pose.translation().cwiseAbs().maxCoeff());
    configuration.residual = !(miss <= configuration.residual) ? miss : configuration.residual;
  }
  // A square matrix needs no preconditioner, which takes seconds to compile.
  const Eigen::JacobiSVD<Eigen::MatrixXd, Eigen::NoQRPreconditioner> values(equations.jacobian);
  configuration.smallest = values.singularValues().tail<1>()(0);
}

/// Solves a scene as a listing has it.
inline LatticeAnswer lattice_answer(const LatticeScene& scene, const std::string& text) {
  const Solved solved(mechanism::parse_scene(text, "scene"));
  LatticeAnswer answer;
  answer.has_family = !solved.solution.families.empty();
  for (const mechanism::Family& family : solved.solution.families) {
    answer.mobility = std::max(answer.mobility, family.mobility);
  }
  for (const Configuration& found : solved.configurations()) {
    ListedConfiguration listed;
    listed.regular = found.regularity == Status::ok;
    for (const std::string& link : scene.links()) {
      const auto& pose = found.link(link).pose;
      Eigen::Isometry2d& at = listed.poses.emplace_back(Eigen::Isometry2d::Identity());
      at.linear() << pose.direction.cos, -pose.direction.sin, pose.direction.sin,
          pose.direction.cos;
      at.translation() << pose.x, pose.y;
    }
    examine(scene, listed);
    answer.configurations.push_back(listed);
  }
  return answer;
}

/// The largest difference of a coordinate of a link.
inline double difference(const ListedConfiguration& one, const ListedConfiguration& other) {
  double largest = 0;
  for (std::size_t link = 0; link < one.poses.size(); ++link) {
    const double apart =
        (one.poses[link].matrix() - other.poses[link].matrix()).cwiseAbs().maxCoeff();
    largest = std::isfinite(apart) ? std::max(largest, apart) : apart;
  }
  return largest;
}

/// Configurations closer than this are the same: on the lattice, others are further apart, and one
/// of multiplicity four is known to 1e-3 only.
inline constexpr double same_configuration = 5e-3;
/// Lengths are up to ten.
inline constexpr double closes = 1e-12;
/// A configuration with a worse Jacobian may be called near singular although it is regular.
inline constexpr double well_conditioned = 1e-6;

inline LatticeFaults lattice_faults(const LatticeTruth& truth, const LatticeAnswer& answer) {
  LatticeFaults faults;
  std::vector<const ListedConfiguration*> good;
  for (const ListedConfiguration& listed : answer.configurations) {
    if (!(listed.residual <= closes)) {
      ++faults.open;
    } else if (std::any_of(good.begin(), good.end(), [&](const ListedConfiguration* before) {
                 return difference(*before, listed) < same_configuration;
               })) {
      ++faults.twice;
    } else {
      good.push_back(&listed);
    }
  }
  // The worst conditioned come last. If there is a family, the singular configurations in excess of
  // the isolated singular ones are on it.
  std::sort(good.begin(), good.end(),
            [](const auto* a, const auto* b) { return a->smallest > b->smallest; });
  const auto conditioned = std::count_if(
      good.begin(), good.end(), [](const auto* at) { return at->smallest >= well_conditioned; });
  if (truth.mobility > 0) {
    good.resize(std::min(good.size(), static_cast<std::size_t>(conditioned + truth.singular)));
  }
  const int listed = static_cast<int>(good.size());
  const bool only_family = answer.has_family && answer.configurations.empty();
  (only_family && truth.mobility > 0 ? faults.hidden : faults.lost) =
      std::max(0, truth.isolated - listed);
  faults.invented =
      static_cast<int>(answer.configurations.size()) - std::min(listed, truth.isolated);
  faults.no_family = truth.mobility > 0 && !answer.has_family ? 1 : 0;
  faults.false_family = truth.mobility == 0 && answer.has_family ? 1 : 0;
  faults.wrong_mobility =
      truth.mobility > 0 && answer.has_family && answer.mobility != truth.mobility ? 1 : 0;
  if (listed == truth.isolated) {
    // The best conditioned ones count as regular, as many as there are regular ones in truth.
    for (int index = 0; index < listed; ++index) {
      const ListedConfiguration& at = *good[static_cast<std::size_t>(index)];
      if (index >= truth.regular()) {
        faults.called_regular += at.regular ? 1 : 0;
      } else if (!at.regular) {
        ++(at.smallest < well_conditioned ? faults.tolerated : faults.called_singular);
      }
    }
  }
  return faults;
}

/// Whether two listings of a scene are answered alike, configuration by configuration.
inline bool same_answer(const LatticeAnswer& one, const LatticeAnswer& other) {
  bool same = one.has_family == other.has_family && one.mobility == other.mobility &&
              one.configurations.size() == other.configurations.size();
  for (std::size_t index = 0; same && index < one.configurations.size(); ++index) {
    const ListedConfiguration& a = one.configurations[index];
    const ListedConfiguration& b = other.configurations[index];
    same = a.regular == b.regular && difference(a, b) < same_configuration;
  }
  return same;
}

}  // namespace assur::test
