#include "groups/derived_kernel.hpp"

#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <assur/support/derivative_digits.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
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

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// A number with its derivatives to unknowns, inputs and dimensions.
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

/// Writes variables as tangents, each with a derivative of one by itself.
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

/// A series that runs along a straight line.
Series along(double start, double rate) {
  Series result(start);
  result.c[1] = rate;
  return result;
}

/// Variables that move along a straight line.
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

/// The configuration nearest to a complex one among those with real angles and displacements.
ComplexConfiguration made_real(ComplexConfiguration at) {
  for (Complex& theta : at.theta) {
    theta /= std::abs(theta);
  }
  at.s = at.s.real().cast<Complex>();
  return at;
}

/// The closures and their derivatives to real angles and displacements.
struct RealClosures {
  Eigen::VectorXd f;
  Eigen::MatrixXd j;
};

RealClosures real_closures(const LoopEquations& equations, const ComplexConfiguration& at) {
  const Eigen::Index loops = equations.loop_count();
  const Eigen::VectorXcd f = closures_at(equations, at);
  const Eigen::MatrixXcd j = jacobian_at(equations, at);
  RealClosures result{Eigen::VectorXd(2 * loops), Eigen::MatrixXd(2 * loops, j.cols())};
  result.f << f.head(loops).real(), f.head(loops).imag();
  result.j << j.topRows(loops).real(), j.topRows(loops).imag();
  return result;
}

/// The largest modulus of the closures' terms: they are not known to more than its roundings.
double reach_of(const LoopEquations& equations, const ComplexConfiguration& at) {
  double result = equations.of_angles.cwiseAbs().rowwise().sum().maxCoeff();
  for (Eigen::Index slide = 0; slide < at.s.size(); ++slide) {
    result += std::abs(at.s(slide));
  }
  return result;
}

/// What rounding may leave of the closures: each is a sum of some ten products of rounded numbers.
double rounding_of(const LoopEquations& equations, const ComplexConfiguration& at) {
  return 64 * epsilon * reach_of(equations, at);
}

/// Gauss and Newton's steps with damping, by Levenberg and Marquardt, to where the closures are
/// least; each step is measured with displacements in parts of the size.
ComplexConfiguration settled(const LoopEquations& equations, ComplexConfiguration at) {
  constexpr int most_steps = 100;
  double damping = 1e-3;
  RealClosures here = real_closures(equations, at);
  for (int step = 0; step < most_steps; ++step) {
    const Eigen::MatrixXd square = here.j.transpose() * here.j;
    const double scale = square.diagonal().maxCoeff();
    const Eigen::MatrixXd damped =
        square + damping * scale * Eigen::MatrixXd::Identity(square.rows(), square.cols());
    const Eigen::VectorXd by = damped.ldlt().solve(-here.j.transpose() * here.f);
    const ComplexConfiguration next = made_real(stepped(at, by.cast<Complex>()));
    RealClosures there = real_closures(equations, next);
    if (there.f.norm() < here.f.norm()) {
      at = next;
      here = std::move(there);
      damping /= 10;
    } else if (damping > 1e6) {
      break;
    } else {
      damping *= 10;
    }
  }
  return at;
}

double gap_between(const ComplexConfiguration& one, const ComplexConfiguration& other,
                   double size) {
  double result = (one.theta - other.theta).cwiseAbs().maxCoeff();
  return one.s.size() > 0 ? std::max(result, (one.s - other.s).cwiseAbs().maxCoeff() / size)
                          : result;
}

/// Where a configuration is not enclosed, rounding moves it by the root of a rounding, or more
/// where more than two meet.
const double apart = std::cbrt(epsilon);

/// The real configurations among those that are not enclosed, and the mobility of what moves.
class UnprovenConfigurations {
 public:
  UnprovenConfigurations(const LoopEquations& equations, const AllConfigurations& all)
      : equations_(equations), all_(all), size_(equations.size()) {
    for (const ComplexConfiguration& at : all.unproven) {
      include(made_real(at));
    }
  }
  [[nodiscard]] const std::vector<ComplexConfiguration>& configurations() const { return found_; }
  [[nodiscard]] int mobility() const { return mobility_; }

