// The scene tasks: the worst case of the six-bar's point M at 360 positions.
#include <benchmark/benchmark.h>

#include <assur/scenes/zhauyt_2017_six_bar.hpp>
#include <memory>

#include "precise.hpp"
#include "scenes/six_bar.hpp"
#include "tasks.hpp"

namespace assur::speed {

namespace {

using Solver = scenes::Zhauyt2017SixBar;
using P = SixBar;

/// The six-bar in one scalar: the group's dimensions and their derivatives by the parameters.
template <typename Scalar>
struct Mechanism {
  Scalar OA;
  TriadModel::Dimensions<Scalar> d;
  Plate<Scalar> at;
  Vector<Scalar, 3> x_D_by, y_D_by;  ///< D on the plate to BE, BD, ED

  Mechanism() {
    const auto number = [](int index) { return scalar(P::value[slot(index)]); };
    using std::sqrt;
    const Scalar BE = number(P::BE);
    const Scalar BD = number(P::BD);
    const Scalar ED = number(P::ED);
    OA = number(P::OA);
    at = plate<Scalar>(BE, BD, ED, {Scalar(1) / Scalar(2), sixty_degrees_sine()});
    d = {BE, at.x_D, at.y_D, number(P::AB), number(P::EF), number(P::DG)};
    x_D_by << Scalar(1) - at.x_D / BE, BD / BE, -ED / BE;
    y_D_by << -at.x_D * x_D_by(0) / at.y_D, (BD - at.x_D * x_D_by(1)) / at.y_D,
        -at.x_D * x_D_by(2) / at.y_D;
  }
  [[nodiscard]] TriadModel::Inputs<Scalar> inputs(const Direction<Scalar>& crank) const {
    const auto number = [](int index) { return scalar(P::value[slot(index)]); };
    return {number(P::x_O) + OA * crank.cos,
            number(P::y_O) + OA * crank.sin,
            number(P::x_F),
            number(P::y_F),
            number(P::x_G),
            number(P::y_G)};
  }
  static constexpr std::size_t slot(int index) { return static_cast<std::size_t>(index); }
  static Scalar sixty_degrees_sine() {
    using std::sqrt;
    return sqrt(scalar(0.75));
  }

