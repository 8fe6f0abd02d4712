#include "audit/latex/paper_audit.hpp"

#include <algorithm>
#include <assur/text/input_file.hpp>

#include "audit/latex/paper_map.hpp"
#include "audit/source_lines.hpp"
#include "latex/macros.hpp"
#include "latex/rows.hpp"

namespace assur::generator::audit::latex {

namespace {

using closures::FormulaError;
using closures::Place;
using generator::latex::Displayed;
using generator::latex::LatexFormula;
using generator::latex::LatexMatrix;
using generator::latex::Meaning;
using generator::latex::printed_name;
using generator::latex::Token;

bool is_zero(const Tokens& side) { return side.size() == 1 && side[0].is("0"); }

/// Values of the indices of one case.
using Case = std::vector<std::pair<std::string, std::string>>;

Tokens in_case(Tokens tokens, const Case& values) {
  for (const auto& [index, value] : values) {
    tokens = generator::latex::with_index(tokens, index, value);
  }
  return tokens;
}

std::string case_text(const Case& values) {
  std::string text;
  for (const auto& [index, value] : values) {
    text += (text.empty() ? "" : ", ") + index + " = " + value;
  }
  return text;
}

/// Names in a tree that the paper has to define.
void collect_printed(const text::Expression& tree, std::vector<const text::Expression*>& list) {
  if (tree.kind == text::Expression::Kind::name && tree.name.starts_with(printed_name(""))) {
    list.push_back(&tree);
  }
  for (const text::Expression& argument : tree.arguments) {
    collect_printed(argument, list);
  }
}

class PaperAuditor {
 public:
  PaperAuditor(const std::string& paper, const std::string& file, PaperMap& map)
      : paper_(paper), map_(map), reading_(map.reading()), points_(map.reader().system()) {
    report_.file = file;
    report_.source = map.reader().source();
  }

  AuditReport run() {
    std::set<std::string> kept;
    for (const auto& [command, form] : map_.commands()) {
      kept.insert(command);
    }
    try {
      const Tokens tokens =
          generator::latex::expanded(generator::latex::tokens_of(paper_, report_.file), kept);
      for (const Displayed& each : generator::latex::displayed(tokens, map_.commands())) {
        if (!map_.skips(each.label, each.section)) {
          separate(each);
        }
      }
    } catch (const FormulaError& error) {
      throw closures::AuditSyntaxError(report_.file, error.place, error.what());
    }
    define_all();
    turn_closures();
    for (const Stated& stated : stated_) {
      audit(stated);
    }
    if (report_.statements.empty()) {
      throw text::InputError(report_.file + ": nothing to audit; no displayed equation was found");
    }
    return std::move(report_);
  }

 private:
  /// One statement of a displayed equation.
  struct Stated {
    std::string label;
    Place place;
    Tokens tokens;
    std::vector<Tokens> sides = {};
    std::string defines = {};                ///< a name that the paper gives
    std::string closure = {};                ///< the closure that it prints
    std::optional<FormulaError> error = {};  ///< why it cannot be read
  };

  closures::ClosureSystem& system() { return points_.system(); }

  void separate(const Displayed& displayed) {
    std::vector<Tokens> statements;
    try {
      statements = generator::latex::statements_of(displayed.tokens);
    } catch (const FormulaError& error) {
      stated_.push_back({displayed.label, displayed.place, displayed.tokens});
      stated_.back().error = error;
      return;
    }
    for (const Tokens& tokens : statements) {
      if (is_remark(tokens)) {
        continue;
      }
      Stated stated{displayed.label, tokens[0].place, tokens};
      try {
        stated.sides = generator::latex::sides_of(tokens);
        expect_sides(stated);
        stated.closure = closure_of(stated);
        stated.defines = stated.closure.empty() ? definition_of(stated.sides[0]) : "";
      } catch (const FormulaError& error) {
        stated.error = error;
      }
      stated_.push_back(std::move(stated));
    }
  }

