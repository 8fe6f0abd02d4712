#include "audit/code_matrix.hpp"

#include <regex>

#include "audit/code_text.hpp"

namespace assur::generator {

namespace {

/// Regular expressions go as deep into the stack as a text is long.
constexpr std::size_t max_length = 10000;

/// Reads the statements in their order.
class CodeMatrix {
 public:
  CodeMatrix(const std::string& code, const std::string& file, const std::string& array,
             std::size_t rows, std::size_t columns, ClosureSystem& system)
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
        static const std::regex nothing(R"([0.\s]*)");
        if (!std::regex_match(text, nothing)) {
          refuse(statement.text.place);
        }
        initialised = text.empty() && statement.end == '{';
        continue;
      }
      if (statement.end == '{' && text.ends_with('=') && std::regex_match(text, begun_form_)) {
        initialised = true;
        continue;
      }
      read(statement);
    }
    if (!found_) {
      throw AuditSyntaxError(file_, {1, 1}, "nothing is assigned to " + array_);
    }
    for (PrintedEntry& entry : entries_) {
      entry.text.place = entry.text.empty() ? *found_ : entry.text.place;
    }
    return std::move(entries_);
  }

 private:
  [[noreturn]] void fail(Place place, const std::string& what) const {
    throw AuditSyntaxError(file_, place_in_code(code_, place), what);
  }
  [[noreturn]] void refuse(Place place) const {
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
    std::smatch match;
    const bool entry = std::regex_match(text, match, entry_form_);
    if (entry || std::regex_match(text, match, list_form_)) {
      if (statement.conditional) {
        fail(statement.text.place, array_ +
                                       " is filled inside a condition or a loop; only what "
                                       "always runs once can be read");
      }
      found_ = found_.value_or(statement.text.place);
      const std::size_t last = match.size() - 1;
      const PlacedText value{match[last],
                             statement.text.at(static_cast<std::size_t>(match.position(last)) + 1)};
      entry ? read_entry(match, statement.text.place, value) : read_list(value);
    } else if (std::regex_match(text, clear_form_)) {
      entries_.assign(entries_.size(), {});
    } else if (std::regex_match(text, other_form_)) {
      refuse(statement.text.place);
    } else {
      read_locals(statement);
    }
  }

  void read_entry(const std::smatch& match, Place place, const PlacedText& value) {
    const auto index = [&](std::size_t one, std::size_t other) {
      const std::string digits = match[match[one].matched ? one : other];
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
      locals_.meanings[name] = read_formula(entry.text, system_, locals_);
    } catch (const FormulaError&) {
      unreadable_[name] = {"see its assignment", place};
    }
  }

  void read_list(const PlacedText& values) {
    const std::vector<PlacedText> list = split(values, ',');
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
  PlacedText formula(const PlacedText& value) {
    std::string text;
    try {
      text = code_as_formula(value.text);
    } catch (const CodeError& error) {
      fail(value.at(error.column), error.what());
    }
    static const std::regex name(R"([A-Za-z_]\w*)");
    for (std::sregex_iterator at(text.begin(), text.end(), name), end; at != end; ++at) {
      if (const auto found = unreadable_.find(at->str()); found != unreadable_.end()) {
        fail(found->second.place, "'" + found->first + "' cannot be read: " + found->second.text);
      }
    }
    return {text, value.place};
  }

  /// `const double a = EXPR, b = EXPR`, `a = EXPR`; `a += EXPR` makes it unreadable.
  void read_locals(const CodeStatement& statement) {
    // Any type counts: a variable that were overlooked would pass for a symbol of its name.
    static const std::regex form(R"(^((?:[A-Za-z_][\w:]*(?:<[^=]*>)?[\s&*]+)*))"
                                 R"(([A-Za-z_](?:\w|\.|->|\[\d+\])*)\s*([-+*/]?)=(?!=)\s*(.*)$)");
    std::smatch match;
    for (const PlacedText& part : split(statement.text, ',')) {
      if (!std::regex_match(part.text, match, form)) {
        return;
      }
      const PlacedText value{match[4], part.at(static_cast<std::size_t>(match.position(4)) + 1)};
      const std::string name = trimmed({code_as_formula(match[2]), {}}).text;
      locals_.meanings.erase(name);
      unreadable_.erase(name);
      if (match[3].length() > 0 || statement.conditional) {
        unreadable_[name] = {match[3].length() > 0
                                 ? "write its whole value in place of '" + match.str(3) + "='"
                                 : "it is set inside a condition or a loop",
                             part.place};
        continue;
      }
      try {
        locals_.meanings[name] =
            read_formula({code_as_formula(value.text), value.place}, system_, locals_);
      } catch (const FormulaError& error) {
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
  ClosureSystem& system_;
  std::vector<PrintedEntry> entries_;
  std::regex entry_form_;
  std::regex list_form_;
  std::regex clear_form_;
  std::regex begun_form_;
  std::regex other_form_;
  LocalNames locals_;
  std::map<std::string, PlacedText> unreadable_;  ///< locals, with the reason and its place
  std::optional<Place> found_;                    ///< where the matrix is first filled
};

}  // namespace

std::vector<PrintedEntry> read_code_matrix(const std::string& code, const std::string& file,
                                           const std::string& array, std::size_t rows,
                                           std::size_t columns, ClosureSystem& system) {
  return CodeMatrix(code, file, array, rows, columns, system).run();
}

}  // namespace assur::generator
