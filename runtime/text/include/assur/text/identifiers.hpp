// C++ identifiers and comments from the names in a scene.
#pragma once

#include <string>
#include <vector>

namespace assur::text {

/// The text with `_` in place of all but letters and digits, and in front of a leading digit, as in
/// CMake's MAKE_C_IDENTIFIER.
[[nodiscard]] std::string c_identifier(const std::string& text);

/// The name of the header for a file, without its ending: the above, with one `_` in place of
/// several and none at the ends. Names that differ only in punctuation give the same header and the
/// same struct.
[[nodiscard]] std::string header_name(const std::string& stem);

/// The name of the struct for a file: `four-bar_2` gives `FourBar2`. `word` is put in front of a
/// leading digit, and of a name used by the templates or a macro.
[[nodiscard]] std::string struct_name(const std::string& stem, const std::string& word = "Scene");

/// Identifiers for the members of one struct: different from each other, from keywords, macros,
/// words of the templates and `taken`, in the order of the names.
[[nodiscard]] std::vector<std::string> member_names(const std::vector<std::string>& names,
                                                    const std::vector<std::string>& taken);

}  // namespace assur::text