  static void expect_sides(const Stated& stated) {
    if (stated.sides.size() < 2) {
      throw FormulaError("an equation with two sides is expected", stated.place);
    }
    for (const Tokens& side : stated.sides) {
      if (side.empty()) {
        throw FormulaError("a side of this equation is missing", stated.place);
      }
    }
  }

  /// `(k = 1, \dots, 4)`, which says again what the map says, and `\text{and}`.
  [[nodiscard]] bool is_remark(const Tokens& tokens) const {
    if (tokens[0].is("\\text") || tokens[0].is("\\mbox")) {
      std::size_t at = 1;
      const std::string words =
          generator::latex::letters_of(generator::latex::take_argument(tokens, at));
      return at == tokens.size() && (words == "and" || words == "with" || words == "where");
    }
    if (tokens.size() < 3 || !tokens.front().is("(") || !tokens.back().is(")")) {
      return false;
    }
    for (std::size_t at = 1; at + 1 < tokens.size(); ++at) {
      const Token& token = tokens[at];
      const bool index = token.is_letter() && (map_.indices().contains(token.text) ||
                                               map_.summed().contains(token.text));
      if (!index && !token.is_digit() && !token.is("=") && !token.is(",") && !token.is("\\dots") &&
          !token.is("\\ldots") && !token.is("\\quad")) {
        return false;
      }
    }
    return true;
  }

  /// The quantity that a whole side is, without power and dots.
  [[nodiscard]] std::optional<Meaning> quantity(const Tokens& side) const {
    Tokens plain = side;
    std::erase_if(plain, [](const Token& token) {
      return generator::latex::is_layout(token) || generator::latex::is_thin_space(token);
    });
    if (plain.empty()) {
      return std::nullopt;
    }
    const std::optional<Meaning> meaning = map_.notations().at(plain, 0);
    const bool whole =
        meaning && meaning->end == plain.size() && meaning->power.empty() && meaning->dots == 0;
    return whole ? meaning : std::nullopt;
  }

  [[nodiscard]] std::string definition_of(const Tokens& side) const {
    const std::optional<Meaning> meaning = quantity(side);
    return meaning && meaning->formula.empty() ? meaning->name : "";
  }

  /// `f_1 = ...`, `f_1 = ... = 0`
  [[nodiscard]] std::string closure_of(const Stated& stated) const {
    const std::optional<Meaning> meaning = quantity(stated.sides[0]);
    const bool closure = meaning && !meaning->formula.empty() &&
                         map_.system().closure_named(meaning->formula) != nullptr;
    const bool form =
        stated.sides.size() == 2 || (stated.sides.size() == 3 && is_zero(stated.sides[2]));
    return closure && form && !is_zero(stated.sides[1]) ? meaning->formula : "";
  }

  /// The expression of tokens. Throws FormulaError.
  GiNaC::ex expression(const Tokens& tokens, Place place) {
    const LatexFormula formula = generator::latex::read_latex(tokens, reading_, place);
    const auto place_of = [&](std::size_t column) { return formula.places[column - 1]; };
    std::vector<const text::Expression*> printed;
    collect_printed(formula.tree, printed);
    for (const text::Expression* each : printed) {
      if (!system().is_known(each->name)) {
        throw FormulaError("the paper does not define '" +
                               each->name.substr(printed_name("").size()) +
                               "' in a way that can be read",
                           place_of(each->column));
      }
    }
    return closures::expression_of(formula.tree, place_of, system());
  }

  /// Definitions in whatever order they stand: each may use others.
  void define_all() {
    bool more = true;
    while (more) {
      more = false;
      for (Stated& stated : stated_) {
        if (stated.defines.empty() || stated.error ||
            system().is_known(printed_name(stated.defines))) {
          continue;
        }
        try {
          system().abbreviate(printed_name(stated.defines),
                              expression(stated.sides[1], stated.place));
          stated.sides.erase(stated.sides.begin());
          more = true;
        } catch (const FormulaError&) {
          continue;  // it may be readable when more is defined; if not, its audit says why
        }
      }
    }
  }

