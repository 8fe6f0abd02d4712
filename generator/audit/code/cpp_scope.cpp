#include "audit/code/cpp_scope.hpp"

#include <algorithm>

#include "audit/code/cpp_file.hpp"

namespace assur::generator::audit::code {

namespace {

using Kind = Type::Kind;
using Origin = Variable::Origin;

}  // namespace

void CppScope::refuse(const Token& at) const {
  throw CodeError("cannot read this use of " + array_ + "; write " + array_ +
                      "(i, j) = EXPRESSION" + by_running,
                  at.place);
}

void CppScope::refuse_statement(Tokens statement) const {
  if (const Token* mention = mention_of(statement, array_)) {
    refuse(*mention);
  }
  throw CodeError("this statement cannot be read; write NAME = EXPRESSION" + by_running,
                  statement[0].place);
}

void CppScope::refuse_mention(const Token& token, const std::string& where) const {
  throw CodeError(array_ + " is mentioned " + where + by_running, token.place);
}

void CppScope::read_function_name(const Token& name) {
  if (has_meaning(name.spelling)) {
    throw CodeError(
        "a function '" + name.spelling + "' of your own is not the one of formulas" + by_running,
        name.place);
  }
  variables_.add_function(name.spelling);
}

void CppScope::read_condition(Tokens condition) {
  std::size_t from = 0;
  const auto compares = [](const Token& token) {
    return token.is("<") || token.is(">") || token.is("<=") || token.is(">=") || token.is("==") ||
           token.is("!=") || token.is("&&") || token.is("||");
  };
  for (std::size_t at = 0; at <= condition.size(); ++at) {
    if (at < condition.size() && condition[at].is("(")) {
      at = behind_closing(condition, at) - 1;
    } else if (at == condition.size() || compares(condition[at])) {
      static_cast<void>(kept(condition.subspan(from, at - from)));
      from = at + 1;
    }
  }
}

bool CppScope::is_declaration(Tokens statement) {
  if (statement[0].is_name() && variables_.find(statement[0].spelling) != nullptr) {
    return false;
  }
  Tokens rest = statement;
  if (!statement[0].is_name() || !types_.take(rest) || rest.empty()) {
    return false;
  }
  return rest[0].is_name() ||
         (rest.size() > 2 && rest[0].is("(") && (rest[1].is("&") || rest[1].is("*")));
}

void CppScope::declare(const Declarator& declared) {
  const Token& name = *declared.name;
  const Type& type = declared.type;
  Tokens value = declared.rest;
  expect_new_meaning(name);
  if (const Token* mention = mention_of(value, array_);
      mention != nullptr && (type.reference || type.kind == Kind::other) && !type.deduced) {
    refuse(*mention);
  }
  if (type.kind == Kind::other && !type.deduced) {
    throw CodeError("'" + name.spelling + "' cannot be read: its type is not known; write double",
                    name.place);
  }
  Variable& variable = variables_.declare(name, Origin::own, type);
  const bool assigned = !value.empty() && value[0].is("=");
  value = value.subspan(assigned ? 1 : 0);
  if (value.empty()) {
    if (assigned || type.deduced) {
      throw CodeError("a value is missing", name.place);
    }
    return;
  }
  if (type.kind == Kind::list || type.kind == Kind::grid || type.kind == Kind::structure) {
    declare_list(variable, value, name);
    return;
  }
  if (value.size() == 1 && value[0].kind == Token::Kind::text && type.deduced) {
    variable.refused = "it is a text";
    return;
  }
  const bool enclosed = is_enclosed(value, "{") || (!assigned && is_enclosed(value, "("));
  if (enclosed) {
    const bool may_be_a_type = value.size() == 3 && value[0].is("(") && value[1].is_name() &&
                               variables_.find(value[1].spelling) == nullptr;
    if (may_be_a_type || (value.size() == 2 && (value[0].is("(") || type.deduced))) {
      throw CodeError("this may declare a function" + by_running, name.place);
    }
    if (value.size() == 2) {
      variable.zero = true;
      return;
    }
    if (type.deduced && assigned) {
      throw CodeError("'{' cannot be read inside an expression" + by_running, value[0].place);
    }
    value = inside_of(value);
  }
  check_reading(value);
  std::vector<Spelled> used;
  Cell cell = kept(value, &used);
  if (mention_of(value, name.spelling) != nullptr) {
    cell = {std::nullopt, Sort::real, "its first value reads the variable itself", name.place};
  }
  if (type.deduced) {
    Type& deduced = *variable.type;
    deduced.kind = Kind::number;
    deduced.sort = cell.sort;
  }
  if (type.reference) {
    for (const Spelled& number : used) {
      variables_.hold(number);
    }
  }
  variable.cells[""] = stored(std::move(cell), variable.type->sort);
}

void CppScope::declare_list(Variable& variable, Tokens value, const Token& name) {
  check_reading(value);
  const bool braces = is_enclosed(value, "{");
  if (!braces && !are(value, {"(", "#", ")"})) {
    throw CodeError("'" + name.spelling + "' is more than one number, and this value of it " +
                        "cannot be read" + by_running,
                    name.place);
  }
  if (are(value, {"{", "}"})) {
    const Type& type = *variable.type;
    variable.zero = type.kind != Kind::structure && !type.round && type.rows;
  } else if (braces) {
    static_cast<void>(leaves_of(value));
    variable.refused = "give each value of a list a name of its own";
  }
}

std::vector<Cell> CppScope::leaves_of(Tokens value) {
  if (!is_enclosed(value, "{")) {
    return {kept(value)};
  }
  std::vector<Cell> leaves;
  for (const Tokens& part : comma_parts(inside_of(value))) {
    if (part.empty() && value.size() == 2) {
      break;
    }
    const std::vector<Cell> more = leaves_of(part);
    leaves.insert(leaves.end(), more.begin(), more.end());
  }
  return leaves;
}

Cell CppScope::kept(Tokens value, std::vector<Spelled>* used) {
  if (value.empty()) {
    throw CodeError("a value is missing", (value.data() - 1)->place);
  }
  check_reading(value);
  try {
    return cell_of(value, used);
  } catch (const Unreadable& error) {
    return {std::nullopt, Sort::real, error.what(), error.place, {"", value[0].place}};
  }
}

Cell CppScope::stored(Cell cell, Sort sort) {
  if (cell.value && sort == Sort::whole && cell.sort != Sort::whole) {
    return {std::nullopt, Sort::whole, "its value is rounded to a whole number", cell.source.place};
  }
  cell.sort = sort;
  return cell;
}

void CppScope::assign(Tokens part, Tokens statement) {
  if (part.empty() || !part[0].is_name()) {
    refuse_statement(part.empty() ? statement : part);
  }
  const Token& first = part[0];
  Variable* const known = variables_.find(first.spelling);
  const auto mark = std::find_if(part.begin(), part.end(), [](const Token& token) {
    return token.is("=") || token.is("+=") || token.is("-=") || token.is("*=") || token.is("/=");
  });
  const Tokens before = part.first(static_cast<std::size_t>(mark - part.begin()));
  if (mark == part.end() || first.is("auto")) {
    refuse_statement(part);
  }
  if (const Token* mention = mention_of(before, array_); mention != nullptr && !gives_values_) {
    refuse(*mention);
  }
  if (!variables_.is_of_function(first.spelling) && variables_.in_function() &&
      !variables_.is_function(first.spelling)) {
    throw CodeError(
        "'" + first.spelling + "' is set, but it is not declared in this function" + by_running,
        first.place);
  }
  const bool unknown = known != nullptr && known->origin == Origin::given && known->type &&
                       known->type->kind == Kind::other;
  const Spelled target =
      unknown ? Spelled{known, "", "", "", {}, Sort::real, first.place, 0, false, true}
              : variables_.spelled(part);
  if (target.shared) {
    throw CodeError("an assignment through '" + first.spelling + "' may change " + array_ +
                        ", or another value" + by_running,
                    first.place);
  }
  if (&part[target.tokens] != &*mark) {
    refuse_statement(part);
  }
  const Tokens value = part.subspan(target.tokens + 1);
  if (value.empty()) {
    refuse_statement(part);
  }
  Cell cell = kept(value);
  if (!mark->is("=")) {
    cell = {std::nullopt, Sort::real, "write its whole value in place of '" + mark->spelling + "'",
            target.place};
  }
  variables_.set(target, stored(std::move(cell), target.sort));
}

void CppScope::check_reading(Tokens value) const {
  for (std::size_t at = 0; !gives_values_ && at < value.size(); ++at) {
    if (names_variable(value, at, array_) && entry_length(value.subspan(at)) == 0) {
      refuse(value[at]);
    }
  }
}

std::size_t CppScope::entry_length(Tokens tokens) const {
  const char* const name = array_.c_str();
  return are(first_of(tokens, 6), {name, "(", "#", ",", "#", ")"})        ? 6
         : are(first_of(tokens, 7), {name, "[", "#", "]", "[", "#", "]"}) ? 7
                                                                          : 0;
}

}  // namespace assur::generator::audit::code
