// Turns a regular expression and a text into what matches; one file alone compiles the standard
// library's machine for it, which costs seconds.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace assur::generator::audit {

/// The whole of a match and, behind it, its groups.
struct PatternMatch {
  struct Part {
    bool matched;
    std::size_t place;
    std::string text;
  };
  std::vector<Part> parts;

  [[nodiscard]] const std::string& operator[](std::size_t part) const { return parts[part].text; }
  [[nodiscard]] std::size_t end() const { return parts[0].place + parts[0].text.size(); }
};

/// A regular expression in the syntax of ECMAScript.
class Pattern {
 public:
  explicit Pattern(const std::string& expression);

  /// Of the whole text.
  [[nodiscard]] std::optional<PatternMatch> match(const std::string& text) const;
  /// The first from a place on.
  [[nodiscard]] std::optional<PatternMatch> search(const std::string& text,
                                                   std::size_t from = 0) const;

 private:
  struct Compiled;
  std::shared_ptr<const Compiled> compiled_;
};

}  // namespace assur::generator::audit