  /// Signs of closures count for all that is printed, before them and behind.
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

  /// As it stands in the file, on one line.
  [[nodiscard]] std::string source(const Tokens& tokens) const {
    if (tokens.empty()) {
      return "";
    }
    std::size_t from = tokens[0].from;
    std::size_t to = tokens[0].to;
    for (const Token& token : tokens) {
      from = std::min(from, token.from);
      to = std::max(to, token.to);
    }
    std::string text;
    for (const char letter : paper_.substr(from, to - from)) {
      const bool space = letter == '\n' || letter == '\r' || letter == '\t' || letter == ' ';
      if (!space || (!text.empty() && text.back() != ' ')) {
        text += space ? ' ' : letter;
      }
    }
    return text;
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
      answer(stated, 0, {unreadable("", source(stated.tokens), *stated.error)});
      return;
    }
    try {
      if (!stated.closure.empty()) {
        answer(stated, 0, {closure_finding(stated)});
      } else if (!audit_matrices(stated)) {
        audit_equations(stated);
      }
    } catch (const FormulaError& error) {
      answer(stated, 0, {unreadable("", source(stated.tokens), error)});
    }
  }

  Finding closure_finding(const Stated& stated) {
    try {
      return audit_closure(points_, stated.closure, expression(stated.sides[1], stated.place),
                           {source(stated.tokens), stated.place});
    } catch (const FormulaError& error) {
      return unreadable(stated.closure, source(stated.tokens), error);
    }
  }

  /// Whether the statement is one of matrices.
  bool audit_matrices(const Stated& stated) {
    if (stated.sides.size() < 2) {
      return false;
    }
    const std::optional<PrintedMatrix> left = map_.matrix_frame(stated.sides[0]);
    if (!left) {
      return false;
    }
    if (audit_inverse(stated, *left)) {
      return true;
    }
    const std::optional<LatexMatrix> matrix = generator::latex::read_matrix(stated.sides[1]);
    if (!matrix || stated.sides.size() != 2) {
      throw FormulaError("a matrix is expected here", stated.sides[1][0].place);
    }
    audit_entries(stated, *left, *matrix);
    return true;
  }

  void audit_entries(const Stated& stated, PrintedMatrix frame, const LatexMatrix& matrix) {
    if (frame.columns.empty()) {
      frame = frame_of_titles(matrix);
    } else if (!matrix.row_titles.empty()) {
      throw FormulaError("the matrix has titles; say 'matrix by its titles' in the map",
                         matrix.place);
    }
    if (matrix.cells.size() != frame.rows.size() ||
        matrix.cells[0].size() != frame.columns.size()) {
      throw FormulaError("the map says " + std::to_string(frame.rows.size()) + " by " +
                             std::to_string(frame.columns.size()) + " entries, and these are " +
                             std::to_string(matrix.cells.size()) + " by " +
                             std::to_string(matrix.cells[0].size()),
                         matrix.place);
    }
    std::vector<Finding> findings;
    for (std::size_t row = 0; row < frame.rows.size(); ++row) {
      Place last = matrix.place;
      for (std::size_t column = 0; column < frame.columns.size(); ++column) {
        const Tokens& cell = matrix.cells[row][column];
        last = cell.empty() ? last : cell[0].place;
        const bool blank = cell.empty() && reading_.blanks_are_zero;
        findings.push_back(audit_entry(
            points_, frame, row, column, {blank ? "0" : source(cell), last},
            [&]() -> GiNaC::ex { return blank ? GiNaC::ex(0) : expression(cell, last); }));
      }
    }
    answer(stated, frame.columns.size(), std::move(findings));
  }

