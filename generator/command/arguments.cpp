#include "command/arguments.hpp"

#include <algorithm>
#include <array>
#include <assur/text/names.hpp>
#include <assur/text/numbers.hpp>
#include <assur/text/quoted.hpp>
#include <assur/text/suggestion.hpp>
#include <charconv>
#include <string_view>
#include <utility>

namespace assur::generator::command {

namespace {

bool has(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

bool is_option(std::string_view word) {
  return word.starts_with("--") &&
         word.find_first_not_of("abcdefghijklmnopqrstuvwxyz-") == std::string_view::npos;
}

/// The two options of a text that consists of them and a word between them, else empty strings. A
/// user's values may contain such words, too.
std::pair<std::string, std::string> options_around(std::string_view text, std::string_view word) {
  const std::size_t at = text.find(word);
  if (at == std::string_view::npos) {
    return {};
  }
  const std::string_view first = text.substr(0, at);
  const std::string_view second = text.substr(at + word.size());
  return is_option(first) && is_option(second) ? std::pair{std::string(first), std::string(second)}
                                               : std::pair<std::string, std::string>();
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
  // With a leading zero it would be read as an octal number.
  if (at == end && error == std::errc() && number >= 1 && number <= most &&
      !text.starts_with('0')) {
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
  if (const auto [given, other] = options_around(words, " requires "); !given.empty()) {
    return given + " has an effect only with " + other + "; add " + other + ", or leave " + given +
           " out";
  }
  if (const auto [given, other] = options_around(words, " excludes "); !given.empty()) {
    return given + " and " + other + " exclude each other; leave one of them out";
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
