// Law: a slip planted in the LaTeX of a model's derivation is found in the equation that has it,
// and nothing else is reported.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <iostream>
#include <map>
#include <optional>
#include <random>
#include <regex>
#include <set>

#include "audit/latex/paper_audit.hpp"
#include "generator/all_models.hpp"
#include "generator/derived_latex.hpp"
#include "whole_campaign.hpp"

namespace assur::test::latex_slips_test {
namespace {

using namespace generator;
using namespace generator::audit;

constexpr unsigned seed = 1918;

/// One numbered equation of a paper: where it stands in the text, and its label.
struct Equation {
  std::size_t from;
  std::size_t to;
  std::string label;
  std::string body;
};

/// Closures, the Jacobian and the right-hand sides, as `derive` numbers them.
std::vector<Equation> equations_of(const std::string& paper) {
  std::vector<Equation> list;
  static const std::regex form(
      R"(\\numbered\{((f_\{\d\}|b_\{\d\}|c_\{\d\}|J) = [^]*?)\}\{(\d+)\}\n)");
  const std::size_t end = paper.find("\\section{Mobility");
  const std::size_t begin = paper.find("\\section{Loop closure}");
  for (auto match = std::sregex_iterator(paper.begin() + static_cast<std::ptrdiff_t>(begin),
                                         paper.begin() + static_cast<std::ptrdiff_t>(end), form);
       match != std::sregex_iterator(); ++match) {
    const std::size_t from = begin + static_cast<std::size_t>(match->position(1));
    list.push_back({from, from + static_cast<std::size_t>(match->length(1)),
                    "(" + (*match)[3].str() + ")", (*match)[1].str()});
  }
  return list;
}

bool is_matrix(const std::string& body) { return body.starts_with("J"); }

class Engine {
 public:
  std::size_t below(std::size_t count) { return engine_() % count; }

