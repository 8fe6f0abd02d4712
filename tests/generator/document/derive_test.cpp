// Law: the output of `assur derive` for every model, read back and evaluated, equals the results of
// the generated code, and its text mentions all required subjects.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <assur/text/expression.hpp>
#include <cmath>
#include <complex>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>
#include <vector>

#include "command/command.hpp"
#include "generator/all_models.hpp"
#include "largest.hpp"
#include "runtime/exact_assembly.hpp"
#include "runtime/model_types.hpp"
#include "whole_campaign.hpp"

namespace assur::test::derive_test {
namespace {

using Json = nlohmann::ordered_json;
using Values = std::map<std::string, double>;

constexpr unsigned seed = 16180;
constexpr double tolerance = 1e-9;

std::string arguments(int number, const std::string& group, const std::string& format) {
  return "derive " + std::to_string(number) + " --group " + group + " --format " + format;
}

double value_of(const std::string& formula, const Values& values) {
  return text::evaluate<double>(text::parse_expression(formula),
                                [&](const std::string& name) { return values.at(name); });
}
double value_of(const Json& formula, const Values& values) {
  return value_of(formula.get<std::string>(), values);
}

template <typename Derived>
void expect_equal(const Json& formulas, const Eigen::MatrixBase<Derived>& generated,
                  const Values& values) {
  ASSERT_EQ(formulas.size(), static_cast<std::size_t>(generated.rows()));
  for (Eigen::Index row = 0; row < generated.rows(); ++row) {
    const Json& line = formulas[static_cast<std::size_t>(row)];
    for (Eigen::Index column = 0; column < generated.cols(); ++column) {
      const Json& entry = line.is_array() ? line[static_cast<std::size_t>(column)] : line;
      EXPECT_NEAR(value_of(entry, values), generated(row, column),
                  tolerance * (1 + std::abs(generated(row, column))))
          << entry;
    }
  }
}

double number_of(double length) { return length; }
double number_of(const Direction<double>& angle) { return std::atan2(angle.sin, angle.cos); }

template <typename Members>
void name_values(const Json& variables, const Members& members, Values& values) {
  std::size_t index = 0;
  std::apply(
      [&](const auto&... member) {
        ((values[variables[index++]["name"].get<std::string>()] = number_of(member)), ...);
      },
      members);
}

template <typename Rates>
void name_rates(const Json& variables, const std::string& key, const Rates& rates, Values& values) {
  for (std::size_t index = 0; index < variables.size(); ++index) {
    values[variables[index][key].get<std::string>()] = rates(static_cast<Eigen::Index>(index));
  }
}

void define(const Json& quantities, Values& values) {
  for (const Json& quantity : quantities) {
    const std::string name = quantity["name"];
    EXPECT_FALSE(values.contains(name)) << name << " is named twice";
    values[name] = value_of(quantity["value"], values);
  }
}

/// A random assembled group, and its variables by name.
template <typename Model>
struct NamedAssembly {
  explicit NamedAssembly(const Json& derivation) {
    RandomInputs random(seed);
    Assembly<Model, Rational> exact_place;
    do {
      exact_place.d = random.variables<typename Model::template Dimensions<Rational>>();
      exact_place.u = random.variables<typename Model::template Inputs<Rational>>();
      exact_place.q = random.variables<typename Model::template Configuration<Rational>>();
    } while (!close_loops<Model>(exact_place));
    place = rounded<double, Model>(exact_place);
    name_values(derivation["unknowns"], place.q.members(), values);
    name_values(derivation["dimensions"], place.d.members(), values);
    name_values(derivation["inputs"], place.u.members(), values);
    define(derivation["quantities"], values);
  }
  Assembly<Model, double> place;
  Values values;
};

template <typename Model>
class Derive : public testing::Test {
 protected:
  /// The output of one run, kept for all tests of the model.
  static const CommandResult& said(const std::string& format) {
    static std::map<std::string, CommandResult> answers;
    const auto at = answers.find(format);
    return at != answers.end()
               ? at->second
               : answers.emplace(format, run_assur(arguments(Model::number, Model::group, format)))
                     .first->second;
  }
  static Json derivation() { return Json::parse(said("json").output); }
};
TYPED_TEST_SUITE(Derive, AllModels, ModelNames);

TYPED_TEST(Derive, EquationsAreThoseOfTheGeneratedCode) {
  const Json derivation = this->derivation();
  NamedAssembly<TypeParam> at(derivation);
  const auto& [d, u, q] = at.place;
  Vector<double, TypeParam::equation_count> f;
  TypeParam::residual(d, u, q, f);
  std::vector<std::string> closures;
  for (const Json& loop : derivation["closures"]) {
    for (const Json& scalar : loop["scalars"]) {
      closures.push_back(scalar);
    }
  }
  expect_equal(Json(closures), f, at.values);
  Matrix<double, TypeParam::equation_count, TypeParam::unknown_count> f_q;
  TypeParam::jacobian(d, u, q, f_q);
  expect_equal(derivation["jacobian"], f_q, at.values);
  Matrix<double, TypeParam::equation_count, TypeParam::dimension_count> f_d;
  TypeParam::dimension_jacobian(d, u, q, f_d);
  expect_equal(derivation["dimension_jacobian"], f_d, at.values);
  Matrix<double, TypeParam::equation_count, TypeParam::input_count> f_u;
  TypeParam::input_jacobian(d, u, q, f_u);
  expect_equal(derivation["input_jacobian"], f_u, at.values);

  RandomInputs random(seed);
  const auto q1 = random.vector<Vector<double, TypeParam::unknown_count>>();
  const auto u1 = random.vector<Vector<double, TypeParam::input_count>>();
  const auto u2 = random.vector<Vector<double, TypeParam::input_count>>();
  name_rates(derivation["unknowns"], "rate", q1, at.values);
  name_rates(derivation["inputs"], "rate", u1, at.values);
  name_rates(derivation["inputs"], "second_rate", u2, at.values);
  TypeParam::velocity_rhs(d, u, q, u1, f);
  expect_equal(derivation["velocity_rhs"], f, at.values);
  TypeParam::acceleration_rhs(d, u, q, q1, u1, u2, f);
  expect_equal(derivation["acceleration_rhs"], f, at.values);

  EXPECT_EQ(derivation["verdict"], TypeParam::rigid ? "rigid" : "degenerate");
  EXPECT_EQ(derivation["mobility"], TypeParam::mobility);
  EXPECT_EQ(derivation.contains("elimination"), TypeParam::rigid);
  if constexpr (TypeParam::rigid) {
    define(derivation["determinant_quantities"], at.values);
    EXPECT_NEAR(value_of(derivation["determinant"], at.values), f_q.determinant(),
                tolerance * (1 + std::abs(f_q.determinant())));
    EXPECT_NE(std::abs(f_q.determinant()), 0);
    EXPECT_EQ(derivation["elimination"]["max_configurations"], TypeParam::max_configurations);
  }
}

/// The values of the polynomial where the group is assembled and where its unknown is moved.
std::pair<double, double> polynomial_values(const Json& elimination, Values values) {
  const double here = value_of(elimination["polynomial"], values);
  values[elimination["unknown"].get<std::string>()] += 0.5;
  return {here, value_of(elimination["polynomial"], values)};
}

void expect_back_substitution(const Json& back, const Values& values) {
  const double unknown = values.at(back["unknown"].get<std::string>());
  const double denominator = value_of(back["denominator"], values);
  const Json& numerators = back["numerators"];
  const bool angle = numerators.size() == 2;
  for (std::size_t part = 0; part < numerators.size(); ++part) {
    const double expected = !angle ? unknown : part == 0 ? std::cos(unknown) : std::sin(unknown);
    EXPECT_NEAR(value_of(numerators[part], values), expected * denominator,
                tolerance * (1 + std::abs(expected * denominator)))
        << back;
  }
}

/// Expects that all parts of the formulas for the equations left and for the final polynomial, in
/// both of its forms, vanish, and that the polynomial's rule states its degree.
void expect_formulas(const Json& step, const Json& elimination, Values values) {
  const std::string title = step["title"];
  const double unknown = values.at(elimination["unknown"].get<std::string>());
  values["t"] = std::tan(unknown / 2);
  if (title.starts_with("the final polynomial")) {
    values["T"] = 0;
    const std::string degree = std::to_string(elimination["degree"].get<int>());
    EXPECT_TRUE(step["rule"].get<std::string>().ends_with(", up to the degree " + degree)) << step;
  } else if (!title.starts_with("the equations left") && !title.starts_with("the same in")) {
    return;
  }
  double size = 1;
  for (const Json& quantity : step["quantities"]) {
    size += std::abs(values.at(quantity["name"].get<std::string>()));
  }
  size *= std::pow(1 + std::pow(values["t"], 2), elimination["degree"].get<int>());
  for (const Json& formula : step["formulas"]) {
    std::string rest = formula;
    std::vector<double> parts;
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find(" = "), rest.size());
      parts.push_back(value_of(rest.substr(0, end), values));
      rest.erase(0, end + 3);
    }
    ASSERT_GE(parts.size(), 2U) << formula;
    for (const double part : parts) {
      EXPECT_NEAR(part, 0, tolerance * size) << formula;
    }
  }
}

