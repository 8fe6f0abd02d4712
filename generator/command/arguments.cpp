#include "command/arguments.hpp"

#include <algorithm>
#include <array>
#include <assur/text/names.hpp>
#include <assur/text/numbers.hpp>
#include <assur/text/quoted.hpp>
#include <assur/text/suggestion.hpp>
#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>

namespace assur::generator::command {

namespace {

bool has(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace

std::string complaint_of_word(const std::string& word, const std::vector<std::string>& words) {
  return has(words, word) ? ""
                          : text::in_quotes(word) + " is not one of " + text::listed(words) +
                                text::suggestion(word, words);
}

std::string complaint_of_whole_number(const std::string& text, int most) {
  int number = 0;
  const char* const end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, number);
  if (at == end && error == std::errc() && number >= 1 && number <= most) {
    return "";
  }
  const bool is_large = at == end && !text.empty() && !text.starts_with('-') &&
                        (error == std::errc::result_out_of_range || number > most);
  return is_large ? "the number " + text::shortened(text) + " is too large; give one up to " +
                        std::to_string(most)
                  : "expected a whole number from 1 on, found " + text::in_quotes(text);
}

std::string complaint_of_number(const std::string& text, double least, double most) {
  double number = 0;
  const char* const end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, number);
  if (at == end && error == std::errc() && number >= least && number <= most) {
    return "";
  }
  return "expected a number from " + text::short_number(least, 6) + " to " +
         text::short_number(most, 6) + ", found " + text::in_quotes(text);
}

std::string complaint_of_options(const std::vector<std::string>& words,
                                 const std::vector<std::string>& options) {
  for (const std::string& word : words) {
    const std::string option = word.substr(0, word.find('='));
    if (option.size() > 2 && option.starts_with("--") && !has(options, option)) {
      return "no option " + text::in_quotes(option) + text::suggestion(option, options);
    }
  }
  return "";
}

std::string complaint_of_library(const std::string& text) {
  const std::string_view words = text;
  const auto between = [words](std::string_view before, std::string_view after) {
    const std::size_t begin = words.find(before);
    const std::size_t end = words.find(after, begin == std::string_view::npos ? 0 : begin);
    return begin == std::string_view::npos || end == std::string_view::npos
               ? std::string()
               : std::string(words.substr(begin + before.size(), end - begin - before.size()));
  };
  const std::string option = between("", ": ");
  if (words.starts_with("--") && words.ends_with(" missing")) {
    return option + " needs a value";
  }
  if (words.starts_with("--") && words.substr(option.size()).starts_with(": At Most 1 required")) {
    return option + " may be given only once";
  }
  constexpr std::string_view requires_word = " requires ";
  const std::size_t needed = words.find(requires_word);
  if (words.starts_with("--") && needed != std::string_view::npos) {
    const std::string given = text.substr(0, needed);
    const std::string other = text.substr(needed + requires_word.size());
    return given + " has an effect only with " + other + "; add " + other + ", or leave " + given +
           " out";
  }
  constexpr std::string_view excludes_word = " excludes ";
  const std::size_t excluded = words.find(excludes_word);
  if (words.starts_with("--") && excluded != std::string_view::npos) {
    return text.substr(0, excluded) + " and " + text.substr(excluded + excludes_word.size()) +
           " exclude each other; leave one of them out";
  }
  if (words.starts_with("Exactly 1 option from [")) {
    std::string choices;
    for (const char letter : between("[", "]")) {
      choices += letter == ',' ? std::string(", ") : std::string(1, letter);
    }
    return "give exactly one of " + choices;
  }
  return text;
}

}  // namespace assur::generator::command
