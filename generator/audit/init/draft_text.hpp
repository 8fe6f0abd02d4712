// Texts of drafts: the audit file of a program, the map of a paper, and single lines.
#pragma once

#include "audit/init/program_words.hpp"

namespace assur::generator::audit::init {

/// The draft of a program's audit file; `named` is the program's file in its statements. Throws
/// InputError where nothing can be audited.
[[nodiscard]] std::string program_draft(const std::string& code, Language language,
                                        const std::string& file, const std::string& named);

/// The draft of the map of a paper in LaTeX. Throws InputError where no displayed equation has a
/// symbol.
[[nodiscard]] std::string paper_draft(const std::string& paper, const std::string& file);

/// The beginning of a line that the user is to replace.
inline const std::string fill_mark = "# fill in: ";

/// The text as a line, with the line end.
[[nodiscard]] inline std::string line(const std::string& text) { return text + "\n"; }
[[nodiscard]] inline std::string marked(const std::string& text) { return line(fill_mark + text); }

}  // namespace assur::generator::audit::init
