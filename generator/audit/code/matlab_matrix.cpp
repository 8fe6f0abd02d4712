#include "audit/code/matlab_matrix.hpp"

#include <algorithm>
#include <assur/text/expression.hpp>

#include "audit/code/function.hpp"

namespace assur::generator::audit::code {

namespace {

constexpr Dialect matlab{true, true, false};

/// The code with comments and line continuations blanked and `.*` as ` *`, so that every letter
/// keeps its place and the tokens are those of C++.
struct PlainMatlab {
  std::string text;
  std::set<std::size_t> joined_lines;  ///< that continue on the next line
};

PlainMatlab plain(const std::string& code) {
  PlainMatlab result{code, {}};
  std::string& text = result.text;
  closures::Place place{1, 1};
  int blocks = 0;  // block comments may be nested
  for (std::size_t from = 0; from < text.size(); ++place.line) {
    const std::size_t end = std::min(text.find('\n', from), text.size());
    const std::string line = closures::trimmed({text.substr(from, end - from), {}}).text;
    const bool opens = line == "%{" || line == "#{";
    const bool closes = line == "%}" || line == "#}";
    std::size_t comment = blocks > 0 || opens ? from : text.find_first_of("%#", from);
    blocks += opens ? 1 : closes && blocks > 0 ? -1 : 0;
    const std::size_t joint = text.find("...", from);
    if (joint < std::min(comment, end)) {
      result.joined_lines.insert(place.line);
      comment = joint;
    }
    const std::size_t code_end = std::min(comment, end);
    if (const std::size_t quote = text.find_first_of("'\"\\", from); quote < code_end) {
      throw CodeError("a transpose, a text or a left division cannot be read" + by_running,
                      {place.line, quote - from + 1});
    }
    for (const char* other : {"//", "/*"}) {
      if (const std::size_t mark = text.find(other, from); mark < code_end) {
        throw CodeError("'" + std::string(other) + "' begins no comment in MATLAB",
                        {place.line, mark - from + 1});
      }
    }
    if (const std::size_t ends = code.find('\r', from); ends < end && ends + 1 < end) {
      throw CodeError(
          "a line that ends with a carriage return alone may be two; end lines with "
          "line feeds",
          {place.line, ends - from + 1});
    }
    std::fill(text.begin() + static_cast<std::ptrdiff_t>(code_end),
              text.begin() + static_cast<std::ptrdiff_t>(end), ' ');
    from = end + 1;
  }
  for (const char* operation : {".*", "./", ".^"}) {
    for (std::size_t at = text.find(operation); at != std::string::npos;
         at = text.find(operation, at)) {
      text[at] = ' ';
    }
  }
  return result;
}

bool ends_operand(const Token& token) {
  return token.is_name() || token.kind == Token::Kind::number || token.is(")") || token.is("]");
}

/// Whether white space between two tokens inside brackets separates two elements.
bool separates(const Token& one, const Token& next, const Token* behind) {
  const auto spaced = [](const Token& left, const Token& right) {
    return right.offset > left.offset + left.spelling.size();
  };
  if (!ends_operand(one) || !spaced(one, next)) {
    return false;
  }
  const bool sign = (next.is("+") || next.is("-")) && behind != nullptr && !spaced(next, *behind);
  return sign || next.is_name() || next.kind == Token::Kind::number || next.is("(");
}

/// The elements of `[a, b; c d]` without its brackets, row by row.
std::vector<std::vector<Tokens>> rows_of(Tokens inside, const std::set<std::size_t>& joined) {
  std::vector<std::vector<Tokens>> rows(1);
  std::size_t from = 0;
  const auto finish = [&](std::size_t to, std::size_t next) {
    if (to > from) {
      rows.back().push_back(inside.subspan(from, to - from));
    }
    from = next;
  };
  for (std::size_t at = 0; at < inside.size(); ++at) {
    const bool new_line = at > 0 && inside[at].place.line != inside[at - 1].place.line &&
                          !joined.contains(inside[at - 1].place.line);
    if (at > from && (new_line || separates(inside[at - 1], inside[at],
                                            at + 1 < inside.size() ? &inside[at + 1] : nullptr))) {
      finish(at, at);
    }
    if ((new_line || inside[at].is(";")) && !rows.back().empty()) {
      finish(at, at);
      rows.emplace_back();
    }
    if (inside[at].is(",") || inside[at].is(";")) {
      if (inside[at].is(",")) {
        finish(at, at + 1);
      }
      from = at + 1;
    } else if (inside[at].is("(") || inside[at].is("[")) {
      at = behind_closing(inside, at) - 1;
    }
  }
  finish(inside.size(), inside.size());
  if (rows.back().empty()) {
    rows.pop_back();
  }
  return rows;
}

class MatlabMatrix {
 public:
  MatlabMatrix(const std::string& code, const AuditedMatrix& matrix,
               closures::ClosureSystem& system, const std::set<std::size_t>& joined_lines)
      : array_(matrix.array),
        filled_(matrix, code),
        locals_(system, matlab),
        joined_(joined_lines) {}

