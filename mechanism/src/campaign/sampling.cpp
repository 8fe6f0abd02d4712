// Random values of the parameters within their tolerances, and the positions of outputs there.
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <assur/directions.hpp>
#include <assur/mechanism/force_columns.hpp>
#include <cmath>
#include <iterator>
#include <memory>
#include <utility>

#include "counter_random.hpp"
#include "outcome.hpp"
#include "plan/plan_data.hpp"

namespace assur::mechanism::campaign {

namespace {

/// The request reduced to positions, and to forces with the rates that they require.
Request positions_and_forces(const Request& request) {
  Request result = positions_alone(request);
  result.want.forces = result.want.velocity = result.want.acceleration = request.want.forces;
  return result;
}

/// The deviating parameters and those that depend on them, each after those in its formula.
std::vector<Deviation> changing_parameters(const Values& values,
                                           const Eigen::VectorXd& half_widths) {
  const Mechanism& mechanism = values.plan().mechanism;
  Table<ParameterIndex, bool> changes(mechanism.parameters().size(), false);
  std::vector<Deviation> changing;
  for (const ParameterIndex parameter : values.plan().evaluation.parameters) {
    const std::vector<ParameterIndex> used =
        mechanism.numbers()[mechanism.parameters()[parameter].value].formula.parameters();
    const double half_width = half_widths(parameter.row());
    changes[parameter] = half_width > 0 || std::ranges::any_of(used, [&](ParameterIndex one) {
                           return changes[one];
                         });
    if (changes[parameter]) {
      changing.push_back({parameter, half_width});
    }
  }
  return changing;
}

/// The covariance of all parameters in the request, for a covariance law; otherwise empty.
Eigen::MatrixXd requested_covariance(const Mechanism& mechanism, const Request& request,
                                     const DeviationLaw& law) {
  if (law.kind != DeviationLaw::Kind::covariance) {
    return {};
  }
  if (!request.covariance) {
    throw MechanismError("covariance", "the scene has no covariance of its parameters; add one");
  }
  Request with = positions_alone(request);
  with.covariance = request.covariance;
  return Plan(mechanism, with).values().spread().covariance;
}

/// The largest deviation of every parameter; zero for those that do not deviate.
Eigen::VectorXd half_widths_of(const DeviationLaw& law, const Eigen::VectorXd& tolerances,
                               const Eigen::MatrixXd& requested) {
  if (law.kind == DeviationLaw::Kind::covariance) {
    return requested.diagonal().cwiseSqrt();
  }
  if (law.kind != DeviationLaw::Kind::given) {
    return tolerances;
  }
  Eigen::VectorXd largest = Eigen::VectorXd::Zero(tolerances.size());
  for (std::size_t at = 0; at < law.given.size(); ++at) {
    double& one = largest(law.parameters[at % law.parameters.size()].row());
    one = std::max(one, std::abs(law.given[at]));
  }
  return largest;
}

/// The covariance of two deviations, by their law.
double covariance_of(const DeviationLaw& law, const Deviation& one, const Deviation& other,
                     const Eigen::MatrixXd& requested) {
  const bool is_same = one.parameter == other.parameter;
  switch (law.kind) {
    case DeviationLaw::Kind::uniform:
      return is_same ? one.half_width * one.half_width / 3 : 0.0;
    case DeviationLaw::Kind::normal:
      return is_same ? one.half_width * one.half_width / 9 : 0.0;
    case DeviationLaw::Kind::covariance:
      return requested(one.parameter.row(), other.parameter.row());
    case DeviationLaw::Kind::given:
      break;
  }
  const auto place_of = [&law](ParameterIndex parameter) {
    return static_cast<std::size_t>(std::ranges::find(law.parameters, parameter) -
                                    law.parameters.begin());
  };
  const std::size_t width = law.parameters.size();
  double sum = 0;
  for (std::size_t first = 0; first < law.given.size(); first += width) {
    sum +=
        law.given[first + place_of(one.parameter)] * law.given[first + place_of(other.parameter)];
  }
  return sum / static_cast<double>(law.given.size() / width);
}

/// F with F F^T = C, for the covariance C of some deviations, of any rank.
Eigen::MatrixXd factors_of(const std::vector<Deviation>& deviations,
                           const Eigen::MatrixXd& requested) {
  std::vector<Eigen::Index> rows;
  for (const Deviation& deviation : deviations) {
    rows.push_back(deviation.parameter.row());
  }
  const Eigen::MatrixXd covariance = requested(rows, rows);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(covariance);
  return solver.eigenvectors() * solver.eigenvalues().cwiseMax(0).cwiseSqrt().asDiagonal();
}

/// With more parameters, no second derivatives are computed.
constexpr std::size_t most_with_spread = 200;

/// The request of the nominal solution: sensitivities, and the variances of the sampled parameters.
Request nominal_request(const Request& request, const std::vector<Deviation>& deviations,
                        const DeviationLaw& law, const Eigen::MatrixXd& requested,
                        Mechanism& mechanism) {
  Request result = positions_and_forces(request);
  result.want.sensitivity = true;
  if (mechanism.parameters().size() > most_with_spread) {
    return result;
  }
  result.covariance.emplace();
  const std::size_t count = deviations.size();
  for (std::size_t row = 0; row < count; ++row) {
    result.covariance->parameters.push_back(deviations[row].parameter);
    std::vector<NumberIndex>& numbers = result.covariance->matrix.emplace_back();
    for (std::size_t column = 0; column < count; ++column) {
      numbers.push_back(
          mechanism.add_number(covariance_of(law, deviations[row], deviations[column], requested),
                               "the variances of deviations"));
    }
  }
  return result;
}

/// The nominal configuration, alone in a solution.
Solution nominal_solution(const Plan& plan, std::size_t branch) {
  const Values values = plan.values();
  Solution solution;
  if (branch == 0 && !plan.request().reference.empty()) {
    if (const auto nearest = plan.solve_nearest(values, solution)) {
      std::swap(solution.configurations.front(), solution.configurations[nearest->configuration]);
    }
  } else {
    const std::size_t passed = plan.solve_one(values, std::max<std::size_t>(branch, 1), solution);
    if (solution.configurations.empty() && passed > 0) {
      throw NoSuchConfiguration(branch, passed);
    }
  }
  if (solution.configurations.empty()) {
    const std::string reason =
        solution.status == SolutionStatus::degenerate ? solution.reason : plan.obstacle(values);
    throw MechanismError("",
                         "at its nominal values there is no configuration to follow: " + reason);
  }
  return solution;
}

/// The numbers of the requested forces; NaN without a configuration.
std::vector<double> force_numbers_or_none(const Plan& plan, const Values& values,
                                          const Configuration* configuration) {
  const std::size_t count = force_columns(plan).size();
  if (count == 0 || configuration == nullptr) {
    return std::vector<double>(count, none);
  }
  return force_numbers(plan, forces_of(values, *configuration));
}

std::vector<NominalPoint> nominal_points(const Plan& plan, const Configuration& configuration) {
  const Values values = plan.values();
  std::vector<NominalPoint> points;
  for (const OutputIndex output : plan.mechanism().outputs().keys()) {
    const Point& point = configuration.outputs[output];
    NominalPoint nominal{plan.mechanism().outputs()[output].name, point.position, {}, {}, {}};
    if (configuration.derivatives_known) {
      nominal.worst_case = worst_case(point, values.spread());
      nominal.rss = root_sum_square(point, values.spread());
      if (plan.request().covariance) {
        nominal.spread = spread_of(point, values.spread());
      }
    }
    points.push_back(std::move(nominal));
  }
  return points;
}

std::vector<NominalForce> nominal_forces(const Plan& plan, const Configuration& configuration) {
  std::vector<NominalForce> result;
  const std::vector<ForceColumn> columns = force_columns(plan);
  if (columns.empty()) {
    return result;
  }
  const Values values = plan.values();
  const std::vector<double> numbers = force_numbers_or_none(plan, values, &configuration);
  const std::vector<double> deviations = force_deviations(plan, values, configuration);
  for (std::size_t place = 0; place < columns.size(); ++place) {
    result.push_back(
        {columns[place], numbers[place], deviations[place], deviations[columns.size() + place]});
  }
  return result;
}

/// The request of the samples: positions and requested forces, near a configuration. Links that
/// drivers place are alike in all configurations of a sample and so cannot distinguish them; if
/// there are no others, they are named because a reference must name some link.
Request sample_request(const Request& request, const Plan& plan, const Configuration& nominal,
                       Mechanism& mechanism) {
  Request result = positions_and_forces(request);
  result.reference.clear();
  const Table<LinkIndex, bool> by_drivers = plan.structure().placed_by_drivers();
  for (const bool wants_driven : {false, true}) {
    for (const LinkIndex link : plan.mechanism().links().keys()) {
      if (by_drivers[link] == wants_driven && link != plan.mechanism().ground()) {
        const std::string& name = plan.mechanism().links()[link].name;
        result.reference.push_back(
            {index_of(mechanism.links(), name),
             mechanism.add_number(angle_of(nominal.links[link].pose.direction),
                                  "the nominal angle of " + name)});
      }
    }
    if (!result.reference.empty()) {
      break;
    }
  }
  return result;
}

}  // namespace

}  // namespace assur::mechanism::campaign

