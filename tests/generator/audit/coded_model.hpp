// Code in four languages, with audits, for a model's Jacobian and for altered versions of it.
#pragma once

#include <ginac/ginac.h>

#include <sstream>
#include <string>
#include <vector>

#include "derivatives/differentiate.hpp"
namespace assur::test {

using generator::derivatives::ExpressionMatrix;
enum class Written : unsigned char { cpp, python, matlab, javascript };

/// An expression of sums, products, whole powers, sines and cosines in a language.
inline std::string code_of(const GiNaC::ex& e, Written language) {
  const auto inner = [&](const GiNaC::ex& part) { return "(" + code_of(part, language) + ")"; };
  if (GiNaC::is_a<GiNaC::numeric>(e)) {
    const auto& number = GiNaC::ex_to<GiNaC::numeric>(e);
    std::ostringstream text;
    text << number.numer();
    text << (number.is_integer() ? "" : ".0/");
    if (!number.is_integer()) {
      text << number.denom();
    }
    return text.str();
  }
  if (GiNaC::is_a<GiNaC::constant>(e)) {
    return language == Written::cpp ? "M_PI" : language == Written::javascript ? "PI" : "pi";
  }
  if (GiNaC::is_a<GiNaC::power>(e)) {
    return language == Written::cpp
               ? "std::pow(" + code_of(e.op(0), language) + ", " + code_of(e.op(1), language) + ")"
               : inner(e.op(0)) + (language == Written::matlab ? "^" : "**") + inner(e.op(1));
  }
  if (GiNaC::is_a<GiNaC::function>(e)) {
    return (language == Written::cpp ? "std::" : "") + GiNaC::ex_to<GiNaC::function>(e).get_name() +
           inner(e.op(0));
  }
  if (GiNaC::is_a<GiNaC::add>(e) || GiNaC::is_a<GiNaC::mul>(e)) {
    std::string text;
    for (const GiNaC::ex& part : e) {
      text += (text.empty() ? "" : GiNaC::is_a<GiNaC::add>(e) ? " + " : "*") + inner(part);
    }
    return text;
  }
  std::ostringstream text;
  text << e;
  return text.str();
}

/// A model's Jacobian in terms of its symbols, and functions that compute it.
class CodedModel {
 public:
  explicit CodedModel(const generator::structure::Model& model)
      : equations_(generator::equations::closure_equations(model)),
        jacobian_(generator::derivatives::closure_jacobian(equations_)) {
    GiNaC::exmap in_angles;
    for (const auto* list : {&equations_.unknowns, &equations_.dimensions, &equations_.inputs}) {
      for (const generator::equations::Variable& variable : *list) {
        names_.push_back(variable.name);
        const GiNaC::symbol symbol(variable.name);
        (variable.is_angle() ? angles_ : lengths_).push_back(symbol);
        if (variable.is_angle()) {
          in_angles[variable.cosine] = GiNaC::cos(symbol);
          in_angles[variable.sine] = GiNaC::sin(symbol);
        } else {
          in_angles[variable.value] = symbol;
        }
      }
    }
    for (std::vector<GiNaC::ex>& row : jacobian_) {
      for (GiNaC::ex& entry : row) {
        entry = equations_.vocabulary.expand(entry).subs(in_angles);
      }
    }
    kind_ = generator::structure::spell(*model.group, model.representative);
  }

  [[nodiscard]] const ExpressionMatrix& jacobian() const { return jacobian_; }
  [[nodiscard]] const std::vector<GiNaC::symbol>& angles() const { return angles_; }
  [[nodiscard]] const std::vector<GiNaC::symbol>& lengths() const { return lengths_; }

  [[nodiscard]] std::string code(const ExpressionMatrix& matrix, Written language) const {
    const std::string columns = std::to_string(matrix[0].size());
    const std::string rows = std::to_string(matrix.size());
    std::string text;
    switch (language) {
      case Written::cpp:
        text = "#include <cmath>\n\nvoid fill(" + list("double ") + ", double (&J)[" + rows + "][" +
               columns + "]) {\n";
        break;
      case Written::python:
        text = "from math import cos, pi, sin\n\n\ndef fill(" + list("") + "):\n    J = [[0] * " +
               columns + " for row in range(" + rows + ")]\n";
        break;
      case Written::javascript:
        text = "const { cos, PI, sin } = Math;\n\nfunction fill(" + list("") +
               ") {\n  const J = Array.from({ length: " + rows + " }, () => Array(" + columns +
               ").fill(0));\n";
        break;
      case Written::matlab:
        text =
            "function J = fill_it(" + list("") + ")\n  J = zeros(" + rows + ", " + columns + ");\n";
    }
    const int first = language == Written::matlab ? 1 : 0;
    for (std::size_t row = 0; row < matrix.size(); ++row) {
      for (std::size_t column = 0; column < matrix[row].size(); ++column) {
        const std::string i = std::to_string(row + static_cast<std::size_t>(first));
        const std::string j = std::to_string(column + static_cast<std::size_t>(first));
        const std::string value = code_of(matrix[row][column], language);
        text += language == Written::matlab   ? "  J(" + i + ", " + j + ") = " + value + ";\n"
                : language == Written::python ? "    J[" + i + "][" + j + "] = " + value + "\n"
                                              : "  J[" + i + "][" + j + "] = " + value + ";\n";
      }
    }
    return text + (language == Written::cpp          ? "}\n"
                   : language == Written::python     ? "    return J\n"
                   : language == Written::javascript ? "  return J;\n}\n"
                                                     : "end\n");
  }

  /// The audit of a file that `code` wrote: read, or run.
  [[nodiscard]] std::string audit(const std::string& file, bool run) const {
    std::string text = "model " + kind_ + "\nprinted " + (run ? "run J " : "code J ") + file +
                       (run ? "" : " J") + " of";
    for (std::size_t row = 0; row < jacobian_.size(); ++row) {
      text += " f" + std::to_string(row + 1);
    }
    text += " by";
    for (const generator::equations::Variable& unknown : equations_.unknowns) {
      text += " " + unknown.name;
    }
    if (!run) {
      return text + "\n";
    }
    if (!file.ends_with(".cpp")) {
      return text + "\n  result " + (file.ends_with(".m") ? "fill_it(" : "fill(") + list("") +
             ")\n";
    }
    const std::string size = std::to_string(jacobian_.size());
    return text + "\n  before double J[" + size + "][" + size + "]\n  before fill(" + list("") +
           ", J)\n  result J\n";
  }

 private:
  [[nodiscard]] std::string list(const std::string& type) const {
    std::string text;
    for (const std::string& name : names_) {
      text += (text.empty() ? "" : ", ") + type + name;
    }
    return text;
  }

  generator::equations::ClosureEquations equations_;
  ExpressionMatrix jacobian_;
  std::vector<std::string> names_;
  std::vector<GiNaC::symbol> angles_;
  std::vector<GiNaC::symbol> lengths_;
  std::string kind_;
};

}  // namespace assur::test
