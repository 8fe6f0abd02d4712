// Turns text into the content of an element or an attribute of XML.
#pragma once

#include <string>

namespace assur::text {

/// XML's own characters as entities; a question mark for each that XML cannot hold; and nothing
/// from the first byte on that is not UTF-8.
[[nodiscard]] std::string escaped_for_xml(const std::string& text);

}  // namespace assur::text
