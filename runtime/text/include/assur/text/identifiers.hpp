// Turns the names of a scene into identifiers and comments of C++.
#pragma once

#include <string>
#include <vector>

namespace assur::text {

/// The text with `_` for all but letters and digits, and in front of a leading digit: what CMake's
/// MAKE_C_IDENTIFIER makes of it.
[[nodiscard]] std::string c_identifier(const std::string& text);

/// The header for a file, without its ending: the above, with one `_` for several and none at the
/// ends. Names that differ in punctuation alone have the same, as they have the same struct.
[[nodiscard]] std::string header_name(const std::string& stem);

/// The struct for a file: `four-bar_2` as `FourBar2`, with a word in front of a leading digit and
/// of a word that the templates or a macro have taken.
[[nodiscard]] std::string struct_name(const std::string& stem, const std::string& word = "Scene");

/// Identifiers for the members of one struct: different from each other, from keywords, macros,
/// words of the templates and `taken`, in the order of the names.
[[nodiscard]] std::vector<std::string> member_names(const std::vector<std::string>& names,
                                                    const std::vector<std::string>& taken);

}  // namespace assur::text