  std::vector<CodeEntry> run(Tokens tokens) {
    std::size_t from = 0;
    for (std::size_t at = 0; at < tokens.size(); ++at) {
      const bool new_line = at > from && tokens[at].place.line != tokens[at - 1].place.line &&
                            !joined_.contains(tokens[at - 1].place.line);
      if (new_line) {
        read(tokens.subspan(from, at - from));
        from = at;
      }
      if (tokens[at].is("function") && at == from) {
        at = from = header_end(tokens, at);
        --at;
      } else if (tokens[at].is(";") || tokens[at].is(",")) {
        read(tokens.subspan(from, at - from));
        from = at + 1;
      } else if (tokens[at].is("(") || tokens[at].is("[") || tokens[at].is("{")) {
        at = behind_closing(tokens, at) - 1;
      }
    }
    read(tokens.subspan(from));
    std::vector<CodeEntry> entries = filled_.entries();
    // A script may fill a matrix that existed before, whose size is not known.
    const AuditedMatrix& audited = filled_.matrix();
    if ((is_function_ || cleared_) && (rows_ != audited.rows || columns_ != audited.columns)) {
      throw CodeError(array_ + " is " + std::to_string(rows_) + " by " + std::to_string(columns_) +
                          " in the end, and is audited as " + audited.size_text(),
                      sized_);
    }
    return entries;
  }

 private:
  [[noreturn]] static void refuse(const std::string& what, const Token& at) {
    throw CodeError(what + by_running, at.place);
  }

  /// `function J = name(r, l)`: the function returns the matrix, and nothing stands before it.
  std::size_t header_end(Tokens tokens, std::size_t from) {
    std::size_t end = from + 1;
    while (end < tokens.size() && (tokens[end].place.line == tokens[end - 1].place.line ||
                                   joined_.contains(tokens[end - 1].place.line))) {
      ++end;
    }
    const Tokens head = tokens.subspan(from, end - from);
    const bool gives = std::any_of(head.begin(), head.end(), [&](const Token& token) {
      return token.is("=") && mention_of(head.first(static_cast<std::size_t>(&token - head.data())),
                                         array_) != nullptr;
    });
    if (begun_ || !gives) {
      refuse(begun_ ? "a second function or statements before one cannot be followed"
                    : "the function does not return " + array_,
             tokens[from]);
    }
    for (const Token& token : head.subspan(1)) {
      if (is_known_function(token.spelling) || token.is("pi")) {
        refuse("'" + token.spelling + "' is given another meaning", token);
      }
    }
    begun_ = true;
    is_function_ = true;
    return end;
  }

