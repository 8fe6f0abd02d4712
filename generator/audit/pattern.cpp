#include "audit/pattern.hpp"

#include <regex>

namespace assur::generator::audit {

namespace {

PatternMatch parts_of(const std::cmatch& match, const std::string& text) {
  PatternMatch result;
  for (const auto& part : match) {
    const auto place = part.matched ? part.first - text.data() : 0;
    result.parts.push_back({part.matched, static_cast<std::size_t>(place), part.str()});
  }
  return result;
}

}  // namespace

struct Pattern::Compiled {
  std::regex regex;
};

Pattern::Pattern(const std::string& expression)
    : compiled_(std::make_shared<const Compiled>(Compiled{std::regex(expression)})) {}

std::optional<PatternMatch> Pattern::match(const std::string& text) const {
  std::cmatch match;
  if (!std::regex_match(text.data(), text.data() + text.size(), match, compiled_->regex)) {
    return std::nullopt;
  }
  return parts_of(match, text);
}

std::optional<PatternMatch> Pattern::search(const std::string& text, std::size_t from) const {
  std::cmatch match;
  const auto flags =
      from == 0 ? std::regex_constants::match_default : std::regex_constants::match_prev_avail;
  if (!std::regex_search(text.data() + from, text.data() + text.size(), match, compiled_->regex,
                         flags)) {
    return std::nullopt;
  }
  return parts_of(match, text);
}

}  // namespace assur::generator::audit
