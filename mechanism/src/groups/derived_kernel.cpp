#include "groups/derived_kernel.hpp"

#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <assur/loops/real_configurations.hpp>
#include <assur/support/derivative_digits.hpp>
#include <assur/support/solved_by_lu.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <unsupported/Eigen/AutoDiff>
#include <utility>

namespace assur::mechanism::groups {

namespace {

using models::Flat;
using models::FlatSeries;
using models::FlatVariables;
using models::Series;
using models::SmallMatrix;
using models::SmallVector;

using assur::loops::Complex;
using assur::loops::epsilon;
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// A number with its derivatives with respect to unknowns, inputs and dimensions.
using Tangent = Eigen::AutoDiffScalar<Eigen::Matrix<double, most_variables, 1>>;

/// Reads lengths and directions from a flat list, one after the other.
template <typename Scalar>
class FlatReader {
 public:
  explicit FlatReader(const Flat<Scalar>& from) : next_(from.data()) {}
  [[nodiscard]] Scalar length() { return *next_++; }
  [[nodiscard]] Direction<Scalar> direction() {
    const Scalar cos = *next_++;
    return {cos, *next_++};
  }

 private:
  const Scalar* next_;
};

/// Writes variables as tangents, each with unit derivative by itself.
class Seeds {
 public:
  [[nodiscard]] Flat<Tangent> seeded(const std::vector<bool>& are_angles,
                                     const FlatVariables& from) {
    Flat<Tangent> result;
    std::size_t place = 0;
    for (const bool is_angle : are_angles) {
      result[place] = from[place];
      if (is_angle) {
        result[place + 1] = from[place + 1];
        result[place].derivatives()(next_) = -from[place + 1];
        result[place + 1].derivatives()(next_) = from[place];
      } else {
        result[place].derivatives()(next_) = 1;
      }
      place += is_angle ? 2 : 1;
      ++next_;
    }
    return result;
  }
  [[nodiscard]] Eigen::Index count() const { return next_; }

