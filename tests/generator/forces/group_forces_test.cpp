// Law: the forces derived for a rigid model keep each of its links in equilibrium, exactly, are
// normal to slides, and take few operations.
#include "forces/group_forces.hpp"

#include <gtest/gtest.h>

#include <array>
#include <set>

#include "derivatives/mobility.hpp"
#include "emission/model/force_function.hpp"
#include "equations/seeded_numbers.hpp"
#include "generator/all_models.hpp"
#include "program/program.hpp"

namespace assur::test::group_forces_test {
namespace {

using generator::derivatives::differentiate;
using generator::equations::ClosureEquations;
using generator::equations::NamedQuantity;
using generator::equations::Vector2;
using generator::forces::GroupForces;
using generator::structure::JointIndex;
using generator::structure::LinkIndex;

/// A model with all that its forces are derived from.
struct ForcedModel {
  explicit ForcedModel(const generator::structure::Model& model)
      : equations(generator::equations::closure_equations(model)),
        derivatives(differentiate(equations)),
        structured(equations),
        forces(generator::forces::group_forces(equations, derivatives, &structured)) {}

  ClosureEquations equations;
  generator::derivatives::Derivatives derivatives;
  generator::pivoting::StructuredJacobian structured;
  GroupForces forces;
};

/// A model in an assembly with rational coordinates, under rational loads.
class LoadedModel {
 public:
  LoadedModel(const ForcedModel& model, unsigned seed)
      : equations_(model.equations),
        forces_(model.forces),
        values_(generator::derivatives::random_assembly(model.equations, seed)) {
    generator::equations::SeededNumbers numbers(seed);
    for (const generator::forces::LinkLoad& load : forces_.loads) {
      for (const GiNaC::symbol& part : {load.x, load.y, load.moment}) {
        values_[part] = numbers.number();
      }
    }
    for (const auto* vocabulary : {&equations_.vocabulary, &forces_.vocabulary}) {
      for (const NamedQuantity& quantity : vocabulary->quantities()) {
        const GiNaC::ex value = quantity.definition.subs(values_);
        is_regular_ = is_regular_ && !(quantity.form == NamedQuantity::Form::reciprocal &&
                                       value.expand().is_zero());
        if (is_regular_) {
          values_[quantity.symbol] =
              quantity.form == NamedQuantity::Form::reciprocal ? 1 / value : value;
        }
      }
    }
  }

  /// Whether the assembly is no dead centre.
  [[nodiscard]] bool is_regular() const { return is_regular_; }

  [[nodiscard]] GiNaC::ex value(const GiNaC::ex& expression) const {
    return expression.subs(values_).expand();
  }
  /// The place of a joint on a link: the point, or the foot of the perpendicular from the origin of
  /// the link's frame.
  [[nodiscard]] Vector2 place(LinkIndex link, JointIndex joint) const {
    const Vector2& local = equations_.frames[link].feature_of(joint).point;
    const auto& pose = equations_.poses[link];
    return {value(pose.origin.x + pose.direction.x * local.x - pose.direction.y * local.y),
            value(pose.origin.y + pose.direction.y * local.x + pose.direction.x * local.y)};
  }
  /// The residual of the forces on a link, and of the moments about the origin of the fixed frame.
  [[nodiscard]] std::array<GiNaC::ex, 3> left_on(LinkIndex link) const {
    const generator::forces::LinkLoad& load = forces_.loads[link];
    const Vector2& origin = equations_.poses[link].origin;
    GiNaC::ex x = load.x;
    GiNaC::ex y = load.y;
    GiNaC::ex moment = load.moment + origin.x * load.y - origin.y * load.x;
    const generator::structure::Group& group = *equations_.model->group;
    for (const JointIndex joint : group.joints_of(link)) {
      const LinkIndex second = group.joints()[joint].second;
      const int side = second == link ? 1 : -1;
      const auto& reaction = forces_.joints[joint];
      const Vector2 at = place(second, joint);
      x += side * reaction.force.x;
      y += side * reaction.force.y;
      moment +=
          side * (at.x * reaction.force.y - at.y * reaction.force.x + reaction.couple.value_or(0));
    }
    return {value(x), value(y), value(moment)};
  }

