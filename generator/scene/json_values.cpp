#include "scene/json_values.hpp"

#include <algorithm>
#include <set>

#include "error.hpp"
#include "scene/suggestion.hpp"

namespace assur::generator {

std::string quoted(const std::string& text) {
  std::string shown;
  for (const char letter : text.substr(0, 40)) {
    shown += static_cast<unsigned char>(letter) < 0x20 ? '?' : letter;
  }
  return "'" + shown + (text.size() > 40 ? "..." : "") + "'";
}

void JsonValues::fail(const std::string& where, const std::string& what) const {
  throw InputError(file_ + ": " + where + (where.empty() ? "" : ": ") + what);
}

SceneJson JsonValues::parsed(const std::string& text) const {
  // The library keeps the last of two equal keys without a word; a scene must not.
  std::vector<std::set<std::string>> open;
  const auto watch = [&](int /*depth*/, SceneJson::parse_event_t event, SceneJson& value) {
    if (event == SceneJson::parse_event_t::object_start) {
      open.emplace_back();
    } else if (event == SceneJson::parse_event_t::object_end) {
      open.pop_back();
    } else if (event == SceneJson::parse_event_t::key) {
      const auto key = value.get<std::string>();
      if (!open.back().insert(key).second) {
        fail("", "the key " + quoted(key) + " stands twice in one object");
      }
    }
    return true;
  };
  try {
    return SceneJson::parse(text, watch);
  } catch (const SceneJson::exception& error) {
    std::string what = error.what();
    what = what.substr(what.find("] ") == std::string::npos ? 0 : what.find("] ") + 2);
    std::replace_if(
        what.begin(), what.end(),
        [](char letter) { return static_cast<unsigned char>(letter) < 0x20; }, ' ');
    fail("", "not JSON: " + what);
  }
}

void JsonValues::expect_object(const SceneJson& value, const std::string& where) const {
  if (!value.is_object()) {
    fail(where, std::string("expected an object {...}, found ") + value.type_name());
  }
}

void JsonValues::expect_keys(const SceneJson& value, const std::string& where,
                             const std::vector<std::string>& known) const {
  for (const auto& [key, ignored] : value.items()) {
    if (std::find(known.begin(), known.end(), key) == known.end()) {
      fail(where, "unknown key " + quoted(key) + suggestion(key, known));
    }
  }
}

const SceneJson& JsonValues::required(const SceneJson& value, const std::string& key,
                                      const std::string& where) const {
  if (!value.contains(key)) {
    fail(where, "the key '" + key + "' is missing");
  }
  return value.at(key);
}

std::string JsonValues::text_of(const SceneJson& value, const std::string& where) const {
  if (!value.is_string()) {
    fail(where, std::string("expected a text, found ") + value.type_name());
  }
  return value.get<std::string>();
}

SceneNumber JsonValues::number_of(const std::string& text, const std::string& where) const {
  SceneNumber number{{}, where};
  try {
    number.expression = parse_expression(text);
  } catch (const ExpressionError& error) {
    fail(where, std::string(error.what()) + " at column " + std::to_string(error.column) + " of " +
                    quoted(text));
  }
  expect_names(number.expression, where);
  return number;
}

SceneNumber JsonValues::number(const SceneJson& value, const std::string& where) const {
  if (value.is_string()) {
    return number_of(value.get<std::string>(), where);
  }
  if (!value.is_number()) {
    fail(where, std::string("expected a number or an expression, found ") + value.type_name());
  }
  return {{Expression::Kind::number, value.get<double>(), value.dump(), {}, 1}, where};
}

void JsonValues::expect_names(const Expression& expression, const std::string& where) const {
  if (expression.kind == Expression::Kind::name &&
      std::find(parameter_names_.begin(), parameter_names_.end(), expression.name) ==
          parameter_names_.end()) {
    fail(where, "no parameter named " + quoted(expression.name) +
                    suggestion(expression.name, parameter_names_));
  }
  for (const Expression& argument : expression.arguments) {
    expect_names(argument, where);
  }
}

std::array<SceneNumber, 2> JsonValues::pair(const SceneJson& value,
                                            const std::string& where) const {
  if (!value.is_array() || value.size() != 2) {
    fail(where, "expected two numbers [x, y]");
  }
  return {number(value[0], where + "[0]"), number(value[1], where + "[1]")};
}

}  // namespace assur::generator
