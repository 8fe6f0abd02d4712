// Texts and numbers from the values of a scene's JSON, with checks of their form.
#pragma once

#include <array>
#include <assur/mechanism/mechanism.hpp>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "scene_keys.hpp"

namespace assur::mechanism::file {

/// Ordered, because the order of links and joints decides how a group is spelled.
using SceneJson = nlohmann::ordered_json;

/// Parses a text. Throws MechanismError for a text that is not JSON, and for a key that occurs
/// twice in one object.
[[nodiscard]] SceneJson parsed(const std::string& text);

/// Expects an object. This function and the following ones throw MechanismError for a value of the
/// wrong form; `part` is its name in the message.
void expect_object(const SceneJson& value, const std::string& part);
void expect_keys(const SceneJson& value, const std::string& part, std::span<const SceneKey> known);
[[nodiscard]] const SceneJson& required(const SceneJson& value, const std::string& key,
                                        const std::string& part);
[[nodiscard]] std::string text_of(const SceneJson& value, const std::string& part);
[[nodiscard]] bool truth_of(const SceneJson& value, const std::string& part);
/// A number, or the text of an expression.
[[nodiscard]] Mechanism::Given number_of(const SceneJson& value, const std::string& part);
[[nodiscard]] std::array<Mechanism::Given, 2> pair_of(const SceneJson& value,
                                                      const std::string& part);

}  // namespace assur::mechanism::file
