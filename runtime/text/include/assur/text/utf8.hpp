// Validity checks of UTF-8 text.
#pragma once

#include <string>

namespace assur::text {

/// The offset of the first byte that is not part of a UTF-8 character; the text's size if there is
/// none.
[[nodiscard]] std::size_t first_byte_outside_utf8(const std::string& text);

/// Throws InputError with `name`, the line and the column of the first NUL byte, if there is one:
/// some readers end a text there, others do not.
void expect_no_nul(const std::string& text, const std::string& name);

}  // namespace assur::text
