// Turns what is wrong with the words of a command line into a line that says what was meant.
#pragma once

#include <string>
#include <vector>

namespace assur::generator::command {

/// What is wrong with a word that must be one of a few: nothing if it is.
[[nodiscard]] std::string complaint_of_word(const std::string& word,
                                            const std::vector<std::string>& words);

/// What is wrong with the text of a whole number from 1 to `most`: nothing if it is one.
[[nodiscard]] std::string complaint_of_whole_number(const std::string& text, int most);

/// What is wrong with the text of a number from `least` to `most`: nothing if it is one.
[[nodiscard]] std::string complaint_of_number(const std::string& text, double least, double most);

/// The first word of a command line that looks like an option and is not one of these; nothing if
/// there is no such word.
[[nodiscard]] std::string complaint_of_options(const std::vector<std::string>& words,
                                               const std::vector<std::string>& options);

/// What the library of command lines says of a missing or repeated value, and of options that go
/// together or exclude each other, as a sentence; other texts of it are sentences already and stay.
[[nodiscard]] std::string complaint_of_library(const std::string& text);

}  // namespace assur::generator::command
