// Reads C++ files, functions and statements into entries of a matrix.
#include <algorithm>

#include "audit/code/code_matrix.hpp"
#include "audit/code/cpp_file.hpp"
#include "audit/code/cpp_filled_matrix.hpp"
#include "audit/code/cpp_given_values.hpp"

namespace assur::generator::audit::code {

namespace {

using Kind = Type::Kind;
using Origin = Variable::Origin;

bool has(Tokens tokens, const char* spelled) {
  return std::any_of(tokens.begin(), tokens.end(),
                     [&](const Token& token) { return token.is(spelled); });
}

class CppReader : public CppScope {
 public:
  using CppScope::CppScope;

  std::vector<CodeEntry> run(Tokens tokens) {
    const std::vector<CppItem> items = cpp_items(tokens);
    const CppItem* const function = filling_function(items);
    std::vector<CodeEntry> entries;
    for (const CppItem& item : items) {
      if (&item == function) {
        read_function(item);
        entries = audited_entries(true);
        variables_.leave_function();
      } else {
        read_item(item, function == nullptr);
      }
    }
    return function == nullptr ? audited_entries(false) : entries;
  }

 private:
  [[nodiscard]] std::vector<CodeEntry> audited_entries(bool of_function) {
    if (gives_values_) {
      return entries_of(values_.cells(), values_.place());
    }
    if (of_function && filling_.is_own() && !returned_) {
      throw CodeError(array_ +
                          " is filled here and never leaves the function; return it, or take "
                          "it by reference",
                      filling_.declared_at());
    }
    const Variable* const matrix = variables_.find(array_);
    return entries_of(matrix == nullptr ? Variable{} : *matrix, 0);
  }

  /// The function of that name, or the one that mentions the matrix; nullptr for a file of
  /// statements.
  [[nodiscard]] const CppItem* filling_function(const std::vector<CppItem>& items) {
    const CppItem* found = nullptr;
    for (const CppItem& item : items) {
      if (item.kind == CppItem::Kind::function && item.name->spelling == array_) {
        if (gives_values_) {
          throw CodeError("a second function '" + array_ + "'" + by_running, item.name->place);
        }
        gives_values_ = true;
        found = &item;
      }
    }
    for (const CppItem& item : items) {
      const Token* const mention = mention_of(item.all, array_);
      if (gives_values_ || item.kind != CppItem::Kind::function || mention == nullptr) {
        continue;
      }
      if (found != nullptr) {
        refuse_mention(*mention, "in a second function");
      }
      found = &item;
    }
    return found;
  }

  /// A declaration outside the function, or a statement of a file of statements.
  void read_item(const CppItem& item, bool is_statement) {
    switch (item.kind) {
      case CppItem::Kind::structure:
        types_.read_structure(*item.name, item.inside);
        break;
      case CppItem::Kind::enumeration:
        for (const Token& token : item.inside) {
          if (token.is_name() && variables_.find(token.spelling) == nullptr) {
            variables_.declare(token, Origin::own, std::nullopt).refused =
                "it is a constant of an enumeration";
          }
        }
        break;
      case CppItem::Kind::function:
        read_function_name(*item.name);
        break;
      case CppItem::Kind::statement:
        if (item.templated) {
          throw CodeError("this template cannot be read" + by_running, item.all[0].place);
        }
        if (is_statement) {
          expect_plain_words(item.all);
          read(item.all);
        } else if (!is_prototype(item.all)) {
          read_global(item.all);
        }
    }
  }

  /// `void fill(Matrix& J)`: a type, a name other than the matrix's, and declared parameters.
  [[nodiscard]] bool is_prototype(Tokens statement) {
    Tokens rest = statement;
    if (statement[0].is("using") || statement[0].is("typedef") || !types_.take(rest) ||
        rest.size() < 3 || !rest[0].is_name() || !rest[1].is("(") ||
        (rest[0].is(array_.c_str()) && !gives_values_)) {
      return false;
    }
    const std::size_t end = behind_closing(rest, 1);
    const Tokens inside = rest.subspan(2, end - 3);
    const bool ends = end == rest.size() || are(rest.subspan(end), {"noexcept"}) ||
                      are(rest.subspan(end), {"const"});
    const auto parts = declared_parts(inside);
    const bool declares =
        ends && std::all_of(parts.begin(), parts.end(), [&](Tokens part) {
          const std::optional<Type> type = types_.take(part);
          return type && (part.empty() ? !variables_.find((part.data() - 1)->spelling)
                                       : part[0].is_name() || part[0].is("[") || part[0].is("="));
        });
    if (declares) {
      read_function_name(rest[0]);
    }
    return declares;
  }