 private:
  std::mt19937 engine_{seed};
};

/// A change of one match of a pattern, if there is one that changes anything.
std::optional<std::string> replaced(const std::string& body, const std::regex& pattern,
                                    const std::function<std::string(const std::smatch&)>& by,
                                    Engine& engine) {
  std::vector<std::string> variants;
  for (auto match = std::sregex_iterator(body.begin(), body.end(), pattern);
       match != std::sregex_iterator(); ++match) {
    const std::string text = by(*match);
    if (text != match->str()) {
      variants.push_back(body.substr(0, static_cast<std::size_t>(match->position())) + text +
                         match->suffix().str());
    }
  }
  return variants.empty() ? std::nullopt : std::optional(variants[engine.below(variants.size())]);
}

using Cells = std::vector<std::vector<std::string>>;

/// The cells of the Jacobian, its titles first.
Cells cells_of(const std::string& body) {
  Cells cells;
  std::size_t from = body.find("\\hline\n") + 7;
  for (std::size_t to = body.find(" \\\\\n", from); to != std::string::npos;
       from = to + 4, to = body.find(" \\\\\n", from)) {
    cells.emplace_back();
    const std::string row = body.substr(from, to - from) + " & ";
    for (std::size_t at = 0, next; (next = row.find(" & ", at)) != std::string::npos;
         at = next + 3) {
      cells.back().push_back(row.substr(at, next - at));
    }
  }
  return cells;
}

std::string with_cells(const std::string& body, const Cells& cells) {
  std::string text = body.substr(0, body.find("\\hline\n") + 7);
  for (const std::vector<std::string>& row : cells) {
    for (std::size_t cell = 0; cell < row.size(); ++cell) {
      text += (cell == 0 ? "" : " & ") + row[cell];
    }
    text += " \\\\\n";
  }
  return text + "\\end{array}";
}

using Slip = std::optional<std::string> (*)(const std::string& body, Engine& engine);

std::optional<std::string> sign(const std::string& body, Engine& engine) {
  static const std::regex form(R"(\\allowbreak[-+] )");
  return replaced(
      body, form,
      [](const std::smatch& match) {
        return match.str()[11] == '+' ? "\\allowbreak- " : "\\allowbreak+ ";
      },
      engine);
}

std::optional<std::string> exchanged_index(const std::string& body, Engine& engine) {
  static const std::regex form(R"(\\(theta|omega)_\{\\mathit\{(\w+)\}\})");
  std::set<std::string> names;
  for (auto match = std::sregex_iterator(body.begin(), body.end(), form);
       match != std::sregex_iterator(); ++match) {
    names.insert((*match)[2].str());
  }
  const std::size_t titles = is_matrix(body) ? body.find("\\hline") : 0;
  const auto changed = replaced(
      body.substr(titles), form,
      [&](const std::smatch& match) {
        const auto other = std::find_if(names.begin(), names.end(), [&](const std::string& name) {
          return name != match[2].str();
        });
        return other == names.end() ? match.str()
                                    : "\\" + match[1].str() + "_{\\mathit{" + *other + "}}";
      },
      engine);
  return changed ? std::optional(body.substr(0, titles) + *changed) : std::nullopt;
}

std::optional<std::string> missing_term(const std::string& body, Engine& engine) {
  static const std::regex form(R"( \\allowbreak[-+] (?:(?! \\allowbreak[-+] | = 0| &| \\\\)[^])+)");
  return replaced(
      body, form, [](const std::smatch&) { return std::string(); }, engine);
}

std::optional<std::string> degrees(const std::string& body, Engine& engine) {
  static const std::regex form(R"(\\(sin|cos)(\\(?:theta|varphi)_\{(?:\\mathit\{\w+\}|\w)\}))");
  return replaced(
      body, form,
      [](const std::smatch& match) {
        return "\\" + match[1].str() + "\\left(\\frac{\\pi}{180}" + match[2].str() + "\\right)";
      },
      engine);
}

std::optional<std::string> wrong_row(const std::string& body, Engine& engine) {
  if (!is_matrix(body)) {
    return std::nullopt;
  }
  Cells cells = cells_of(body);
  const std::size_t row = engine.below(cells.size() - 1);
  std::swap(cells[row], cells[row + 1]);
  std::swap(cells[row][0], cells[row + 1][0]);
  return with_cells(body, cells);
}

std::optional<std::string> transposed(const std::string& body, Engine&) {
  if (!is_matrix(body)) {
    return std::nullopt;
  }
  Cells cells = cells_of(body);
  for (std::size_t row = 0; row < cells.size(); ++row) {
    for (std::size_t column = row + 1; column < cells.size(); ++column) {
      std::swap(cells[row][column + 1], cells[column][row + 1]);
    }
  }
  const std::string changed = with_cells(body, cells);
  return changed == body ? std::nullopt : std::optional(changed);
}

std::optional<std::string> missing_factor(const std::string& body, Engine& engine) {
  static const std::regex form(R"(2\\,)");
  return replaced(
      body, form, [](const std::smatch&) { return std::string(); }, engine);
}

/// Puts a vector's component in the place of its derivative: x and y are exchanged.
std::optional<std::string> stale_derivative(const std::string& body, Engine& engine) {
  if (!is_matrix(body)) {
    return std::nullopt;
  }
  static const std::regex form(R"((\\overline\{(?:\\mathit\{\w+\}|s)\}_\{(?:\w,)?)([xy])\})");
  return replaced(
      body, form,
      [](const std::smatch& match) {
        return match[1].str() + (match[2].str() == "x" ? "y}" : "x}");
      },
      engine);
}

const std::vector<std::pair<const char*, Slip>> slips = {{"sign", sign},
                                                         {"exchanged indices", exchanged_index},
                                                         {"missing term", missing_term},
                                                         {"degree for radian", degrees},
                                                         {"wrong row", wrong_row},
                                                         {"transposed", transposed},
                                                         {"missing factor 2", missing_factor},
                                                         {"stale derivative", stale_derivative}};

// A share of the models by default, all by `ctest -L long`, which sets the variable.
TEST(LatexSlips, AreFoundAndNothingElseIs) {
  const bool whole = is_whole_campaign();
  constexpr std::size_t most_models = 6;
  std::vector<document::Derivation> derivations;
  for (const structure::Model* model : all_models()) {
    // Tetrads take longest: one in six of them, and the first models of the smaller groups.
    const bool taken =
        whole || (model->group->name() == "tetrad" ? model->number % 6 == 1
                                                   : derivations.size() + 3 < most_models);
    if (!taken || (!whole && derivations.size() == most_models)) {
      continue;
    }
    document::Derivation derivation = document::derive(*model->group, model->representative);
    if (is_square(derivation)) {
      derivations.push_back(std::move(derivation));
    }
  }
  Engine engine;
  std::map<std::string, int> planted;
  std::map<std::string, int> found;
  int false_alarms = 0;
  for (const document::Derivation& derivation : derivations) {
    const structure::Model* const model = derivation.model;
    // The part of the paper after the derivatives is not audited.
    std::string paper = document::derivation_latex(derivation);
    paper.resize(paper.find("\\section{Elimination}"));
    const std::string map = map_of(derivation);
    const std::vector<Equation> equations = equations_of(paper);
    ASSERT_GT(equations.size(), derivation.jacobian.rows.size());
    for (const auto& [name, slip] : slips) {
      std::vector<std::pair<Equation, std::string>> possible;
      for (const Equation& equation : equations) {
        if (const std::optional<std::string> changed = slip(equation.body, engine)) {
          possible.emplace_back(equation, *changed);
        }
      }
      if (possible.empty()) {
        continue;
      }
      const auto& [equation, changed] = possible[engine.below(possible.size())];
      std::string text = paper;
      text.replace(equation.from, equation.to - equation.from, changed);
      ++planted[name];
      bool seen = false;
      for (const AuditedStatement& statement :
           latex::audit_paper_text(text, "slip.tex", map, "slip.map").statements) {
        for (const Finding& finding : statement.findings) {
          if (finding.agrees()) {
            continue;
          }
          const bool here = statement.label.ends_with(" " + equation.label);
          seen = seen || here;
          false_alarms += here ? 0 : 1;
          EXPECT_TRUE(here) << name << " in " << equation.label << " of " << model->group->name()
                            << " " << model->number << ": " << statement.label << " "
                            << finding.item;
        }
      }
      found[name] += seen ? 1 : 0;
      EXPECT_TRUE(seen) << name << " in " << equation.label << " of " << model->group->name() << " "
                        << model->number << ":\n"
                        << equation.body << "\n"
                        << changed;
    }
  }
  int all = 0;
  for (const auto& [name, count] : planted) {
    std::cout << name << ": " << found[name] << " of " << count << " found\n";
    all += count;
  }
  std::cout << derivations.size() << " models, " << all << " slips, " << false_alarms
            << " false alarms; seed " << seed << "\n";
  EXPECT_GE(derivations.size(), whole ? 20U : most_models);
  EXPECT_EQ(planted.size(), slips.size());
}

}  // namespace
}  // namespace assur::test::latex_slips_test