namespace assur::mechanism {

/// Solves one sample after the other in the same memory.
class Sampling::Worker {
 public:
  explicit Worker(const Sampling& sampling)
      : sampling_(&sampling),
        values_(sampling.plan_->values()),
        numbers_(sampling.plan_->mechanism().parameters().size()) {
    for (const ParameterIndex parameter : numbers_.keys()) {
      numbers_[parameter] = values_.parameter(parameter);
    }
    for (const Deviation& deviation : sampling.deviations_) {
      changed_.emplace_back(deviation.parameter, 0);
    }
  }

  void set(std::uint64_t sample) {
    const Mechanism& mechanism = sampling_->plan_->mechanism();
    std::size_t place = 0;
    for (const auto& [parameter, half_width] : sampling_->changing_) {
      const Formula& formula = mechanism.numbers()[mechanism.parameters()[parameter].value].formula;
      numbers_[parameter] =
          formula.evaluate<double>([this](ParameterIndex used) { return numbers_[used]; });
      if (half_width > 0) {
        numbers_[parameter] += sampling_->deviation(sample, place);
        changed_[place++].second = numbers_[parameter];
      }
    }
  }

  [[nodiscard]] const std::vector<std::pair<ParameterIndex, double>>& parameters() const {
    return changed_;
  }