  [[nodiscard]] PrintedMatrix frame_of_titles(const LatexMatrix& matrix) const {
    if (matrix.row_titles.empty()) {
      throw FormulaError("the matrix has no titles that are ruled off", matrix.place);
    }
    PrintedMatrix frame;
    const auto name_of = [&](const Tokens& title) {
      const std::optional<Meaning> meaning = quantity(title);
      if (!meaning || !map_.system().is_known(meaning->formula)) {
        throw FormulaError("no quantity is known as '" + source(title) + "'",
                           title.empty() ? matrix.place : title[0].place);
      }
      return meaning->formula;
    };
    for (const Tokens& title : matrix.row_titles) {
      frame.rows.push_back(name_of(title));
    }
    for (const Tokens& title : matrix.column_titles) {
      frame.columns.push_back(name_of(title));
      if (map_.system().symbol_named(frame.columns.back()) == nullptr) {
        throw FormulaError("'" + frame.columns.back() + "' is nothing to differentiate by",
                           title[0].place);
      }
    }
    return frame;
  }

  /// `dq/da = -[df/dq]^{-1} df/da`, audited as `df/dq dq/da = -df/da`: entry by entry.
  bool audit_inverse(const Stated& stated, const PrintedMatrix& left) {
    Tokens side = stated.sides[1];
    std::erase_if(side, [](const Token& token) { return generator::latex::is_layout(token); });
    const bool minus = !side.empty() && side[0].is("-");
    std::size_t mark = 0;
    while (mark + 4 < side.size() &&
           !(side[mark].is("^") && side[mark + 1].is("{") && side[mark + 2].is("-") &&
             side[mark + 3].is("1") && side[mark + 4].is("}"))) {
      ++mark;
    }
    if (mark + 5 >= side.size() || stated.sides.size() != 2 || left.rows.empty()) {
      return false;
    }
    std::size_t behind = mark + 5;
    behind += side[behind].is("\\cdot") ? 1 : 0;
    const Tokens one = generator::latex::slice(side, minus ? 1 : 0, mark);
    const Tokens other = generator::latex::slice(side, behind, side.size());
    const std::optional<PrintedMatrix> inverted =
        one.empty() ? std::nullopt : map_.matrix_frame(one);
    const std::optional<PrintedMatrix> right =
        other.empty() ? std::nullopt : map_.matrix_frame(other);
    if (!inverted || !right || inverted->columns != left.rows || inverted->rows != right->rows ||
        right->columns != left.columns) {
      throw FormulaError("the map's matrices do not fit together here", stated.sides[1][0].place);
    }
    std::vector<Finding> findings;
    for (const std::string& row : right->rows) {
      for (const std::string& column : right->columns) {
        const closures::AuditSymbol& by = *system().symbol_named(column);
        const GiNaC::ex& closure = *system().closure_named(row);
        GiNaC::ex sum;
        for (const std::string& unknown : left.rows) {
          const closures::AuditSymbol& each = *system().symbol_named(unknown);
          sum += system().partial(closure, each.symbol) * system().total(each.symbol, by);
        }
        const GiNaC::ex direct = system().partial(closure, by.symbol);
        findings.push_back(audit_equation(points_, row + " by " + column, sum,
                                          minus ? -direct : direct,
                                          {source(stated.tokens), stated.place}));
      }
    }
    answer(stated, 0, std::move(findings));
    return true;
  }

  void audit_equations(const Stated& stated) {
    if (stated.sides.size() < 2) {
      return;  // a definition, and nothing beside it
    }
    std::vector<Case> cases = {{}};
    for (const auto& [index, values] : map_.indices()) {
      if (!generator::latex::has_index(stated.tokens, index)) {
        continue;
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
    const std::string printed = source(left) + " = " + source(right);
    try {
      const GiNaC::ex one = expression(in_case(left, values), left[0].place);
      return audit_equation(points_, case_text(values), one,
                            expression(in_case(right, values), right[0].place),
                            {printed, left[0].place});
    } catch (const FormulaError& error) {
      return unreadable(case_text(values), printed, error);
    }
  }

  const std::string& paper_;
  PaperMap& map_;
  generator::latex::Reading reading_;
  closures::ClosurePoints points_;
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
