// Quotation of user input in messages: short and on one line.
#pragma once

#include <string>

namespace assur::text {

/// The offset of the first control character other than white space: one of C0, C1 or bidirectional
/// text, which moves the cursor, begins a line or changes the display or order of other characters.
/// The text's size if there is none.
[[nodiscard]] std::size_t first_control_character(const std::string& text);

/// The text on one line: control characters and white space other than spaces become question
/// marks.
[[nodiscard]] std::string on_one_line(const std::string& text);

/// The first letters of a text on one line, with `...` where some are left out.
[[nodiscard]] std::string shortened(const std::string& text);

/// The same in quotes.
[[nodiscard]] std::string in_quotes(const std::string& text);

}  // namespace assur::text
