#include "audit/code/cpp_given_values.hpp"

#include <algorithm>

namespace assur::generator::audit::code {

void CppGivenValues::give_returned(Tokens value, const Type& result) {
  given_at_ = value[0].place;
  const auto open = std::find_if(value.begin(), value.end(),
                                 [](const Token& token) { return token.is("{") || token.is("("); });
  const Tokens list = value.subspan(static_cast<std::size_t>(open - value.begin()));
  Tokens type = value.first(value.size() - list.size());
  if (is_enclosed(list, "{")) {
    const std::optional<Type> named = type.empty() ? result : scope_.types().take(type);
    if (!named || !type.empty()) {
      refuse_returned();
    }
    given_ = scope_.leaves_of(list);
    expect_values(*named, given_.size());
    if (!result.deduced) {
      expect_values(result, given_.size());
    }
    return;
  }
  const bool made = are(type, {"std", "::", "make_tuple"}) || are(type, {"std", "::", "make_pair"});
  if (made && is_enclosed(list, "(")) {
    for (const Tokens& part : comma_parts(inside_of(list))) {
      given_.push_back(scope_.kept(part));
    }
  } else if (value.size() == 1 && value[0].is_name() && is_several(value[0])) {
    collect(*scope_.variables().find(value[0].spelling), value[0]);
  } else {
    given_ = {scope_.kept(value)};
    if (!result.deduced && (result.kind != Type::Kind::number || result.sort != Sort::real)) {
      refuse_returned();
    }
    return;
  }
  if (!result.deduced) {
    expect_values(result, given_.size());
  }
}

void CppGivenValues::refuse_returned() const {
  throw CodeError("the type that is returned is not known" + by_running, given_at_);
}

bool CppGivenValues::is_several(const Token& name) const {
  const Variable* const variable = scope_.variables().find(name.spelling);
  return variable != nullptr && variable->type && variable->type->kind != Type::Kind::number;
}

/// Throws CodeError unless the type holds `count` real numbers.
void CppGivenValues::expect_values(const Type& type, std::size_t count) const {
  const bool list = (type.kind == Type::Kind::list && type.rows == count) ||
                    (type.kind == Type::Kind::grid && type.rows && type.columns &&
                     *type.rows * *type.columns == count) ||
                    (type.kind == Type::Kind::number && count == 1);
  const bool members =
      type.kind == Type::Kind::structure && type.members.size() == count &&
      std::all_of(type.members.begin(), type.members.end(), [](const auto& member) {
        return member.second.kind == Type::Kind::number && member.second.sort == Sort::real &&
               !member.second.is_shared();
      });
  if (type.is_shared() || !((list && type.sort == Sort::real) || members)) {
    refuse_returned();
  }
}

/// All numbers of a variable of the function, in the order of its type.
void CppGivenValues::collect(const Variable& variable, const Token& name) {
  const Type& type = *variable.type;
  std::vector<std::string> parts;
  if (type.kind == Type::Kind::structure) {
    for (const auto& member : type.members) {
      parts.push_back("." + member.first);
    }
  }
  for (std::size_t row = 0; type.kind != Type::Kind::structure && row < type.rows.value_or(0);
       ++row) {
    const std::string index = "[" + std::to_string(row) + "]";
    for (std::size_t column = 0; type.kind == Type::Kind::grid && column < type.columns.value_or(0);
         ++column) {
      parts.push_back(index + "[" + std::to_string(column) + "]");
    }
    if (type.kind == Type::Kind::list) {
      parts.push_back(index);
    }
  }
  if (variable.origin != Variable::Origin::own || !variable.refused.empty() || parts.empty()) {
    throw CodeError("'" + name.spelling + "' cannot be returned; return what it holds" + by_running,
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

void CppGivenValues::set_pointed(Tokens statement) {
  Variable* const pointed = scope_.variables().find("*" + statement[1].spelling);
  if (pointed == nullptr) {
    scope_.refuse_statement(statement);
  }
  pointed->cells[""] = CppScope::stored(scope_.kept(statement.subspan(3)), Sort::real);
  scope_.variables().find(statement[1].spelling)->refused = "it is set through its pointer";
}

void CppGivenValues::give_outputs(const Token& function) {
  given_at_ = function.place;
  for (const std::string& output : outputs_) {
    const Variable& variable = *scope_.variables().find(output);
    const auto cell = variable.cells.find("");
    if (cell == variable.cells.end() && output[0] == '*') {
      continue;  // it is read-only
    }
    if (cell == variable.cells.end()) {
      throw CodeError("'" + output + "' is never assigned", variable.place);
    }
    given_.push_back(cell->second);
  }
}

}  // namespace assur::generator::audit::code
