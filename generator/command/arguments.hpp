// Turns errors in the words of a command line into one line that explains them.
#pragma once

#include <string>
#include <vector>

namespace assur::generator::command {

/// What is wrong with a word that must be one of `words`; empty if it is.
[[nodiscard]] std::string complaint_of_word(const std::string& word,
                                            const std::vector<std::string>& words);

/// What is wrong with the text of a whole number from 1 to `most`; empty if it is one.
[[nodiscard]] std::string complaint_of_whole_number(const std::string& text, int most);

/// What is wrong with the text of a number from `least` to `most`; empty if it is one.
[[nodiscard]] std::string complaint_of_number(const std::string& text, double least, double most);

/// What is wrong with the first word of a command line that looks like an option and is not one of
/// `options`; empty if there is no such word.
[[nodiscard]] std::string complaint_of_options(const std::vector<std::string>& words,
                                               const std::vector<std::string>& options);

/// Turns the library's messages about a missing or repeated value, and about options that require
/// or exclude each other, into sentences. Its other messages are sentences already and stay.
[[nodiscard]] std::string complaint_of_library(const std::string& text);

}  // namespace assur::generator::command
