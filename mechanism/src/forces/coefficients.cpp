#include "coefficients.hpp"

#include <assur/mechanism/forces.hpp>
#include <assur/support/rigid_motion.hpp>
#include <cmath>

#include "balance.hpp"
#include "plan/plan_data.hpp"
#include "solve/relative_frames.hpp"

namespace assur::mechanism::forces {

namespace {

using Eigen::Vector2d;

/// Solves the equations of the links' rates: the transposed equilibrium.
class CoefficientFinder {
 public:
  CoefficientFinder(const Values& values, const Configuration& configuration,
                    const Balance& balance)
      : values_(values),
        mechanism_(values.plan().mechanism),
        configuration_(configuration),
        balance_(balance),
        equations_(balance.matrix().transpose(), balance.threshold(),
                   LinearEquations::OfLinks::columns) {}

  [[nodiscard]] KinematicCoefficients first() {
    KinematicCoefficients result;
    result.drivers = free_drivers(mechanism_);
    const Eigen::Index count = std::ssize(result.drivers);
    result.links.resize(mechanism_.links().size());
    for (Derivatives<3>& link : result.links) {
      link.set_zero(count, true);
    }
    Eigen::MatrixXd rates = Eigen::MatrixXd::Zero(balance_.matrix().cols(), count);
    for (std::size_t row = 0; row < balance_.held().size(); ++row) {
      const HeldCoordinate& held = balance_.held()[row];
      for (Eigen::Index column = 0; column < count; ++column) {
        if (held.driver.exists() &&
            held.driver == result.drivers[static_cast<std::size_t>(column)]) {
          rates(static_cast<Eigen::Index>(row), column) = unit_of(held);
        }
      }
    }
    const Eigen::MatrixXd moved = equations_.solve(rates);
    for (Eigen::Index column = 0; column < count; ++column) {
      for (const LinkIndex link : mechanism_.links().keys()) {
        result.links[link].first.col(column) = of_origin(link, moved.col(column));
      }
    }
    return result;
  }

  /// Second derivatives. The second derivative of a held coordinate along two motions vanishes, or
  /// is that of the law that drives it: J q_ij = law_ij - D2c(q_i, q_j).
  void add_second(KinematicCoefficients& result) {
    const Eigen::Index count = std::ssize(result.drivers);
    for (Eigen::Index i = 0; i < count; ++i) {
      for (Eigen::Index j = 0; j <= i; ++j) {
        Eigen::VectorXd bent(balance_.matrix().cols());
        for (std::size_t row = 0; row < balance_.held().size(); ++row) {
          const HeldCoordinate& held = balance_.held()[row];
          const HeldPair& pair = balance_.pairs()[held.pair];
          double second = -bend({pair.first, pair.second, held.coordinate}, result, i, j);
          if (held.driver.exists()) {
            second += law_bend(held.driver, result, i, j);
          }
          bent(static_cast<Eigen::Index>(row)) = unit_of(held) * second;
        }
        const Eigen::VectorXd moved = equations_.solve(bent);
        for (const LinkIndex link : mechanism_.links().keys()) {
          const Eigen::Vector3d second = of_origin(link, moved);
          for (std::size_t row = 0; row < 3; ++row) {
            result.links[link].second[row](i, j) = result.links[link].second[row](j, i) =
                second(static_cast<Eigen::Index>(row));
          }
        }
      }
    }
  }

  void add_points(KinematicCoefficients& result) const {
    const Eigen::Index count = std::ssize(result.drivers);
    result.outputs.resize(mechanism_.outputs().size());
    for (const OutputIndex output : mechanism_.outputs().keys()) {
      const FeatureIndex feature = mechanism_.outputs()[output].point;
      const LinkIndex link = mechanism_.features()[feature].link;
      const Pose<double>& at = values_.frame(feature).pose;
      const Vector2d arm =
          support::rotated<double>(configuration_.links[link].pose.direction, Vector2d(at.x, at.y));
      Derivatives<2>& point = result.outputs[output];
      point.set_zero(count, true);
      const Derivatives<3>& frame = result.links[link];
      for (Eigen::Index i = 0; i < count; ++i) {
        point.first.col(i) = support::carried<double>(frame.first.col(i), arm, Vector2d::Zero());
        for (Eigen::Index j = 0; j < count; ++j) {
          const Eigen::Vector3d second(frame.second[0](i, j), frame.second[1](i, j),
                                       frame.second[2](i, j));
          const Vector2d bent =
              support::carried_twice<double>(second, frame.first(2, i), frame.first(2, j), arm,
                                             Vector2d::Zero(), Vector2d::Zero(), Vector2d::Zero());
          point.second[0](i, j) = bent.x();
          point.second[1](i, j) = bent.y();
        }
      }
    }
  }

  void add_joints(KinematicCoefficients& result) const {
    const Eigen::Index count = std::ssize(result.drivers);
    for (const HeldPair& held : pairs_of_two_links(mechanism_, values_.plan().redundant)) {
      const CoordinatePair pair = balance_.coordinates().pair_of(held.between);
      Derivatives<1>& joint =
          result.joints.emplace_back(JointCoefficients{held.joint, {}}).coordinate;
      joint.set_zero(count, true);
      for (Eigen::Index i = 0; i < count; ++i) {
        joint.first(0, i) = relative(pair, along(result, i)).velocity(pair.coordinate);
        for (Eigen::Index j = 0; j < count; ++j) {
          joint.second[0](i, j) = bend(pair, result, i, j) + follows(pair, result, i, j);
        }
      }
    }
  }

 private:
  using Links = Table<LinkIndex, Frame>;

  [[nodiscard]] double unit_of(const HeldCoordinate& held) const {
    return held.coordinate == 2 ? balance_.size() : 1;
  }

