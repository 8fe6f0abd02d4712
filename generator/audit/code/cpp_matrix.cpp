#include "audit/code/cpp_matrix.hpp"

#include <algorithm>

#include "audit/code/cpp_scope.hpp"
#include "audit/code/declared_shape.hpp"

namespace assur::generator::audit::code {

namespace {

/// Whether all tokens are zeros, commas or braces.
bool is_nothing(Tokens tokens) {
  return std::all_of(tokens.begin(), tokens.end(), [](const Token& token) {
    return token.is("{") || token.is("}") || token.is(",") || token.is("0") || token.is("0.0") ||
           token.is("0.");
  });
}

class CppMatrix {
 public:
  CppMatrix(const std::string& code, const AuditedMatrix& matrix, closures::ClosureSystem& system)
      : array_(matrix.array), filled_(matrix, code), scope_(matrix.array, system) {}

  std::vector<CodeEntry> run(Tokens tokens) {
    const FillingFunction function = filling_function(tokens, array_);
    scope_.read_file(function);
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
  void expect_shape(const DeclaredShape& shape, const Token& at) const {
    const AuditedMatrix& audited = filled_.matrix();
    if (shape.rows.value_or(audited.rows) != audited.rows ||
        shape.columns.value_or(audited.columns) != audited.columns) {
      throw CodeError(array_ + " has another size here, and is audited as " + audited.size_text(),
                      at.place);
    }
  }
  void expect_real(Tokens type, const Token& at) {
    const ValueSort sort = scope_.types().sort_of(type);
    if (sort == ValueSort::whole || sort == ValueSort::rounded) {
      throw CodeError(
          array_ + (sort == ValueSort::whole
                        ? " holds whole numbers"
                        : " holds numbers that do not keep every value as it is" + by_running),
          at.place);
    }
  }

  void read_parameters(Tokens parameters) {
    for (const Tokens& parameter : declared_parts(parameters)) {
      const bool shared = has(parameter, "&") || has(parameter, "*") || has(parameter, "[") ||
                          has(parameter, "Ref") || has(parameter, "Map");
      if (const Token* mention = mention_of(parameter, array_)) {
        const auto before = static_cast<std::size_t>(mention - parameter.data());
        Tokens behind = parameter.subspan(before + 1);
        behind = behind.subspan(!behind.empty() && behind[0].is(")") ? 1 : 0);
        copied_ = shared ? nullptr : mention;
        expect_real(parameter.first(before), *mention);
        expect_shape(shape_of_type(parameter.first(before)), *mention);
        expect_shape(leading_shape(behind), *mention);
        continue;
      }
      scope_.take_parameter(parameter, shared);
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
        CppScope::expect_no_function(name.name);
        scope_.locals().forget(name.name, "a variable outside the function may be set by anyone");
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
        scope_.refuse(*mention);
      }
      static_cast<void>(scope_.locals().formula(statement.subspan(1)));
    } else if (const std::size_t type = type_length(statement); type > 0) {
      read_declaration(statement, type);
    } else if (names_matrix(statement, 0, array_) ||
               (statement[0].is("this") && mention_of(statement, array_) == &statement[2])) {
      read_filling(statement[0].is("this") ? statement.subspan(2) : statement);
    } else {
      for (const Tokens& part : comma_parts(statement)) {
        scope_.assign(part, statement);
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
      static_cast<void>(scope_.locals().formula(value));
    }
  }

  void read_using(Tokens statement) {
    const bool of_standard =
        statement.size() > 2 && !has(statement, "=") &&
        (statement[1].is("std") || statement[1].is("namespace") || statement[1].is("Eigen"));
    const bool type = has(statement, "=") && statement.size() > 1 &&
                      !is_known_function(statement[1].spelling) && !statement[1].is(array_.c_str());
    if (!of_standard && !type) {
      throw CodeError("what this brings in cannot be followed" + by_running, statement[0].place);
    }
    if (type && statement.size() > 3) {
      scope_.types().define(statement[1].spelling, statement.subspan(3));
    }
  }

  /// `(void)x`: a variable and nothing else.
  void read_unused(Tokens statement) const {
    const Tokens value = statement.size() > 3 ? statement.subspan(3) : Tokens{};
    if (value.size() != 1 || !value[0].is_name()) {
      scope_.refuse_statement(statement);
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
    const bool zero = declared.size() > 2 && declared[1].is("=") && is_zero(declared.subspan(2));
    // A template's arguments have commas too.
    for (const Tokens& part : zero ? std::vector<Tokens>{declared} : comma_parts(declared)) {
      if (!part.empty() && names_matrix(part, 0, array_)) {
        if (has(type, "&")) {
          throw CodeError(array_ + " is a reference to something else" + by_running, type[0].place);
        }
        expect_real(type, type[0]);
        read_own_matrix(part, type);
      } else {
        scope_.declare(part, statement, type);
      }
    }
  }

  /// `J`, `J(2, 2)`, `J = Matrix::Zero()`, `J[2][2] = {}`.
  void read_own_matrix(Tokens declared, Tokens type) {
    copied_ = declared.data();
    expect_shape(shape_of_type(type), declared[0]);
    Tokens rest = declared.subspan(1);
    expect_shape(leading_shape(rest), declared[0]);
    scope_.locals().forget({array_, array_, declared[0].place}, "this entry has no value yet");
    // Braces with zeros or nothing set a plain array to zero, but not the entries of a class.
    const bool plain = (!rest.empty() && rest[0].is("[")) || has(type, "array");
    while (!rest.empty() && rest[0].is("[")) {
      rest = rest.subspan(behind_closing(rest, 0));
    }
    const bool sized = are(rest, {"(", "#", ",", "#", ")"});
    const bool assigned = !rest.empty() && rest[0].is("=");
    const bool braces = !rest.empty() && (assigned || rest[0].is("{")) &&
                        is_nothing(rest.subspan(assigned ? 1 : 0));
    if (rest.empty() || sized ||
        (braces && !plain && rest.size() == (assigned ? std::size_t{3} : std::size_t{2}))) {
      filled_.begin_undefined(declared[0].place);
    } else if (!(braces && plain) && !(assigned && is_zero(rest.subspan(1)))) {
      scope_.refuse(declared[0]);
    }
  }

  /// `Eigen::Matrix2d::Zero()` and the like.
  [[nodiscard]] bool is_zero(Tokens value) const {
    for (std::size_t at = 2; at < value.size(); ++at) {
      if (value[at].is("Zero") && value[at - 1].is("::") && at + 1 < value.size() &&
          value[at + 1].is("(")) {
        expect_shape(shape_of_type(value.first(at)), value[at]);
        expect_shape(leading_shape(value.subspan(at + 1)), value[at]);
        return behind_closing(value, at + 1) == value.size() && !has(value.first(at), "(") &&
               value.size() - at <= 6;
      }
    }
    return false;
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
        scope_.refuse(first);
      }
      scope_.check_reading(value);
      filled_.assign(whole_number(statement[2]), whole_number(statement[brackets ? 5 : 4]),
                     entry.name, value, scope_.locals());
    } else if (!indexed && !rest.empty() && rest[0].is("<<")) {
      const std::vector<Tokens> values = comma_parts(rest.subspan(1));
      for (const Tokens& value : values) {
        scope_.check_reading(value);
      }
      filled_.assign_all(values, first.place, scope_.locals());
      scope_.locals().forget(whole, "it is set as part of a list");
    } else if (!indexed && clears(rest)) {
      filled_.clear();
      scope_.locals().forget(whole, "it is cleared");
    } else {
      scope_.refuse(first);
    }
  }

