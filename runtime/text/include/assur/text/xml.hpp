// Escaping of text for the content of XML elements and attributes.
#pragma once

#include <string>

namespace assur::text {

/// The text with XML's special characters as entities and a question mark for each character that
/// XML cannot represent, cut before the first byte that is not UTF-8.
[[nodiscard]] std::string escaped_for_xml(const std::string& text);

}  // namespace assur::text
