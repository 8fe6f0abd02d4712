#include <algorithm>
#include <assur/text/names.hpp>
#include <assur/text/suggestion.hpp>
#include <cctype>
#include <numeric>

namespace assur::text {

namespace {

char lower(char letter) {
  return static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
}

/// The Levenshtein distance, ignoring case.
std::size_t edit_distance(const std::string& left, const std::string& right) {
  std::vector<std::size_t> row(right.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= left.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= right.size(); ++j) {
      const std::size_t replaced = diagonal + (lower(left[i - 1]) == lower(right[j - 1]) ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row.back();
}

}  // namespace

std::string suggestion(const std::string& name, const std::vector<std::string>& candidates) {
  constexpr std::size_t longest_name = 64;
  const std::string* best = nullptr;
  std::size_t best_distance = 3;
  for (const std::string& candidate : candidates) {
    if (name.size() > longest_name || candidate.size() > longest_name) {
      continue;
    }
    const std::size_t distance = edit_distance(name, candidate);
    const bool shares_half = 2 * distance <= std::max(name.size(), candidate.size());
    if (distance < best_distance && shares_half) {
      best = &candidate;
      best_distance = distance;
    }
  }
  return best == nullptr ? "" : " (did you mean '" + *best + "'?)";
}

std::string suggestion_or_choice(const std::string& name,
                                 const std::vector<std::string>& candidates) {
  constexpr std::size_t longest_list = 120;
  const std::string near = suggestion(name, candidates);
  const std::string all = listed(candidates);
  return !near.empty() || all.empty() || all.size() > longest_list ? near
                                                                   : " (choose from " + all + ")";
}

}  // namespace assur::text
