#include "audit/init/given_matrix.hpp"

#include <algorithm>
#include <regex>

namespace assur::generator::audit::init {

namespace {

/// Names the entries by the variables that they consist of.
void name_entries(Given& given) {
  given.names.clear();
  for (const Words& entry : given.entries) {
    const bool is_name = entry.size() == 1 && entry[0].is_name();
    given.names.push_back(is_name ? entry[0].text : "");
  }
}

std::size_t first_bracket(Words words) {
  std::size_t at = 0;
  while (at < words.size() && (words[at].is_name() || words[at].kind == Word::Kind::number ||
                               is_one_of(words[at], {".", "::", "<", ">", ","}))) {
    ++at;
  }
  return at < words.size() && is_one_of(words[at], {"(", "{"}) ? at : words.size();
}

}  // namespace

std::optional<Given> MatrixReader::variable(const std::string& name, int hops) const {
  std::optional<MatrixSize> size;
  if (const auto found = set_.lengths.find(name); found != set_.lengths.end()) {
    size = found->second;
  } else if (const auto type = set_.types.find(name); type != set_.types.end()) {
    size = size_of_type(type->second);
  } else if (const Argument* const given = find_argument(arguments_, name)) {
    size = size_of_type(given->type);
  }
  if (const auto found = set_.streamed.find(name); found != set_.streamed.end() && size) {
    Given given{name, size->rows, size->columns, parts(found->second, ","), {}, {}};
    name_entries(given);
    return given;
  }
  const auto set = set_.last_values.find(name);
  std::optional<Given> initial = set == set_.last_values.end() || hops > most_hops
                                     ? std::nullopt
                                     : value(set->second, hops + 1);
  if (initial) {
    initial->name = name;
  }
  const auto elements = set_.elements.find(name);
  if (elements == set_.elements.end()) {
    return with_size(initial, size);
  }
  if (initial && !size) {
    size = MatrixSize{initial->rows, initial->columns};
  }
  if (!size || size->rows * size->columns <= 1) {
    size = MatrixSize{0, 0};
    for (const auto& [place, entry] : elements->second) {
      size->rows = std::max(size->rows, place.first + 1);
      size->columns = std::max(size->columns, place.second + 1);
    }
  }
  if (size->rows * size->columns > most_entries) {
    return std::nullopt;
  }
  Given given{name, size->rows, size->columns, {}, {}, {}};
  static const std::vector<Word> zero = {{Word::Kind::number, "0"}};
  for (std::size_t row = 0; row < size->rows; ++row) {
    for (std::size_t column = 0; column < size->columns; ++column) {
      const auto entry = elements->second.find({row, column});
      given.entries.push_back(entry == elements->second.end() ? Words(zero) : entry->second);
    }
  }
  name_entries(given);
  return given;
}

std::optional<Given> MatrixReader::value(Words words, int hops) const {
  if (hops > most_hops || words.empty()) {
    return std::nullopt;
  }
  if (words[0].is("(") && is_whole_bracket(words)) {
    return value(inside(words, 0), hops + 1);
  }
  if (words.size() == 1 && words[0].is_name() &&
      find_argument(arguments_, words[0].text) == nullptr) {
    const std::string& name = words[0].text;
    const bool known = set_.last_values.contains(name) || set_.elements.contains(name) ||
                       set_.streamed.contains(name) || set_.types.contains(name);
    std::optional<Given> given = known ? variable(name, hops + 1) : std::nullopt;
    return given;
  }
  if (std::optional<Given> zeros = cleared(words)) {
    return zeros;
  }
  // `np.array([...])`, `Matrix([...])`, `Eigen::Vector2d(a, b)`, `std::array<double, 2>{a, b}`
  const std::size_t open = first_bracket(words);
  if (open > 0 && open < words.size() && behind_bracket(words, open) == words.size()) {
    const std::string callee = spelled(words.subspan(0, open));
    const Words content = inside(words, open);
    const std::vector<Words> list = parts(content, ",");
    if (const std::optional<MatrixSize> size =
            is_c_or_cpp(language_) ? size_of_type(callee) : std::nullopt) {
      Given given{"", size->rows, size->columns, list, {}, {}};
      name_entries(given);
      return given;
    }
    static const std::regex wrapper("(\\w+\\.)?(array|asarray|Matrix|matrix|ImmutableMatrix)");
    if (callee.size() <= longest_type && std::regex_match(callee, wrapper) && !list.empty()) {
      return value(list[0], hops + 1);
    }
  }
  if (is_one_of(words[0], {"[", "{"}) && is_whole_bracket(words)) {
    return list_of(inside(words, 0));
  }
  if (std::optional<Given> list = list_within(words)) {
    return list;
  }
  return Given{"", 1, 1, {words}, {}, {}};
}

/// A list within a product or a sum: its size is known, its entries are not.
std::optional<Given> MatrixReader::list_within(Words words) const {
  for (std::size_t at = 0; at < words.size(); ++at) {
    const bool begins =
        at == 0 || (!words[at - 1].is_name() && !is_one_of(words[at - 1], {")", "]"}) &&
                    words[at - 1].kind != Word::Kind::number);
    if (words[at].is("[") && (begins || is_one_of(words[at - 1], {"return"}))) {
      std::optional<Given> list = list_of(inside(words, at));
      if (list) {
        list->entries.clear();
        list->names.clear();
      }
      return list;
    }
    if (words[at].is("[")) {
      at = behind_bracket(words, at) - 1;
    }
  }
  return std::nullopt;
}

std::optional<Given> MatrixReader::jacobian(Words words) const {
  if (words.size() < 5 || !words[1].is(".") || !words[2].is("jacobian") || !words[3].is("(")) {
    return std::nullopt;
  }
  const std::optional<Given> of = variable(words[0].text, 0);
  const Words content = inside(words, 3);
  const std::optional<Given> by = value(content, 0);
  if (!of || !by || by->columns != 1) {
    return std::nullopt;
  }
  Given given{"", of->rows, by->rows, {}, {}, by->names};
  return given;
}

/// `zeros(2, 3)`, `np.zeros((2, 2))`.
std::optional<Given> MatrixReader::cleared(Words words) const {
  for (std::size_t at = 0; at + 2 < words.size() && at < 3; ++at) {
    if (is_one_of(words[at], {"zeros", "empty", "zeros_like"}) && words[at + 1].is("(")) {
      Words content = inside(words, at + 1);
      if (!content.empty() && is_one_of(content[0], {"(", "["})) {
        content = inside(content, 0);
      }
      const std::vector<Words> list = parts(content, ",");
      const bool are_numbers = !list.empty() && list.size() < 3 &&
                               std::all_of(list.begin(), list.end(), [](const Words& size) {
                                 return size.size() == 1 && is_whole(size[0]);
                               });
      if (!are_numbers) {
        return std::nullopt;
      }
      const std::size_t first = number_of(list[0][0]);
      const std::size_t second = list.size() == 2                ? number_of(list[1][0])
                                 : language_ == Language::matlab ? first
                                                                 : 1;
      return Given{"", first, second, {}, {}, {}};
    }
  }
  return std::nullopt;
}

std::optional<Given> MatrixReader::list_of(Words content) const {
  std::vector<Words> rows = parts(content, language_ == Language::matlab ? ";" : ",");
  Given given{"", rows.size(), 1, {}, {}, {}};
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const bool nested = is_whole_bracket(rows[row]) && is_one_of(rows[row][0], {"[", "{"});
    std::vector<Words> entries = language_ == Language::matlab ? parts(rows[row], ",")
                                 : nested                      ? parts(inside(rows[row], 0), ",")
                                                               : std::vector<Words>{rows[row]};
    given.columns = row == 0 ? entries.size() : given.columns;
    if (entries.empty() || entries.size() != given.columns) {
      return std::nullopt;
    }
    given.entries.insert(given.entries.end(), entries.begin(), entries.end());
  }
  name_entries(given);
  return given;
}

std::optional<Given> with_size(std::optional<Given> given, std::optional<MatrixSize> size) {
  if (!size) {
    return given;
  }
  Given sized = given.value_or(Given());
  sized.rows = size->rows;
  sized.columns = size->columns;
  if (sized.entries.size() != sized.rows * sized.columns) {
    sized.entries.clear();
    sized.names.clear();
  }
  return sized;
}

}  // namespace assur::generator::audit::init