  std::optional<Nearest> solve() {
    values_.set(changed_);
    return sampling_->plan_->solve_nearest(values_, solution_);
  }

  [[nodiscard]] const Solution& solution() const { return solution_; }

  /// The reason is determined anew, with the present numbers.
  [[nodiscard]] std::string obstacle() const { return sampling_->plan_->obstacle(values_); }

  void add_row(std::uint64_t sample, std::vector<double>& rows) {
    set(sample);
    Outcome outcome = Outcome::refused;
    const Configuration* found = nullptr;
    try {
      const std::optional<Nearest> nearest = solve();
      found = nearest ? &solution_.configurations[nearest->configuration] : nullptr;
      outcome = found == nullptr ? campaign::outcome_without_configurations(solution_)
                                 : campaign::outcome_of(*found);
      if (outcome == Outcome::regular && nearest->runner_up &&
          *nearest->runner_up < 3 * nearest->distance) {
        outcome = Outcome::ambiguous;
      }
    } catch (const MechanismError&) {  // this is an outcome; `reason_of` gives its reason
    }
    rows.insert(rows.end(), {static_cast<double>(sample), static_cast<double>(outcome)});
    campaign::add_outputs(sampling_->plan_->mechanism(), found, rows);
    std::ranges::copy(campaign::force_numbers_or_none(*sampling_->plan_, values_, found),
                      std::back_inserter(rows));
  }

