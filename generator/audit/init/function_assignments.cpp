#include "audit/init/function_assignments.hpp"

#include <algorithm>
#include <regex>

namespace assur::generator::audit::init {

namespace {

class AssignmentReader {
 public:
  AssignmentReader(Language language, const std::vector<std::string>& arguments,
                   std::vector<std::vector<Word>>& more_words)
      : language_(language), arguments_(arguments), more_words_(more_words) {}

  Assignments read(const std::vector<Words>& statements) {
    for (const Words& statement : statements) {
      read_statement(statement);
    }
    for (const std::string& name : arguments_) {
      if (const auto found = set_.unpacked.find(name); found != set_.unpacked.end()) {
        set_unpacked(name, found->second);
      }
    }
    return std::move(set_);
  }

 private:
  [[nodiscard]] bool is_argument(const std::string& name) const {
    return std::find(arguments_.begin(), arguments_.end(), name) != arguments_.end();
  }

  void read_statement(Words words) {
    while (!words.empty() && is_one_of(words[0], {"const", "let", "var", "static", "constexpr"})) {
      words = words.subspan(1);
    }
    if (words.empty()) {
      return;
    }
    if (words[0].is("return")) {
      set_.returned = words.subspan(1);
      return;
    }
    if (const std::size_t at = find_mark(words, "<<"); at == 1 && words[0].is_name()) {
      set_.streamed[words[0].text] = words.subspan(2);
      return;
    }
    const std::size_t equals = find_mark(words, "=");
    if (equals == words.size()) {
      read_declaration(words);
      return;
    }
    const Words target = words.subspan(0, equals);
    Words value = words.subspan(equals + 1);
    if (language_ != Language::python && language_ != Language::matlab) {
      const std::vector<Words> list = parts(value, ",");
      if (list.size() > 1) {
        value = list[0];
        std::for_each(list.begin() + 1, list.end(),
                      [&](const Words& more) { read_statement(more); });
      }
    }
    assign(target, value);
  }

  void assign(Words target, Words value) {
    if (target.empty()) {
      return;
    }
    const bool in_brackets = is_whole_bracket(target);
    const std::vector<Words> names = parts(in_brackets ? inside(target, 0) : target, ",");
    if ((names.size() > 1 && !is_c_or_cpp(language_)) || in_brackets) {
      unpack(names, value, target[0].is("{"));
      return;
    }
    if (read_element(target, value)) {
      return;
    }
    read_declaration(target);
    if (target.back().is_name() && !(target.size() > 1 && target[target.size() - 2].is("."))) {
      set_.first_values.try_emplace(target.back().text, value);
      set_.last_values[target.back().text] = value;
    }
  }

  void unpack(const std::vector<Words>& names, Words value, bool by_name) {
    std::vector<std::string> list;
    for (const Words& each : names) {
      if (each.size() != 1 || !each[0].is_name()) {
        return;
      }
      list.push_back(each[0].text);
    }
    const std::vector<Words> values = parts(value, ",");
    if (values.size() == list.size() && list.size() > 1) {
      for (std::size_t at = 0; at < list.size(); ++at) {
        set_.first_values.try_emplace(list[at], values[at]);
      }
    } else if (value.size() == 1 && is_argument(value[0].text)) {
      set_.unpacked[value[0].text] = list;
      if (by_name) {
        set_.unpacked_by_name.insert(value[0].text);
      }
    }
  }

  /// `A(i, j) = value`, `A[i][j] = value`, `A[i, j] = value`, `A(i) = value`.
  bool read_element(Words target, Words value) {
    if (target.size() < 4 || !target[0].is_name() || !is_one_of(target[1], {"[", "("})) {
      return false;
    }
    std::vector<Words> indices;
    std::size_t at = 1;
    for (; at < target.size() && is_one_of(target[at], {"[", "("});
         at = behind_bracket(target, at)) {
      const std::vector<Words> list = parts(inside(target, at), ",");
      indices.insert(indices.end(), list.begin(), list.end());
    }
    const bool are_numbers = std::all_of(indices.begin(), indices.end(), [](const Words& index) {
      return index.size() == 1 && is_whole(index[0]);
    });
    std::map<std::pair<std::size_t, std::size_t>, Words>& elements = set_.elements[target[0].text];
    const bool too_low =
        are_numbers && std::any_of(indices.begin(), indices.end(), [&](const Words& index) {
          return number_of(index[0]) < first_index(language_);
        });
    if (at != target.size() || !are_numbers || too_low || indices.empty() || indices.size() > 2) {
      return true;  // an element, but its indices are unknown
    }
    const std::size_t row = number_of(indices[0][0]) - first_index(language_);
    const std::size_t column =
        indices.size() == 2 ? number_of(indices[1][0]) - first_index(language_) : 0;
    elements[{row, column}] = value;
    return true;
  }

