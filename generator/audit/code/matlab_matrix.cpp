// Reads straight-line MATLAB or Octave into entries of a matrix.
#include <algorithm>

#include "audit/code/code_matrix.hpp"

namespace assur::generator::audit::code {

namespace {

class MatlabReader : public CodeReader {
 public:
  MatlabReader(const std::string& code, const AuditedMatrix& audited,
               closures::ClosureSystem& system, const std::set<std::size_t>& joined_lines)
      : CodeReader(code, audited, system, Language::matlab),
        array_(audited.array),
        joined_(joined_lines) {}

  std::vector<CodeEntry> run(Tokens tokens) {
    for (std::size_t from = 0; from < tokens.size();) {
      const std::size_t end = statement_end(tokens, from);
      const Tokens statement = tokens.subspan(from, end - from);
      const bool marked = end < tokens.size() && (tokens[end].is(";") || tokens[end].is(","));
      if (!statement.empty() && statement[0].is("function")) {
        read_head(statement);
      } else if (!statement.empty()) {
        read(statement);
      }
      from = end + (marked ? 1 : 0);
    }
    if (gives_values_) {
      return given_values();
    }
    const Variable* const matrix = variables_.find(array_);
    std::vector<CodeEntry> entries = entries_of(matrix == nullptr ? Variable{} : *matrix, 1);
    // A script may fill a matrix that existed before, whose size is unknown.
    if ((is_function_ || cleared_) && (rows_ != audited_.rows || columns_ != audited_.columns)) {
      throw CodeError(array_ + " is " + std::to_string(rows_) + " by " + std::to_string(columns_) +
                          " in the end, and is audited as " + audited_.size_text(),
                      sized_);
    }
    return entries;
  }

 private:
  [[noreturn]] static void refuse(const std::string& what, const Token& at) {
    throw CodeError(what + by_running, at.place);
  }

  [[nodiscard]] bool begins_line(Tokens tokens, std::size_t at) const {
    return at > 0 && tokens[at].place.line != tokens[at - 1].place.line &&
           !joined_.contains(tokens[at - 1].place.line);
  }

  /// A statement ends before a semicolon or comma outside brackets, or at the end of its line.
  [[nodiscard]] std::size_t statement_end(Tokens tokens, std::size_t from) const {
    std::size_t at = from;
    while (at < tokens.size() && !tokens[at].is(";") && !tokens[at].is(",") &&
           !(at > from && begins_line(tokens, at))) {
      at = tokens[at].is("(") || tokens[at].is("[") || tokens[at].is("{")
               ? behind_closing(tokens, at)
               : at + 1;
    }
    return at;
  }

  /// `function J = name(r, l)` or `function [x, y] = name(r, l)`, at the beginning of the file.
  void read_head(Tokens head) {
    if (begun_) {
      refuse("a second function or statements before one cannot be followed", head[0]);
    }
    const auto equals =
        std::find_if(head.begin(), head.end(), [](const Token& token) { return token.is("="); });
    if (equals == head.end()) {
      refuse("the function does not return " + array_, head[0]);
    }
    const auto at = static_cast<std::size_t>(equals - head.begin());
    Tokens outputs = head.subspan(1, at - 1);
    Tokens rest = head.subspan(at + 1);
    if (outputs.size() > 1 && outputs[0].is("[") && outputs.back().is("]")) {
      outputs = outputs.subspan(1, outputs.size() - 2);
    }
    const bool list = rest.size() > 2 && rest[1].is("(") && behind_closing(rest, 1) == rest.size();
    if (rest.empty() || !rest[0].is_name() || (rest.size() > 1 && !list)) {
      refuse("the head of this function cannot be read; end its line behind it", head[0]);
    }
    for (const Token& name : outputs) {
      if (name.is_name()) {
        outputs_.push_back(&name);
      } else if (!name.is(",")) {
        refuse("the head of this function cannot be read", name);
      }
    }
    begun_ = is_function_ = true;
    const bool gives = std::any_of(outputs_.begin(), outputs_.end(),
                                   [&](const Token* name) { return name->is(array_.c_str()); });
    gives_values_ = !gives && rest[0].is(array_.c_str());
    if (!gives && !gives_values_) {
      refuse("the function does not return " + array_, head[0]);
    }
    variables_.enter_function();
    const Tokens inputs = list ? rest.subspan(2, rest.size() - 3) : Tokens{};
    for (const Tokens& input : inputs.empty() ? std::vector<Tokens>{} : comma_parts(inputs)) {
      if (input.size() != 1 || !input[0].is_name() || input[0].is("varargin")) {
        refuse("this parameter cannot be read", input.empty() ? head[0] : input[0]);
      }
      expect_free_name(input[0]);
      variables_.declare(input[0], Variable::Origin::given, std::nullopt);
    }
    for (const Token* output : outputs_) {
      expect_free_name(*output);
    }
  }

