#include "audit/latex/paper_audit.hpp"

#include <algorithm>
#include <assur/text/input_file.hpp>
#include <assur/text/names.hpp>
#include <set>

#include "audit/finding.hpp"
#include "audit/latex/paper_statements.hpp"
#include "latex/indices.hpp"
#include "latex/macros.hpp"

namespace assur::generator::audit::latex {

namespace {

using generator::latex::printed_name;

/// Values of the indices of one case.
using Case = std::vector<std::pair<std::string, std::string>>;

Tokens in_case(Tokens tokens, const Case& values) {
  for (const auto& [index, value] : values) {
    tokens = generator::latex::with_index(tokens, index, value);
  }
  return tokens;
}

std::string case_text(const Case& values) {
  return text::joined(values, ", ",
                      [](const auto& pair) { return pair.first + " = " + pair.second; });
}

/// The reason why a paper with these equations has nothing to audit.
std::string why_nothing(const std::vector<generator::latex::Displayed>& equations,
                        const PaperMap& map) {
  if (equations.empty()) {
    return "no displayed equation was found";
  }
  const bool skipped = std::all_of(equations.begin(), equations.end(), [&](const auto& equation) {
    return map.skips(equation.label, equation.section);
  });
  return skipped ? "the map skips every equation"
                 : "the equations only define what the map takes as printed";
}

class PaperAuditor {
 public:
  PaperAuditor(const std::string& paper, const std::string& file, PaperMap& map)
      : paper_(paper), map_(map), formulas_(paper, map) {
    report_.file = file;
    report_.source = map.reader().source();
  }

  AuditReport run() {
    std::set<std::string> kept;
    for (const auto& [command, form] : map_.commands()) {
      kept.insert(command);
    }
    try {
      tokens_ = generator::latex::expanded(generator::latex::tokens_of(paper_, report_.file), kept);
      stated_ = paper_statements(tokens_, map_);
    } catch (const FormulaError& error) {
      throw closures::AuditSyntaxError(report_.file, error.place, error.what());
    }
    define_all();
    turn_closures();
    for (const Stated& stated : stated_) {
      audit(stated);
    }
    if (report_.statements.empty()) {
      throw text::InputError(
          report_.file + ": nothing to audit: " +
          why_nothing(generator::latex::displayed(tokens_, map_.commands()), map_));
    }
    return std::move(report_);
  }

 private:
  closures::ClosureSystem& system() { return formulas_.system(); }

  /// Reads the definitions of the paper; each may use others, also later ones.
  void define_all() {
    // Of several definitions of a name, the first that can be read in a pass through the paper
    // counts. Only definitions whose missing names have since been defined are read again.
    std::set<std::pair<std::size_t, std::size_t>> ready;  // pass, place in the paper
    for (std::size_t place = 0; place < stated_.size(); ++place) {
      if (!stated_[place].defines.empty() && !stated_[place].error) {
        ready.emplace(0, place);
      }
    }
    std::map<std::string, std::vector<std::size_t>> waiting;  // by the name that each needs first
    while (!ready.empty()) {
      const auto [pass, place] = *ready.begin();
      ready.erase(ready.begin());
      Stated& stated = stated_[place];
      const std::string name = printed_name(stated.defines);
      if (system().is_known(name)) {
        continue;
      }
      try {
        system().abbreviate(name, formulas_.expression(stated.sides[1], stated.place));
      } catch (const NotDefined& needed) {
        waiting[needed.name].push_back(place);
        continue;
      } catch (const FormulaError&) {
        continue;  // its audit reports the error
      }
      stated.sides.erase(stated.sides.begin());
      for (const std::size_t other : waiting[name]) {
        ready.emplace(other > place ? pass : pass + 1, other);
      }
      waiting.erase(name);
    }
  }

  /// Reverses closures that are printed with all signs reversed, also in earlier statements.
  void turn_closures() {
    std::map<std::string, bool> turned;
    for (const Stated& stated : stated_) {
      if (stated.closure.empty() || stated.error) {
        continue;
      }
      const bool one = is_turned(closure_finding(stated));
      const bool first = !turned.contains(stated.closure);
      turned[stated.closure] = one && (first || turned[stated.closure]);
    }
    for (const auto& [name, turn] : turned) {
      if (turn) {
        system().negate_closure(name);
      }
    }
  }

