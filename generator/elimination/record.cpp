#include "elimination/record.hpp"

#include <string>

namespace assur::generator::elimination {

GiNaC::symbol RecordedStep::record(const std::string& name, const GiNaC::ex& value,
                                   const std::string& meaning) {
  quantities.push_back({GiNaC::symbol(name), value, meaning});
  return quantities.back().symbol;
}

equations::Vector2 RecordedStep::record(const std::string& name, const equations::Vector2& value,
                                        const std::string& meaning) {
  const auto component = [&](const std::string& axis, const GiNaC::ex& part) -> GiNaC::ex {
    return equations::is_plain(part) ? part
                                     : record(name + "_" + axis, part, meaning + ", " + axis);
  };
  const GiNaC::ex x = component("x", value.x);
  return {x, component("y", value.y)};
}

void RecordedStep::record_equation(const std::string& name, const GiNaC::ex& value,
                                   const std::string& meaning) {
  quantities.push_back({GiNaC::symbol(name), value, meaning, true});
}

namespace {

/// `*x^2`; empty for the power zero.
std::string times_power(const std::string& base, std::size_t power) {
  return power == 0 ? "" : power == 1 ? "*" + base : "*" + base + "^" + std::to_string(power);
}

std::string up_to_degree(std::size_t degree, std::size_t formal_degree) {
  return ", up to the degree " + std::to_string(degree) +
         (formal_degree > degree ? "; above it, up to " + std::to_string(formal_degree) +
                                       ", they vanish, by exact evaluation at random assemblies"
                                 : "");
}

}  // namespace

RecordedStep ordered_by_second(const std::vector<std::array<GiNaC::ex, 3>>& equations,
                               const equations::Variable& second,
                               const equations::Variable& first) {
  const std::string& z = second.name;
  const std::array<std::string, 3> parts =
      second.is_angle() ? std::array<std::string, 3>{"cos(" + z + ")", "sin(" + z + ")", "1"}
                        : std::array<std::string, 3>{z + "^2", z, "1"};
  RecordedStep step{"the equations left, ordered by " + z,
                    "two equations in two unknowns; the coefficients of " + z +
                        " hold no unknown but " + first.name,
                    {},
                    {}};
  for (std::size_t index = 0; index < equations.size(); ++index) {
    const std::string number = std::to_string(index + 1);
    const std::array<std::string, 3> names = {"A" + number, "B" + number, "C" + number};
    step.formulas.push_back("g" + number + " = " + names[0] + "*" + parts[0] + " + " + names[1] +
                            "*" + parts[1] + " + " + names[2] + " = 0");
    for (std::size_t part = 0; part < 3; ++part) {
      step.record(names[part], equations[index][part],
                  "coefficient of " + parts[part] + " in g" + number);
    }
  }
  return step;
}

RecordedStep final_coefficients(const std::vector<equations::Vector2>& polynomial,
                                const equations::Variable& unknown, std::size_t formal_degree) {
  const std::string& x = unknown.name;
  const std::string degrees = up_to_degree(polynomial.size() - 1, formal_degree);
  RecordedStep step{
      "the final polynomial in " + x,
      (unknown.is_angle() ? "the coefficient T_k of `w^k` gives `2*Re(T_k)` for `cos(k*x)` "
                            "and `-2*Im(T_k)` for `sin(k*x)`"
                          : "the coefficients of T") +
          degrees,
      {},
      {}};
  std::string formula;
  for (std::size_t power = 0; power < polynomial.size(); ++power) {
    const equations::Vector2& pair = polynomial[power];
    const std::string k = std::to_string(power);
    const std::string plus = power == 0 ? "" : " + ";
    if (!unknown.is_angle()) {
      step.record("T_" + k, pair.x, "coefficient of " + x + "^" + k);
      formula += plus + "T_" + k + times_power(x, power);
      continue;
    }
    const std::string angle = power == 1 ? x : k + "*" + x;
    if (power == 0) {
      step.record("Tc_0", pair.x, "the constant");
      formula = "Tc_0";
      continue;
    }
    step.record("Tc_" + k, pair.x, "coefficient of cos(" + k + " x)");
    step.record("Ts_" + k, pair.y, "coefficient of sin(" + k + " x)");
    formula += plus + "Tc_" + k + "*cos(" + angle + ") + Ts_" + k + "*sin(" + angle + ")";
  }
  step.formulas.push_back(formula);
  return step;
}

RecordedStep half_angle_form(const std::vector<RecordedQuantity>& coefficients,
                             const equations::Variable& unknown) {
  const std::size_t degree = coefficients.size() / 2;
  const GiNaC::symbol t("t");
  const ComplexExpression twice_turned = ComplexExpression{1, t} * ComplexExpression{1, t};
  ComplexExpression turn = twice_turned;
  GiNaC::ex sum = coefficients[0].symbol * GiNaC::pow(1 + t * t, degree);
  for (std::size_t power = 1; power <= degree; ++power) {
    sum +=
        (coefficients[2 * power - 1].symbol * turn.re + coefficients[2 * power].symbol * turn.im) *
        GiNaC::pow(1 + t * t, degree - power);
    turn = turn * twice_turned;
  }
  sum = sum.expand();
  RecordedStep step{
      "the same in the half-angle t = tan(" + unknown.name + "/2)",
      "`T*(1 + t^2)^" + std::to_string(degree) +
          "` with `cos(x) = (1 - t^2)/(1 + t^2)` and `sin(x) = 2*t/(1 + t^2)`; `x = pi` "
          "is `t` at infinity",
      {},
      {}};
  std::string formula;
  for (std::size_t power = 0; power <= 2 * degree; ++power) {
    const std::string name = "p_" + std::to_string(power);
    step.record(name, sum.coeff(t, static_cast<int>(power)),
                "coefficient of t^" + std::to_string(power));
    formula += (power == 0 ? "" : " + ") + name + times_power("t", power);
  }
  step.formulas.push_back(formula + " = 0");
  return step;
}

}  // namespace assur::generator::elimination