  static void expect_free_name(const Token& name) {
    if (name.is("pi")) {
      refuse("'pi' is given another meaning", name);
    }
    expect_new_meaning(name);
  }

  void read(Tokens statement) {
    if (ended_ && !(statement.size() == 1 && statement[0].is("end"))) {
      refuse("nothing after this end or return runs", statement[0]);
    }
    begun_ = true;
    if (statement.size() == 1 &&
        (statement[0].is("end") || statement[0].is("return") || statement[0].is("endfunction"))) {
      ended_ = true;
      return;
    }
    const auto equals = std::find_if(statement.begin(), statement.end(),
                                     [](const Token& token) { return token.is("="); });
    const auto at = static_cast<std::size_t>(equals - statement.begin());
    if (equals == statement.end() || at == 0 || at + 1 == statement.size() ||
        !statement[0].is_name() || statement[1].is_name()) {
      refuse(
          "'" + statement[0].spelling + "': this statement cannot be read; write NAME = EXPRESSION",
          statement[0]);
    }
    expect_free_name(statement[0]);
    const Tokens value = statement.subspan(at + 1);
    if (!gives_values_ && statement[0].is(array_.c_str())) {
      read_filling(statement.first(at), value);
      return;
    }
    expect_entries(value);
    const bool list = value[0].is("[");
    Cell cell = list ? Cell{std::nullopt, Sort::real, "give each value of a list a name of its own",
                            value[0].place}
                     : cell_of(value);
    if (variables_.find(statement[0].spelling) == nullptr && is_function_) {
      variables_.declare(statement[0], Variable::Origin::own, std::nullopt);
    }
    const Spelled target = variables_.spelled(statement);
    const auto known = lists_.find(target.name);
    const bool grows =
        known != lists_.end() && !target.indices.empty() && target.indices[0] > known->second.first;
    if (target.tokens != at || grows) {
      refuse("this assignment cannot be read", statement[0]);
    }
    if (list) {
      read_list(target, value);
    } else {
      variables_.set(target, std::move(cell));
    }
  }

  /// `q = [a, b]` or `[a; b]`: the values of a row or a column.
  void read_list(const Spelled& target, Tokens value) {
    const auto rows = rows_at(value);
    const bool row = rows.size() == 1;
    if (rows.empty() ||
        (!row && std::any_of(rows.begin(), rows.end(),
                             [](const auto& each) { return each.size() != 1; })) ||
        !target.part.empty()) {
      refuse("this list cannot be read; give each value a name of its own", value[0]);
    }
    std::vector<Cell> cells;
    for (const std::vector<Tokens>& each : rows) {
      for (const Tokens& one : each) {
        expect_entries(one);
        cells.push_back(cell_of(one));
      }
    }
    Variable& variable = *target.variable;
    variable.cells.clear();
    variable.parts = {"[1]"};
    variable.origin = Variable::Origin::own;
    for (std::size_t at = 0; at < cells.size(); ++at) {
      variable.cells["[" + std::to_string(at + 1) + "]"] = cells[at];
    }
    lists_[target.name] = {cells.size(), row};
  }

  [[nodiscard]] std::vector<std::vector<Tokens>> rows_at(Tokens value) const {
    if (behind_closing(value, 0) != value.size()) {
      refuse("this list cannot be read", value[0]);
    }
    return matlab_rows(value.subspan(1, value.size() - 2), joined_);
  }

  /// Throws CodeError for a mention of the matrix other than one of its entries.
  void expect_entries(Tokens value) const {
    for (std::size_t at = 0; !gives_values_ && at < value.size(); ++at) {
      const Tokens rest = value.subspan(at);
      if (value[at].is(array_.c_str()) && !are(rest.first(std::min<std::size_t>(rest.size(), 6)),
                                               {array_.c_str(), "(", "#", ",", "#", ")"})) {
        refuse("cannot read this use of " + array_, value[at]);
      }
    }
  }

  [[nodiscard]] Variable& matrix(const Token& name) {
    if (Variable* const known = variables_.find(array_)) {
      return *known;
    }
    Variable& matrix = variables_.declare(
        name, is_function_ ? Variable::Origin::own : Variable::Origin::free, std::nullopt);
    matrix.zero = is_function_;  // an assignment beyond its size fills it up with zeros
    return matrix;
  }

