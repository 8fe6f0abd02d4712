#include "audit/code_matrix.hpp"

#include "audit/code_text.hpp"
#include "audit/pattern.hpp"

namespace assur::generator::audit {

namespace {

/// Regular expressions go as deep into the stack as a text is long.
constexpr std::size_t max_length = 10000;

/// Reads the statements in their order.
class CodeMatrix {
 public:
  CodeMatrix(const std::string& code, const std::string& file, const std::string& array,
             std::size_t rows, std::size_t columns, closures::ClosureSystem& system)
      : code_(code),
        file_(file),
        array_(array),
        rows_(rows),
        columns_(columns),
        system_(system),
        entries_(rows * columns),
        entry_form_("^" + array +
                    R"(\s*(?:\(\s*(\d+)\s*,\s*(\d+)\s*\)|\[\s*(\d+)\s*\]\s*\[\s*(\d+)\s*\]))"
                    R"(\s*=(?!=)\s*(.*)$)"),
        list_form_("^" + array + R"(\s*<<\s*(.*)$)"),
        clear_form_(
            "(^|.*[^\\w.])" + array +
            R"(\s*(\.\s*setZero\s*\(.*\)|\.\s*fill\s*\(\s*0\.?0?\s*\)|=.*\bZero\s*\(.*\))$)"),
        begun_form_(".*\\b" + array + R"(\s*(\[[^=]*\])?\s*=?\s*$)"),
        other_form_("(^|.*[^\\w.])" + array + R"(\s*((\(|\[|\.)[^=]*)?(<<|[-+*/]?=(?!=)).*$)") {}

  std::vector<PrintedEntry> run() {
    const std::vector<CodeStatement> statements = code_statements(code_);
    bool initialised = false;
    for (const CodeStatement& statement : statements) {
      const std::string& text = statement.text.text;
      if (initialised) {  // `J[2][2] = {}`, or with a zero in it
        static const Pattern nothing(R"([0.\s]*)");
        if (!nothing.match(text)) {
          refuse(statement.text.place);
        }
        initialised = text.empty() && statement.end == '{';
        continue;
      }
      if (statement.end == '{' && text.ends_with('=') && begun_form_.match(text)) {
        initialised = true;
        continue;
      }
      read(statement);
    }
    if (!found_) {
      throw closures::AuditSyntaxError(file_, {1, 1}, "nothing is assigned to " + array_);
    }
    for (PrintedEntry& entry : entries_) {
      entry.text.place = entry.text.empty() ? *found_ : entry.text.place;
    }
    return std::move(entries_);
  }

 private:
  [[noreturn]] void fail(closures::Place place, const std::string& what) const {
    throw closures::AuditSyntaxError(file_, place_in_code(code_, place), what);
  }
  [[noreturn]] void refuse(closures::Place place) const {
    fail(place, "cannot read this use of " + array_ + "; write " + array_ + "(i, j) = EXPRESSION");
  }

  void read(const CodeStatement& statement) {
    const std::string& text = statement.text.text;
    if (text.size() > max_length) {
      if (text.find(array_) != std::string::npos) {
        fail(statement.text.place, "a statement longer than " + std::to_string(max_length) +
                                       " characters cannot be read");
      }
      return;
    }
    const std::optional<PatternMatch> entry = entry_form_.match(text);
    if (const std::optional<PatternMatch> match = entry ? entry : list_form_.match(text)) {
      if (statement.conditional) {
        fail(statement.text.place, array_ +
                                       " is filled inside a condition or a loop; only what "
                                       "always runs once can be read");
      }
      found_ = found_.value_or(statement.text.place);
      const PatternMatch::Part& last = match->parts.back();
      const closures::PlacedText value{last.text, statement.text.at(last.place + 1)};
      entry ? read_entry(*match, statement.text.place, value) : read_list(value);
    } else if (clear_form_.match(text)) {
      entries_.assign(entries_.size(), {});
    } else if (other_form_.match(text)) {
      refuse(statement.text.place);
    } else {
      read_locals(statement);
    }
  }