/// The values, by name, of the series in which a resultant is written, at the assembled group.
std::map<std::string, std::complex<double>> series_values(const Json& step, const Json& elimination,
                                                          const Values& values) {
  const double unknown = values.at(elimination["unknown"].get<std::string>());
  std::map<std::string, std::complex<double>> result;
  for (const Json& series : step["series"]) {
    const std::complex<double> base =
        series["base"] == "w" ? std::polar(1.0, unknown) : std::complex<double>(unknown);
    std::complex<double>& value = result[series["name"].get<std::string>()];
    for (const Json& term : series["terms"]) {
      value += std::complex(value_of(term["re"], values), value_of(term["im"], values)) *
               std::pow(base, term["power"].get<int>());
    }
  }
  return result;
}

/// At a root of the resultant both its equations hold, and the series equal their formulas. The
/// only series of a single equation vanishes. Returns whether there are series.
bool expect_series(const Json& step, const Json& elimination, const Values& values) {
  if (step["series"].empty()) {
    return false;
  }
  const auto series = series_values(step, elimination, values);
  double size = 1;
  for (const auto& [name, value] : series) {
    size += std::norm(value);
  }
  if (step["eliminated"].empty()) {
    EXPECT_EQ(series.size(), 1U);
    EXPECT_LE(std::abs(series.at("T")), tolerance * size) << step;
    return true;
  }
  const std::string name = step["eliminated"][0];
  const double root = values.at(name);
  if (series.contains("P1")) {
    const std::complex<double> p1 = series.at("P1");
    const std::complex<double> p2 = series.at("P2");
    const std::complex<double> c1 = series.at("C1");
    const std::complex<double> c2 = series.at("C2");
    EXPECT_NEAR((p1 * std::polar(1.0, root)).real() + c1.real(), 0, tolerance * size) << step;
    EXPECT_NEAR((p2 * std::polar(1.0, root)).real() + c2.real(), 0, tolerance * size) << step;
    EXPECT_LE(std::abs(series.at("U") - (p1 * c2 - p2 * c1)), tolerance * size) << step;
    EXPECT_LE(std::abs(series.at("V") - std::imag(p1 * std::conj(p2))), tolerance * size) << step;
    EXPECT_NEAR(std::norm(series.at("U")) - std::norm(series.at("V")), 0, tolerance * size * size)
        << step;
    return true;
  }
  Values reals;
  for (const auto& [letter, value] : series) {
    EXPECT_NEAR(value.imag(), 0, tolerance * size) << letter;
    reals[letter] = value.real();
  }
  for (const std::string equation : {"a*z^2 + b*z + c", "d*z^2 + e*z + f"}) {
    reals["z"] = root;
    EXPECT_NEAR(value_of(equation, reals), 0, tolerance * size) << step;
  }
  for (const Json& one : step["series"]) {
    const std::string formula = one["formula"];
    if (formula.size() > 2) {
      EXPECT_NEAR(value_of(formula, reals), reals.at(one["name"]), tolerance * size) << one;
    }
  }
  const std::string resultant = step["formulas"][0];
  const std::string back = step["formulas"][1];
  EXPECT_TRUE(resultant.starts_with("T = ") && resultant.ends_with(" = 0")) << resultant;
  EXPECT_TRUE(back.starts_with(name + " = ")) << back;
  EXPECT_NEAR(value_of(resultant.substr(4, resultant.size() - 8), reals), 0,
              tolerance * size * size)
      << step;
  EXPECT_NEAR(value_of(back.substr(name.size() + 3), reals), root, 1e-6 * (1 + std::abs(root)))
      << step;
  return true;
}