  /// `Eigen::Matrix2d J`, `double J[2][2]`.
  void read_declaration(Words words) {
    if (!is_c_or_cpp(language_) || words.size() < 2) {
      return;
    }
    std::size_t name = 0;
    for (std::size_t at = 0; at < words.size() && !is_one_of(words[at], {"[", "(", "{", "."});
         ++at) {
      name = words[at].is_name() ? at : name;
    }
    if (name == 0) {
      return;
    }
    set_.types[words[name].text] = spelled(words.subspan(0, name));
    std::vector<std::size_t> sizes;
    for (std::size_t at = name + 1;
         at + 1 < words.size() && words[at].is("[") && is_whole(words[at + 1]);
         at = behind_bracket(words, at)) {
      sizes.push_back(number_of(words[at + 1]));
    }
    if (!sizes.empty()) {
      set_.lengths[words[name].text] = {sizes[0], sizes.size() > 1 ? sizes[1] : 1};
    }
  }

  void set_unpacked(const std::string& argument, const std::vector<std::string>& variables) {
    const bool by_name = set_.unpacked_by_name.contains(argument);
    for (std::size_t at = 0; at < variables.size(); ++at) {
      set_.first_values.try_emplace(variables[at],
                                    part_words(argument, at, by_name, variables[at]));
    }
  }

  /// `q[1]` or `q.name`, the meaning of a variable that is unpacked from `q`.
  Words part_words(const std::string& whole, std::size_t at, bool by_name,
                   const std::string& name) {
    const auto mark = [](const char* text) { return Word{Word::Kind::mark, text}; };
    const Word of{Word::Kind::name, whole};
    more_words_.push_back(
        by_name ? std::vector<Word>{of, mark("."), {Word::Kind::name, name}}
                : std::vector<Word>{
                      of, mark("["), {Word::Kind::number, std::to_string(at)}, mark("]")});
    return more_words_.back();
  }

  Language language_;
  const std::vector<std::string>& arguments_;
  std::vector<std::vector<Word>>& more_words_;
  Assignments set_;
};

}  // namespace

std::optional<MatrixSize> size_of_type(const std::string& type) {
  static const std::regex fixed("(Matrix|RowVector|Vector)([234])[df]");
  static const std::regex matrix("Matrix<\\w+, ?(\\d\\d?), ?(\\d\\d?)");
  static const std::regex rows("array<(?:std::)?array<\\w+, ?(\\d\\d?)>, ?(\\d\\d?)>");
  static const std::regex list("array<\\w+, ?(\\d\\d?)>");
  std::smatch found;
  if (type.size() > longest_type) {
    return std::nullopt;
  }
  if (std::regex_search(type, found, fixed)) {
    const std::size_t size = std::stoul(found[2]);
    return found[1] == "Matrix"   ? MatrixSize{size, size}
           : found[1] == "Vector" ? MatrixSize{size, 1}
                                  : MatrixSize{1, size};
  }
  if (std::regex_search(type, found, matrix)) {
    return MatrixSize{std::stoul(found[1]), std::stoul(found[2])};
  }
  if (std::regex_search(type, found, rows)) {
    return MatrixSize{std::stoul(found[2]), std::stoul(found[1])};
  }
  if (std::regex_search(type, found, list)) {
    return MatrixSize{std::stoul(found[1]), 1};
  }
  return std::nullopt;
}

Assignments assignments_of(const Source& source, Language language,
                           const std::vector<std::string>& arguments,
                           std::vector<std::vector<Word>>& more_words) {
  return AssignmentReader(language, arguments, more_words).read(source.statements);
}

}  // namespace assur::generator::audit::init
