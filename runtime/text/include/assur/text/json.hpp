// Writer for JSON documents.
#pragma once

#include <concepts>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace assur::text {

/// A value of a JSON document without fractions. Names keep the order of insertion. Smaller to
/// compile than a library that also reads JSON.
class Json {
 public:
  using Member = std::pair<std::string, Json>;

  Json() = default;  ///< null
  Json(bool truth) : scalar_(truth ? "true" : "false") {}
  template <std::integral Number>
  Json(Number number) : scalar_(std::to_string(number)) {}
  Json(const std::string& text);
  Json(const char* text) : Json(std::string(text)) {}
  template <typename Items>
  requires requires(const Items& items) { items.begin(); }
  Json(const Items& items) : Json(array()) {
    for (const auto& item : items) {
      push_back(Json(item));
    }
  }
  Json(std::initializer_list<Member> members);
  [[nodiscard]] static Json array();
  [[nodiscard]] static Json object();

  void push_back(Json item);
  /// The value of a name, null if it is new.
  Json& operator[](const std::string& name);

  /// The document, indented by two blanks per level.
  [[nodiscard]] std::string dump() const;

 private:
  enum class Kind { scalar, array, object };

  void append_to(std::string& text, std::size_t indent) const;

  Kind kind_ = Kind::scalar;
  std::string scalar_ = "null";
  std::vector<std::string> names_;  ///< of an object's values
  std::vector<Json> values_;
};

}  // namespace assur::text