 private:
  /// A float of 60 digits, since CLN takes the root of an integer in single precision.
  static Scalar scalar(double value) {
    if constexpr (std::is_same_v<Scalar, Precise>) {
      return precise(value);
    } else {
      return value;
    }
  }
};

/// The worst case of M from the group's sensitivities: dM/da of each parameter by the chain rule.
template <typename Scalar>
Vector<Scalar, 2> worst_case(const Mechanism<Scalar>& mechanism, const Direction<Scalar>& crank,
                             const TriadModel::Configuration<Scalar>& q,
                             const Matrix<Scalar, 4, 6>& S_d, const Matrix<Scalar, 4, 6>& S_u) {
  using std::abs;
  const auto& plate_turn = q.theta_CEG;
  const auto& bar_turn = q.theta_BC;
  const auto& at = mechanism.at;
  // The displacement of M per rotation of the plate and of the bar.
  const Scalar x_plate = -(plate_turn.sin * at.x_M + plate_turn.cos * at.y_M);
  const Scalar y_plate = plate_turn.cos * at.x_M - plate_turn.sin * at.y_M;
  const Scalar x_bar = -mechanism.d.BC * bar_turn.sin;
  const Scalar y_bar = mechanism.d.BC * bar_turn.cos;
  Scalar x_sum(0);
  Scalar y_sum(0);
  const auto add = [&](const Scalar& plate_rate, const Scalar& bar_rate, const Scalar& x,
                       const Scalar& y, double tolerance) {
    const Scalar half_width = Scalar(static_cast<int>(20 * tolerance)) / Scalar(20);
    x_sum = x_sum + abs(x + x_plate * plate_rate + x_bar * bar_rate) * half_width;
    y_sum = y_sum + abs(y + y_plate * plate_rate + y_bar * bar_rate) * half_width;
  };
  const auto tolerance = [](int index) { return P::tolerance[static_cast<std::size_t>(index)]; };
  const Scalar zero(0);
  const Scalar one(1);
  add(S_u(0, 0), S_u(1, 0), one, zero, tolerance(P::x_O));
  add(S_u(0, 1), S_u(1, 1), zero, one, tolerance(P::y_O));
  add(crank.cos * S_u(0, 0) + crank.sin * S_u(0, 1), crank.cos * S_u(1, 0) + crank.sin * S_u(1, 1),
      crank.cos, crank.sin, tolerance(P::OA));
  add(S_d(0, 3), S_d(1, 3), bar_turn.cos, bar_turn.sin, tolerance(P::AB));
  const auto by_plate = [&](int index, int row) {
    return mechanism.x_D_by(index) * S_d(row, 1) + mechanism.y_D_by(index) * S_d(row, 2);
  };
  add(S_d(0, 0) + by_plate(0, 0), S_d(1, 0) + by_plate(0, 1), plate_turn.cos, plate_turn.sin,
      tolerance(P::BE));
  add(by_plate(1, 0), by_plate(1, 1), zero, zero, tolerance(P::BD));
  add(by_plate(2, 0), by_plate(2, 1), zero, zero, tolerance(P::ED));
  add(S_d(0, 4), S_d(1, 4), zero, zero, tolerance(P::EF));
  add(S_d(0, 5), S_d(1, 5), zero, zero, tolerance(P::DG));
  add(S_u(0, 2), S_u(1, 2), zero, zero, tolerance(P::x_F));
  add(S_u(0, 3), S_u(1, 3), zero, zero, tolerance(P::y_F));
  add(S_u(0, 4), S_u(1, 4), zero, zero, tolerance(P::x_G));
  add(S_u(0, 5), S_u(1, 5), zero, zero, tolerance(P::y_G));
  return {x_sum, y_sum};
}

const Mechanism<double>& six_bar() {
  static const Mechanism<double> made;
  return made;
}

InputMotion<TriadModel> input_motion(double crank) {
  const Direction<double> direction = direction_of(crank);
  const double x = six_bar().OA * direction.cos;
  const double y = six_bar().OA * direction.sin;
  return {six_bar().inputs(direction), {-y, x, 0, 0, 0, 0}, {-x, -y, 0, 0, 0, 0}};
}

SixBarAnswer at_known(double crank, const TriadModel::Configuration<double>& q) {
  const Direction<double> direction = direction_of(crank);
  Matrix<double, 4, 6> S_d;
  Matrix<double, 4, 6> S_u;
  TriadModel::sensitivities(six_bar().d, six_bar().inputs(direction), q, S_d, S_u);
  return {false, worst_case<double>(six_bar(), direction, q, S_d, S_u)};
}

SixBarAnswer tracked(const SixBarSample& sample) {
  const auto way = track<TriadModel>(six_bar().d, input_motion, sample.previous_crank, sample.crank,
                                     sample.previous);
  return way.status == Status::ok ? at_known(sample.crank, way.point.q) : SixBarAnswer{true, {}};
}

/// Both configurations with all results of the scene, velocities and accelerations included.
SixBarAnswer all_configurations(const SixBarSample& sample) {
  std::array<Solver::State<double>, Solver::max_configurations> states;
  Solver::Drivers<double> drivers;
  drivers.O.position = sample.crank;
  const auto solution = Solver::solve(drivers, states);
  benchmark::DoNotOptimize(states);
  for (int index = 0; index < solution.count; ++index) {
    const auto& state = states[static_cast<std::size_t>(index)];
    if (state.links.output.pose.direction.cos > 0) {
      return {false, state.outputs.M.worst_case};
    }
  }
  return {true, {}};
}

struct SixBarSamples {
  std::vector<SixBarSample> list;
  std::vector<Vector<Precise, 2>> truth;
};

SixBarSamples around_the_turn() {
  const Mechanism<Precise> exact;
  SixBarSamples samples;
  SixBarSample last;
  for (int degree = -1; degree < P::positions; ++degree) {
    SixBarSample sample;
    sample.crank = degree * (3.14159265358979323846 / 180);
    const auto set = assemblies<TriadModel>(six_bar().d, input_motion(sample.crank).u);
    for (int index = 0; index < set.count; ++index) {
      const auto& q = set.configurations[static_cast<std::size_t>(index)];
      sample.q = q.theta_FG.cos > 0 ? q : sample.q;
    }
    const Direction<Precise> crank = direction_of<Precise>(precise(sample.crank));
    const auto u = exact.inputs(crank);
    auto q = in_scalar<TriadModel::Configuration<Precise>>(sample.q);
    (void)assemble<TriadModel>(exact.d, u, q);
    sample.q = in_scalar<TriadModel::Configuration<double>>(q);
    sample.theta = {angle_of(sample.q.theta_CEG), angle_of(sample.q.theta_BC),
                    angle_of(sample.q.theta_DE), angle_of(sample.q.theta_FG)};
    Matrix<Precise, 4, 6> F_d;
    Matrix<Precise, 4, 6> F_u;
    TriadModel::dimension_jacobian(exact.d, u, q, F_d);
    TriadModel::input_jacobian(exact.d, u, q, F_u);
    const PreciseJacobian<TriadModel> jacobian(exact.d, u, q);
    sample.previous_crank = last.crank;
    sample.previous = branch_point<TriadModel>(six_bar().d, input_motion(last.crank), last.q);
    sample.previous_theta = last.theta;
    last = sample;
    if (degree >= 0) {
      samples.list.push_back(sample);
      samples.truth.push_back(
          worst_case<Precise>(exact, crank, q, jacobian.solve<6>(-F_d), jacobian.solve<6>(-F_u)));
    }
  }
  return samples;
}

template <typename Answer>
void add(Task& task, const std::shared_ptr<const SixBarSamples>& samples, const std::string& method,
         Answer answer_of) {
  Entry entry;
  entry.row.task = task.name;
  entry.row.method = method;
  ErrorTally tally;
  for (std::size_t index = 0; index < samples->list.size(); ++index) {
    const SixBarAnswer answer = answer_of(samples->list[index]);
    double error = answer.failed ? 10 : 0;
    for (int axis = 0; axis < 2 && !answer.failed; ++axis) {
      const Precise& exact = samples->truth[index](axis);
      const Precise off = abs(precise(answer.worst_case(axis)) - exact) / exact;
      error = std::max(error, cln::double_approx(off));
    }
    tally.add(error);
  }
  tally.write_to(entry.row);
  entry.run = [samples, answer_of](std::size_t first, std::size_t last) {
    for (std::size_t index = first; index < last; ++index) {
      auto answer = answer_of(samples->list[index]);
      benchmark::DoNotOptimize(answer);
    }
  };
  task.entries.push_back(std::move(entry));
}

}  // namespace

std::vector<Task> scene_tasks() {
  const auto samples = std::make_shared<const SixBarSamples>(around_the_turn());
  Task known{"six-bar, worst case of M, positions known", samples->list.size(), {}};
  add(known, samples, "generated",
      [](const SixBarSample& sample) { return at_known(sample.crank, sample.q); });
  Task from_crank{"six-bar, worst case of M, from the crank's angle", samples->list.size(), {}};
  add(from_crank, samples, "generated, tracked",
      [](const SixBarSample& sample) { return tracked(sample); });
  add(from_crank, samples, "generated, all configurations",
      [](const SixBarSample& sample) { return all_configurations(sample); });
#ifdef ASSUR_CERES
  add(known, samples, "Ceres Jet + LU",
      [](const SixBarSample& sample) { return six_bar_by_jets(sample.crank, sample.theta); });
  add(from_crank, samples, "Ceres Jet + LU", [](const SixBarSample& sample) {
    return six_bar_tracked_by_jets(sample.crank, sample.previous_theta);
  });
#endif
  std::vector<Task> tasks;
  tasks.push_back(std::move(known));
  tasks.push_back(std::move(from_crank));
  return tasks;
}

}  // namespace assur::speed
