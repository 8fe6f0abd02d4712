#include "campaign/description.hpp"

#include <algorithm>
#include <array>
#include <assur/text/error.hpp>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>
#include <sstream>

#include "campaign/csv_table.hpp"

namespace assur::generator::campaign {

namespace {

constexpr std::array<const char*, 3> kinds = {"whole", "outcome", "real"};
constexpr std::uint64_t most_shards = 1'000'000;

std::uint64_t whole_number(const std::string& text) {
  std::uint64_t number = 0;
  const char* const end = text.data() + text.size();
  const auto [at, error] = std::from_chars(text.data(), end, number);
  return error == std::errc() && at == end ? number : 0;
}

}  // namespace

std::string Shard::text() const { return std::to_string(number) + "/" + std::to_string(count); }

Shard shard_of(const std::string& text, const std::string& option) {
  const std::size_t slash = text.find('/');
  const bool has_both = slash != std::string::npos;
  const Shard shard{whole_number(text.substr(0, slash)),
                    has_both ? whole_number(text.substr(slash + 1)) : 0};
  if (shard.number < 1 || shard.number > shard.count || shard.count > most_shards) {
    throw text::InputError(
        option + ": '" + text +
        "' is not a part; expected I/N with 1 <= I <= N <= 1000000, such as 1/8");
  }
  return shard;
}

void Description::add(const std::string& name, const std::string& text) {
  std::string line = text;
  std::ranges::replace_if(
      line, [](char letter) { return static_cast<unsigned char>(letter) < 0x20; }, '?');
  entries.emplace_back(name, line);
}

void Description::add(const std::string& name, const std::vector<double>& numbers) {
  std::string text;
  for (const double number : numbers) {
    text += (text.empty() ? "" : " ") + number_text(number);
  }
  add(name, text);
}

std::string Description::text_of(const std::string& name) const {
  const auto found = std::ranges::find(entries, name, &std::pair<std::string, std::string>::first);
  return found == entries.end() ? "" : found->second;
}

std::vector<std::string> Description::texts_of(const std::string& name) const {
  std::vector<std::string> texts;
  for (const auto& [key, text] : entries) {
    if (key == name) {
      texts.push_back(text);
    }
  }
  return texts;
}

bool Description::has_kinds(std::vector<mechanism::Column::Kind> first) const {
  if (columns.size() < first.size()) {
    return false;
  }
  first.resize(columns.size(), mechanism::Column::Kind::real);
  return std::ranges::equal(columns, first, {}, &mechanism::Column::kind);
}

std::vector<double> Description::numbers_of(const std::string& name) const {
  std::vector<double> numbers;
  std::istringstream words(text_of(name));
  for (std::string word; words >> word;) {
    double number = std::numeric_limits<double>::quiet_NaN();
    (void)std::from_chars(word.data(), word.data() + word.size(), number);  // `-` is not a number
    numbers.push_back(number);
  }
  return numbers;
}

std::vector<std::pair<std::string, std::string>> Description::written() const {
  auto all = entries;
  all.emplace_back("items", std::to_string(items));
  all.emplace_back("shard", shard.text());
  std::string words;
  for (const mechanism::Column& column : columns) {
    words += (words.empty() ? "" : " ") + std::string(kinds[static_cast<std::size_t>(column.kind)]);
  }
  all.emplace_back("columns", words);
  return all;
}

Description Description::read(const std::vector<std::pair<std::string, std::string>>& written,
                              const std::string& where) {
  Description result;
  const auto refuse = [&where](const std::string& what) {
    throw text::InputError(where + ": " + what + ", so it is not a table of a campaign");
  };
  for (const auto& [name, text] : written) {
    if (name == "items") {
      result.items = whole_number(text);
    } else if (name == "shard") {
      result.shard = shard_of(text, where + ": shard");
    } else if (name == "columns") {
      std::istringstream words(text);
      for (std::string word; words >> word;) {
        const auto* const kind = std::ranges::find(kinds, word);
        if (kind == kinds.end()) {
          refuse("a column holds '" + word + "'");
        }
        result.columns.push_back({"", static_cast<mechanism::Column::Kind>(kind - kinds.begin())});
      }
    } else {
      result.add(name, text);
    }
  }
  if (result.entries.empty() || result.entries[0].first != "assur" || result.columns.empty()) {
    refuse("the file has no description of the rows of a campaign");
  }
  const auto canonical = result.written();
  const auto [own, given] = std::ranges::mismatch(canonical, written);
  if (own != canonical.end() || given != written.end() || result.items == 0) {
    refuse("the line '" + (own == canonical.end() ? given->first : own->first) +
           "' of its description is missing, doubled or changed");
  }
  return result;
}

std::string difference(const Description& one, const Description& other) {
  const auto differs = [](const std::string& name, const std::string& first,
                          const std::string& second) {
    return (name == "assur" ? "campaign" : name) + ": " + (first.empty() ? "none" : first) +
           " instead of " + (second.empty() ? "none" : second);
  };
  const std::size_t most = std::max(one.entries.size(), other.entries.size());
  for (std::size_t place = 0; place < most; ++place) {
    const std::pair<std::string, std::string> none;
    const auto& first = place < one.entries.size() ? one.entries[place] : none;
    const auto& second = place < other.entries.size() ? other.entries[place] : none;
    if (first.first != second.first) {
      // The difference is the entry that one of them lacks, not the entries that it shifts.
      const std::string& name =
          first.first.empty() || one.text_of(second.first).empty() ? second.first : first.first;
      return differs(name, one.text_of(name), other.text_of(name));
    }
    if (first.second != second.second) {
      return differs(first.first, first.second, second.second);
    }
  }
  if (one.items != other.items) {
    return differs("items", std::to_string(one.items), std::to_string(other.items));
  }
  const std::string first = csv_head(one.columns);
  const std::string second = csv_head(other.columns);
  return first == second ? "" : differs("columns", first, second);
}

std::string number_text(double number) {
  if (!std::isfinite(number)) {
    return "-";
  }
  std::array<char, 32> text{};
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), number + 0.0);
  (void)error;  // 24 characters suffice
  return {text.data(), end};
}

std::string hash_of(const std::string& text) {
  std::uint64_t hash = 14695981039346656037U;
  for (const char letter : text) {
    hash = (hash ^ static_cast<unsigned char>(letter)) * 1099511628211U;
  }
  std::array<char, 17> digits{};
  (void)std::snprintf(digits.data(), digits.size(), "%016llx",
                      static_cast<unsigned long long>(hash));
  return digits.data();
}

std::string axis_text(const NamedAxis& axis) {
  return axis.name + " " + number_text(axis.from) + " " + number_text(axis.to) + " " +
         std::to_string(axis.count);
}

std::vector<NamedAxis> axes_of(const Description& description) {
  std::vector<NamedAxis> axes;
  for (const std::string& text : description.texts_of("axis")) {
    NamedAxis axis{};
    std::istringstream(text) >> axis.name >> axis.from >> axis.to >> axis.count;
    axes.push_back(axis);
  }
  return axes;
}

}  // namespace assur::generator::campaign
