#include "audit/code/cpp_matrix.hpp"

#include <algorithm>

#include "audit/code/cpp_file.hpp"
#include "audit/code/cpp_scope.hpp"

namespace assur::generator::audit::code {

namespace {

using Kind = Type::Kind;
using Origin = Variable::Origin;

/// Whether all tokens are zeros, commas or braces.
bool is_nothing(Tokens tokens) {
  return std::all_of(tokens.begin(), tokens.end(), [](const Token& token) {
    return token.is("{") || token.is("}") || token.is(",") || token.is("0") || token.is("0.0") ||
           token.is("0.");
  });
}

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
      return entries_of(given_, given_at_);
    }
    if (of_function && copied_ && !returned_) {
      throw CodeError(array_ +
                          " is filled here and never leaves the function; return it, or take "
                          "it by reference",
                      copied_at_);
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

  /// What stands beside the function, or in a file of statements.
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

  /// `void fill(Matrix& J)`: a type, a name that is not the matrix's, and declared parameters.
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
      give_outputs(*item.name);
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
                      parameter.empty() ? given_at_ : parameter[0].place);
    }
    if (rest.empty() || rest[0].is("=")) {
      return;  // it has no name
    }
    const Declarator declared = types_.take_name(*type, rest);
    if (!declared.rest.empty() && !declared.rest[0].is("=")) {
      throw CodeError("this parameter cannot be read" + by_running, parameter[0].place);
    }
    if (!gives_values_ && declared.name->is(array_.c_str())) {
      declare_matrix(declared, Origin::own).zero = true;  // the caller has cleared it
      copied_ = !declared.type.is_shared() && !declared.type.plain;
      return;
    }
    const bool output = gives_values_ && !type->constant && declared.type.kind == Kind::number &&
                        declared.type.reference;
    Variable& variable =
        variables_.declare(*declared.name, output ? Origin::own : Origin::given, declared.type);
    if (output) {
      variable.type->reference = false;  // it is what the function gives
      outputs_.push_back(declared.name->spelling);
    } else if (gives_values_ && !type->constant && type->pointer && type->kind == Kind::list &&
               type->sort == Sort::real && !declared.type.plain) {
      Token pointed = *declared.name;  // what it points to may be given as `*name`
      pointed.spelling = "*" + pointed.spelling;
      variables_.declare(pointed, Origin::own, std::nullopt);
      outputs_.push_back(pointed.spelling);
    }
  }

  /// Throws CodeError unless it is a matrix of real numbers of the audited size.
  Variable& declare_matrix(const Declarator& declared, Origin origin) {
    const Type& type = declared.type;
    if (type.kind != Kind::other && (type.sort == Sort::whole || type.sort == Sort::rounded)) {
      throw CodeError(
          array_ + (type.sort == Sort::whole
                        ? " holds whole numbers"
                        : " holds numbers that do not keep every value as it is" + by_running),
          declared.name->place);
    }
    if (type.kind != Kind::grid && !(type.kind == Kind::other && type.undeclared)) {
      throw CodeError("the type of " + array_ + " is not known" + by_running, declared.name->place);
    }
    expect_shape(type.rows, type.columns, *declared.name);
    copied_at_ = declared.name->place;
    std::optional<Type> known = type;
    known->rows.reset();
    known->columns.reset();
    known->constant = false;
    eigen_ = type.kind == Kind::other || type.round;
    brackets_ = type.kind == Kind::other || type.square;
    return variables_.declare(*declared.name, origin,
                              type.kind == Kind::other ? std::nullopt : known);
  }

  void expect_shape(std::optional<std::size_t> rows, std::optional<std::size_t> columns,
                    const Token& at) const {
    if (rows.value_or(audited_.rows) != audited_.rows ||
        columns.value_or(audited_.columns) != audited_.columns) {
      throw CodeError(array_ + " has another size here, and is audited as " + audited_.size_text(),
                      at.place);
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
      return;  // the compiler decides it
    } else if (statement[0].is("assert") && statement.size() > 1 &&
               is_enclosed(statement.subspan(1), "(")) {
      read_condition(statement.subspan(2, statement.size() - 3));
    } else if (are(first_of(statement, 3), {"(", "void", ")"})) {
      if (statement.size() != 4 || !statement[3].is_name()) {
        refuse_statement(statement);
      }
    } else if (gives_values_ && statement.size() > 3 && statement[0].is("*") &&
               statement[2].is("=")) {
      give_pointed(statement);
    } else if (is_declaration(statement)) {
      Tokens rest = statement;
      const std::optional<Type> type = types_.take(rest);
      read_declaration(statement, *type, rest);
    } else if (!gives_values_ && names_variable(statement, 0, array_)) {
      read_filling(statement);
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
      throw CodeError("what a pointer or a reference changes cannot be followed" + by_running,
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
        read_own_matrix(each);
      } else {
        declare(each);
      }
    }
  }

  /// `J = Eigen::Matrix<double, 2, 2>::Zero()` has commas that separate no variables.
  [[nodiscard]] std::vector<Tokens> zero_or_parts(Tokens declared) {
    const bool zero = declared.size() > 2 && declared[1].is("=") && is_zero(declared.subspan(2));
    return zero ? std::vector<Tokens>{declared} : comma_parts(declared);
  }

  /// `J`, `J(2, 2)`, `J = Matrix::Zero()`, `J[2][2] = {}`.
  void read_own_matrix(const Declarator& declared) {
    Variable& matrix = declare_matrix(declared, Origin::own);
    copied_ = true;
    Tokens rest = declared.rest;
    const bool class_of_known_size = !declared.type.round && declared.type.rows;
    const bool assigned = !rest.empty() && rest[0].is("=");
    if (are(rest, {"(", "#", ",", "#", ")"})) {
      if (!eigen_) {
        refuse(*declared.name);
      }
      expect_shape(whole_number(rest[1]), whole_number(rest[3]), *declared.name);
    } else if (assigned && is_zero(rest.subspan(1))) {
      matrix.zero = true;
    } else if (!rest.empty()) {
      // Braces with zeros or nothing set an array to zero, but not the entries of Eigen's classes.
      const Tokens braces = rest.subspan(assigned ? 1 : 0);
      const bool nothing = is_enclosed(braces, "{") && is_nothing(braces);
      matrix.zero = nothing && class_of_known_size;
      if (!nothing || (!class_of_known_size && braces.size() != 2)) {
        refuse(*declared.name);
      }
    }
    filled_ = matrix.zero ? std::optional(declared.name->place) : filled_;
  }

  /// `Eigen::Matrix2d::Zero()` and the like.
  [[nodiscard]] bool is_zero(Tokens value) {
    const auto word = std::find_if(value.begin(), value.end(),
                                   [](const Token& token) { return token.is("Zero"); });
    const auto at = static_cast<std::size_t>(word - value.begin());
    if (at < 2 || at + 1 >= value.size() || !value[at - 1].is("::")) {
      return false;
    }
    Tokens type = value.first(at - 1);
    const std::optional<Type> of = types_.take(type);
    const Tokens size = value.subspan(at + 1);
    const bool sized = are(size, {"(", "#", ",", "#", ")"});
    if (!of || !type.empty() || (!sized && !are(size, {"(", ")"}))) {
      return false;
    }
    if (of->kind != Kind::grid || !of->round || of->sort != Sort::real) {
      return false;
    }
    if (!sized && !(of->rows && of->columns)) {
      return false;
    }
    expect_shape(of->rows, of->columns, *word);
    if (sized) {
      expect_shape(whole_number(size[1]), whole_number(size[3]), *word);
    }
    return true;
  }

  void read_filling(Tokens statement) {
    const Token& first = statement[0];
    const std::size_t entry = entry_length(statement);
    const Tokens rest = statement.subspan(entry > 0 ? entry : 1);
    if (entry > 0 && !rest.empty() && rest[0].is("=")) {
      const Tokens value = rest.subspan(1);
      if (comma_parts(value).size() > 1) {
        refuse(first);
      }
      if (value.empty()) {
        throw CodeError("a value is missing", first.place);
      }
      if (entry == 6 ? !eigen_ : !brackets_) {
        refuse(first);
      }
      check_reading(value);
      static_cast<void>(variables_.found(first));
      const Spelled target = variables_.spelled(statement);
      set_entry(target.indices[0], target.indices[1], target, cell_of(value));
    } else if (entry == 0 && !rest.empty() && rest[0].is("<<") && eigen_) {
      set_all(comma_parts(rest.subspan(1)), first);
    } else if (entry == 0 && eigen_ && clears(rest)) {
      Variable& matrix = variables_.found(first);
      variables_.expect_free(matrix, "", array_, first.place);
      matrix.cells.clear();
      matrix.zero = true;
    } else {
      refuse(first);
    }
  }

  /// `J << a, b, c, d`, where no value reads the matrix, since some entries are set before.
  void set_all(const std::vector<Tokens>& values, const Token& first) {
    if (values.size() != audited_.rows * audited_.columns) {
      throw CodeError(array_ + " is audited as " + audited_.size_text() + ", and this lists " +
                          std::to_string(values.size()) + " entries",
                      first.place);
    }
    Variable& matrix = variables_.found(first);
    variables_.expect_free(matrix, "", array_, first.place);
    for (std::size_t at = 0; at < values.size(); ++at) {
      if (values[at].empty()) {
        throw CodeError("a value is missing", first.place);
      }
      if (const Token* mention = mention_of(values[at], array_)) {
        refuse(*mention);
      }
      const std::size_t row = at / audited_.columns;
      const std::size_t column = at % audited_.columns;
      Spelled entry{
          &matrix,     array_, "[" + std::to_string(row) + "][" + std::to_string(column) + "]",
          "",          {},     Sort::real,
          first.place, 0,      true};
      set_entry(row, column, entry, cell_of(values[at]));
    }
  }

  /// Whether what stands behind the matrix's name sets all its entries to zero.
  [[nodiscard]] bool clears(Tokens rest) {
    if (are(rest, {".", "setZero", "(", "#", ",", "#", ")"})) {
      expect_shape(whole_number(rest[3]), whole_number(rest[5]), rest[1]);
      return true;
    }
    return are(rest, {".", "setZero", "(", ")"}) || are(rest, {".", "fill", "(", "0", ")"}) ||
           are(rest, {".", "fill", "(", "0.0", ")"}) ||
           are(rest, {".", "setConstant", "(", "0", ")"}) ||
           (rest.size() > 1 && rest[0].is("=") && is_zero(rest.subspan(1)));
  }

  void read_return(Tokens statement) {
    const Tokens value = statement.subspan(1);
    if (gives_values_) {
      returned_ = !value.empty();
      if (returned_) {
        give(value);
      }
      return;
    }
    const Token* mention = mention_of(value, array_);
    const bool whole = value.size() == 1 && mention != nullptr;
    if (mention != nullptr && !whole) {
      throw CodeError("what is returned is not " + array_ + " itself" + by_running, mention->place);
    }
    const bool same = result_.undeclared || (result_.deduced && !result_.is_shared()) ||
                      (result_.kind == Kind::grid && result_.sort == Sort::real &&
                       !(result_.is_shared() && copied_));
    if (whole && variables_.in_function() && copied_ && !same) {
      throw CodeError("the type that is returned is not known" + by_running, mention->place);
    }
    returned_ = whole;
    if (!whole && !value.empty()) {
      static_cast<void>(kept(value));
    }
  }

  /// What the function returns: `{a, b}`, `Pair{a, b}`, `std::make_tuple(a, b)`, a variable, or one
  /// number.
  void give(Tokens value) {
    given_at_ = value[0].place;
    const auto open = std::find_if(value.begin(), value.end(), [](const Token& token) {
      return token.is("{") || token.is("(");
    });
    const Tokens list = value.subspan(static_cast<std::size_t>(open - value.begin()));
    Tokens type = value.first(value.size() - list.size());
    if (is_enclosed(list, "{")) {
      const std::optional<Type> named = type.empty() ? result_ : types_.take(type);
      if (!named || !type.empty()) {
        refuse_returned();
      }
      given_ = leaves_of(list);
      expect_values(*named, given_.size());
      if (!result_.deduced) {
        expect_values(result_, given_.size());
      }
      return;
    }
    const bool made =
        are(type, {"std", "::", "make_tuple"}) || are(type, {"std", "::", "make_pair"});
    if (made && is_enclosed(list, "(")) {
      for (const Tokens& part : comma_parts(inside_of(list))) {
        given_.push_back(kept(part));
      }
    } else if (value.size() == 1 && value[0].is_name() && is_several(value[0])) {
      collect(*variables_.find(value[0].spelling), value[0]);
    } else {
      given_ = {kept(value)};
      if (!result_.deduced && (result_.kind != Kind::number || result_.sort != Sort::real)) {
        refuse_returned();
      }
      return;
    }
    if (!result_.deduced) {
      expect_values(result_, given_.size());
    }
  }

  [[noreturn]] void refuse_returned() const {
    throw CodeError("the type that is returned is not known" + by_running, given_at_);
  }

  [[nodiscard]] bool is_several(const Token& name) {
    const Variable* const variable = variables_.find(name.spelling);
    return variable != nullptr && variable->type && variable->type->kind != Kind::number;
  }

  /// Throws CodeError unless values of that type are so many real numbers.
  void expect_values(const Type& type, std::size_t count) const {
    const bool list = (type.kind == Kind::list && type.rows == count) ||
                      (type.kind == Kind::grid && type.rows && type.columns &&
                       *type.rows * *type.columns == count) ||
                      (type.kind == Kind::number && count == 1);
    const bool members =
        type.kind == Kind::structure && type.members.size() == count &&
        std::all_of(type.members.begin(), type.members.end(), [](const auto& member) {
          return member.second.kind == Kind::number && member.second.sort == Sort::real &&
                 !member.second.is_shared();
        });
    if (type.is_shared() || !((list && type.sort == Sort::real) || members)) {
      refuse_returned();
    }
  }

  /// All numbers of a variable of the function, in the order of its type.
  void collect(const Variable& variable, const Token& name) {
    const Type& type = *variable.type;
    std::vector<std::string> parts;
    if (type.kind == Kind::structure) {
      for (const auto& member : type.members) {
        parts.push_back("." + member.first);
      }
    }
    for (std::size_t row = 0; type.kind != Kind::structure && row < type.rows.value_or(0); ++row) {
      const std::string index = "[" + std::to_string(row) + "]";
      for (std::size_t column = 0; type.kind == Kind::grid && column < type.columns.value_or(0);
           ++column) {
        parts.push_back(index + "[" + std::to_string(column) + "]");
      }
      if (type.kind == Kind::list) {
        parts.push_back(index);
      }
    }
    if (variable.origin != Origin::own || !variable.refused.empty() || parts.empty()) {
      throw CodeError(
          "'" + name.spelling + "' cannot be returned; return what it holds" + by_running,
          name.place);
    }
    expect_values(type, parts.size());
    for (const std::string& part : parts) {
      const auto cell = variable.cells.find(part);
      if (cell == variable.cells.end()) {
        throw CodeError("'" + name.spelling + part + "' is never assigned", name.place);
      }
      given_.push_back(cell->second);
    }
  }

  /// `*x = EXPR` of a parameter, which is not read from then on.
  void give_pointed(Tokens statement) {
    Variable* const pointed = variables_.find("*" + statement[1].spelling);
    if (pointed == nullptr) {
      refuse_statement(statement);
    }
    pointed->cells[""] = stored(kept(statement.subspan(3)), Sort::real);
    variables_.find(statement[1].spelling)->refused = "it is set through its pointer";
  }

  /// What the function has set through its parameters, in their order.
  void give_outputs(const Token& name) {
    given_at_ = name.place;
    for (const std::string& output : outputs_) {
      const Variable& variable = *variables_.find(output);
      const auto cell = variable.cells.find("");
      if (cell == variable.cells.end() && output[0] == '*') {
        continue;  // it may be read only
      }
      if (cell == variable.cells.end()) {
        throw CodeError("'" + output + "' is never assigned", variable.place);
      }
      given_.push_back(cell->second);
    }
  }

  std::vector<Cell> given_;  ///< what the function gives
  closures::Place given_at_{1, 1};
  std::vector<std::string> outputs_;
  Type result_;
  bool eigen_ = true;     ///< entries may be spelled J(0, 0)
  bool brackets_ = true;  ///< entries may be spelled J[0][0]
  bool copied_ = false;   ///< the matrix is the function's own
  closures::Place copied_at_{1, 1};
  bool returned_ = false;
};

}  // namespace

std::vector<CodeEntry> read_cpp_matrix(const std::string& code, const AuditedMatrix& matrix,
                                       closures::ClosureSystem& system) {
  const std::vector<Token> tokens = code_tokens(code);
  return CppReader(code, matrix, system).run(tokens);
}

}  // namespace assur::generator::audit::code
