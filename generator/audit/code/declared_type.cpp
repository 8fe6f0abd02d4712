#include "audit/code/declared_type.hpp"

#include <algorithm>
#include <assur/text/expression.hpp>

namespace assur::generator::audit::code {

namespace {

using Kind = Type::Kind;

Type number(Sort sort) {
  Type type;
  type.kind = Kind::number;
  type.sort = sort;
  return type;
}

/// The sort of a type that is spelled by these words, sorted alphabetically.
std::optional<Sort> sort_of_words(std::vector<std::string> words) {
  static const std::map<std::string, Sort> sorts = {
      {"double", Sort::real},       {"double long", Sort::real},
      {"float", Sort::rounded},     {"int", Sort::whole},
      {"long", Sort::whole},        {"int long", Sort::whole},
      {"long long", Sort::whole},   {"signed", Sort::whole},
      {"int signed", Sort::whole},  {"int long long", Sort::whole},
      {"long signed", Sort::whole}, {"int long signed", Sort::whole}};
  std::sort(words.begin(), words.end());
  std::string spelled;
  for (const std::string& word : words) {
    spelled += (spelled.empty() ? "" : " ") + word;
  }
  const auto found = sorts.find(spelled);
  return found == sorts.end() ? Sort::rounded : found->second;
}

bool is_word_of_numbers(const Token& token) {
  static const std::set<std::string> words = {"double", "float",    "int",  "long", "short",
                                              "signed", "unsigned", "char", "bool", "wchar_t"};
  return token.is_name() && words.contains(token.spelling);
}

std::optional<std::size_t> size_in(Tokens tokens) {
  return are(tokens, {"#"}) ? std::optional<std::size_t>(whole_number(tokens[0])) : std::nullopt;
}

/// Eigen's names such as `Matrix2d`, `RowVectorXf`: an array with sizes and a sort of number.
std::optional<Type> eigen_name(const std::string& name) {
  for (const char* begins : {"Matrix", "Vector", "RowVector"}) {
    const std::string start = begins;
    const std::string rest = name.starts_with(start) ? name.substr(start.size()) : "";
    if (rest.size() != 2 || std::string("234X").find(rest[0]) == std::string::npos ||
        std::string("dfi").find(rest[1]) == std::string::npos) {
      continue;
    }
    Type type = number(rest[1] == 'd' ? Sort::real : rest[1] == 'f' ? Sort::rounded : Sort::whole);
    const auto size = rest[0] == 'X' ? std::nullopt : std::optional<std::size_t>(rest[0] - '0');
    type.kind = start == "Matrix" ? Kind::grid : Kind::list;
    type.rows = size;
    type.columns = start == "Matrix" ? size : std::nullopt;
    type.round = true;
    type.square = type.kind == Kind::list;
    return type;
  }
  return std::nullopt;
}

/// Takes the tokens between `<` and the `>` that closes it from the front.
std::optional<Tokens> take_arguments(Tokens& tokens) {
  int depth = 0;
  for (std::size_t at = 0; at < tokens.size(); ++at) {
    const Token& token = tokens[at];
    depth += token.is("<") ? 1 : token.is(">") ? -1 : token.is(">>") ? -2 : 0;
    if (token.is("(") || token.is("{") || token.is(";")) {
      return std::nullopt;
    }
    if (depth <= 0) {
      const Tokens inside = tokens.subspan(1, at - 1);
      tokens = tokens.subspan(at + 1);
      return inside;
    }
  }
  // A `>>` that also closes the enclosing list ends it, too.
  const Tokens inside = tokens.subspan(1);
  tokens = tokens.last(0);
  return inside;
}

[[noreturn]] void refuse_type(const Token& at) {
  throw CodeError("a type that is more than a list of members cannot be read" + by_running,
                  at.place);
}

}  // namespace

Type Type::array(std::optional<std::size_t> length) const {
  Type result;
  const bool of_lists = kind == Kind::list && square && !round;
  if ((kind != Kind::number && !of_lists) || is_shared()) {
    return result;
  }
  result.kind = of_lists ? Kind::grid : Kind::list;
  result.sort = sort;
  result.rows = length;
  result.columns = of_lists ? rows : std::nullopt;
  result.square = true;
  result.constant = constant;
  return result;
}

bool is_known_function(const std::string& name) {
  return name == "pow" || (text::is_reserved_name(name) && name != "pi" && name != "deg");
}

bool has_meaning(const std::string& name) {
  static const std::set<std::string> names = {"M_PI", "std",  "Eigen", "numbers",
                                              "pi_v", "Zero", "zeros", "this"};
  return names.contains(name) || is_known_function(name);
}

void expect_new_meaning(const Token& name) {
  if (has_meaning(name.spelling)) {
    throw CodeError("'" + name.spelling + "' is given another meaning" + by_running, name.place);
  }
}

Tokens without_attributes(Tokens tokens) {
  while (tokens.size() > 1 && tokens[0].is("[") && tokens[1].is("[")) {
    if (tokens.size() < 5 || !(tokens[2].is("maybe_unused") || tokens[2].is("nodiscard")) ||
        !tokens[3].is("]") || !tokens[4].is("]")) {
      throw CodeError("this attribute cannot be read" + by_running, tokens[0].place);
    }
    tokens = tokens.subspan(5);
  }
  return tokens;
}

Type TypeNames::made_of(const std::string& space, const std::string& name,
                        const std::vector<Tokens>& arguments) const {
  const auto type_at = [&](std::size_t at) -> Type {
    Tokens tokens = arguments[at];
    const std::optional<Type> type = take(tokens);
    return type && tokens.empty() ? *type : Type{};
  };
  const auto is_size = [&](std::size_t at) {
    const Tokens size = arguments[at];
    return are(size, {"#"}) || are(size, {"Dynamic"}) || are(size, {"Eigen", "::", "Dynamic"});
  };
  if (space == "std" && arguments.empty()) {
    const bool whole = name == "int32_t" || name == "int64_t" || name == "ptrdiff_t";
    const bool rounded =
        name == "size_t" || name == "int8_t" || name == "int16_t" || name.starts_with("uint");
    return whole ? number(Sort::whole) : rounded ? number(Sort::rounded) : Type{};
  }
  if (space == "std" && name == "array" && arguments.size() == 2 && are(arguments[1], {"#"})) {
    return type_at(0).array(size_in(arguments[1]));
  }
  if (space == "std" && name == "vector" && arguments.size() == 1) {
    return type_at(0).array(std::nullopt);
  }
  if (space == "std" && (name == "tuple" || name == "pair")) {
    Type result = number(Sort::real);
    result.kind = Kind::list;
    result.rows = arguments.size();
    for (std::size_t at = 0; at < arguments.size(); ++at) {
      const Type part = type_at(at);
      if (part.kind != Kind::number || part.sort != Sort::real || part.is_shared()) {
        return {};
      }
    }
    return result;
  }
  if (space == "Eigen" && arguments.empty()) {
    return name == "Index" ? number(Sort::whole) : eigen_name(name).value_or(Type{});
  }
  if (space == "Eigen" && name == "Ref" && arguments.size() == 1) {
    Type type = type_at(0);
    type.reference = true;
    return type;
  }
  const bool ordered = arguments.size() == 4 && (are(arguments[3], {"Eigen", "::", "RowMajor"}) ||
                                                 are(arguments[3], {"Eigen", "::", "ColMajor"}));
  if (space == "Eigen" && name == "Matrix" && (arguments.size() == 3 || ordered) && is_size(1) &&
      is_size(2)) {
    Type type = type_at(0);
    if (type.kind == Kind::number && !type.is_shared()) {
      type.rows = size_in(arguments[1]);
      type.columns = size_in(arguments[2]);
      type.round = true;
      type.kind = type.columns == 1 ? Kind::list : type.rows == 1 ? Kind::other : Kind::grid;
      type.square = type.kind == Kind::list;
      return type;
    }
  }
  return {};
}

Type TypeNames::take_named(Tokens& tokens) const {
  std::vector<std::string> names;
  const Token& first = tokens[0];
  const bool qualified = tokens.size() > 1 && tokens[1].is("::");
  while (!tokens.empty() && tokens[0].is_name()) {
    names.push_back(tokens[0].spelling);
    tokens = tokens.subspan(1);
    if (tokens.size() < 2 || !tokens[0].is("::") || !tokens[1].is_name()) {
      break;
    }
    tokens = tokens.subspan(1);
  }
  std::vector<Tokens> arguments;
  if (!tokens.empty() && tokens[0].is("<")) {
    const std::optional<Tokens> inside = take_arguments(tokens);
    if (!inside || inside->empty()) {
      throw CodeError("this type cannot be read" + by_running, first.place);
    }
    arguments = declared_parts(*inside);
  }
  Type type;
  const bool more = !tokens.empty() && tokens[0].is("::");
  while (tokens.size() > 1 && tokens[0].is("::") && tokens[1].is_name()) {
    tokens = tokens.subspan(2);
  }
  if (more || names.size() > 2) {
    return type;
  }
  if (!qualified) {
    const auto own = own_.find(names[0]);
    if (own != own_.end()) {
      return arguments.empty() ? own->second : type;
    }
    for (const char* space : {"std", "Eigen"}) {
      static const std::set<std::string> global = {"size_t", "int32_t", "int64_t", "ptrdiff_t"};
      if (opens(space, names[0]) || global.contains(names[0])) {
        type = made_of(space, names[0], arguments);
      }
      if (type.kind != Kind::other) {
        return type;
      }
    }
    type.undeclared = arguments.empty() && opened_.empty();
    return type;
  }
  return made_of(names[0], names[1], arguments);
}

std::optional<Type> TypeNames::take_base(Tokens& tokens) const {
  if (tokens.empty() || !tokens[0].is_name()) {
    return std::nullopt;
  }
  if (tokens[0].is("auto")) {
    tokens = tokens.subspan(1);
    Type type;
    type.deduced = true;
    return type;
  }
  if (tokens[0].is("void")) {
    tokens = tokens.subspan(1);
    return Type{};
  }
  std::vector<std::string> words;
  while (!tokens.empty() && (is_word_of_numbers(tokens[0]) || tokens[0].is("const"))) {
    if (!tokens[0].is("const")) {
      words.push_back(tokens[0].spelling);
    }
    tokens = tokens.subspan(1);
  }
  if (!words.empty()) {
    return number(*sort_of_words(words));
  }
  return take_named(tokens);
}

std::optional<Type> TypeNames::take(Tokens& tokens) const {
  Tokens rest = without_attributes(tokens);
  Type flags;
  const auto take_flags = [&] {
    while (!rest.empty() &&
           (rest[0].is("const") || rest[0].is("constexpr") || rest[0].is("static") ||
            rest[0].is("inline") || rest[0].is("struct"))) {
      flags.constant = flags.constant || rest[0].is("const") || rest[0].is("constexpr");
      flags.outlives = flags.outlives || rest[0].is("static");
      flags.computed = flags.computed || rest[0].is("constexpr");
      rest = rest.subspan(1);
    }
  };
  take_flags();
  const Token* const first = rest.data();
  std::optional<Type> type = take_base(rest);
  if (!type) {
    return std::nullopt;
  }
  flags.constant = flags.constant || std::any_of(first, rest.data(), [](const Token& token) {
                     return token.is("const") && (&token)[-1].is_name();
                   });
  take_flags();
  type->constant = type->constant || flags.constant;
  type->outlives = flags.outlives;
  type->computed = flags.computed;
  while (!rest.empty() && (rest[0].is("*") || rest[0].is("&") || rest[0].is("&&"))) {
    if (rest[0].is("&&") || (type->is_shared() && (type->pointer || rest[0].is("*")))) {
      const bool constant = type->constant;  // a pointer to a pointer
      Type grid;
      if (type->pointer && !type->reference && rest[0].is("*") && type->kind == Kind::list) {
        type->pointer = false;
        grid = type->array(std::nullopt);
        grid.pointer = true;
      }
      type = grid;
      type->constant = constant;
    } else if (rest[0].is("*")) {
      const bool constant = type->constant;
      Type pointed = type->kind == Kind::number ? type->array(std::nullopt) : *type;
      pointed.kind =
          type->kind == Kind::number || type->kind == Kind::structure ? pointed.kind : Kind::other;
      pointed.constant = constant;
      pointed.pointer = true;
      type = pointed;
    } else {
      type->reference = true;
    }
    rest = rest.subspan(1);
    while (!rest.empty() && (rest[0].is("const") || rest[0].is("restrict"))) {
      rest = rest.subspan(1);
    }
  }
  tokens = rest;
  return type;
}

Declarator TypeNames::take_name(const Type& type, Tokens tokens) const {
  Declarator result{type, nullptr, tokens};
  Tokens& rest = result.rest;
  const bool bracketed = rest.size() > 3 && rest[0].is("(") &&
                         (rest[1].is("&") || rest[1].is("*")) && rest[2].is_name() &&
                         rest[3].is(")");
  if (rest.empty() || (!bracketed && !rest[0].is_name())) {
    throw CodeError("this declaration cannot be read" + by_running,
                    rest.empty() ? (tokens.data() - 1)->place : rest[0].place);
  }
  result.name = &rest[bracketed ? 2 : 0];
  const bool points = bracketed && rest[1].is("*");
  rest = rest.subspan(bracketed ? 4 : 1);
  std::vector<std::optional<std::size_t>> sizes;
  while (!rest.empty() && rest[0].is("[")) {
    const std::size_t end = behind_closing(rest, 0);
    const Tokens size = rest.subspan(1, end - 2);
    const bool known = size.empty() || are(size, {"#"});
    if (!known) {
      throw CodeError("this size cannot be read; write a number" + by_running, rest[0].place);
    }
    sizes.push_back(size_in(size));
    rest = rest.subspan(end);
  }
  if (bracketed && sizes.empty()) {
    throw CodeError("this declaration cannot be read" + by_running, result.name->place);
  }
  if (points) {
    sizes.insert(sizes.begin(), std::nullopt);
  }
  for (auto size = sizes.rbegin(); size != sizes.rend(); ++size) {
    result.type = result.type.array(*size);
  }
  if (!sizes.empty()) {
    result.type.plain = true;
    result.type.constant = type.constant;
    result.type.outlives = type.outlives;
    result.type.reference = bracketed && !points;
    result.type.pointer = points;
  }
  return result;
}

void TypeNames::define(const Token& name, Type type) {
  expect_new_meaning(name);
  if (!own_.emplace(name.spelling, std::move(type)).second) {
    throw CodeError("'" + name.spelling + "' is declared twice" + by_running, name.place);
  }
}

void TypeNames::read_using(Tokens statement) {
  const Tokens rest = statement.subspan(1);
  const auto is_space = [](const Token& token) { return token.is("std") || token.is("Eigen"); };
  if (rest.size() == 2 && rest[0].is("namespace") && is_space(rest[1])) {
    opened_.insert(rest[1].spelling);
    return;
  }
  if (rest.size() == 3 && is_space(rest[0]) && rest[1].is("::") && rest[2].is_name()) {
    opened_.insert(rest[0].spelling + "::" + rest[2].spelling);
    return;
  }
  if (rest.size() < 3 || !rest[0].is_name() || !rest[1].is("=")) {
    throw CodeError("the names that this declares cannot be read" + by_running, statement[0].place);
  }
  expect_new_meaning(rest[0]);
  Tokens tokens = rest.subspan(2);
  std::optional<Type> type = take(tokens);
  if (type && !tokens.empty() && tokens[0].is("[")) {
    std::vector<Token> named = {rest[0]};  // `double[2][2]` as `NAME[2][2]`
    named.insert(named.end(), tokens.begin(), tokens.end());
    const Declarator array = take_name(*type, named);
    tokens = tokens.last(array.rest.size());
    type = array.type;
  }
  const bool known = type && tokens.empty() && !type->is_shared() && !type->constant;
  define(rest[0], known ? *type : Type{});
}

void TypeNames::read_typedef(Tokens statement) {
  Tokens rest = statement.subspan(1);
  const std::optional<Type> type = take(rest);
  if (!type) {
    throw CodeError("this type cannot be read" + by_running, statement[0].place);
  }
  const Declarator declared = take_name(*type, rest);
  const bool known = declared.rest.empty() && !declared.type.is_shared() && !declared.type.constant;
  define(*declared.name, known ? declared.type : Type{});
}

void TypeNames::read_structure(const Token& name, Tokens members) {
  Type structure;
  structure.kind = Kind::structure;
  while (!members.empty()) {
    const auto end = std::find_if(members.begin(), members.end(),
                                  [](const Token& token) { return token.is(";"); });
    const Tokens all = members.first(static_cast<std::size_t>(end - members.begin()));
    if (end == members.end()) {
      refuse_type(name);
    }
    members = members.subspan(all.size() + 1);
    Tokens rest = all;
    const std::optional<Type> type = take(rest);
    if (!type || type->outlives || type->computed) {
      refuse_type(name);
    }
    for (const Tokens& part : comma_parts(rest)) {
      if (part.empty() || !(part[0].is_name() || part[0].is("("))) {
        refuse_type(name);
      }
      const Declarator member = take_name(*type, part);
      const bool initialised = are(member.rest, {"=", "#"}) || are(member.rest, {"{", "}"}) ||
                               (member.rest.size() == 2 && member.rest[0].is("=") &&
                                member.rest[1].kind == Token::Kind::number);
      if (!member.rest.empty() && !initialised) {
        refuse_type(name);
      }
      structure.members.emplace_back(member.name->spelling, member.type);
    }
  }
  define(name, structure);
}

}  // namespace assur::generator::audit::code
