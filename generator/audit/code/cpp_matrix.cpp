#include "audit/code/cpp_matrix.hpp"

#include <algorithm>

#include "audit/code/declared_type.hpp"
#include "audit/code/function.hpp"

namespace assur::generator::audit::code {

namespace {

bool has(Tokens tokens, const char* spelled) {
  return std::any_of(tokens.begin(), tokens.end(),
                     [&](const Token& token) { return token.is(spelled); });
}

/// Zeros and brackets alone.
bool is_nothing(Tokens tokens) {
  return std::all_of(tokens.begin(), tokens.end(), [](const Token& token) {
    return token.is("{") || token.is("}") || token.is(",") || token.is("0") || token.is("0.0") ||
           token.is("0.");
  });
}

class CppMatrix {
 public:
  CppMatrix(const std::string& code, const AuditedMatrix& matrix, closures::ClosureSystem& system)
      : array_(matrix.array), filled_(matrix, code), locals_(system, {}) {}

  std::vector<CodeEntry> run(Tokens tokens) {
    const FillingFunction function = filling_function(tokens, array_);
    for (const Tokens& statement : function.globals) {
      read_global(statement);
    }
    read_parameters(function.parameters);
    for (const Tokens& statement : function.statements) {
      read(statement);
    }
    if (function.is_function && copied_ != nullptr && !returned_) {
      throw CodeError(array_ +
                          " is filled here and never leaves the function; return it, or take "
                          "it by reference",
                      copied_->place);
    }
    return filled_.entries();
  }

 private:
  [[noreturn]] void refuse(const Token& at) const {
    throw CodeError("cannot read this use of " + array_ + "; write " + array_ +
                        "(i, j) = EXPRESSION" + by_running,
                    at.place);
  }
  [[noreturn]] void refuse_statement(Tokens statement) const {
    if (const Token* mention = mention_of(statement, array_)) {
      refuse(*mention);
    }
    throw CodeError("this statement cannot be read; write NAME = EXPRESSION" + by_running,
                    statement[0].place);
  }

  void read_parameters(Tokens parameters) {
    for (const Tokens& parameter : comma_parts(parameters)) {
      const Token* mention = mention_of(parameter, array_);
      const bool whole = std::any_of(parameter.begin(), parameter.end(), is_whole_type);
      if (mention != nullptr) {
        const bool shared = has(parameter, "&") || has(parameter, "*") || has(parameter, "[") ||
                            has(parameter, "Ref") || has(parameter, "Map");
        copied_ = shared ? nullptr : mention;
        if (whole) {
          throw CodeError(array_ + " holds whole numbers", mention->place);
        }
        continue;
      }
      const auto value = std::find_if(parameter.begin(), parameter.end(), [](const Token& token) {
        return token.is("=") || token.is("[");
      });
      const Tokens declared = parameter.first(static_cast<std::size_t>(value - parameter.begin()));
      if (declared.size() > 1 && declared.back().is_name()) {
        const std::string& name = declared.back().spelling;
        locals_.take({name, name, declared.back().place});
        whole ? locals_.declare_whole(name) : locals_.declare_real(name);
      }
    }
  }

  void read_global(Tokens statement) {
    const bool constant = has(statement, "const") || has(statement, "constexpr");
    const std::size_t type = type_length(statement);
    if (statement[0].is("using") || statement[0].is("static_assert") || constant || type == 0) {
      read(statement);
      return;
    }
    for (const Tokens& part : comma_parts(statement.subspan(type))) {
      if (const LeadingName name = leading_name(part); name.tokens > 0) {
        locals_.forget(name.name, "a variable outside the function may be set by anyone");
      }
    }
  }

  void read(Tokens statement) {
    while (statement.size() > 1 && statement[0].is("[") && statement[1].is("[")) {
      statement = statement.subspan(behind_closing(statement, 0));  // [[maybe_unused]]
    }
    if (statement.empty()) {
      return;
    }
    if (statement[0].is("return")) {
      read_return(statement);
    } else if (statement[0].is("using")) {
      read_using(statement);
    } else if (are(statement.first(std::min<std::size_t>(2, statement.size())), {"(", "void"})) {
      read_unused(statement);
    } else if (statement[0].is("static_assert") || statement[0].is("assert")) {
      if (const Token* mention = mention_of(statement, array_)) {
        refuse(*mention);
      }
      static_cast<void>(locals_.formula(statement.subspan(1)));
    } else if (const std::size_t type = type_length(statement); type > 0) {
      read_declaration(statement, type);
    } else if (names_matrix(statement, 0, array_) ||
               (statement[0].is("this") && mention_of(statement, array_) == &statement[2])) {
      read_filling(statement[0].is("this") ? statement.subspan(2) : statement);
    } else {
      for (const Tokens& part : comma_parts(statement)) {
        read_assignment(part, statement);
      }
    }
  }

