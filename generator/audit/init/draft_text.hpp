// Holds the lines of a draft.
#pragma once

#include <string>

namespace assur::generator::audit::init {

/// What a line begins with that the user is to replace.
inline const std::string fill_mark = "# fill in: ";

/// A line of its own, with the line end.
[[nodiscard]] inline std::string line(const std::string& text) { return text + "\n"; }
[[nodiscard]] inline std::string marked(const std::string& text) { return line(fill_mark + text); }

}  // namespace assur::generator::audit::init