  /// Whether what stands behind the matrix's name sets all its entries to zero.
  [[nodiscard]] bool clears(Tokens rest) const {
    if (rest.size() > 2 && rest[1].is("setZero")) {
      expect_shape(leading_shape(rest.subspan(2)), rest[1]);
    }
    return are(rest, {".", "setZero", "(", ")"}) ||
           are(rest, {".", "setZero", "(", "#", ",", "#", ")"}) ||
           are(rest, {".", "fill", "(", "0", ")"}) || are(rest, {".", "fill", "(", "0.0", ")"}) ||
           are(rest, {".", "setConstant", "(", "0", ")"}) ||
           (rest.size() > 1 && rest[0].is("=") && is_zero(rest.subspan(1)));
  }

  const std::string& array_;
  FilledMatrix filled_;
  CppScope scope_;
  const Token* copied_ = nullptr;  ///< where the matrix is declared, if it is the function's own
  bool returned_ = false;
};

}  // namespace

std::vector<CodeEntry> read_cpp_matrix(const std::string& code, const AuditedMatrix& matrix,
                                       closures::ClosureSystem& system) {
  const std::vector<Token> tokens = code_tokens(code);
  return CppMatrix(code, matrix, system).run(tokens);
}

}  // namespace assur::generator::audit::code
