// Turns a list of names into text for messages.
#pragma once

#include <string>
#include <vector>

namespace assur::generator {

/// `A, B, C`.
[[nodiscard]] inline std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) {
    text += (text.empty() ? "" : ", ") + name;
  }
  return text;
}

}  // namespace assur::generator
