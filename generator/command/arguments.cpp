#include "command/arguments.hpp"

#include <algorithm>
#include <array>
#include <assur/text/names.hpp>
#include <assur/text/suggestion.hpp>
#include <charconv>
#include <limits>
#include <regex>
#include <utility>

namespace assur::generator::command {

namespace {

bool has(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace

std::string complaint_of_word(const std::string& word, const std::vector<std::string>& words) {
  return has(words, word) ? ""
                          : "'" + word + "' is not one of " + text::listed(words) +
                                text::suggestion(word, words);
}

std::string complaint_of_number(const std::string& text) {
  constexpr int most = std::numeric_limits<int>::max();
  int number = 0;
  const char* const end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, number);
  if (at == end && error == std::errc() && number >= 1) {
    return "";
  }
  if (at == end && error == std::errc::result_out_of_range && !text.starts_with('-')) {
    return "the number " + text + " is too large; give one up to " + std::to_string(most);
  }
  return "expected a whole number from 1 on, found '" + text + "'";
}

std::string complaint_of_options(const std::vector<std::string>& words,
                                 const std::vector<std::string>& options) {
  for (const std::string& word : words) {
    const std::string option = word.substr(0, word.find('='));
    if (option.size() > 2 && option.starts_with("--") && !has(options, option)) {
      return "no option '" + option + "'" + text::suggestion(option, options);
    }
  }
  return "";
}

std::string complaint_of_library(const std::string& text) {
  const std::array<std::pair<std::regex, const char*>, 4> sentences = {
      {{std::regex("^(--[a-z-]+): .* required .*missing$"), "$1 needs a value"},
       {std::regex("^(--[a-z-]+): At Most 1 required.*$"), "$1 may be given only once"},
       {std::regex("^(--[a-z-]+) requires (--[a-z-]+)$"),
        "$1 has an effect only with $2; add $2, or leave $1 out"},
       {std::regex("^Exactly 1 option from \\[(\\S+),(\\S+),(\\S+),(\\S+)\\] is required.*$"),
        "give exactly one of $1, $2, $3, $4"}}};
  std::string result = text;
  for (const auto& [pattern, sentence] : sentences) {
    result = std::regex_replace(result, pattern, sentence);
  }
  return result;
}

}  // namespace assur::generator::command
