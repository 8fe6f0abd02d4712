// Fills in a template with the values of a view.
#pragma once

#include <map>
#include <string>
#include <variant>
#include <vector>

namespace assur::generator::emission::cpp {

/// Named values of a template: texts, whether a section is shown, and lists of views.
class View {
 public:
  using List = std::vector<View>;
  using Value = std::variant<std::string, bool, List>;

  View() = default;
  View(const std::string& name, std::string text) { set(name, std::move(text)); }

  void set(const std::string& name, std::string text) { values_[name] = std::move(text); }
  void set(const std::string& name, const char* text) { values_[name] = std::string(text); }
  void set(const std::string& name, bool stands) { values_[name] = stands; }
  void set(const std::string& name, List list) { values_[name] = std::move(list); }

  [[nodiscard]] const std::map<std::string, Value>& values() const { return values_; }

 private:
  std::map<std::string, Value> values_;
};

/// One view per line, whose value `line` is that line.
[[nodiscard]] View::List line_list(const std::vector<std::string>& lines,
                                   const std::string& indentation = "");

[[nodiscard]] std::string boolean(bool value);

/// A user's text for a comment: one line, without a backslash that would continue it.
[[nodiscard]] std::string comment_text(std::string text);

/// A template of templates/ filled in, with its lines broken at 100 columns. It may include other
/// templates; lines that contain only a section's tag leave no blank line.
[[nodiscard]] std::string page(const std::string& name, const View& view);

}  // namespace assur::generator::emission::cpp