  void read_global(Tokens statement) {
    if (const Token* mention = mention_of(statement, array_)) {
      refuse_mention(*mention, "outside the function that fills it");
    }
    expect_plain_words(statement);
    if (statement[0].is("using") || statement[0].is("typedef") || !is_declaration(statement)) {
      read(statement);
      return;
    }
    Tokens rest = statement;
    const std::optional<Type> type = types_.take(rest);
    const bool known = type->deduced || type->kind != Kind::other;
    if (type->constant && !type->is_shared() && known) {
      read_declaration(statement, *type, rest);
      return;
    }
    for (const Tokens& part : comma_parts(rest)) {
      const Declarator declared = types_.take_name(*type, part);
      variables_.declare(*declared.name, Origin::own, declared.type).refused =
          type->constant ? "its type is not known; write double"
                         : "a variable outside the function may be set by anyone";
    }
  }

  void read_function(const CppItem& item) {
    if (item.templated || has(item.parameters, "auto")) {
      throw CodeError("the types of a template are not known here" + by_running, item.name->place);
    }
    read_function_name(*item.name);
    Tokens before = item.type;
    while (before.size() > 1 && before.back().is("::") && before[before.size() - 2].is_name()) {
      before = before.first(before.size() - 2);
    }
    const std::optional<Type> type = types_.take(before);
    if (item.odd || !type || !before.empty()) {
      throw CodeError("the head of this function cannot be read" + by_running, item.name->place);
    }
    result_ = *type;
    variables_.enter_function();
    const bool none = item.parameters.empty() || are(item.parameters, {"void"});
    for (const Tokens& parameter : none ? std::vector<Tokens>{} : declared_parts(item.parameters)) {
      take_parameter(without_attributes(parameter));
    }
    for (const Tokens& statement : statements_of(item.inside)) {
      read(statement);
    }
    if (gives_values_ && !returned_) {
      values_.give_outputs(*item.name);
    }
  }

  void take_parameter(Tokens parameter) {
    for (const Token& token : parameter) {
      if (token.is_name() && is_known_function(token.spelling)) {
        expect_new_meaning(token);
      }
    }
    Tokens rest = parameter;
    const std::optional<Type> type = types_.take(rest);
    if (!type) {
      throw CodeError("this parameter cannot be read" + by_running,
                      parameter.empty() ? closures::Place{1, 1} : parameter[0].place);
    }
    if (rest.empty() || rest[0].is("=")) {
      return;  // it has no name
    }
    const Declarator declared = types_.take_name(*type, rest);
    if (!declared.rest.empty() && !declared.rest[0].is("=")) {
      throw CodeError("this parameter cannot be read" + by_running, parameter[0].place);
    }
    if (!gives_values_ && declared.name->is(array_.c_str())) {
      filling_.take_parameter(declared);
      return;
    }
    const bool output = gives_values_ && !type->constant && declared.type.kind == Kind::number &&
                        declared.type.reference;
    Variable& variable =
        variables_.declare(*declared.name, output ? Origin::own : Origin::given, declared.type);
    if (output) {
      variable.type->reference = false;  // it is a result of the function
      values_.add_output(declared.name->spelling);
    } else if (gives_values_ && !type->constant && type->pointer && type->kind == Kind::list &&
               type->sort == Sort::real && !declared.type.plain) {
      Token pointed = *declared.name;  // its target may be written as `*name`
      pointed.spelling = "*" + pointed.spelling;
      variables_.declare(pointed, Origin::own, std::nullopt);
      values_.add_output(pointed.spelling);
    }
  }

