// The parsers that fuzzing and the corpus test call: each answers or refuses any text.
#pragma once

#include <string>

namespace assur::test::fuzz {

/// Each reads a text as its parser does. A text that cannot be used is refused in one line that is
/// not empty; everything else, an exception of another type among it, is a fault. Throws
/// std::logic_error for a refusal that is not such a line.
void read_scene_text(const std::string& text);
/// A file of another program, and the scene that is made of it.
void read_import_text(const std::string& text);
void read_expression_text(const std::string& text);
void read_closures_text(const std::string& text);
void read_audit_text(const std::string& text);
/// The first line tells the language: `m`, or anything else for C++.
void read_code_text(const std::string& text);
/// A paper and the map of its notation, which a line of three hyphens divides.
void read_paper_text(const std::string& text);

}  // namespace assur::test::fuzz
