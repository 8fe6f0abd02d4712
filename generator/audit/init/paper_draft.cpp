// Drafts the map of a paper's notation.
#include <algorithm>
#include <assur/text/error.hpp>
#include <assur/text/expression.hpp>
#include <assur/text/names.hpp>
#include <filesystem>
#include <set>

#include "audit/init/draft_text.hpp"
#include "latex/displayed.hpp"
#include "latex/macros.hpp"
#include "latex/notation.hpp"
#include "latex/read_matrix.hpp"
#include "latex/rows.hpp"

namespace assur::generator::audit::init {

namespace {

using latex::Tokens;

bool is_angle_function(const latex::Token& token) {
  return token.is("\\sin") || token.is("\\cos") || token.is("\\tan");
}

class PaperDraft {
 public:
  PaperDraft(const std::string& paper, const std::string& file) : file_(file) {
    try {
      const Tokens tokens = latex::expanded(latex::tokens_of(paper, file), {});
      for (const latex::Displayed& equation : latex::displayed(tokens, {})) {
        for (const Tokens& statement : latex::statements_of(equation.tokens)) {
          read_statement(statement);
        }
      }
    } catch (const latex::FormulaError& error) {
      throw closures::AuditSyntaxError(file, error.place, error.what());
    }
  }

  [[nodiscard]] std::string text() const {
    std::vector<std::string> lengths;
    std::vector<std::string> angles;
    for (const std::string& name : names_) {
      (angles_.contains(name) ? angles : lengths).push_back(name);
    }
    if (names_.empty()) {
      throw text::InputError(file_ + ": no displayed equation has a symbol; write the map by hand");
    }
    std::string text = line("source " + std::filesystem::path(file_).filename().string());
    if (!lengths.empty()) {
      text += line("length " + text::joined(lengths, " "));
    }
    if (!angles.empty()) {
      text += line("angle " + text::joined(angles, " "));
    }
    const std::string moving =
        dotted_.empty()
            ? ""
            : " (dots stand above " + text::joined({dotted_.begin(), dotted_.end()}, ", ") + ")";
    text += marked("what the closures determine: unknown NAME NAME" + moving);
    text += marked("what moves by itself: moving NAME");
    text += marked("links around a loop: loop f1 f2 = polar(LENGTH, ANGLE) + ... - point(X, Y)");
    for (const std::string& matrix : matrices_) {
      text += marked("what stands in it: " + matrix + " = matrix of f1 f2 by NAME NAME");
    }
    return text;
  }

 private:
  void read_statement(const Tokens& statement) {
    const std::size_t equals = static_cast<std::size_t>(
        std::find_if(statement.begin(), statement.end(),
                     [](const latex::Token& token) { return token.is("="); }) -
        statement.begin());
    if (equals < statement.size() &&
        is_matrix(latex::slice(statement, equals + 1, statement.size()))) {
      const Tokens left = latex::slice(statement, 0, equals);
      std::string notation;
      for (const latex::Token& token : left) {
        notation += (token.spaced && !notation.empty() ? " " : "") + token.text;
      }
      if (!notation.empty() &&
          std::find(matrices_.begin(), matrices_.end(), notation) == matrices_.end()) {
        matrices_.push_back(notation);
      }
      read_symbols(latex::slice(statement, equals, statement.size()), false);
      return;
    }
    read_symbols(statement, false);
  }

  static bool is_matrix(const Tokens& side) {
    try {
      return latex::read_matrix(side).has_value();
    } catch (const latex::FormulaError&) {
      return false;  // the audit reports its error
    }
  }

  /// Adds the symbols; those after a sine or cosine are angles.
  void read_symbols(const Tokens& tokens, bool are_angles) {
    for (std::size_t at = 0; at < tokens.size();) {
      if (tokens[at].is("\\begin") || tokens[at].is("\\end") || tokens[at].is("\\operatorname")) {
        at = latex::end_of_argument(tokens, at + 1);
        continue;
      }
      if (is_angle_function(tokens[at])) {
        at = read_argument(tokens, at + 1);
        continue;
      }
      const std::optional<latex::Atom> atom = atom_at(tokens, at);
      if (!atom) {
        ++at;
        continue;
      }
      add(*atom, are_angles);
      at = std::max(atom->end, at + 1);
    }
  }

  /// Reads the argument of a function, a bracket or a product of symbols; returns its end.
  std::size_t read_argument(const Tokens& tokens, std::size_t at) {
    if (at < tokens.size() && tokens[at].is("^")) {
      at = latex::end_of_argument(tokens, at + 1);
    }
    while (at < tokens.size() && (latex::is_layout(tokens[at]) ||
                                  latex::is_thin_space(tokens[at]) || tokens[at].is_digit())) {
      ++at;
    }
    if (at >= tokens.size()) {
      return at;
    }
    std::size_t end = at + 1;
    if (latex::opens(tokens[at])) {
      for (int depth = 1; end < tokens.size() && depth > 0; ++end) {
        depth += latex::opens(tokens[end]) ? 1 : latex::closes(tokens[end]) ? -1 : 0;
      }
    } else if (const std::optional<latex::Atom> atom = atom_at(tokens, at)) {
      end = std::max(atom->end, end);
    } else if (tokens[at].is("{")) {
      end = latex::end_of_argument(tokens, at);
    }
    read_symbols(latex::slice(tokens, at, end), true);
    return end;
  }

  static std::optional<latex::Atom> atom_at(const Tokens& tokens, std::size_t at) {
    try {
      return latex::read_atom(tokens, at);
    } catch (const latex::FormulaError&) {
      return std::nullopt;  // the audit reports its error
    }
  }

  void add(const latex::Atom& atom, bool is_angle) {
    // `d`, `t` and `T` denote derivatives and transposed matrices.
    static const std::set<std::string> signs = {"d", "t", "T"};
    // `f_1` is the name of a closure in most papers.
    if (signs.contains(atom.name) || atom.name.starts_with("f_") ||
        !text::is_identifier(atom.name) || text::is_reserved_name(atom.name)) {
      return;
    }
    if (std::find(names_.begin(), names_.end(), atom.name) == names_.end()) {
      names_.push_back(atom.name);
    }
    if (is_angle) {
      angles_.insert(atom.name);
    }
    if (atom.dots > 0) {
      dotted_.insert(atom.name);
    }
  }

  std::string file_;
  std::vector<std::string> names_;
  std::set<std::string> angles_;
  std::set<std::string> dotted_;
  std::vector<std::string> matrices_;
};

}  // namespace

std::string paper_draft(const std::string& paper, const std::string& file) {
  return PaperDraft(paper, file).text();
}

}  // namespace assur::generator::audit::init
