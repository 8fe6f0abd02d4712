// One-line messages about errors in the words of a command line.
#pragma once

#include <string>
#include <vector>

namespace assur::generator::command {

/// The error of a word that must be one of `words`; empty if it is.
[[nodiscard]] std::string complaint_of_word(const std::string& word,
                                            const std::vector<std::string>& words);

/// The error in the text of an integer from 1 to `most`; empty if it is one.
[[nodiscard]] std::string complaint_of_whole_number(const std::string& text, int most);

/// The error in the text of a number from `least` to `most`; empty if it is one.
[[nodiscard]] std::string complaint_of_number(const std::string& text, double least, double most);

/// The error of the first word of a command line that looks like an option and is not one of
/// `options`; empty if there is no such word.
[[nodiscard]] std::string complaint_of_options(const std::vector<std::string>& words,
                                               const std::vector<std::string>& options);

/// Rewrites the library's messages about a missing or repeated value, and about options that
/// require or exclude each other, as sentences. Its other messages are sentences already.
[[nodiscard]] std::string complaint_of_library(const std::string& text);

}  // namespace assur::generator::command