  void read_return(Tokens statement) {
    const Tokens value = statement.subspan(1);
    const Token* mention = mention_of(value, array_);
    returned_ = value.size() == 1 && mention != nullptr;
    if (mention != nullptr && !returned_) {
      throw CodeError("what is returned is not " + array_ + " itself" + by_running, mention->place);
    }
    if (!returned_ && !value.empty()) {
      static_cast<void>(locals_.formula(value));
    }
  }

  void read_using(Tokens statement) const {
    const bool of_standard =
        statement.size() > 2 && !has(statement, "=") &&
        (statement[1].is("std") || statement[1].is("namespace") || statement[1].is("Eigen"));
    const bool type = has(statement, "=") && statement.size() > 1 &&
                      !is_known_function(statement[1].spelling) && !statement[1].is(array_.c_str());
    if (!of_standard && !type) {
      throw CodeError("what this brings in cannot be followed" + by_running, statement[0].place);
    }
  }

  /// `(void)x`: a variable and nothing else.
  void read_unused(Tokens statement) const {
    const Tokens value = statement.size() > 3 ? statement.subspan(3) : Tokens{};
    if (value.size() != 1 || !value[0].is_name()) {
      refuse_statement(statement);
    }
  }

  void read_declaration(Tokens statement, std::size_t length) {
    const Tokens type = statement.first(length);
    const Tokens declared = statement.subspan(length);
    const bool constant = has(type, "const") || has(type, "constexpr");
    if (has(type, "static") && !has(type, "constexpr")) {
      throw CodeError("a static variable keeps its value from the first call" + by_running,
                      type[0].place);
    }
    if (has(type, "*") || has(type, "&&") || (has(type, "&") && !constant)) {
      throw CodeError("what a pointer or a reference changes cannot be followed" + by_running,
                      type[0].place);
    }
    const bool whole = std::any_of(type.begin(), type.end(), is_whole_type);
    if (names_matrix(declared, 0, array_)) {
      if (whole || has(type, "&")) {
        throw CodeError(whole ? array_ + " holds whole numbers"
                              : array_ + " is a reference to something else" + by_running,
                        type[0].place);
      }
      read_own_matrix(declared);
      return;
    }
    for (const Tokens& part : comma_parts(declared)) {
      read_declared(part, statement, has(type, "&"), whole);
    }
  }

  /// `J`, `J(2, 2)`, `J = Matrix::Zero()`, `J[2][2] = {}`.
  void read_own_matrix(Tokens declared) {
    copied_ = &declared[0];
    const CodeName name{array_, array_, declared[0].place};
    Tokens rest = declared.subspan(1);
    locals_.forget(name, "this entry has no value yet");
    while (!rest.empty() && rest[0].is("[")) {
      rest = rest.subspan(behind_closing(rest, 0));
    }
    const bool sized = are(rest, {"(", "#", ",", "#", ")"});
    const bool zeros = !rest.empty() && (rest[0].is("=") || rest[0].is("{")) &&
                       is_nothing(rest.subspan(rest[0].is("=") ? 1 : 0));
    if (rest.empty() || sized) {
      filled_.begin_undefined(declared[0].place);
      return;
    }
    if (zeros) {
      return;
    }
    if (!rest[0].is("=") || !is_zero(rest.subspan(1))) {
      refuse(declared[0]);
    }
  }

  /// `Eigen::Matrix2d::Zero()` and its like.
  [[nodiscard]] static bool is_zero(Tokens value) {
    for (std::size_t at = 2; at < value.size(); ++at) {
      if (value[at].is("Zero") && value[at - 1].is("::") && at + 1 < value.size() &&
          value[at + 1].is("(")) {
        return behind_closing(value, at + 1) == value.size() && !has(value.first(at), "(") &&
               value.size() - at <= 6;
      }
    }
    return false;
  }

  /// `name = EXPR`, `name{EXPR}`, `name(EXPR)` or `name` behind a type.
  void read_declared(Tokens part, Tokens statement, bool reference, bool whole) {
    if (part.empty() || !part[0].is_name()) {
      refuse_statement(statement);
    }
    const CodeName name{part[0].spelling, part[0].spelling, part[0].place};
    Tokens value = part.subspan(1);
    if (const Token* mention = mention_of(value, array_); mention != nullptr && reference) {
      refuse(*mention);
    }
    if (value.empty()) {
      locals_.forget(name, "it has no value yet");
      whole ? locals_.declare_whole(name.name) : locals_.declare_real(name.name);
      return;
    }
    if (value[0].is("[")) {
      locals_.forget(name, "give each value of a list a name of its own");
      return;
    }
    if (value[0].is("=")) {
      value = value.subspan(1);
    }
    if (!value.empty() && (value[0].is("{") || (value[0].is("(") && part[1].is("(")))) {
      if (behind_closing(value, 0) == value.size()) {
        value = value.subspan(1, value.size() - 2);
      }
    }
    if (value.empty() || comma_parts(value).size() > 1) {
      locals_.forget(name, "it is more than one number");
      return;
    }
    if (reference) {
      locals_.hold(value);
    }
    check_reading(value);
    locals_.declare_real(name.name);
    const bool takes_type = has(statement, "auto");
    if (whole || (takes_type && is_whole_value(value))) {
      locals_.declare_whole(name.name);
    }
    locals_.set(name, value);
  }