 private:
  const Sampling* sampling_;
  Values values_;
  Solution solution_;
  Table<ParameterIndex, double> numbers_;  ///< of the sample, where they change; otherwise nominal
  std::vector<std::pair<ParameterIndex, double>> changed_;
};

Sampling::Sampling(const Mechanism& mechanism, const Request& request, std::size_t branch,
                   std::uint64_t seed, std::uint64_t count, DeviationLaw law)
    : law_(std::move(law)), seed_(seed), count_(count) {
  if (mechanism.outputs().size() == 0 && !request.want.forces) {
    throw MechanismError("outputs", "there is no point to sample; name some, or want forces");
  }
  const Plan positions(mechanism, campaign::positions_alone(request));
  const Values nominal_values = positions.values();
  const Eigen::VectorXd& tolerances = nominal_values.spread().tolerances;
  const Eigen::MatrixXd requested = campaign::requested_covariance(mechanism, request, law_);
  changing_ = campaign::changing_parameters(nominal_values,
                                            campaign::half_widths_of(law_, tolerances, requested));
  std::ranges::copy_if(changing_, std::back_inserter(deviations_),
                       [](const Deviation& one) { return one.half_width > 0; });
  if (deviations_.empty() && law_.kind == DeviationLaw::Kind::given) {
    throw MechanismError("parameters", "all given deviations are zero; give one that is not");
  }
  if (law_.kind == DeviationLaw::Kind::covariance) {
    factors_ = campaign::factors_of(deviations_, requested);
  }
  if (deviations_.empty()) {
    throw MechanismError(
        "parameters",
        "no parameter has a tolerance, so there is nothing to sample; add one, such as "
        "\"AB\": {\"value\": 100, \"tolerance\": 0.05}");
  }
  Mechanism extended = mechanism;
  const Request at_nominal =
      campaign::nominal_request(request, deviations_, law_, requested, extended);
  const Plan nominal_plan(extended, at_nominal);
  const Solution nominal = campaign::nominal_solution(nominal_plan, branch);
  nominal_ = campaign::nominal_points(nominal_plan, nominal.configurations.front());
  forces_ = campaign::nominal_forces(nominal_plan, nominal.configurations.front());
  extended = mechanism;
  const Request near_nominal =
      campaign::sample_request(request, nominal_plan, nominal.configurations.front(), extended);
  plan_.emplace(extended, near_nominal);
}

double Sampling::deviation(std::uint64_t sample, std::size_t place) const {
  const auto& [parameter, half_width] = deviations_[place];
  const auto number = static_cast<std::uint32_t>(parameter.place());
  switch (law_.kind) {
    case DeviationLaw::Kind::uniform:
      return half_width * campaign::uniform(seed_, sample, number);
    case DeviationLaw::Kind::normal:
      return half_width / 3 * campaign::normal(seed_, sample, number);
    case DeviationLaw::Kind::covariance: {
      double sum = 0;
      for (std::size_t column = 0; column < deviations_.size(); ++column) {
        const auto other = static_cast<std::uint32_t>(deviations_[column].parameter.place());
        sum += factors_(static_cast<Eigen::Index>(place), static_cast<Eigen::Index>(column)) *
               campaign::normal(seed_, sample, other);
      }
      return sum;
    }
    case DeviationLaw::Kind::given:
      break;
  }
  const auto at = std::ranges::find(law_.parameters, parameter) - law_.parameters.begin();
  return law_.given[sample * law_.parameters.size() + static_cast<std::size_t>(at)];
}

Campaign Sampling::campaign() const {
  Campaign campaign{
      {{"sample", Column::Kind::whole}, {"outcome", Column::Kind::outcome}}, count_, [this] {
        return
            [worker = std::make_shared<Worker>(*this)](
                std::uint64_t sample, std::vector<double>& rows) { worker->add_row(sample, rows); };
      }};
  campaign::add_output_columns(plan_->mechanism(), campaign.columns);
  for (const ForceColumn& column : force_columns(*plan_)) {
    campaign.columns.push_back({column.name(), Column::Kind::real});
  }
  return campaign;
}

std::vector<double> Sampling::parameters_of(std::uint64_t sample) const {
  Worker worker(*this);
  worker.set(sample);
  std::vector<double> numbers;
  for (const auto& [parameter, number] : worker.parameters()) {
    numbers.push_back(number);
  }
  return numbers;
}

std::string Sampling::reason_of(std::uint64_t sample) const {
  Worker worker(*this);
  worker.set(sample);
  try {
    (void)worker.solve();
    return worker.obstacle();
  } catch (const MechanismError& error) {
    return error.what();
  }
}

}  // namespace assur::mechanism
