#include "audit/code/variables.hpp"

#include <algorithm>

namespace assur::generator::audit::code {

namespace {

using Kind = Type::Kind;

constexpr const char* rounded = "its type does not keep every number as it is; write double";

/// Reads the indices in one pair of brackets at the front, and returns their number of tokens.
std::size_t bracketed(Tokens tokens, bool round, std::vector<std::size_t>& indices) {
  const char* const open = round ? "(" : "[";
  const char* const close = round ? ")" : "]";
  if (are(first_of(tokens, 3), {open, "#", close})) {
    indices = {whole_number(tokens[1])};
    return 3;
  }
  if (round && are(first_of(tokens, 5), {"(", "#", ",", "#", ")"})) {
    indices = {whole_number(tokens[1]), whole_number(tokens[3])};
    return 5;
  }
  return 0;
}

void add_index(Spelled& number, std::size_t index) {
  number.part += "[" + std::to_string(index) + "]";
  number.formula += "_" + std::to_string(index);
  number.indices.push_back(index);
}

void add_member(Spelled& number, const Token& member) {
  number.part += "." + member.spelling;
  number.formula += "_" + member.spelling;
}

/// `.q[]` for `.q[2]`.
std::string shape_of(const std::string& part) {
  std::string shape;
  for (std::size_t at = 0; at < part.size(); ++at) {
    const bool in_index = !shape.empty() && shape.back() == '[';
    if (!in_index || part[at] == ']') {
      shape += part[at];
    }
  }
  return shape;
}

/// Whether two shapes may belong to one variable: both end here, or both continue with members.
bool agree(const std::string& one, const std::string& other) {
  std::size_t same = 0;
  while (same < one.size() && same < other.size() && one[same] == other[same]) {
    ++same;
  }
  if (same == one.size() && same == other.size()) {
    return true;
  }
  const auto ends = [&](const std::string& shape) { return same == shape.size(); };
  const auto begins_part = [&](const std::string& shape) {
    return ends(shape) || shape[same] == '.' || shape[same] == '[';
  };
  // Parts that differ within the name of a member are different members.
  return !(begins_part(one) && begins_part(other));
}

}  // namespace

Variable* Variables::find(const std::string& name) {
  for (auto* scope : {&inner_, &outer_}) {
    if (const auto at = scope->find(name); at != scope->end()) {
      return &at->second;
    }
  }
  return nullptr;
}

Variable& Variables::declare(const Token& name, Variable::Origin origin, std::optional<Type> type) {
  expect_new_meaning(name);
  Variable variable;
  variable.origin = origin;
  variable.place = name.place;
  variable.type = std::move(type);
  if (variable.type && variable.type->kind != Kind::structure &&
      variable.type->sort == Sort::rounded) {
    variable.refused = rounded;
  }
  const auto [at, is_new] = inner_.emplace(name.spelling, variable);
  if (!is_new || functions_.contains(name.spelling)) {
    throw CodeError("'" + name.spelling + "' is declared twice" + by_running, name.place);
  }
  return at->second;
}

Variable& Variables::found(const Token& name) {
  Variable* const known = find(name.spelling);
  return known != nullptr
             ? *known
             : inner_.emplace(name.spelling, Variable{Variable::Origin::free, name.place})
                   .first->second;
}

void Variables::take_inferred(Tokens rest, Spelled& number) const {
  bool members = false;
  while (!rest.empty()) {
    std::vector<std::size_t> indices;
    std::size_t taken = 0;
    if (rest.size() > 1 && (rest[0].is(".") || rest[0].is("->")) && rest[1].is_name() &&
        number.indices.empty()) {
      add_member(number, rest[1]);
      members = true;
      taken = 2;
    } else if (const bool round = rest[0].is("("); round || rest[0].is("[")) {
      taken = bracketed(rest, round, indices);
      const bool more =
          !number.indices.empty() && (round || number.round || number.indices.size() > 1);
      if (taken == 0 || more) {
        if (round) {
          throw CodeError("the effect of '" + number.text() + "' is not known" + by_running,
                          number.place);
        }
        throw CodeError("'[' cannot be read inside an expression" + by_running, rest[0].place);
      }
      number.round = round;
      std::for_each(indices.begin(), indices.end(),
                    [&](std::size_t index) { add_index(number, index); });
      if (round && members) {
        throw CodeError("'" + number.text() + "' may be another name of a value" + by_running,
                        number.place);
      }
    } else {
      break;
    }
    rest = rest.subspan(taken);
    number.tokens += taken;
  }
}

void Variables::take_parts(Tokens rest, Spelled& number) const {
  const auto fail = [&](const std::string& why) {
    throw CodeError("'" + number.text() + "' " + why, number.place);
  };
  const Type* type = &*number.variable->type;
  number.shared =
      type->is_shared() || (type->plain && number.variable->origin == Variable::Origin::given);
  while (type->kind != Kind::number) {
    std::size_t taken = 0;
    if (type->kind == Kind::structure) {
      const bool member =
          rest.size() > 1 && (rest[0].is(".") || rest[0].is("->")) && rest[1].is_name();
      const auto found =
          std::find_if(type->members.begin(), type->members.end(),
                       [&](const auto& each) { return member && rest[1].spelling == each.first; });
      if (!member || found == type->members.end()) {
        fail(member ? "has no known member '" + rest[1].spelling + "'" + by_running
                    : "is more than one number" + by_running);
      }
      add_member(number, rest[1]);
      type = &found->second;
      number.shared = number.shared || type->is_shared();
      taken = 2;
    } else if (type->kind == Kind::list || type->kind == Kind::grid) {
      std::vector<std::size_t> indices;
      const bool round = !rest.empty() && rest[0].is("(");
      const bool allowed = round ? type->round : type->square;
      taken = allowed ? bracketed(rest, round, indices) : 0;
      if (taken > 0 && !round && type->kind == Kind::grid) {
        std::vector<std::size_t> column;
        const std::size_t more = bracketed(rest.subspan(taken), false, column);
        taken = more == 0 ? 0 : taken + more;
        indices.insert(indices.end(), column.begin(), column.end());
      }
      if (taken == 0 || indices.size() != (type->kind == Kind::grid ? 2 : 1)) {
        if (rest.size() > 1 && rest[0].is(".")) {
          add_member(number, rest[1]);
          fail("may be another name of a value" + by_running);
        }
        fail("is more than one number" + by_running);
      }
      if (indices[0] >= type->rows.value_or(999999) ||
          (indices.size() > 1 && indices[1] >= type->columns.value_or(999999))) {
        fail("has no such element");
      }
      std::for_each(indices.begin(), indices.end(),
                    [&](std::size_t index) { add_index(number, index); });
      static const std::map<Sort, Type> elements = [] {
        std::map<Sort, Type> all;
        for (const Sort sort : {Sort::real, Sort::whole, Sort::single, Sort::rounded}) {
          all[sort].kind = Kind::number;
          all[sort].sort = sort;
        }
        return all;
      }();
      type = &elements.at(type->sort);
    } else {
      throw CodeError("'" + number.text() + "' cannot be read: its type is not known; write double",
                      number.variable->place);
    }
    rest = rest.subspan(taken);
    number.tokens += taken;
  }
  number.sort = type->sort;
  if (!rest.empty() && rest[0].is("(")) {
    throw CodeError("the effect of '" + number.text() + "' is not known" + by_running,
                    number.place);
  }
}

void Variables::expect_one_shape(Spelled& number) {
  std::vector<std::string>& parts = number.variable->parts;
  const std::string shape = shape_of(number.part);
  for (const std::string& part : parts) {
    if (!agree(shape, shape_of(part))) {
      const std::string other = number.name + part;
      const bool longer = number.part.size() > part.size();
      const bool whole = part.empty() || number.part.empty();
      throw CodeError(
          whole ? "'" + (longer ? number.text() : other) + "' may be '" +
                      (longer ? other : number.text()) + "' itself" + by_running
                : "'" + number.text() + "' and '" + other + "' may be one value" + by_running,
          number.place);
    }
  }
  if (std::none_of(parts.begin(), parts.end(),
                   [&](const std::string& part) { return shape_of(part) == shape; })) {
    parts.push_back(number.part);
  }
}

Spelled Variables::spelled(Tokens tokens) {
  const Token& name = tokens[0];
  if (functions_.contains(name.spelling)) {
    throw CodeError("the effect of '" + name.spelling + "' is not known" + by_running, name.place);
  }
  if (has_meaning(name.spelling) && find(name.spelling) == nullptr) {
    throw CodeError("'" + name.spelling + "' cannot be read here" + by_running, name.place);
  }
  if (language_ == Language::matlab && in_function_ && find(name.spelling) == nullptr) {
    throw CodeError(
        "'" + name.spelling + "' is neither given to this function nor set in it" + by_running,
        name.place);
  }
  // An undeclared name is checked before it is stored, since it may be a call.
  Variable unknown{Variable::Origin::free, name.place};
  Variable* const known = find(name.spelling);
  Spelled number{known == nullptr ? &unknown : known,
                 name.spelling,
                 "",
                 name.spelling,
                 {},
                 Sort::real,
                 name.place,
                 1};
  if (number.variable->type) {
    take_parts(tokens.subspan(1), number);
  } else {
    take_inferred(tokens.subspan(1), number);
  }
  const bool set = tokens.size() > number.tokens && tokens[number.tokens].spelling.ends_with('=');
  if (known == nullptr && language_ == Language::cpp && number.round && (in_function_ || !set) &&
      !system_.is_known(number.formula)) {
    throw CodeError("the effect of '" + name.spelling + "' is not known" + by_running, name.place);
  }
  number.variable = &found(name);
  if (!number.variable->type) {
    expect_one_shape(number);
    const bool element = !number.part.empty() && number.part[0] == '[';
    if (element && number.variable->origin != Variable::Origin::own &&
        system_.is_known(number.name)) {
      throw CodeError("'" + number.text() + "' may be '" + number.name + "' itself" + by_running,
                      number.place);
    }
  }
  return number;
}

Cell Variables::read(const Spelled& number) {
  const Variable& variable = *number.variable;
  const auto refuse = [&](const std::string& reason, closures::Place place) {
    throw Unreadable("'" + number.text() + "' cannot be read: " + reason, place);
  };
  if (!variable.refused.empty()) {
    refuse(variable.refused, variable.place);
  }
  const auto cell = variable.cells.find(number.part);
  if (cell != variable.cells.end()) {
    if (!cell->second.value) {
      refuse(cell->second.reason, cell->second.place);
    }
    return cell->second;
  }
  if (variable.zero) {
    return {GiNaC::ex(0), number.sort};
  }
  if (variable.origin == Variable::Origin::own) {
    refuse("it has no value yet", variable.place);
  }
  if (number.sort == Sort::whole) {
    refuse("its type holds whole numbers alone; write double", variable.place);
  }
  if (number.sort != Sort::real) {
    refuse(rounded, variable.place);
  }
  const bool hides = number.formula != number.name && find(number.formula) != nullptr;
  std::string other = number.text();
  if (variable.origin == Variable::Origin::given) {
    other = symbols_.emplace(number.formula, other).first->second;
  }
  if (hides || other != number.text()) {
    throw CodeError("'" + number.text() + "' and '" + (hides ? number.formula : other) +
                        "' would be read as one; give one of them another name",
                    number.place);
  }
  if (number.formula == "pi" || number.formula == "deg") {
    throw CodeError("a variable named '" + number.formula +
                        "' means something else in a formula; give it another name",
                    number.place);
  }
  return {std::nullopt, Sort::real};
}

void Variables::expect_free(const Variable& variable, const std::string& part,
                            const std::string& text, closures::Place place) const {
  for (const auto& [held, held_part] : held_) {
    if (held == &variable && (part.empty() || held_part == part)) {
      throw CodeError("'" + text + "' is set while a reference to it is held" + by_running, place);
    }
  }
}

void Variables::set(const Spelled& number, Cell cell) {
  expect_free(*number.variable, number.part, number.text(), number.place);
  if (number.variable->origin == Variable::Origin::own && number.variable->type &&
      number.variable->type->constant && number.variable->cells.contains(number.part)) {
    throw CodeError("'" + number.text() + "' cannot be set" + by_running, number.place);
  }
  number.variable->cells[number.part] = std::move(cell);
}

}  // namespace assur::generator::audit::code