 private:
  const ClosureEquations& equations_;
  const GroupForces& forces_;
  GiNaC::exmap values_;
  bool is_regular_ = true;
};

/// The models whose angles no slides over-determine.
std::vector<const generator::structure::Model*> rigid_models() {
  std::vector<const generator::structure::Model*> models = all_models();
  std::erase_if(models, [](const auto* model) {
    return !generator::equations::closure_equations(*model).compatibility.empty();
  });
  return models;
}

class ForcesOfModels : public testing::TestWithParam<const generator::structure::Model*> {};

TEST_P(ForcesOfModels, KeepLinksInEquilibrium) {
  const ForcedModel model(*GetParam());
  int regular = 0;
  for (unsigned seed = 1; seed <= 2; ++seed) {
    const LoadedModel loaded(model, seed);
    if (!loaded.is_regular()) {
      continue;
    }
    ++regular;
    for (const LinkIndex link : model.equations.model->group->links().keys()) {
      for (const GiNaC::ex& left : loaded.left_on(link)) {
        EXPECT_TRUE(left.is_zero()) << model.equations.model->group->links()[link] << ": " << left;
      }
    }
    for (const generator::equations::AngleTie& tie : model.equations.ties) {
      const Vector2& along = model.equations.slide_directions[tie.joint];
      const Vector2& force = model.forces.joints[tie.joint].force;
      EXPECT_TRUE(loaded.value(along.x * force.x + along.y * force.y).is_zero());
    }
  }
  EXPECT_GT(regular, 0);
}

INSTANTIATE_TEST_SUITE_P(RigidModels, ForcesOfModels, testing::ValuesIn(rigid_models()),
                         name_of_model);

generator::program::OperationCount operations(const ForcedModel& model,
                                              const std::vector<NamedQuantity>& quantities,
                                              const std::vector<generator::program::Result>& all) {
  std::vector<GiNaC::symbol> given;
  for (const auto& [symbol, entry] :
       generator::emission::model::force_function(model.forces).given) {
    given.push_back(symbol);
  }
  const generator::program::SymbolOrder order = generator::program::symbol_order(
      model.equations, model.equations.vocabulary, quantities, given);
  return generator::program::Program(order, quantities, all).count();
}

using Results = std::vector<generator::program::Result>;

void append(const std::vector<NamedQuantity>& more, std::vector<NamedQuantity>& quantities) {
  std::set<std::string> known;
  for (const NamedQuantity& quantity : quantities) {
    known.insert(quantity.symbol.get_name());
  }
  for (const NamedQuantity& quantity : more) {
    if (known.insert(quantity.symbol.get_name()).second) {
      quantities.push_back(quantity);
    }
  }
}

/// The operations of the forces beside those of the loads Q and of others that are computed with
/// them.
std::vector<std::size_t> beside(const ForcedModel& model, Results others,
                                std::vector<NamedQuantity> quantities) {
  append(model.forces.vocabulary.quantities(), quantities);
  for (const GiNaC::ex& load : model.forces.generalised) {
    others.push_back({generator::program::entry("Q", others.size()), load});
  }
  Results all = others;
  const auto function = generator::emission::model::force_function(model.forces).naming.function;
  all.insert(all.end(), function.results.begin(), function.results.end());
  const generator::program::OperationCount count = operations(model, quantities, all);
  const generator::program::OperationCount other = operations(model, quantities, others);
  return {count.multiplications - other.multiplications, count.additions - other.additions,
          count.divisions - other.divisions};
}

/// Where motion is computed too, named quantities and the one division are shared.
std::vector<std::size_t> beside_motion(const ForcedModel& model) {
  for (const auto& function : generator::emission::model::solution_functions(model.structured)) {
    if (function.function.name == "motion") {
      return beside(model, function.function.results, function.vocabulary.quantities());
    }
  }
  return {};
}

/// Multiplications, additions and divisions beside those of the loads.
TEST(ForcesOfModels, TakeFewOperations) {
  using Counts = std::vector<std::size_t>;
  const auto first_of = [](const std::string& group) {
    return ForcedModel(
        generator::structure::models_of(generator::structure::group_named(group)).front());
  };
  const ForcedModel dyad = first_of("dyad");
  const ForcedModel tetrad = first_of("tetrad");
  EXPECT_EQ(beside(dyad, {}, {}), (Counts{10, 7, 1}));
  EXPECT_EQ(beside_motion(dyad), (Counts{8, 6, 0}));
  EXPECT_EQ(beside(tetrad, {}, {}), (Counts{46, 33, 1}));
  EXPECT_EQ(beside_motion(tetrad), (Counts{30, 28, 0}));
}

}  // namespace
}  // namespace assur::test::group_forces_test
