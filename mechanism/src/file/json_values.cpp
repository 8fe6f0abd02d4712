#include "json_values.hpp"

#include <algorithm>
#include <assur/text/quoted.hpp>
#include <assur/text/suggestion.hpp>
#include <set>

namespace assur::mechanism::file {

namespace {

/// No scene nests more than six lists and objects.
constexpr int deepest = 20;
/// The most keys of one object, since an object looks up its keys one by one.
constexpr std::size_t most_keys = 20000;

}  // namespace

SceneJson parsed(const std::string& text) {
  // The library silently keeps the last of two equal keys, which a scene must not have.
  std::vector<std::set<std::string>> open;
  const auto watch = [&](int depth, SceneJson::parse_event_t event, SceneJson& value) {
    if (depth > deepest) {
      throw MechanismError("", "the lists and objects are nested too deeply for a scene");
    }
    if (event == SceneJson::parse_event_t::object_start) {
      open.emplace_back();
    } else if (event == SceneJson::parse_event_t::object_end) {
      open.pop_back();
    } else if (event == SceneJson::parse_event_t::key) {
      const auto key = value.get<std::string>();
      if (!open.back().insert(key).second) {
        throw MechanismError("", "the key " + text::in_quotes(key) + " occurs twice in one object");
      }
      if (open.back().size() > most_keys) {
        throw MechanismError(
            "", "an object has more than " + std::to_string(most_keys) + " keys; divide the scene");
      }
    }
    return true;
  };
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) {
    throw MechanismError("", "the text is empty; expected a scene in JSON, {...}");
  }
  try {
    return SceneJson::parse(text, watch);
  } catch (const SceneJson::exception& error) {
    std::string what = error.what();
    what = what.substr(what.find("] ") == std::string::npos ? 0 : what.find("] ") + 2);
    std::replace_if(
        what.begin(), what.end(),
        [](char letter) { return static_cast<unsigned char>(letter) < 0x20; }, ' ');
    throw MechanismError("", "the text is not JSON: " + what);
  }
}

void expect_object(const SceneJson& value, const std::string& part) {
  if (!value.is_object()) {
    throw MechanismError(part, std::string("expected an object {...}, found ") + value.type_name());
  }
}

void expect_keys(const SceneJson& value, const std::string& part, std::span<const SceneKey> known) {
  std::vector<std::string> names;
  for (const SceneKey& key : known) {
    names.emplace_back(key.name);
  }
  for (const auto& [key, ignored] : value.items()) {
    if (std::find(names.begin(), names.end(), key) == names.end()) {
      throw MechanismError(
          part, "unknown key " + text::in_quotes(key) + text::suggestion_or_choice(key, names));
    }
  }
}

const SceneJson& required(const SceneJson& value, const std::string& key, const std::string& part) {
  if (!value.contains(key)) {
    throw MechanismError(part, "the key '" + key + "' is missing");
  }
  return value.at(key);
}

std::string text_of(const SceneJson& value, const std::string& part) {
  if (!value.is_string()) {
    throw MechanismError(part, std::string("expected a text, found ") + value.type_name());
  }
  return value.get<std::string>();
}

bool truth_of(const SceneJson& value, const std::string& part) {
  if (!value.is_boolean()) {
    throw MechanismError(part, "expected true or false");
  }
  return value.get<bool>();
}

Mechanism::Given number_of(const SceneJson& value, const std::string& part) {
  if (value.is_string()) {
    return value.get<std::string>();
  }
  if (!value.is_number()) {
    throw MechanismError(
        part, std::string("expected a number or an expression, found ") + value.type_name());
  }
  return value.get<double>();
}

std::array<Mechanism::Given, 2> pair_of(const SceneJson& value, const std::string& part) {
  if (!value.is_array() || value.size() != 2) {
    throw MechanismError(part, "expected two numbers [x, y]");
  }
  return {number_of(value[0], part + "[0]"), number_of(value[1], part + "[1]")};
}

}  // namespace assur::mechanism::file
