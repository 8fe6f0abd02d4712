#include "audit/code/cpp_scope.hpp"

#include <algorithm>

namespace assur::generator::audit::code {

bool has(Tokens tokens, const char* spelled) {
  return std::any_of(tokens.begin(), tokens.end(),
                     [&](const Token& token) { return token.is(spelled); });
}

namespace {

CodeName name_of(const Token& token) { return {token.spelling, token.spelling, token.place}; }

bool is_read(ValueSort sort) { return sort == ValueSort::real || sort == ValueSort::unknown; }

/// Whether variables of this sort keep the real value that is assigned to them.
bool is_kept(ValueSort sort) { return sort == ValueSort::real || sort == ValueSort::whole; }

Tokens without_attributes(Tokens tokens) {
  while (tokens.size() > 1 && tokens[0].is("[") && tokens[1].is("[")) {
    tokens = tokens.subspan(behind_closing(tokens, 0));
  }
  return tokens;
}

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

void CppScope::read_file(const FillingFunction& file) {
  for (const Token& name : file.functions) {
    locals_.declare_function(name.spelling);
  }
  for (const Token& name : file.constants) {
    locals_.forget(name_of(name), "it is a constant of an enumeration");
  }
  in_function_ = file.is_function;
  for (const Tokens& member : file.members) {
    read_member(member);
  }
  for (const Tokens& list : file.templated) {
    for (const Tokens& each : declared_parts(list)) {
      read_template(each);
    }
  }
}

void CppScope::read_member(Tokens member) {
  if (member.size() > 3 && member[0].is("using")) {
    types_.define(member[1].spelling, member.subspan(3));
    return;
  }
  if (member.size() > 2 && member[0].is("typedef")) {
    types_.define(member.back().spelling, member.subspan(1, member.size() - 2));
    return;
  }
  const std::size_t length = type_length(member);
  const bool read = is_read(types_.sort_of(member.first(length)));
  for (const Tokens& part : comma_parts(member.subspan(read ? member.size() : length))) {
    if (!part.empty()) {
      locals_.declare_member(part[0].spelling, why_not_read(ValueSort::rounded));
    }
  }
}

void CppScope::expect_no_function(const CodeName& name) {
  if (is_known_function(name.name)) {
    throw CodeError("'" + name.name + "' is given another meaning" + by_running, name.place);
  }
}

const CppScope::Declared* CppScope::declared(const CodeName& name) const {
  const auto found = std::find_if(declared_.rbegin(), declared_.rend(),
                                  [&](const Declared& each) { return name.is_part_of(each.name); });
  return found == declared_.rend() ? nullptr : &*found;
}

void CppScope::read_template(Tokens parameter) {
  if (parameter.size() < 2) {
    return;
  }
  if (parameter[0].is("class") || parameter[0].is("typename")) {
    types_.add_real(parameter[1].spelling);
    locals_.declare_function(parameter[1].spelling);
  } else {
    const auto value = std::find_if(parameter.begin(), parameter.end(),
                                    [](const Token& token) { return token.is("="); });
    locals_.forget(name_of(*(value - 1)), "it is a parameter of the template");
  }
}

void CppScope::take_parameter(Tokens parameter, bool shared) {
  parameter = without_attributes(parameter);
  int depth = 0;  // of a template's arguments
  const auto value = std::find_if(parameter.begin(), parameter.end(), [&](const Token& token) {
    depth += token.is("<") ? 1 : token.is(">") ? -1 : token.is(">>") ? -2 : 0;
    return depth <= 0 && (token.is("=") || token.is("[") || token.is(")"));
  });
  const Tokens declared = parameter.first(static_cast<std::size_t>(value - parameter.begin()));
  if (declared.size() < 2 || !declared.back().is_name()) {
    return;
  }
  const CodeName name = name_of(declared.back());
  const ValueSort sort = types_.sort_of(declared.first(declared.size() - 1));
  expect_no_function(name);
  declared_.push_back({name, sort, shared || sort == ValueSort::unknown, false});
  locals_.declare_real(name.name);
  if (sort == ValueSort::rounded) {
    locals_.forget(name, why_not_read(sort));
    return;
  }
  if (sort == ValueSort::whole) {
    locals_.refuse(name, "its type holds whole numbers alone; write double");
    return;
  }
  const bool is_number = sort == ValueSort::real;
  locals_.take(name, is_number ? "" : why_not_read(sort));
}

void CppScope::declare(Tokens part, Tokens statement, Tokens type) {
  if (part.empty() || !part[0].is_name()) {
    refuse_statement(statement);
  }
  const ValueSort sort = types_.sort_of(type);
  const bool reference = has(type, "&");
  const CodeName name = name_of(part[0]);
  Tokens value = part.subspan(1);
  const bool view = has(type, "Map") || has(type, "Ref") || has(type, "span");
  const bool unknown = sort == ValueSort::unknown && !value.empty();
  expect_no_function(name);
  declared_.push_back({name, sort, unknown || view, has(type, "auto")});
  if (const Token* mention = mention_of(value, array_); mention != nullptr && reference) {
    refuse(*mention);
  }
  locals_.declare_real(name.name);
  if (sort == ValueSort::whole) {
    locals_.declare_whole(name);
  }
  const bool list = !value.empty() && value[0].is("[");
  while (!value.empty() && value[0].is("[")) {
    value = value.subspan(behind_closing(value, 0));
  }
  if (value.empty() && !list) {
    locals_.forget(name, "it has no value yet");
    return;
  }
  const bool assigned = !value.empty() && value[0].is("=");
  value = value.subspan(assigned ? 1 : 0);
  check_list(value);
  if (!value.empty() && (value[0].is("{") || (value[0].is("(") && !assigned)) &&
      behind_closing(value, 0) == value.size()) {
    value = value.subspan(1, value.size() - 2);
  }
  if (list || value.empty() || comma_parts(value).size() > 1) {
    locals_.forget(
        name, list ? "give each value of a list a name of its own" : "it is more than one number");
    return;
  }
  if (reference) {
    locals_.hold(value);
  }
  if (sort == ValueSort::rounded || sort == ValueSort::unknown) {
    locals_.refuse_calls(value);
    locals_.forget(name, why_not_read(sort));
    return;
  }
  if (mention_of(value, name.name) != nullptr) {
    locals_.forget(name, "its first value reads the variable itself");
    return;
  }
  if (has(type, "auto") && is_whole_value(value)) {
    locals_.declare_whole(name);
  }
  locals_.set(name, value);
}

bool CppScope::is_whole_value(Tokens value) const {
  try {
    return locals_.is_whole(locals_.formula(value));
  } catch (const CodeError&) {
    return false;  // reported where it is used
  }
}

void CppScope::assign(Tokens part, Tokens statement) {
  const Tokens target =
      part.size() > 2 && are(part.first(2), {"this", "->"}) ? part.subspan(2) : part;
  const LeadingName name = leading_name(target);
  if (name.tokens == 0 || name.tokens >= target.size()) {
    refuse_statement(part.empty() ? statement : part);
  }
  const Token& mark = target[name.tokens];
  if (!mark.is("=") && !mark.is("+=") && !mark.is("-=") && !mark.is("*=") && !mark.is("/=")) {
    refuse_statement(part);
  }
  const Declared* const known = declared(name.name);
  if (known == nullptr && in_function_) {
    throw CodeError(
        "'" + name.name.spelled + "' is set, but it is not declared in this function" + by_running,
        name.name.place);
  }
  const bool whole = known != nullptr && known->name.spelled == name.name.spelled;
  if (known != nullptr && (known->shared || (known->shared_parts && !whole))) {
    throw CodeError("what is set through '" + known->name.spelled + "' may be " + array_ +
                        ", or another value" + by_running,
                    name.name.place);
  }
  const Tokens value = target.subspan(name.tokens + 1);
  if (value.empty()) {
    refuse_statement(part);
  }
  check_reading(value);
  if (!mark.is("=")) {
    locals_.refuse_calls(value);
    locals_.forget(name.name, "write its whole value in place of '" + mark.spelling + "'");
  } else if (known != nullptr && !is_kept(known->sort)) {
    locals_.refuse_calls(value);
    locals_.forget(name.name, why_not_read(known->sort));
  } else {
    locals_.set(name.name, value);
  }
}

void CppScope::check_reading(Tokens value) const {
  for (std::size_t at = 0; at < value.size(); ++at) {
    if (names_matrix(value, at, array_)) {
      const std::size_t tokens = leading_name(value.subspan(at)).tokens;
      if (tokens != 6 && tokens != 7) {
        refuse(value[at]);
      }
    }
  }
}

/// Throws CodeError where one of several values, or one in brackets, may do more than give a value.
void CppScope::check_list(Tokens values) const {
  check_reading(values);
  const bool braces = has(values, "{");
  std::size_t from = 0;
  for (std::size_t at = 0; braces && at < values.size(); ++at) {
    if (values[at].is("{") || values[at].is("}")) {
      locals_.refuse_calls(values.subspan(from, at - from));
      from = at + 1;
    }
  }
  if (braces || comma_parts(values).size() > 1 || (!values.empty() && values[0].is("("))) {
    locals_.refuse_calls(values.subspan(from));
  }
}

}  // namespace assur::generator::audit::code