 private:
  void include(const ComplexConfiguration& near) {
    if (!near.theta.allFinite() || !near.s.allFinite()) {
      return;
    }
    const ComplexConfiguration at = settled(equations_, near);
    const RealClosures here = real_closures(equations_, at);
    if (!(here.f.norm() <= rounding_of(equations_, at)) ||
        gap_between(at, near, size_) > apart * 100) {
      return;
    }
    const auto is_here = [&](const ComplexConfiguration& other) {
      return gap_between(at, other, size_) < apart;
    };
    if (std::ranges::any_of(found_, is_here) ||
        std::ranges::any_of(all_.enclosed, [&](const Enclosed& one) { return is_here(one.at); })) {
      return;
    }
    if (const int freedoms = mobility_at(at, here); freedoms > 0) {
      mobility_ = std::max(mobility_, freedoms);
    } else {
      found_.push_back(at);
    }
  }

  /// How many directions of the kernel lead to configurations that close as well.
  [[nodiscard]] int mobility_at(const ComplexConfiguration& at, const RealClosures& here) const {
    constexpr double step = 0x1p-7;  // radians: the closures of an isolated one open by its square
    const Eigen::JacobiSVD<Eigen::MatrixXd> factors(in_size(here.j), Eigen::ComputeFullV);
    int result = 0;
    for (Eigen::Index column = 0; column < factors.singularValues().size(); ++column) {
      if (factors.singularValues()(column) > apart * factors.singularValues()(0)) {
        continue;
      }
      Eigen::VectorXd along = step * factors.matrixV().col(column);
      along.tail(at.s.size()) *= size_;
      const ComplexConfiguration there =
          settled(equations_, made_real(stepped(at, along.cast<Complex>())));
      const bool closes =
          real_closures(equations_, there).f.norm() <= rounding_of(equations_, there);
      result += closes && gap_between(there, at, size_) > step / 4 ? 1 : 0;
    }
    return result;
  }

  [[nodiscard]] Eigen::MatrixXd in_size(Eigen::MatrixXd j) const {
    j.leftCols(j.cols() - all_slides()) /= size_;
    return j;
  }
  [[nodiscard]] Eigen::Index all_slides() const { return equations_.slide_count(); }

  const LoopEquations& equations_;
  const AllConfigurations& all_;
  double size_;
  std::vector<ComplexConfiguration> found_;
  int mobility_ = 0;
};

/// How firmly the closures hold the unknowns, with displacements in parts of the group's size:
/// the least singular value of J over the largest.
Regularity<double> standing_of(const Eigen::MatrixXd& j, Eigen::Index slides, double size,
                               double unsure) {
  Regularity<double> result;
  if (!j.allFinite() || !(size > 0)) {
    result.status = Status::not_finite;
    return result;
  }
  Eigen::MatrixXd in_size = j / size;
  in_size.rightCols(slides) *= size;
  const Eigen::JacobiSVD<Eigen::MatrixXd> factors(in_size);
  const double largest = factors.singularValues()(0);
  const double least = factors.singularValues()(j.cols() - 1);
  result.rounding = static_cast<double>(4 * j.rows()) * (epsilon + unsure);
  result.margin = result.firmness = largest > 0 ? least / largest : 0;
  result.status = !(result.margin > result.rounding)     ? Status::singular
                  : result.error() < support::six_digits ? Status::ok
                                                         : Status::near_singular;
  return result;
}