  /// The derivatives (x, y, theta) of a link's frame from those of its pivot, which the equations
  /// give. Second derivatives are those of (x, y, theta) as well: the equations are linear in them.
  [[nodiscard]] Eigen::Vector3d of_origin(LinkIndex link, const Eigen::VectorXd& moved) const {
    Eigen::Vector3d result = Eigen::Vector3d::Zero();
    if (const Eigen::Index row = balance_.row_of(link); row >= 0) {
      const double turn = moved(row + 2) / balance_.size();
      const Pose<double>& pose = configuration_.links[link].pose;
      const Vector2d arm = Vector2d(pose.x, pose.y) - balance_.pivots()[link];
      result << moved.segment<2>(row) + turn * support::across<double>(arm), turn;
    }
    return result;
  }

  /// The links at their present poses, moving along one driver's coordinate.
  [[nodiscard]] Links along(const KinematicCoefficients& result, Eigen::Index i,
                            Eigen::Index j = -1, double sense = 1) const {
    Links links = configuration_.links;
    for (const LinkIndex link : links.keys()) {
      Frame& frame = links[link];
      frame.velocity = result.links[link].first.col(i);
      if (j >= 0) {
        frame.velocity += sense * result.links[link].first.col(j);
      }
      frame.acceleration.setZero();
    }
    return links;
  }

  [[nodiscard]] Frame relative(const CoordinatePair& pair, const Links& links) const {
    const auto placed = [&](FeatureIndex feature) {
      Frame at = values_.frame(feature);
      at.velocity.setZero();
      at.acceleration.setZero();
      return composed(links[mechanism_.features()[feature].link], at);
    };
    return solve::seen_from(placed(pair.first), placed(pair.second));
  }

  /// The second derivative of a coordinate along two motions without second derivatives of the
  /// links, from those along their sum and their difference.
  [[nodiscard]] double bend(const CoordinatePair& pair, const KinematicCoefficients& result,
                            Eigen::Index i, Eigen::Index j) const {
    const auto of = [&](double sense) {
      return relative(pair, along(result, i, j, sense)).acceleration(pair.coordinate);
    };
    return (of(1) - of(-1)) / 4;
  }

  /// The part of the second derivative of a coordinate that results from those of the links.
  [[nodiscard]] double follows(const CoordinatePair& pair, const KinematicCoefficients& result,
                               Eigen::Index i, Eigen::Index j) const {
    Links links = configuration_.links;
    for (const LinkIndex link : links.keys()) {
      const auto& second = result.links[link].second;
      links[link].velocity << second[0](i, j), second[1](i, j), second[2](i, j);
    }
    return relative(pair, links).velocity(pair.coordinate);
  }

  /// The second derivative of a law along two motions of the joints that it reads.
  [[nodiscard]] double law_bend(DriverIndex driver, const KinematicCoefficients& result,
                                Eigen::Index i, Eigen::Index j) const {
    const std::vector<JointIndex> read = balance_.coordinates().joints_of(driver);
    const Dual law = read.empty() ? Dual() : balance_.coordinates().law(driver);
    if (law.derivatives().size() == 0) {
      return 0;
    }
    const auto moved = [&](Eigen::Index column) {
      const Links links = along(result, column);
      Eigen::VectorXd rates(std::ssize(read));
      for (std::size_t place = 0; place < read.size(); ++place) {
        const CoordinatePair pair = balance_.coordinates().pair_of(read[place]);
        rates(static_cast<Eigen::Index>(place)) = relative(pair, links).velocity(pair.coordinate);
      }
      return rates;
    };
    double second = moved(i).dot(law.hessian() * moved(j));
    for (std::size_t place = 0; place < read.size(); ++place) {
      const CoordinatePair pair = balance_.coordinates().pair_of(read[place]);
      second += law.derivatives()(static_cast<Eigen::Index>(place)) * bend(pair, result, i, j);
    }
    return second;
  }

  const Values& values_;
  const Mechanism& mechanism_;
  const Configuration& configuration_;
  const Balance& balance_;
  LinearEquations equations_;
};

bool are_known(const KinematicCoefficients& coefficients) {
  for (const Derivatives<3>& link : coefficients.links) {
    if (!link.first.allFinite()) {
      return false;
    }
  }
  return true;
}

}  // namespace

KinematicCoefficients first_coefficients(const Values& values, const Configuration& configuration,
                                         const Balance& balance) {
  return CoefficientFinder(values, configuration, balance).first();
}

}  // namespace assur::mechanism::forces

namespace assur::mechanism {

std::vector<DriverIndex> described_drivers(const Mechanism& mechanism) {
  std::vector<DriverIndex> drivers;
  for (const DriverIndex driver : mechanism.drivers().keys()) {
    if (!mechanism.holds_idle(driver)) {
      drivers.push_back(driver);
    }
  }
  return drivers;
}

std::vector<DriverIndex> free_drivers(const Mechanism& mechanism) {
  std::vector<DriverIndex> drivers;
  for (const DriverIndex driver : described_drivers(mechanism)) {
    if (mechanism.numbers()[mechanism.drivers()[driver].position].formula.joints().empty()) {
      drivers.push_back(driver);
    }
  }
  return drivers;
}

KinematicCoefficients coefficients_of(const Values& values, const Configuration& configuration) {
  const forces::Balance balance(values, configuration);
  forces::CoefficientFinder finder(values, configuration, balance);
  KinematicCoefficients result = finder.first();
  finder.add_second(result);
  finder.add_points(result);
  finder.add_joints(result);
  result.reason = forces::are_known(result)
                      ? ""
                      : "the configuration is singular: the drivers do not determine the motion";
  return result;
}

}  // namespace assur::mechanism