  void read_filling(Tokens target, Tokens value) {
    expect_entries(value);
    const char* const name = array_.c_str();
    if (are(target, {name, "(", "#", ",", "#", ")"})) {
      Cell cell = cell_of(value);
      static_cast<void>(matrix(target[0]));
      const std::size_t row = whole_number(target[2]);
      const std::size_t column = whole_number(target[4]);
      set_entry(row - 1, column - 1, variables_.spelled(target), std::move(cell));
      rows_ = std::max(rows_, row);
      columns_ = std::max(columns_, column);
      sized_ = target[0].place;
    } else if (are(target, {name}) && value[0].is("[")) {
      set_all(target[0], value);
    } else if (are(target, {name}) && (are(value, {"zeros", "(", "#", ")"}) ||
                                       are(value, {"zeros", "(", "#", ",", "#", ")"}))) {
      Variable& cleared = matrix(target[0]);
      cleared.cells.clear();
      cleared.zero = true;
      set_size(whole_number(value[2]), whole_number(value[value.size() - 2]), target[0]);
    } else {
      refuse("cannot read this use of " + array_ + "; write " + array_ + "(i, j) = EXPRESSION",
             target[0]);
    }
  }

  /// `J = [a, b; c, d]`, where a row may be the name of a list.
  void set_all(const Token& name, Tokens value) {
    const std::vector<std::vector<Tokens>> rows = rows_at(value);
    std::vector<std::vector<Cell>> cells;
    for (const std::vector<Tokens>& row : rows) {
      cells.emplace_back();
      for (const Tokens& one : row) {
        const auto list = one.size() == 1 ? lists_.find(one[0].spelling) : lists_.end();
        if (list == lists_.end()) {
          cells.back().push_back(cell_of(one));
          continue;
        }
        const auto [count, is_row] = list->second;
        if (!is_row) {
          refuse("a column in a matrix cannot be read", one[0]);
        }
        for (std::size_t at = 1; at <= count; ++at) {
          cells.back().push_back(
              variables_.find(one[0].spelling)->cells.at("[" + std::to_string(at) + "]"));
        }
      }
      if (cells.back().size() != audited_.columns || rows.size() != audited_.rows) {
        throw CodeError(array_ + " is audited as " + audited_.size_text() + ", and this has " +
                            std::to_string(rows.size()) + " rows, one of " +
                            std::to_string(cells.back().size()),
                        value[0].place);
      }
    }
    if (rows.size() != audited_.rows) {
      throw CodeError(array_ + " is audited as " + audited_.size_text() + ", and this has " +
                          std::to_string(rows.size()) + " rows",
                      value[0].place);
    }
    Variable& filled = matrix(name);
    for (std::size_t row = 0; row < cells.size(); ++row) {
      for (std::size_t column = 0; column < audited_.columns; ++column) {
        const Spelled entry{&filled,
                            array_,
                            "[" + std::to_string(row + 1) + "][" + std::to_string(column + 1) + "]",
                            "",
                            {},
                            Sort::real,
                            name.place,
                            0,
                            true};
        set_entry(row, column, entry, std::move(cells[row][column]));
      }
    }
    filled.zero = true;
    set_size(rows.size(), audited_.columns, name);
  }

  void set_size(std::size_t rows, std::size_t columns, const Token& at) {
    rows_ = rows;
    columns_ = columns;
    cleared_ = true;
    sized_ = at.place;
    filled_ = filled_.value_or(at.place);
  }

  /// The results of `function [x, y] = name(...)`: numbers, or the values of one list.
  [[nodiscard]] std::vector<CodeEntry> given_values() {
    std::vector<Cell> cells;
    for (const Token* output : outputs_) {
      const Variable* const variable = variables_.find(output->spelling);
      if (variable == nullptr || variable->cells.empty()) {
        throw CodeError("'" + output->spelling + "' is never assigned", output->place);
      }
      const bool number = variable->cells.contains("");
      if (!number && (outputs_.size() != 1 || !lists_.contains(output->spelling))) {
        refuse("'" + output->spelling + "' is not one number", *output);
      }
      const std::size_t count = number ? 1 : lists_[output->spelling].first;
      for (std::size_t at = 1; at <= count; ++at) {
        cells.push_back(variable->cells.at(number ? "" : "[" + std::to_string(at) + "]"));
      }
    }
    return entries_of(cells, outputs_.empty() ? closures::Place{1, 1} : outputs_[0]->place);
  }

  const std::string& array_;
  const std::set<std::size_t>& joined_;
  std::vector<const Token*> outputs_;
  std::map<std::string, std::pair<std::size_t, bool>> lists_;  ///< their sizes, and whether rows
  bool gives_values_ = false;                                  ///< the name is the function's
  std::size_t rows_ = 0;
  std::size_t columns_ = 0;
  closures::Place sized_{1, 1};  ///< where the size was last set
  bool cleared_ = false;
  bool is_function_ = false;
  bool begun_ = false;
  bool ended_ = false;
};

}  // namespace

std::vector<CodeEntry> read_matlab_matrix(const std::string& code, const AuditedMatrix& matrix,
                                          closures::ClosureSystem& system) {
  const PlainMatlab text = plain_matlab(code);
  const std::vector<Token> tokens = code_tokens(text.text);
  return MatlabReader(code, matrix, system, text.joined_lines).run(tokens);
}

}  // namespace assur::generator::audit::code