/// Steps lead to quantities that vanish, and every unknown is eliminated but the polynomial's.
TYPED_TEST(Derive, EliminationHoldsAtAnAssembledGroup) {
  if constexpr (TypeParam::rigid) {
    const Json derivation = this->derivation();
    NamedAssembly<TypeParam> at(derivation);
    const Json& elimination = derivation["elimination"];
    std::set<std::string> eliminated = {elimination["unknown"].get<std::string>()};
    int vanishing = 0;
    int steps_with_series = 0;
    double half_angle_sum = 0;
    for (const Json& step : elimination["steps"]) {
      define(step["quantities"], at.values);
      for (const Json& quantity : step["quantities"]) {
        if (quantity.contains("vanishes")) {
          const double size = std::abs(at.values.at(quantity["name"].get<std::string>()));
          EXPECT_LE(size, tolerance) << quantity;
          ++vanishing;
        }
        const std::string name = quantity["name"];
        if (name.starts_with("p_")) {
          const double t = std::tan(at.values.at(elimination["unknown"].get<std::string>()) / 2);
          half_angle_sum += at.values.at(name) * std::pow(t, std::stoi(name.substr(2)));
        }
      }
      expect_formulas(step, elimination, at.values);
      steps_with_series += expect_series(step, elimination, at.values) ? 1 : 0;
      for (const Json& name : step["eliminated"]) {
        EXPECT_TRUE(eliminated.insert(name.get<std::string>()).second) << name;
      }
    }
    EXPECT_GE(vanishing, TypeParam::group == std::string("dyad") ? 0 : 1);
    EXPECT_EQ(steps_with_series, 1);
    EXPECT_EQ(eliminated.size(), static_cast<std::size_t>(TypeParam::unknown_count));
    const auto [here, moved] = polynomial_values(elimination, at.values);
    EXPECT_LE(std::abs(here), tolerance * std::abs(moved));
    EXPECT_GT(std::abs(moved), 0);
    EXPECT_LE(std::abs(half_angle_sum), 1e-6 * std::abs(moved));
    for (const Json& back : elimination["back_substitution"]) {
      expect_back_substitution(back, at.values);
    }
  }
}