  void read(Tokens statement) {
    if (statement.empty()) {
      return;
    }
    if (ended_ && !(statement.size() == 1 && statement[0].is("end"))) {
      refuse("nothing after this end or return runs", statement[0]);
    }
    begun_ = true;
    if (statement.size() == 1 &&
        (statement[0].is("end") || statement[0].is("return") || statement[0].is("endfunction"))) {
      ended_ = true;
      return;
    }
    const LeadingName target = leading_name(statement);
    const bool sets = target.tokens > 0 && target.tokens + 1 < statement.size() &&
                      statement[target.tokens].is("=");
    if (!sets) {
      refuse(
          "'" + statement[0].spelling + "': this statement cannot be read; write NAME = EXPRESSION",
          statement[0]);
    }
    const Tokens value = statement.subspan(target.tokens + 1);
    expect_plain(value);
    if (statement[0].is(array_.c_str())) {
      read_filling(target, statement, value);
    } else if (text::is_reserved_name(target.name.name)) {
      refuse("'" + target.name.name + "' is given another meaning", statement[0]);
    } else if (value[0].is("[")) {
      locals_.forget(target.name, "give each value of a list a name of its own");
    } else {
      locals_.set(target.name, value);
    }
  }

  /// Refuses a mention of the matrix that is not one of its entries, and a^b^c.
  void expect_plain(Tokens value) const {
    for (std::size_t at = 0; at < value.size(); ++at) {
      if (value[at].is(array_.c_str()) && leading_name(value.subspan(at)).tokens != 6) {
        refuse("cannot read this use of " + array_, value[at]);
      }
      if (value[at].is("^") && at + 1 < value.size()) {
        std::size_t behind = at + 1;
        behind += value[behind].is("-") || value[behind].is("+") ? 1 : 0;
        const Tokens rest = value.subspan(std::min(behind, value.size()));
        const std::size_t named = leading_name(rest).tokens;
        behind += rest.empty()      ? 0
                  : rest[0].is("(") ? behind_closing(rest, 0)
                                    : std::max<std::size_t>(named, 1);
        if (behind < value.size() && value[behind].is("^")) {
          throw CodeError("MATLAB raises the left power first; write its parentheses",
                          value[behind].place);
        }
      }
    }
  }

  void read_filling(const LeadingName& target, Tokens statement, Tokens value) {
    const CodeName whole{array_, array_, statement[0].place};
    sized_ = statement[0].place;
    if (target.tokens == 6) {
      rows_ = std::max(rows_, index(statement[2]) + 1);
      columns_ = std::max(columns_, index(statement[4]) + 1);
      filled_.assign(index(statement[2]), index(statement[4]), target.name, value, locals_);
    } else if (target.tokens == 1 && value[0].is("[") && behind_closing(value, 0) == value.size()) {
      std::vector<Tokens> all;
      const std::vector<std::vector<Tokens>> rows =
          rows_of(value.subspan(1, value.size() - 2), joined_);
      for (const std::vector<Tokens>& row : rows) {
        if (row.size() != filled_.matrix().columns || rows.size() != filled_.matrix().rows) {
          throw CodeError(array_ + " is audited as " + filled_.matrix().size_text() +
                              ", and this has " + std::to_string(rows.size()) + " rows, one of " +
                              std::to_string(row.size()),
                          value[0].place);
        }
        all.insert(all.end(), row.begin(), row.end());
      }
      set_size(rows.size(), filled_.matrix().columns);
      filled_.assign_all(all, value[0].place, locals_);
      locals_.forget(whole, "it is set as part of a list");
    } else if (target.tokens == 1 && (are(value, {"zeros", "(", "#", ")"}) ||
                                      are(value, {"zeros", "(", "#", ",", "#", ")"}))) {
      set_size(whole_number(value[2]), whole_number(value[value.size() - 2]));
      filled_.clear();
      locals_.forget(whole, "it is cleared");
    } else {
      refuse("cannot read this use of " + array_ + "; write " + array_ + "(i, j) = EXPRESSION",
             statement[0]);
    }
  }

  void set_size(std::size_t rows, std::size_t columns) {
    rows_ = rows;
    columns_ = columns;
    cleared_ = true;
  }

  /// Indices begin with 1; `FilledMatrix` refuses those outside the matrix.
  [[nodiscard]] static std::size_t index(const Token& token) { return whole_number(token) - 1; }

  const std::string& array_;
  FilledMatrix filled_;
  LocalValues locals_;
  const std::set<std::size_t>& joined_;
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
  const PlainMatlab text = plain(code);
  const std::vector<Token> tokens = code_tokens(text.text);
  return MatlabMatrix(code, matrix, system, text.joined_lines).run(tokens);
}

}  // namespace assur::generator::audit::code