 private:
  Eigen::Index next_ = 0;
};

/// The derivatives of a group's closures and of its links' poses, a column per variable.
struct AllDerivatives {
  Eigen::MatrixXd closures, poses;
};

AllDerivatives derivatives_of(const PlacedLinks<Tangent>& placed, Eigen::Index count) {
  AllDerivatives result{Eigen::MatrixXd(placed.closures.size(), count),
                        Eigen::MatrixXd(3 * placed.poses.size(), count)};
  for (std::size_t row = 0; row < placed.closures.size(); ++row) {
    result.closures.row(static_cast<Eigen::Index>(row)) =
        placed.closures[row].derivatives().head(count).transpose();
  }
  for (std::size_t link = 0; link < placed.poses.size(); ++link) {
    const auto& [x, y, direction] = placed.poses[link];
    const auto row = 3 * static_cast<Eigen::Index>(link);
    result.poses.row(row) = x.derivatives().head(count).transpose();
    result.poses.row(row + 1) = y.derivatives().head(count).transpose();
    result.poses.row(row + 2) = (direction.cos.value() * direction.sin.derivatives() -
                                 direction.sin.value() * direction.cos.derivatives())
                                    .head(count)
                                    .transpose();
  }
  return result;
}

/// A linear series.
Series along(double start, double rate) {
  Series result(start);
  result.c[1] = rate;
  return result;
}

/// Variables that change linearly.
FlatSeries moving(const std::vector<bool>& are_angles, const FlatVariables& from,
                  const SmallVector& rate) {
  FlatSeries result;
  std::size_t place = 0;
  Eigen::Index variable = 0;
  for (const bool is_angle : are_angles) {
    if (is_angle) {
      const Direction<Series> turned =
          models::turning({from[place], from[place + 1]}, along(0, rate(variable)));
      result[place++] = turned.cos;
      result[place++] = turned.sin;
    } else {
      result[place] = along(from[place], rate(variable));
      ++place;
    }
    ++variable;
  }
  return result;
}

/// The longest of the lengths among variables.
double longest(const std::vector<bool>& are_angles, const FlatVariables& variables) {
  double result = 0;
  std::size_t place = 0;
  for (const bool is_angle : are_angles) {
    result = is_angle ? result : std::max(result, std::abs(variables[place]));
    place += is_angle ? 2 : 1;
  }
  return result;
}

/// The displacement of a group's links that rounding may cause, as in `support::DisplacedGroup`.
support::Displacement displaced_links(const SmallMatrix& inverse, Eigen::Index angles, double size,
                                      double longest_input, double longest_slide,
                                      const support::Displacement& given) {
  const double reach = std::max(given.reach, size);
  if (!inverse.allFinite()) {
    return {std::numeric_limits<double>::infinity(), std::numbers::pi, reach, size};
  }
  double largest = 0;
  double turn = 0;
  for (Eigen::Index row = 0; row < inverse.rows(); ++row) {
    double sum = 0;
    for (Eigen::Index loop = 0; loop < inverse.cols(); loop += 2) {
      sum += std::hypot(inverse(row, loop), inverse(row, loop + 1));
    }
    largest = std::max(largest, (row < angles ? size : 1) * sum);
    turn = std::max(turn, row < angles ? sum : 0);
  }
  const double moved = given.moved + epsilon * longest_input;
  const double open = 2 * (moved + given.turned * std::max(size, longest_slide)) + epsilon * size;
  return {moved + largest * open,
          std::min(given.turned + epsilon + (turn > 0 ? turn * open : 0), std::numbers::pi), reach,
          size};
}

}  // namespace

DerivedKernel::DerivedKernel(Loops loops, std::vector<std::vector<int>> link_joints)
    : loops_(std::move(loops)), link_joints_(std::move(link_joints)) {
  unknown_is_angle_.assign(static_cast<std::size_t>(loops_.angle_count), true);
  unknown_is_angle_.insert(unknown_is_angle_.end(), static_cast<std::size_t>(loops_.slide_count),
                           false);
  for (const ModelJoint& joint : loops_.joints) {
    if (joint.first == base_link) {
      input_is_angle_.insert(input_is_angle_.end(), {false, false});
      input_is_angle_.insert(input_is_angle_.end(), joint.prismatic ? 1 : 0, true);
    }
  }
  for (const std::vector<int>& joints : link_joints_) {
    const int origin = origin_of(joints);
    for (const int joint : joints) {
      const bool is_line = slides(joint);
      dimension_is_angle_.insert(dimension_is_angle_.end(), is_line ? 1 : 0, true);
      dimension_is_angle_.insert(dimension_is_angle_.end(),
                                 joint == origin ? 0
                                 : is_line       ? 1
                                                 : 2,
                                 false);
    }
  }
  // Numbers in general position show which coefficients are structurally zero, and the number of
  // complex configurations; each trial must find the same number.
  constexpr int trials = 3;
  constexpr int any_number = std::numeric_limits<int>::max();
  GeneralEquations general(loops_);
  eliminations_ = eliminations_of(general.next());
  const std::vector<assur::loops::Elimination>& all = eliminations_.list();
  for (int trial = 0; trial < trials && !all.empty(); ++trial) {
    // Two eliminations that hide different angles, so that no solution is lost by chance.
    const std::vector<assur::loops::Elimination> few = {all.front(), all.back()};
    complex_count_ = std::max(
        complex_count_, assur::loops::all_configurations(general.next(), few, any_number).count());
  }
  if (all.empty()) {
    starts_ = Starts(general);
    complex_count_ = starts_.complex_count();
  }
}

bool DerivedKernel::slides(int joint) const {
  return loops_.joints[static_cast<std::size_t>(joint)].prismatic;
}

int DerivedKernel::origin_of(const std::vector<int>& joints) const {
  const auto point = std::ranges::find_if_not(joints, [&](int joint) { return slides(joint); });
  return point != joints.end() ? *point : joints.front();
}

template <typename Scalar>
std::vector<JointFeatures<Scalar>> DerivedKernel::features(const Flat<Scalar>& d,
                                                           const Flat<Scalar>& u) const {
  std::vector<JointFeatures<Scalar>> result(loops_.joints.size());
  for (std::size_t joint = 0; joint < result.size(); ++joint) {
    result[joint].on_first.line = result[joint].on_second.line = loops_.joints[joint].prismatic;
  }
  FlatReader<Scalar> dimensions(d);
  for (int link = 0; link < loops_.link_count; ++link) {
    const std::vector<int>& joints = link_joints_[static_cast<std::size_t>(link)];
    const int origin = origin_of(joints);
    for (const int joint : joints) {
      const auto place = static_cast<std::size_t>(joint);
      LinkFeature<Scalar>& feature =
          loops_.joints[place].first == link ? result[place].on_first : result[place].on_second;
      feature.x = feature.y = Scalar(0);
      if (feature.line) {
        feature.along = dimensions.direction();
      }
      if (joint != origin && feature.line) {
        const Scalar offset = dimensions.length();
        feature.x = -offset * feature.along.sin;
        feature.y = offset * feature.along.cos;
      } else if (joint != origin) {
        feature.x = dimensions.length();
        feature.y = dimensions.length();
      }
    }
  }
  FlatReader<Scalar> inputs(u);
  for (std::size_t joint = 0; joint < result.size(); ++joint) {
    if (loops_.joints[joint].first == base_link) {
      LinkFeature<Scalar>& feature = result[joint].on_first;
      feature.x = inputs.length();
      feature.y = inputs.length();
      if (feature.line) {
        feature.along = inputs.direction();
      }
    }
  }
  return result;
}

template <typename Scalar>
PlacedLinks<Scalar> DerivedKernel::placed(const Flat<Scalar>& d, const Flat<Scalar>& u,
                                          const Flat<Scalar>& q) const {
  FlatReader<Scalar> unknowns(q);
  std::vector<Direction<Scalar>> angles;
  for (int angle = 0; angle < loops_.angle_count; ++angle) {
    angles.push_back(unknowns.direction());
  }
  std::vector<Scalar> displacements;
  for (int slide = 0; slide < loops_.slide_count; ++slide) {
    displacements.push_back(unknowns.length());
  }
  return place_links(loops_, features(d, u), angles, displacements);
}

FlatVariables DerivedKernel::flat(const ComplexConfiguration& at) {
  FlatVariables result{};
  double* to = result.data();
  for (Eigen::Index angle = 1; angle < at.theta.size(); ++angle) {
    const Complex theta = at.theta(angle) / std::abs(at.theta(angle));
    *to++ = theta.real();
    *to++ = theta.imag();
  }
  for (const Complex& s : at.s) {
    *to++ = s.real();
  }
  return result;
}

GroupProof DerivedKernel::proof(const std::vector<JointFeatures<double>>& features,
                                const std::vector<Direction<double>>& directions) const {
  const LoopEquations equations = loop_equations(loops_, features);
  const auto all = by_every_way([&](const auto& ways) {
    return assur::loops::all_configurations(equations, ways, complex_count_);
  });
  GroupProof result{all.count(), complex_count_, 0, ""};
  for (const assur::loops::Enclosed<assur::loops::AnySizes>& one : all.enclosed) {
    double distance = 0;
    for (std::size_t angle = 0; angle < loops_.free_turned.size(); ++angle) {
      const auto& [cos, sin] = directions[static_cast<std::size_t>(loops_.free_turned[angle])];
      distance = std::max(distance, std::abs(one.at.theta(static_cast<Eigen::Index>(angle) + 1) -
                                             Complex(cos, sin)));
    }
    if (one.is_real && distance <= one.alone) {
      result.radius = std::max(result.radius, one.holds);
    }
  }
  if (result.radius == 0) {
    result.obstacle = "the configuration is too close to a multiple one to be enclosed";
  }
  return result;
}

void DerivedKernel::assemble(const FlatVariables& d, const FlatVariables& u,
                             const support::Displacement& displaced,
                             models::GroupAssemblies& found) const {
  const LoopEquations equations = loop_equations(loops_, features(d, u));
  found.count = 0;
  found.mobility = 0;
  found.is_compatible = true;
  found.complex_count = std::nullopt;
  found.status = equations.is_finite() && equations.size() > 0 ? AssemblyStatus::ok
                                                               : AssemblyStatus::not_finite;
  if (found.status != AssemblyStatus::ok) {
    return;
  }
  const auto real = by_every_way([&](const auto& ways) {
    return assur::loops::real_configurations(equations, ways, complex_count_);
  });
  if (real.complex_count < complex_count_) {
    found.mobility = real.mobility;
    found.complex_count = real.complex_count;
  }
  found.configurations.resize(std::max<std::size_t>(
      real.list.size(), static_cast<std::size_t>(models::most_configurations)));
  found.regularity.resize(found.configurations.size());
  const double unsure = unsure_jacobian(d, u, displaced);
  const double size = size_of(d, u);
  for (const ComplexConfiguration& at : real.list) {
    found.configurations[found.count] = flat(at);
    const Eigen::MatrixXd j = assur::loops::real_closures(equations, at).j;
    const Status status = regularity(j, size, unsure).status;
    found.regularity[found.count++] = status == Status::ok ? Status::ok : Status::near_singular;
  }
  if (found.count == 0 && found.mobility > 0) {
    found.status = AssemblyStatus::degenerate;
  }
}

Regularity<double> DerivedKernel::regularity(const Eigen::MatrixXd& j, double size,
                                             double unsure) const {
  Eigen::MatrixXd in_size = j;
  in_size.leftCols(loops_.angle_count) /= size;
  return support::regularity_by_lu(in_size, unsure);
}

double DerivedKernel::size_of(const FlatVariables& d, const FlatVariables& u) const {
  const auto without_lengths = [](const std::vector<bool>& are_angles) {
    FlatVariables result{};
    std::size_t place = 0;
    for (const bool is_angle : are_angles) {
      result[place] = is_angle ? 1 : 0;
      place += is_angle ? 2 : 1;
    }
    return result;
  };
  double result = longest(dimension_is_angle_, d);
  for (const double closure :
       placed(without_lengths(dimension_is_angle_), u, without_lengths(unknown_is_angle_))
           .closures) {
    result = std::max(result, std::abs(closure));
  }
  return result;
}

double DerivedKernel::unsure_jacobian(const FlatVariables& d, const FlatVariables& u,
                                      const support::Displacement& displaced) const {
  const support::Displacement by = displaced.bounded();
  const double moved = std::max(by.moved, epsilon * longest(input_is_angle_, u));
  return moved > 0 ? std::max(moved / size_of(d, u), by.turned) : by.turned;
}

Status DerivedKernel::gap(const FlatVariables& d, const FlatVariables& u, double& result) const {
  const LoopEquations equations = loop_equations(loops_, features(d, u));
  if (!equations.is_finite()) {
    return Status::not_finite;
  }
  result = std::numeric_limits<double>::infinity();
  by_every_way([&](const auto& ways) {
    for (auto way = ways.begin(); way != ways.end() && !std::isfinite(result); ++way) {
      assur::loops::each_candidate(equations, *way, [&](const ComplexConfiguration& near) {
        const ComplexConfiguration at =
            assur::loops::settled(equations, assur::loops::made_real(near));
        result = std::min(result, assur::loops::real_closures(equations, at).f.norm());
      });
    }
  });
  return std::isfinite(result) ? Status::ok : Status::not_finite;
}

void DerivedKernel::stand(const FlatVariables& d, const FlatVariables& u, const FlatVariables& q,
                          models::GroupPoses& poses) const {
  const PlacedLinks<double> links = placed(d, u, q);
  std::ranges::copy(links.poses, poses.begin());
}

void DerivedKernel::move(const FlatVariables& d, const FlatVariables& u, const FlatVariables& q,
                         const models::MotionQuery& query, models::GroupMotion& motion) const {
  const PlacedLinks<double> links = placed(d, u, q);
  std::ranges::copy(links.poses, motion.poses.begin());
  motion.residual = 0;
  for (const double closure : links.closures) {
    motion.residual = std::max(motion.residual, std::abs(closure));
  }
  const Eigen::Index unknowns = std::ssize(unknown_is_angle_);
  const Eigen::Index inputs = std::ssize(input_is_angle_);
  Seeds seeds;
  const Flat<Tangent> of_q = seeds.seeded(unknown_is_angle_, q);
  const Flat<Tangent> of_u = seeds.seeded(input_is_angle_, u);
  const Flat<Tangent> of_d = seeds.seeded(dimension_is_angle_, d);
  const AllDerivatives all = derivatives_of(placed(of_d, of_u, of_q), seeds.count());
  const Eigen::MatrixXd j = all.closures.leftCols(unknowns);
  const Eigen::MatrixXd f_u = all.closures.middleCols(unknowns, inputs);
  const Eigen::MatrixXd p_q = all.poses.leftCols(unknowns);
  const Eigen::MatrixXd p_u = all.poses.middleCols(unknowns, inputs);

  motion.size = size_of(d, u);
  const double longest_input = longest(input_is_angle_, u);
  const support::Displacement given = query.displaced;
  motion.held =
      std::max(std::max(given.moved, epsilon * longest_input), given.turned * motion.size);
  motion.standing = regularity(j, motion.size, unsure_jacobian(d, u, given));
  const bool solvable = is_solvable(motion.standing.status);
  motion.inverse = solvable ? Eigen::MatrixXd(j.fullPivLu().inverse())
                            : Eigen::MatrixXd::Constant(unknowns, unknowns, unknown);
  motion.displaced = displaced_links(motion.inverse, loops_.angle_count, motion.size, longest_input,
                                     longest(unknown_is_angle_, q), given);

  motion.rate = -motion.inverse * (f_u * query.input_rate);
  motion.second_rate = SmallVector::Constant(unknowns, unknown);
  SmallVector velocities = p_q * motion.rate + p_u * query.input_rate;
  SmallVector accelerations = SmallVector::Constant(velocities.size(), unknown);
  if (motion.rate.allFinite()) {
    models::Curvature curvature;
    bend(d, u, q, motion.rate, SmallVector::Zero(std::ssize(dimension_is_angle_)), query.input_rate,
         curvature);
    motion.second_rate = motion.inverse * (curvature.closures - f_u * query.input_second_rate);
    accelerations = p_q * motion.second_rate + p_u * query.input_second_rate + curvature.poses;
  }
  motion.velocities.resize(loops_.link_count, 3);
  motion.accelerations.resize(loops_.link_count, 3);
  for (Eigen::Index link = 0; link < loops_.link_count; ++link) {
    motion.velocities.row(link) = velocities.segment<3>(3 * link).transpose();
    motion.accelerations.row(link) = accelerations.segment<3>(3 * link).transpose();
  }
  if (query.derivatives) {
    const Eigen::Index dimensions = std::ssize(dimension_is_angle_);
    motion.q_u = -motion.inverse * f_u;
    motion.q_d = -motion.inverse * all.closures.rightCols(dimensions);
    motion.p_q = p_q;
    motion.p_u = p_u;
    motion.p_d = all.poses.rightCols(dimensions);
  }
}

void DerivedKernel::bend(const FlatVariables& d, const FlatVariables& u, const FlatVariables& q,
                         const SmallVector& q_x, const SmallVector& d_x, const SmallVector& u_x,
                         models::Curvature& along_x) const {
  models::MovingGroup group;
  expand(moving(dimension_is_angle_, d, d_x), moving(input_is_angle_, u, u_x),
         moving(unknown_is_angle_, q, q_x), group);
  along_x.closures.resize(2 * loops_.loop_count());
  for (Eigen::Index row = 0; row < along_x.closures.size(); ++row) {
    along_x.closures(row) = -group.closures[static_cast<std::size_t>(row)].second_rate();
  }
  along_x.poses.resize(3 * loops_.link_count);
  for (int link = 0; link < loops_.link_count; ++link) {
    const Pose<Series>& pose = group.poses[static_cast<std::size_t>(link)];
    along_x.poses.segment<3>(3 * link) << pose.x.second_rate(), pose.y.second_rate(),
        models::second_turning_rate(pose.direction);
  }
}

void DerivedKernel::expand(const FlatSeries& d, const FlatSeries& u, const FlatSeries& q,
                           models::MovingGroup& moving) const {
  const PlacedLinks<Series> links = placed(d, u, q);
  std::ranges::copy(links.closures, moving.closures.begin());
  std::ranges::copy(links.poses, moving.poses.begin());
}

}  // namespace assur::mechanism::groups
