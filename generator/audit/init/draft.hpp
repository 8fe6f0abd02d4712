// Drafts of audit files and maps from programs and papers, with marks to be filled in.
#pragma once

#include <string>

namespace assur::generator::audit::init {

/// The draft for a program (by the ending of its name), or the map for a paper (.tex). `named` is
/// the file's name in the draft. Throws InputError where there is nothing to audit.
[[nodiscard]] std::string draft_of(const std::string& file, const std::string& named);

/// Throws InputError at the first unfilled mark in an audit file or a map.
void expect_filled_in(const std::string& text, const std::string& file);

}  // namespace assur::generator::audit::init
