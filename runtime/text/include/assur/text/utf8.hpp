// Turns bytes into the place where they stop being text.
#pragma once

#include <string>

namespace assur::text {

/// The offset of the first byte that is not part of a letter in UTF-8; the text's size if all are.
[[nodiscard]] std::size_t first_byte_outside_utf8(const std::string& text);

}  // namespace assur::text