/// The forces on a link add up to zero, those on its neighbours are the opposite ones, and the
/// multipliers satisfy the transposed equations, with the matrices of the generated code.
TYPED_TEST(Derive, ForcesSolveTheTransposedEquations) {
  if constexpr (TypeParam::rigid) {
    const Json derivation = this->derivation();
    const Json& forces = derivation["forces"];
    NamedAssembly<TypeParam> at(derivation);
    const auto& [d, u, q] = at.place;
    RandomInputs random(seed);
    const auto loads = random.vector<Vector<double, 3 * TypeParam::link_count>>();
    Eigen::Index row = 0;
    for (const Json& load : forces["loads"]) {
      for (const Json& name : load) {
        at.values[name.get<std::string>()] = loads(row++);
      }
    }
    define(derivation["determinant_quantities"], at.values);
    for (const char* stage : {"generalised", "multipliers", "reactions", "couples"}) {
      define(forces[stage], at.values);
    }
    std::map<std::string, std::size_t> place_of;
    for (std::size_t place = 0; place < forces["joints"].size(); ++place) {
      place_of[forces["joints"][place]["joint"]] = place;
    }
    const auto force_of = [&](const Json& reaction) {
      return Eigen::Vector2d(value_of(reaction["force"][0], at.values),
                             value_of(reaction["force"][1], at.values));
    };
    Matrix<double, TypeParam::equation_count, TypeParam::unknown_count> J;
    TypeParam::jacobian(d, u, q, J);
    Matrix<double, 3 * TypeParam::link_count, TypeParam::unknown_count> P_q;
    Matrix<double, 3 * TypeParam::link_count, TypeParam::dimension_count> P_d;
    Matrix<double, 3 * TypeParam::link_count, TypeParam::input_count> P_u;
    TypeParam::pose_jacobians(d, u, q, P_q, P_d, P_u);
    // Only one choice of forces in the cut joints solves the equations: those joints are found.
    const Eigen::VectorXd lambda = J.transpose().partialPivLu().solve(-P_q.transpose() * loads);
    const double size = 1 + lambda.cwiseAbs().maxCoeff();
    for (Eigen::Index loop = 0; 2 * loop < lambda.size(); ++loop) {
      EXPECT_TRUE(std::ranges::any_of(forces["joints"], [&](const Json& joint) {
        return (force_of(joint) - lambda.segment<2>(2 * loop)).norm() < tolerance * size;
      })) << loop;
    }
    Eigen::Vector2d passed_on(0, 0);
    for (const Json& neighbour : forces["neighbours"]) {
      const Json& joint = forces["joints"][place_of.at(neighbour["joint"])];
      const double sign = joint["on"] == "base" ? 1 : -1;
      EXPECT_LT((force_of(neighbour) - sign * force_of(joint)).norm(), tolerance * size);
      passed_on += force_of(neighbour);
    }
    for (Eigen::Index link = 0; link < TypeParam::link_count; ++link) {
      passed_on -= loads.template segment<2>(3 * link);
    }
    EXPECT_LT(passed_on.norm(), tolerance * size) << "the loads are passed on";
    for (const Json& equation : forces["equations"]) {
      EXPECT_NEAR(value_of(equation, at.values), 0, tolerance * size) << equation;
    }
  }
}