  [[nodiscard]] bool is_whole_value(Tokens value) const {
    try {
      return locals_.is_whole(locals_.formula(value));
    } catch (const CodeError&) {
      return false;  // said where it is used
    }
  }

  /// `name = EXPR` of something that stands; `name += EXPR` makes it unreadable.
  void read_assignment(Tokens part, Tokens statement) {
    const Tokens target =
        part.size() > 2 && are(part.first(2), {"this", "->"}) ? part.subspan(2) : part;
    const LeadingName name = leading_name(target);
    if (name.tokens == 0 || name.tokens >= target.size()) {
      refuse_statement(part.empty() ? statement : part);
    }
    const Token& mark = target[name.tokens];
    const Tokens value = target.subspan(name.tokens + 1);
    check_reading(value);
    if (mark.is("=") && !value.empty()) {
      locals_.set(name.name, value);
    } else if (mark.is("+=") || mark.is("-=") || mark.is("*=") || mark.is("/=")) {
      static_cast<void>(code_formula(value.empty() ? part : value));
      locals_.forget(name.name, "write its whole value in place of '" + mark.spelling + "'");
    } else {
      refuse_statement(part);
    }
  }

  /// A value mentions the matrix by whole entries alone.
  void check_reading(Tokens value) const {
    for (std::size_t at = 0; at < value.size(); ++at) {
      if (names_matrix(value, at, array_)) {
        const std::size_t tokens = leading_name(value.subspan(at)).tokens;
        if (tokens != 6 && tokens != 7) {
          refuse(value[at]);
        }
      }
    }
  }

  void read_filling(Tokens statement) {
    const Token& first = statement[0];
    const CodeName whole{array_, array_, first.place};
    const LeadingName entry = leading_name(statement);
    const bool brackets = entry.tokens == 7;
    const bool indexed = brackets || (entry.tokens == 6 && statement[1].is("("));
    const Tokens rest = statement.subspan(indexed ? entry.tokens : 1);
    if (indexed && !rest.empty() && rest[0].is("=")) {
      const Tokens value = rest.subspan(1);
      if (comma_parts(value).size() > 1) {
        refuse(first);
      }
      check_reading(value);
      filled_.assign(index(statement[2]), index(statement[brackets ? 5 : 4]), entry.name, value,
                     locals_);
    } else if (!indexed && !rest.empty() && rest[0].is("<<")) {
      const std::vector<Tokens> values = comma_parts(rest.subspan(1));
      for (const Tokens& value : values) {
        check_reading(value);
      }
      filled_.assign_all(values, first.place, locals_);
      locals_.forget(whole, "it is set as part of a list");
    } else if (!indexed && clears(rest)) {
      filled_.clear();
      locals_.forget(whole, "it is cleared");
    } else {
      refuse(first);
    }
  }

  [[nodiscard]] static std::size_t index(const Token& token) {
    return token.spelling.size() > 6 ? 999999 : std::stoul(token.spelling);
  }

  /// What stands behind the name sets all of it to zero.
  [[nodiscard]] static bool clears(Tokens rest) {
    return are(rest, {".", "setZero", "(", ")"}) ||
           are(rest, {".", "setZero", "(", "#", ",", "#", ")"}) ||
           are(rest, {".", "fill", "(", "0", ")"}) || are(rest, {".", "fill", "(", "0.0", ")"}) ||
           are(rest, {".", "setConstant", "(", "0", ")"}) ||
           (rest.size() > 1 && rest[0].is("=") && is_zero(rest.subspan(1)));
  }

  const std::string& array_;
  FilledMatrix filled_;
  LocalValues locals_;
  const Token* copied_ = nullptr;  ///< where the matrix is the function's own
  bool returned_ = false;
};

}  // namespace

std::vector<CodeEntry> read_cpp_matrix(const std::string& code, const AuditedMatrix& matrix,
                                       closures::ClosureSystem& system) {
  const std::vector<Token> tokens = code_tokens(code);
  return CppMatrix(code, matrix, system).run(tokens);
}

}  // namespace assur::generator::audit::code
