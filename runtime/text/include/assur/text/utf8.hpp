// Turns bytes into the place where they stop being text, and into a message that names it.
#pragma once

#include <string>

namespace assur::text {

/// The offset of the first byte that is not part of a letter in UTF-8; the text's size if all are.
[[nodiscard]] std::size_t first_byte_outside_utf8(const std::string& text);

/// Throws InputError with `name`, the line and the column of the first NUL byte, if there is one:
/// it ends a text for some readers and not for others.
void expect_no_nul(const std::string& text, const std::string& name);

}  // namespace assur::text
