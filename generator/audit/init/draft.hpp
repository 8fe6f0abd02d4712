// Turns a program or a paper into a draft of its audit file or map, in which what cannot be told
// is marked.
#pragma once

#include <string>

namespace assur::generator::audit::init {

/// The draft for a program (by the ending of its name), or the map for a paper (.tex).
/// `named` is the file as the draft names it. Throws InputError where there is nothing to audit.
[[nodiscard]] std::string draft_of(const std::string& file, const std::string& named);

/// Throws InputError at the first mark of a draft that is still in an audit file or a map.
void expect_filled_in(const std::string& text, const std::string& file);

}  // namespace assur::generator::audit::init