/// How far rounding may have moved the links of a group, as `support::DisplacedGroup` has it.
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
  // Numbers in general position tell which coefficients are zero by structure, and how many complex
  // configurations there are; each trial must find the same number.
  constexpr std::uint64_t seed = 20261128;
  constexpr int trials = 3;
  std::mt19937_64 engine(seed);
  std::uniform_real_distribution<double> length(-1, 1);
  std::uniform_real_distribution<double> angle(-std::numbers::pi, std::numbers::pi);
  const auto general = [&] {
    std::vector<JointFeatures<double>> result;
    for (const ModelJoint& joint : loops_.joints) {
      JointFeatures<double> features;
      for (LinkFeature<double>* feature : {&features.on_first, &features.on_second}) {
        const double x = length(engine);
        const double y = length(engine);
        *feature = {joint.prismatic, x, y, direction_of(joint.prismatic ? angle(engine) : 0.0)};
      }
      result.push_back(features);
    }
    return loop_equations(loops_, result);
  };
  eliminations_ = eliminations_of(general());
  for (int trial = 0; trial < trials && !eliminations_.empty(); ++trial) {
    const LoopEquations equations = general();
    // Two eliminations that hide different angles, so that none is lost by chance.
    const std::vector<Elimination> few = {eliminations_.front(), eliminations_.back()};
    complex_count_ =
        std::max(complex_count_,
                 all_configurations(equations, few, std::numeric_limits<int>::max()).count());
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

FlatVariables DerivedKernel::flat(const ComplexConfiguration& at) const {
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
  const AllConfigurations all = all_configurations(equations, eliminations_, complex_count_);
  GroupProof result{all.count(), complex_count_, 0, ""};
  for (const Enclosed& one : all.enclosed) {
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
  const double size = equations.size();
  found.status = equations.of_angles.allFinite() && equations.of_slides.allFinite() && size > 0
                     ? AssemblyStatus::ok
                     : AssemblyStatus::not_finite;
  if (found.status != AssemblyStatus::ok) {
    return;
  }
  const AllConfigurations all = all_configurations(equations, eliminations_, complex_count_);
  std::vector<ComplexConfiguration> real;
  for (const Enclosed& one : all.enclosed) {
    if (one.is_real) {
      real.push_back(made_real(one.at));
    }
  }
  if (all.count() == complex_count_) {
    found.complex_count = std::nullopt;
  } else {
    const UnprovenConfigurations unproven(equations, all);
    real.insert(real.end(), unproven.configurations().begin(), unproven.configurations().end());
    found.mobility = unproven.mobility();
    found.complex_count = all.count();
  }
  found.configurations.resize(
      std::max<std::size_t>(real.size(), static_cast<std::size_t>(models::most_configurations)));
  found.regularity.resize(found.configurations.size());
  const double unsure = std::max(displaced.moved / size, displaced.turned);
  for (const ComplexConfiguration& at : real) {
    found.configurations[found.count] = flat(at);
    const Status status =
        standing_of(real_closures(equations, at).j, equations.slide_count(), size, unsure).status;
    found.regularity[found.count++] = status == Status::ok ? Status::ok : Status::near_singular;
  }
  if (found.count == 0 && found.mobility > 0) {
    found.status = AssemblyStatus::degenerate;
  }
}

Status DerivedKernel::gap(const FlatVariables& d, const FlatVariables& u, double& result) const {
  const LoopEquations equations = loop_equations(loops_, features(d, u));
  if (!equations.of_angles.allFinite() || !equations.of_slides.allFinite()) {
    return Status::not_finite;
  }
  result = std::numeric_limits<double>::infinity();
  for (const Elimination& elimination : eliminations_) {
    for (const ComplexConfiguration& near : candidates(equations, elimination)) {
      const ComplexConfiguration at = settled(equations, made_real(near));
      result = std::min(result, real_closures(equations, at).f.norm());
    }
    if (std::isfinite(result)) {
      break;
    }
  }
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

  motion.size = loop_equations(loops_, features(d, u)).size();
  const double longest_input = longest(input_is_angle_, u);
  const support::Displacement given = query.displaced;
  const double moved = std::max(given.moved, epsilon * longest_input);
  motion.held = std::max(moved, given.turned * motion.size);
  motion.standing =
      standing_of(j, loops_.slide_count, motion.size, std::max(moved / motion.size, given.turned));
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