  void read_entry(const PatternMatch& match, closures::Place place,
                  const closures::PlacedText& value) {
    const auto index = [&](std::size_t one, std::size_t other) {
      const std::string& digits = match[match.parts[one].matched ? one : other];
      return digits.size() > 6 ? rows_ + columns_ : std::stoul(digits);
    };
    const std::size_t row = index(1, 3);
    const std::size_t column = index(2, 4);
    if (row >= rows_ || column >= columns_) {
      fail(place, array_ + " is audited as " + size_text() + ", and this entry is outside");
    }
    PrintedEntry& entry = entries_[row * columns_ + column];
    entry = {formula(value), locals_, value.text};
    const std::string name = array_ + "_" + std::to_string(row) + "_" + std::to_string(column);
    locals_.meanings.erase(name);
    try {  // later entries may repeat this one
      locals_.meanings[name] = closures::read_formula(entry.text, system_, locals_);
    } catch (const closures::FormulaError&) {
      unreadable_[name] = {"see its assignment", place};
    }
  }

  void read_list(const closures::PlacedText& values) {
    const std::vector<closures::PlacedText> list = closures::split(values, ',');
    if (list.size() != entries_.size()) {
      fail(values.place, array_ + " is audited as " + size_text() + ", and this lists " +
                             std::to_string(list.size()) + " entries");
    }
    for (std::size_t place = 0; place < list.size(); ++place) {
      entries_[place] = {formula(list[place]), locals_, list[place].text};
    }
  }

  [[nodiscard]] std::string size_text() const {
    return std::to_string(rows_) + " by " + std::to_string(columns_);
  }

  /// The formula of an expression in which every local variable is one that could be read.
  closures::PlacedText formula(const closures::PlacedText& value) {
    std::string text;
    try {
      text = code_as_formula(value.text);
    } catch (const CodeError& error) {
      fail(value.at(error.column), error.what());
    }
    static const Pattern name(R"([A-Za-z_]\w*)");
    for (auto at = name.search(text); at; at = name.search(text, at->end())) {
      if (const auto found = unreadable_.find((*at)[0]); found != unreadable_.end()) {
        fail(found->second.place, "'" + found->first + "' cannot be read: " + found->second.text);
      }
    }
    return {text, value.place};
  }

  /// `const double a = EXPR, b = EXPR`, `a = EXPR`; `a += EXPR` makes it unreadable.
  void read_locals(const CodeStatement& statement) {
    // Any type counts: a variable that were overlooked would pass for a symbol of its name.
    static const Pattern form(R"(^((?:[A-Za-z_][\w:]*(?:<[^=]*>)?[\s&*]+)*))"
                              R"(([A-Za-z_](?:\w|\.|->|\[\d+\])*)\s*([-+*/]?)=(?!=)\s*(.*)$)");
    for (const closures::PlacedText& part : closures::split(statement.text, ',')) {
      const std::optional<PatternMatch> matched = form.match(part.text);
      if (!matched) {
        return;
      }
      const PatternMatch& match = *matched;
      const closures::PlacedText value{match[4], part.at(match.parts[4].place + 1)};
      const std::string name = closures::trimmed({code_as_formula(match[2]), {}}).text;
      locals_.meanings.erase(name);
      unreadable_.erase(name);
      if (!match[3].empty() || statement.conditional) {
        unreadable_[name] = {!match[3].empty()
                                 ? "write its whole value in place of '" + match[3] + "='"
                                 : "it is set inside a condition or a loop",
                             part.place};
        continue;
      }
      try {
        locals_.meanings[name] =
            closures::read_formula({code_as_formula(value.text), value.place}, system_, locals_);
      } catch (const closures::FormulaError& error) {
        unreadable_[name] = {error.what(), error.place};
      } catch (const CodeError& error) {
        unreadable_[name] = {error.what(), value.at(error.column)};
      }
    }
  }

  const std::string& code_;
  const std::string& file_;
  const std::string& array_;
  std::size_t rows_;
  std::size_t columns_;
  closures::ClosureSystem& system_;
  std::vector<PrintedEntry> entries_;
  Pattern entry_form_;
  Pattern list_form_;
  Pattern clear_form_;
  Pattern begun_form_;
  Pattern other_form_;
  closures::LocalNames locals_;
  std::map<std::string, closures::PlacedText>
      unreadable_;                        ///< locals, with the reason and its place
  std::optional<closures::Place> found_;  ///< where the matrix is first filled
};

}  // namespace

std::vector<PrintedEntry> read_code_matrix(const std::string& code, const std::string& file,
                                           const std::string& array, std::size_t rows,
                                           std::size_t columns, closures::ClosureSystem& system) {
  return CodeMatrix(code, file, array, rows, columns, system).run();
}

}  // namespace assur::generator::audit
