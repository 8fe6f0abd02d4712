// Turns what a user wrote into how a message quotes it: short, and on one line.
#pragma once

#include <string>

namespace assur::text {

/// Whether a letter moves the cursor, or changes how a terminal writes, and is no white space.
[[nodiscard]] bool is_control_character(char letter);

/// The text on one line: control characters become question marks.
[[nodiscard]] std::string on_one_line(const std::string& text);

/// The first letters of a text on one line, with `...` where some are left out.
[[nodiscard]] std::string shortened(const std::string& text);

/// The same in quotes.
[[nodiscard]] std::string in_quotes(const std::string& text);

}  // namespace assur::text
