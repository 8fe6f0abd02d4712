#include "emission/cpp/expression.hpp"

#include <algorithm>

namespace assur::generator::emission::cpp {

namespace {

using Form = Expression::Form;

Expression of_parts(Form form, std::vector<Expression> parts, const std::string& text = "") {
  Expression result;
  result.form = form;
  result.text = text;
  result.parts = std::move(parts);
  return result;
}

Expression named(Form form, Name name, std::vector<Expression> parts) {
  Expression result = of_parts(form, std::move(parts));
  result.name = std::move(name);
  return result;
}

}  // namespace

Name alias(const std::string& name) { return {name, name}; }
Name scalar_only(const std::string& name) { return {name, "", false}; }

Expression Expression::member(const std::string& of) const {
  return of_parts(Form::member, {*this}, of);
}

Expression Expression::at(std::vector<Expression> places) const {
  places.insert(places.begin(), *this);
  return of_parts(Form::entry, std::move(places));
}

Expression Expression::item(std::size_t place) const {
  return of_parts(Form::item, {*this}, std::to_string(place));
}

Expression number(double value) {
  Expression result = of_parts(Form::number, {});
  result.value = value;
  return result;
}

Expression word(const std::string& text) { return of_parts(Form::word, {}, text); }
Expression word(std::size_t count) { return word(std::to_string(count)); }
Expression variable(const std::string& name) { return of_parts(Form::variable, {}, name); }

Expression call(Name function, std::vector<Expression> arguments) {
  return named(Form::call, std::move(function), std::move(arguments));
}

Expression braces(Name type, std::vector<Expression> members) {
  return named(Form::braces, std::move(type), std::move(members));
}

Expression array(const Name& type, std::vector<Expression> items) {
  const std::string count = std::to_string(items.size());
  return braces({"std::array<" + type.text + ", " + count + ">", type.alias},
                {braces("", std::move(items))});
}

Expression address(Expression of) { return of_parts(Form::address, {std::move(of)}); }
Expression parentheses(Expression inner) { return of_parts(Form::parentheses, {std::move(inner)}); }

Expression negative(Expression of) {
  if (of.form == Form::number) {
    of.value = -of.value;
    return of;
  }
  if (of.form == Form::negative) {
    Expression inner = of.parts.front();
    return inner;
  }
  return of_parts(Form::negative, {std::move(of)});
}

Expression sum(std::vector<Expression> terms) {
  return terms.size() == 1 ? terms.front() : of_parts(Form::sum, std::move(terms));
}

Expression product(std::vector<Expression> factors) {
  return factors.size() == 1 ? factors.front() : of_parts(Form::product, std::move(factors));
}

Expression quotient(Expression above, Expression below) {
  return of_parts(Form::quotient, {std::move(above), std::move(below)});
}

Expression infix(const std::string& operation, std::vector<Expression> parts) {
  return of_parts(Form::infix, std::move(parts), operation);
}

Statement declared(Name type, Expression target, std::optional<Expression> value) {
  return {std::move(type), std::move(target), std::move(value), "", false};
}

Statement assigned(Expression target, Expression value, const std::string& comment) {
  return {std::nullopt, std::move(target), std::move(value), comment, false};
}

Statement called(Expression call) {
  return {std::nullopt, std::nullopt, std::move(call), "", false};
}

Statement returned(Expression value) {
  return {std::nullopt, std::nullopt, std::move(value), "", true};
}

void visit(const Expression& expression, const Visit& visitor) {
  visitor(expression);
  for (const Expression& part : expression.parts) {
    visit(part, visitor);
  }
}

void visit(const Statement& statement, const Visit& visitor) {
  for (const std::optional<Expression>* side : {&statement.target, &statement.value}) {
    if (*side) {
      visit(**side, visitor);
    }
  }
}

bool any_part(const Block& block, const std::function<bool(const Expression&)>& has_property) {
  bool found = false;
  for (const Statement& statement : block) {
    visit(statement, [&](const Expression& part) { found = found || has_property(part); });
  }
  return found;
}

bool reads(const Statement& statement, const std::string& variable) {
  bool found = false;
  const auto look = [&](const Expression& part) {
    found = found || (part.form == Form::variable && part.text == variable);
  };
  if (statement.target && !statement.type) {
    visit(*statement.target, look);
  }
  if (statement.value) {
    visit(*statement.value, look);
  }
  return found;
}

bool reads(const Block& block, const std::string& variable) {
  return std::ranges::any_of(
      block, [&](const Statement& statement) { return reads(statement, variable); });
}

bool declares(const Block& block, const std::string& variable) {
  return std::ranges::any_of(block, [&](const Statement& statement) {
    return statement.type && statement.target->form == Form::variable &&
           statement.target->text == variable;
  });
}

std::set<std::string> aliases_in(const Block& block) {
  std::set<std::string> aliases;
  for (const Statement& statement : block) {
    if (statement.type) {
      aliases.insert(statement.type->alias);
    }
    visit(statement, [&](const Expression& part) { aliases.insert(part.name.alias); });
  }
  aliases.erase("");
  return aliases;
}

bool serves_packs(const Block& block) {
  return !any_part(block, [](const Expression& part) { return !part.name.in_packs; });
}

}  // namespace assur::generator::emission::cpp
