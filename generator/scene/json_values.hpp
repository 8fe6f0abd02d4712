// Turns the values of a scene's JSON into texts and numbers, or into one line of complaint.
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace assur::generator {

/// Ordered, because the order of links and joints decides how a group is spelled.
using SceneJson = nlohmann::ordered_json;

/// Printable, short, on one line: what a message may quote.
[[nodiscard]] std::string quoted(const std::string& text);

/// Reads values of one scene. `where` is the place that a message names; every function throws
/// InputError where a value is not what it must be.
class JsonValues {
 public:
  explicit JsonValues(std::string file) : file_(std::move(file)) {}

  /// Expressions may name it from now on.
  void add_parameter(const std::string& name) { parameter_names_.push_back(name); }
  [[nodiscard]] const std::vector<std::string>& parameter_names() const { return parameter_names_; }

  [[noreturn]] void fail(const std::string& where, const std::string& what) const;
  [[nodiscard]] SceneJson parsed(const std::string& text) const;
  void expect_object(const SceneJson& value, const std::string& where) const;
  void expect_keys(const SceneJson& value, const std::string& where,
                   const std::vector<std::string>& known) const;
  [[nodiscard]] const SceneJson& required(const SceneJson& value, const std::string& key,
                                          const std::string& where) const;
  [[nodiscard]] std::string text_of(const SceneJson& value, const std::string& where) const;
  /// An expression in the parameters.
  [[nodiscard]] SceneNumber number_of(const std::string& text, const std::string& where) const;
  /// A number or an expression.
  [[nodiscard]] SceneNumber number(const SceneJson& value, const std::string& where) const;
  [[nodiscard]] std::array<SceneNumber, 2> pair(const SceneJson& value,
                                                const std::string& where) const;

 private:
  void expect_names(const Expression& expression, const std::string& where) const;

  std::string file_;
  std::vector<std::string> parameter_names_;
};

}  // namespace assur::generator
