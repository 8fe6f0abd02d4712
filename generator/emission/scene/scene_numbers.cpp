#include "emission/scene/scene_numbers.hpp"

#include <algorithm>
#include <assur/mechanism/error.hpp>

#include "emission/cpp/cpp_text.hpp"
#include "emission/cpp/statement_text.hpp"
#include "emission/scene/formula_expression.hpp"
#include "emission/scene/sample_poses.hpp"

namespace assur::generator::emission::scene {

namespace {

/// Whether rates are wanted, and parameters with rates move features, centres of mass, or drivers
/// whose laws read joints.
bool have_rates_of_parameters(const mechanism::Plan& plan) {
  const mechanism::Want& want = plan.request().want;
  const mechanism::Mechanism& mechanism = plan.mechanism();
  const auto moves = [&plan](mechanism::NumberIndex number) {
    return number.exists() && plan.has_rates(number);
  };
  const bool places_move = std::ranges::any_of(mechanism.features(), [&](const auto& feature) {
    return moves(feature.x) || moves(feature.y) || moves(feature.along_x) || moves(feature.along_y);
  });
  const bool laws_move = std::ranges::any_of(mechanism.drivers(), [&](const auto& driver) {
    return !mechanism.numbers()[driver.position].formula.joints().empty() && moves(driver.position);
  });
  const bool masses_move =
      want.loaded() && std::ranges::any_of(mechanism.loading().masses, [&](const auto& mass) {
        return moves(mass.at.x) || moves(mass.at.y);
      });
  return masses_move ||
         ((want.velocity || want.acceleration || want.loaded()) && (places_move || laws_move));
}

}  // namespace

SceneNumbers::SceneNumbers(
    const mechanism::Plan& plan, const mechanism::Values& values,
    const std::vector<std::pair<mechanism::ParameterIndex, cpp::Expression>>& variable,
    const std::vector<Eigen::Index>& modelled,
    const mechanism::Table<mechanism::DriverIndex, std::string>& drivers,
    const mechanism::Table<mechanism::JointIndex, std::string>& joints,
    const mechanism::Table<mechanism::LinkIndex, std::string>& relative)
    : plan_(plan), values_(values), movers_(symbols_) {
  const auto& parameters = plan.mechanism().parameters();
  symbol_of_.assign(parameters.size(), 0);
  is_variable_.assign(parameters.size(), false);
  parameters_.resize(parameters.size());
  for (const auto& [parameter, argument] : variable) {
    const GiNaC::symbol symbol = this->symbol(argument);
    symbol_of_[parameter] = symbol;
    is_variable_[parameter] = true;
    symbols_.add(symbol, cpp::exact(values.parameter(parameter)));
    variables_.push_back(symbol);
  }
  if (const mechanism::Want& want = plan.request().want; want.coefficients || want.dynamics) {
    given_rates_ = symbol(cpp::variable("placed").member("given_rates"));
  }
  const bool counts_rates = have_rates_of_parameters(plan);
  const auto has_own_rates = [&](mechanism::ParameterIndex parameter) {
    return counts_rates &&
           (parameters[parameter].velocity.exists() || parameters[parameter].acceleration.exists());
  };
  const bool has_formulas =
      !variable.empty() || plan.structure().moves_by_laws(plan.mechanism()) || counts_rates;
  const auto add_deviation = [&](mechanism::ParameterIndex parameter) {
    if (!is_variable_[parameter] && symbol_of_[parameter].is_zero()) {
      const GiNaC::symbol symbol(parameters[parameter].name);
      symbol_of_[parameter] = symbol;
      symbols_.add(symbol, 0);
      deviations_[symbol] = 0;
    }
  };
  for (const Eigen::Index column : modelled) {
    const mechanism::ParameterIndex parameter = values.columns()[static_cast<std::size_t>(column)];
    if (has_formulas) {
      add_deviation(parameter);
    }
    modelled_.push_back(symbol_of_[parameter]);
  }
  for (const mechanism::ParameterIndex parameter : parameters.keys()) {
    if (has_own_rates(parameter)) {
      add_deviation(parameter);
    }
  }
  for (const mechanism::ParameterIndex parameter : parameters.keys()) {
    evaluate(parameter);
  }
  for (const mechanism::ParameterIndex parameter : parameters.keys()) {
    if (has_own_rates(parameter)) {
      const auto symbol = GiNaC::ex_to<GiNaC::symbol>(symbol_of_[parameter]);
      movers_.add({symbol, {}, {}, parameter, {}});
    }
  }
  for (const Mover& mover : movers_.list()) {
    set_rates(mover);
  }
  add_positions(drivers, joints);
  add_relative_frames(relative);
  const mechanism::Structure& structure = plan.structure();
  for (const mechanism::FoundGroup& group : structure.groups) {
    groups_.add(mechanism::group_geometry(
        structure, group,
        [this](const mechanism::ElementaryJoint& at, mechanism::LinkIndex link) {
          return feature(at, link);
        },
        SceneNumber()));
  }
}

void SceneNumbers::evaluate(mechanism::ParameterIndex parameter) {
  const auto& parameters = plan_.mechanism().parameters();
  std::vector<mechanism::ParameterIndex> pending{parameter};
  while (!pending.empty()) {
    const mechanism::ParameterIndex last = pending.back();
    const mechanism::Number& own = plan_.mechanism().numbers()[parameters[last].value];
    const std::size_t before = pending.size();
    if (!is_variable_[last]) {
      for (const mechanism::ParameterIndex other : own.formula.parameters()) {
        if (!parameters_[other]) {
          pending.push_back(other);
        }
      }
    }
    if (pending.size() > before) {
      continue;
    }
    pending.pop_back();
    const GiNaC::ex& symbol = symbol_of_[last];
    const mechanism::Dual varied = deviation(last);
    if (is_variable_[last]) {
      parameters_[last] =
          SceneNumber(mechanism::Dual(values_.parameter(last)) + varied, symbol, symbols_);
    } else {
      parameters_[last] =
          number(parameters[last].value) +
          (symbol.is_zero() ? SceneNumber(varied) : SceneNumber(varied, symbol, symbols_));
    }
  }
}

/// Zero, with derivative one by the parameter itself.
mechanism::Dual SceneNumbers::deviation(mechanism::ParameterIndex parameter) const {
  const std::vector<mechanism::ParameterIndex>& columns = values_.columns();
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(std::ssize(columns));
  const auto column = std::find(columns.begin(), columns.end(), parameter);
  if (column != columns.end()) {
    gradient(column - columns.begin()) = 1;
  }
  return {0, std::move(gradient)};
}

SceneNumber SceneNumbers::number(mechanism::NumberIndex number) const {
  return plan_.mechanism().numbers()[number].formula.evaluate<SceneNumber>(
      [this](mechanism::ParameterIndex parameter) -> const SceneNumber& {
        return *parameters_[parameter];
      });
}

/// A parameter may be a formula in others that move.
void SceneNumbers::set_rates(const Mover& mover) {
  const mechanism::Parameter& parameter = plan_.mechanism().parameters()[mover.parameter];
  const GiNaC::ex formula =
      is_variable_[mover.parameter] ? GiNaC::ex(0) : number(parameter.value).formula();
  set_rates(mover, formula, parameter.velocity, parameter.acceleration);
}

void SceneNumbers::set_rates(const Mover& mover, const GiNaC::ex& formula,
                             mechanism::NumberIndex velocity, mechanism::NumberIndex acceleration) {
  const auto own = [this](mechanism::NumberIndex given, const GiNaC::ex& follows) -> GiNaC::ex {
    return given.exists() ? given_rates_ * (number(given).formula() - follows) : GiNaC::ex(0);
  };
  own_rates_[mover.velocity] = own(velocity, movers_.rate(formula));
  own_rates_[mover.acceleration] = own(acceleration, movers_.second_rate(formula));
}

/// The position gets a deviation that is zero and has the difference as its rates.
void SceneNumbers::set_rates(mechanism::DriverIndex driver) {
  const mechanism::Driver& given = plan_.mechanism().drivers()[driver];
  if (!given.velocity.exists() && !given.acceleration.exists()) {
    return;
  }
  const Mover mover;
  set_rates(mover, positions_[driver].formula(), given.velocity, given.acceleration);
  symbols_.add(mover.position, 0);
  deviations_[mover.position] = 0;
  movers_.add(mover);
  positions_[driver] =
      positions_[driver] + SceneNumber(mechanism::Dual(0.0), mover.position, symbols_);
}

LinkFeature<SceneNumber> SceneNumbers::feature(mechanism::FeatureIndex index, bool is_line) const {
  if (!index.exists()) {  // a block's feature
    return {is_line, SceneNumber(), SceneNumber(), {}};
  }
  const mechanism::Feature& feature = plan_.mechanism().features()[index];
  LinkFeature<SceneNumber> result{feature.is_line, number(feature.x), number(feature.y), {}};
  if (feature.is_line) {
    result.along = mechanism::unit_direction(number(feature.along_x), number(feature.along_y));
  }
  return result;
}

LinkFeature<SceneNumber> SceneNumbers::feature(const mechanism::ElementaryJoint& at,
                                               mechanism::LinkIndex link) const {
  const auto feature_of = [this](mechanism::FeatureIndex index, bool is_line) {
    return feature(index, is_line);
  };
  return mechanism::carried_feature<SceneNumber>(
      plan_.structure(), at, link, feature_of,
      [&](const LinkFeature<SceneNumber>& feature, const mechanism::CarriedLink& carried) {
        return carried.group.exists()
                   ? mechanism::placed_feature(feature, relative_[carried.to])
                   : mechanism::moved_feature(feature, plan_.structure(), carried, feature_of,
                                              positions_[carried.driver]);
      });
}

/// Drivers and joints come before the laws that read them.
void SceneNumbers::add_positions(
    const mechanism::Table<mechanism::DriverIndex, std::string>& drivers,
    const mechanism::Table<mechanism::JointIndex, std::string>& joints) {
  const mechanism::Mechanism& mechanism = plan_.mechanism();
  positions_.resize(drivers.size());
  coordinates_.resize(joints.size());
  for (const mechanism::DriverIndex driver : plan_.structure().laws) {
    const mechanism::Formula& law =
        mechanism.numbers()[mechanism.drivers()[driver].position].formula;
    if (law.joints().empty()) {
      const cpp::Expression state = cpp::variable("drivers").member(drivers[driver]);
      Mover mover = this->mover(state.member("position"), state.member("velocity"),
                                state.member("acceleration"));
      const SceneNumber given = this->law(driver);
      for (const GiNaC::ex& symbol : modelled_) {
        mover.gradient.push_back(
            symbols_.derivative(given.formula(), GiNaC::ex_to<GiNaC::symbol>(symbol)));
      }
      positions_[driver] = add_mover(mover, values_.motion(driver).position);
      continue;
    }
    for (const mechanism::JointIndex joint : law.joints()) {
      add_coordinate(joint, joints);
    }
    positions_[driver] = law.evaluate<SceneNumber>(
        [this](mechanism::ParameterIndex parameter) -> const SceneNumber& {
          return *parameters_[parameter];
        },
        [this](mechanism::JointIndex joint) -> const SceneNumber& { return *coordinates_[joint]; });
    set_rates(driver);
  }
  if (plan_.request().want.loaded()) {
    for (const mechanism::Load& load : mechanism.loading().loads) {
      for (const mechanism::NumberIndex number : {load.force_x, load.force_y, load.moment}) {
        if (number.exists()) {
          for (const mechanism::JointIndex joint : mechanism.numbers()[number].formula.joints()) {
            add_coordinate(joint, joints);
          }
        }
      }
    }
  }
}

void SceneNumbers::add_coordinate(
    mechanism::JointIndex joint,
    const mechanism::Table<mechanism::JointIndex, std::string>& joints) {
  if (const mechanism::DriverIndex driver = plan_.mechanism().driver_of(joint); driver.exists()) {
    coordinates_[joint] = positions_[driver];
  } else if (!coordinates_[joint]) {
    // The coordinate depends on the configuration, so any number will do.
    const cpp::Expression coordinate = cpp::variable("joint_" + joints[joint]);
    const cpp::Expression rates = coordinate.member("rates");
    Mover mover = this->mover(coordinate.member("position"), rates.at({cpp::word(0U)}),
                              rates.at({cpp::word(1U)}));
    for (std::size_t column = 0; column < modelled_.size(); ++column) {
      mover.gradient.emplace_back(symbol(coordinate.member("gradient").at({cpp::word(column)})));
    }
    coordinates_[joint] = add_mover(mover, mechanism::Dual(1.0));
  }
}

SceneNumber SceneNumbers::loading(mechanism::NumberIndex number) const {
  return plan_.mechanism().numbers()[number].formula.evaluate<SceneNumber>(
      [this](mechanism::ParameterIndex parameter) -> const SceneNumber& {
        return *parameters_[parameter];
      },
      [this](mechanism::JointIndex joint) -> const SceneNumber& { return *coordinates_[joint]; });
}

/// Each joint gets a symbol of its own, as the coordinates of several may follow one driver.
SceneNumber SceneNumbers::slope(mechanism::DriverIndex driver, mechanism::JointIndex joint) const {
  const mechanism::Formula& law =
      plan_.mechanism().numbers()[plan_.mechanism().drivers()[driver].position].formula;
  std::map<mechanism::JointIndex, GiNaC::symbol> stand_ins;
  for (const mechanism::JointIndex read : law.joints()) {
    symbols_.add(stand_ins[read], cpp::exact(coordinates_[read]->value()));
  }
  const SceneNumber position = law.evaluate<SceneNumber>(
      [this](mechanism::ParameterIndex parameter) -> const SceneNumber& {
        return *parameters_[parameter];
      },
      [&](mechanism::JointIndex read) {
        return SceneNumber(coordinates_[read]->number(), stand_ins.at(read), symbols_);
      });
  GiNaC::exmap coordinates;
  for (const auto& [read, symbol] : stand_ins) {
    coordinates[symbol] = coordinates_[read]->formula();
  }
  const GiNaC::ex slope =
      symbols_.written_out(symbols_.derivative(position.formula(), stand_ins.at(joint)))
          .subs(coordinates);
  const double value = GiNaC::ex_to<GiNaC::numeric>(symbols_.value_of(slope)).to_double();
  return is_constant(slope) ? SceneNumber(value)
                            : SceneNumber(mechanism::Dual(value), slope, symbols_);
}

SceneNumber SceneNumbers::law(mechanism::DriverIndex driver) const {
  return number(plan_.mechanism().drivers()[driver].position);
}

/// The roles and the lengths of the groups' links are decided with the frames of the scene's first
/// configuration.
void SceneNumbers::add_relative_frames(
    const mechanism::Table<mechanism::LinkIndex, std::string>& relative) {
  const mechanism::Structure& structure = plan_.structure();
  relative_.resize(structure.linkage.links.size());
  if (!structure.has_relative_groups()) {
    return;
  }
  const mechanism::Table<mechanism::LinkIndex, Pose<double>> poses = poses_of_links(plan_, values_);
  for (const mechanism::CarriedLink& link : structure.carried) {
    if (!link.group.exists()) {
      continue;
    }
    const Pose<double> there = seen_from(poses[link.from], poses[link.to]);
    const cpp::Expression frame = cpp::variable("placed").member(relative[link.to]);
    const cpp::Expression pose = frame.member("pose");
    const auto coordinate = [&](const cpp::Expression& position, std::size_t row, double value) {
      const auto entry = [&](const std::string& matrix, std::size_t column) {
        return frame.member(matrix).at({cpp::word(row), cpp::word(column)});
      };
      Mover mover = this->mover(position, entry("rates", 0), entry("rates", 1));
      for (std::size_t column = 0; column < modelled_.size(); ++column) {
        mover.gradient.emplace_back(symbol(entry("gradient", column)));
      }
      return add_mover(mover, mechanism::Dual(value));
    };
    const SceneNumber theta = coordinate(frame.member("theta"), 2, angle_of(there.direction));
    relative_[link.to] = {coordinate(pose.member("x"), 0, there.x),
                          coordinate(pose.member("y"), 1, there.y),
                          {cos(theta), sin(theta)}};
    const cpp::Expression direction = pose.member("direction");
    directions_[GiNaC::cos(theta.formula())] = symbol(direction.member("cos"));
    directions_[GiNaC::sin(theta.formula())] = symbol(direction.member("sin"));
  }
}

GiNaC::symbol SceneNumbers::symbol(const cpp::Expression& expression) {
  const std::string name = cpp::printed(expression);
  expressions_.emplace(name, expression);
  return GiNaC::symbol(name);
}

Mover SceneNumbers::mover(const cpp::Expression& position, const cpp::Expression& velocity,
                          const cpp::Expression& acceleration) {
  return {symbol(position), symbol(velocity), symbol(acceleration), {}, {}};
}

SceneNumber SceneNumbers::add_mover(const Mover& mover, const mechanism::Dual& value) {
  movers_.add(mover);
  symbols_.add(mover.position, cpp::exact(value.value()));
  variables_.push_back(mover.position);
  return {value, mover.position, symbols_};
}

mechanism::SlideMeasure<SceneNumber> SceneNumbers::slide_measure(mechanism::GroupIndex group,
                                                                 int model_joint) const {
  const mechanism::Structure& structure = plan_.structure();
  return mechanism::slide_measure(structure, structure.groups[group], groups_[group], model_joint,
                                  SceneNumber());
}

}  // namespace assur::generator::emission::scene