int count(const std::string& text, const std::string& line_start) {
  const std::regex start("(^|\n)" + line_start);
  return static_cast<int>(
      std::distance(std::sregex_iterator(text.begin(), text.end(), start), std::sregex_iterator()));
}

/// Each line of the text is a comment, a statement, a row or a continuation of one.
TYPED_TEST(Derive, TextIsAnAuditFileThatMentionsEverything) {
  const CommandResult& result = this->said("text");
  EXPECT_EQ(result.status, TypeParam::rigid ? 0 : 1);
  const std::string& text = result.output;
  const Json derivation = this->derivation();
  EXPECT_EQ(count(text, "model " + derivation["kind"].get<std::string>() + "\n"), 1);
  EXPECT_EQ(count(text, "source "), 1);
  EXPECT_EQ(count(text, "printed closure \\([0-9]+\\) f[1-4] : "), TypeParam::equation_count);
  EXPECT_EQ(count(text, "printed matrix (J|F_d|F_u) of f1 f2 .*by "), 3);
  const std::size_t lets = std::min<std::size_t>(derivation["quantities"].size(),
                                                 static_cast<std::size_t>(count(text, "let ")));
  EXPECT_EQ(lets, derivation["quantities"].size());
  for (const char* list : {"unknowns", "dimensions", "inputs"}) {
    for (const Json& variable : derivation[list]) {
      EXPECT_TRUE(
          std::regex_search(text, std::regex("\\b" + variable["name"].get<std::string>() + "\\b")))
          << variable;
    }
  }
  EXPECT_EQ(
      count(text, "(?!#|let |length |source |model |printed (closure|matrix|equation) | |\n|$)"),
      0);
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    EXPECT_TRUE(line.size() <= 100 || line.starts_with("printed matrix ")) << line;
  }
}

TYPED_TEST(Derive, TextAgreesWhenAudited) {
  const TemporaryDirectory directory;
  const auto file = directory.write("derived.audit", this->said("text").output);
  const CommandResult audit = run_assur("audit " + file.string());
  EXPECT_EQ(audit.status, 0) << audit.output << audit.messages;
  EXPECT_TRUE(std::regex_search(audit.output, std::regex("in all: all [0-9]+ agree\n$")));
}

}  // namespace
}  // namespace assur::test::derive_test