  void read(Tokens statement) {
    statement = without_attributes(statement);
    if (statement.empty()) {
      return;
    }
    if (statement[0].is("return")) {
      read_return(statement);
    } else if (statement[0].is("using")) {
      types_.read_using(statement);
    } else if (statement[0].is("typedef")) {
      types_.read_typedef(statement);
    } else if (statement[0].is("static_assert")) {
      return;  // decided by the compiler
    } else if (statement[0].is("assert") && statement.size() > 1 &&
               is_enclosed(statement.subspan(1), "(")) {
      read_condition(statement.subspan(2, statement.size() - 3));
    } else if (are(first_of(statement, 3), {"(", "void", ")"})) {
      if (statement.size() != 4 || !statement[3].is_name()) {
        refuse_statement(statement);
      }
    } else if (gives_values_ && statement.size() > 3 && statement[0].is("*") &&
               statement[2].is("=")) {
      values_.set_pointed(statement);
    } else if (is_declaration(statement)) {
      Tokens rest = statement;
      const std::optional<Type> type = types_.take(rest);
      read_declaration(statement, *type, rest);
    } else if (!gives_values_ && names_variable(statement, 0, array_)) {
      filling_.fill(statement);
    } else {
      for (const Tokens& part : comma_parts(statement)) {
        assign(part, statement);
      }
    }
  }

  void read_declaration(Tokens statement, const Type& type, Tokens declared) {
    if (type.outlives && !type.computed && variables_.in_function()) {
      throw CodeError("a static variable keeps its value from the first call" + by_running,
                      statement[0].place);
    }
    if (type.deduced && audited_.is_c) {
      throw CodeError("'auto' means a whole number to some compilers of C; write double",
                      statement[0].place);
    }
    const bool grouped = !declared.empty() && declared[0].is("(");
    if (type.pointer || (type.reference && !type.constant) || grouped ||
        has(first_of(statement, statement.size() - declared.size()), "&&")) {
      if (const Token* mention = mention_of(declared, array_); mention != nullptr && grouped) {
        refuse(*mention);
      }
      throw CodeError("changes through a pointer or a reference cannot be followed" + by_running,
                      statement[0].place);
    }
    for (const Tokens& part : zero_or_parts(declared)) {
      if (part.empty() || !part[0].is_name()) {
        refuse_statement(statement);
      }
      const Declarator each = types_.take_name(type, part);
      if (!gives_values_ && each.name->is(array_.c_str())) {
        if (type.reference) {
          throw CodeError(array_ + " is a reference to something else" + by_running,
                          statement[0].place);
        }
        filling_.declare(each);
      } else {
        declare(each);
      }
    }
  }

  /// The commas of `J = Eigen::Matrix<double, 2, 2>::Zero()` do not separate variables.
  [[nodiscard]] std::vector<Tokens> zero_or_parts(Tokens declared) {
    const bool zero =
        declared.size() > 2 && declared[1].is("=") && filling_.is_zero(declared.subspan(2));
    return zero ? std::vector<Tokens>{declared} : comma_parts(declared);
  }

  void read_return(Tokens statement) {
    const Tokens value = statement.subspan(1);
    if (gives_values_) {
      returned_ = !value.empty();
      if (returned_) {
        values_.give_returned(value, result_);
      }
      return;
    }
    const Token* mention = mention_of(value, array_);
    const bool whole = value.size() == 1 && mention != nullptr;
    if (mention != nullptr && !whole) {
      throw CodeError("the returned value is not " + array_ + " itself" + by_running,
                      mention->place);
    }
    const bool same = result_.undeclared || (result_.deduced && !result_.is_shared()) ||
                      (result_.kind == Kind::grid && result_.sort == Sort::real &&
                       !(result_.is_shared() && filling_.is_own()));
    if (whole && variables_.in_function() && filling_.is_own() && !same) {
      throw CodeError("the type that is returned is not known" + by_running, mention->place);
    }
    returned_ = whole;
    if (!whole && !value.empty()) {
      static_cast<void>(kept(value));
    }
  }

  CppFilledMatrix filling_{*this};
  CppGivenValues values_{*this};
  Type result_;
  bool returned_ = false;
};

}  // namespace

std::vector<CodeEntry> read_cpp_matrix(const std::string& code, const AuditedMatrix& matrix,
                                       closures::ClosureSystem& system) {
  const std::vector<Token> tokens = code_tokens(code);
  return CppReader(code, matrix, system).run(tokens);
}

}  // namespace assur::generator::audit::code