  void answer(const Stated& stated, std::size_t columns, std::vector<Finding> findings) {
    const std::string label = (columns > 0              ? "matrix "
                               : stated.closure.empty() ? "equation "
                                                        : "closure ") +
                              stated.label;
    if (columns == 0 && !report_.statements.empty() && report_.statements.back().label == label) {
      std::vector<Finding>& list = report_.statements.back().findings;
      std::move(findings.begin(), findings.end(), std::back_inserter(list));
    } else {
      report_.statements.push_back({label, stated.place, columns, std::move(findings), ""});
    }
  }

  void audit(const Stated& stated) {
    if (stated.error) {
      answer(stated, 0, {unreadable("", formulas_.source(stated.tokens), *stated.error)});
      return;
    }
    try {
      if (!stated.closure.empty()) {
        answer(stated, 0, {closure_finding(stated)});
      } else if (auto matrix = audit_matrix_statement(formulas_, stated)) {
        answer(stated, matrix->columns, std::move(matrix->findings));
      } else {
        audit_equations(stated);
      }
    } catch (const FormulaError& error) {
      answer(stated, 0, {unreadable("", formulas_.source(stated.tokens), error)});
    }
  }

  Finding closure_finding(const Stated& stated) {
    try {
      return audit_closure(formulas_.points(), stated.closure,
                           formulas_.expression(stated.sides[1], stated.place),
                           {formulas_.source(stated.tokens), stated.place});
    } catch (const FormulaError& error) {
      return unreadable(stated.closure, formulas_.source(stated.tokens), error);
    }
  }

  void audit_equations(const Stated& stated) {
    if (stated.sides.size() < 2) {
      return;  // only a definition
    }
    const std::size_t letters =
        std::max(stated.tokens.size(), formulas_.source(stated.tokens).size());
    std::vector<Case> cases = {{}};
    for (const auto& [index, values] : map_.indices()) {
      if (!generator::latex::has_index(stated.tokens, index)) {
        continue;
      }
      const std::size_t count = cases.size() * values.size();
      const bool many = count * (stated.sides.size() - 1) > most_cases;
      if (many || count * letters > most_letters_of_cases) {
        throw FormulaError("the indices make more than " +
                               (many ? std::to_string(most_cases) + " equations"
                                     : std::to_string(most_letters_of_cases) + " letters") +
                               " of this one; let the map skip it",
                           stated.place);
      }
      std::vector<Case> more;
      for (const Case& one : cases) {
        for (const std::string& value : values) {
          more.push_back(one);
          more.back().emplace_back(index, value);
        }
      }
      cases = std::move(more);
    }
    std::vector<Finding> findings;
    for (const Case& one : cases) {
      for (std::size_t side = 0; side + 1 < stated.sides.size(); ++side) {
        findings.push_back(sides_finding(stated, side, one));
      }
    }
    answer(stated, 0, std::move(findings));
  }

  Finding sides_finding(const Stated& stated, std::size_t side, const Case& values) {
    const Tokens& left = stated.sides[side];
    const Tokens& right = stated.sides[side + 1];
    const std::string printed = formulas_.source(left) + " = " + formulas_.source(right);
    try {
      const GiNaC::ex one = formulas_.expression(in_case(left, values), left[0].place);
      return audit_equation(formulas_.points(), case_text(values), one,
                            formulas_.expression(in_case(right, values), right[0].place),
                            {printed, left[0].place});
    } catch (const FormulaError& error) {
      return unreadable(case_text(values), printed, error);
    }
  }

  const std::string& paper_;
  PaperMap& map_;
  PaperFormulas formulas_;
  Tokens tokens_;
  std::vector<Stated> stated_;
  AuditReport report_;
};

}  // namespace

AuditReport audit_paper_text(const std::string& paper, const std::string& paper_file,
                             const std::string& map, const std::string& map_file) {
  PaperMap read(map, map_file);
  AuditReport report = PaperAuditor(paper, paper_file, read).run();
  quote_lines(report, paper);
  return report;
}

AuditReport audit_paper(const std::string& paper, const std::string& map) {
  return audit_paper_text(text::read_input_file(paper), paper, text::read_input_file(map), map);
}

}  // namespace assur::generator::audit::latex
