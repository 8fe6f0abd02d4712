#include "audit/init/program_outline.hpp"

#include <algorithm>
#include <assur/text/expression.hpp>
#include <cstdlib>
#include <functional>
#include <optional>
#include <regex>

#include "audit/init/program_sources.hpp"

namespace assur::generator::audit::init {

namespace {

/// More entries than this are of no Jacobian that anybody audits.
constexpr std::size_t most_entries = 100;
/// How often one variable may stand for another.
constexpr int most_hops = 20;
/// Types and names of functions that are longer are none that are known here.
constexpr std::size_t longest_type = 200;

struct Size {
  std::size_t rows = 0;
  std::size_t columns = 0;
};

/// The size that a type of C++ says.
std::optional<Size> size_of_type(const std::string& type) {
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
    return found[1] == "Matrix"   ? Size{size, size}
           : found[1] == "Vector" ? Size{size, 1}
                                  : Size{1, size};
  }
  if (std::regex_search(type, found, matrix)) {
    return Size{std::stoul(found[1]), std::stoul(found[2])};
  }
  if (std::regex_search(type, found, rows)) {
    return Size{std::stoul(found[2]), std::stoul(found[1])};
  }
  if (std::regex_search(type, found, list)) {
    return Size{std::stoul(found[1]), 1};
  }
  return std::nullopt;
}

void name_elements(Argument& list, std::size_t first) {
  list.parts.clear();
  for (std::size_t at = 0; at < list.size; ++at) {
    list.parts.push_back(list.name + "_" + std::to_string(at + first));
  }
}

/// What has parts in one function has them in all that take it by the same name, also where they
/// only pass it on.
void unite_arguments(std::vector<ProgramFunction>& functions, std::size_t first) {
  std::map<std::string, Argument> largest;
  for (const ProgramFunction& function : functions) {
    for (const Argument& each : function.arguments) {
      Argument& found = largest[each.name];
      if (each.kind == Argument::Kind::list || each.kind == Argument::Kind::object) {
        found = each.parts.size() > found.parts.size() ? each : found;
      }
    }
  }
  for (ProgramFunction& function : functions) {
    for (Argument& each : function.arguments) {
      const Argument& found = largest.at(each.name);
      const bool is_one_number = each.kind == Argument::Kind::number &&
                                 (each.type == "double" || each.type == "float") && !each.is_array;
      if (each.name.empty() || found.parts.empty() || is_one_number ||
          each.kind == Argument::Kind::output) {
        continue;
      }
      each.kind = found.kind;
      each.members = found.members;
      each.size = found.size;
      each.parts = found.parts;
      if (each.kind == Argument::Kind::list) {
        name_elements(each, first);
      }
    }
  }
}

/// Fills one function from its source.
class FunctionReader {
 public:
  FunctionReader(const Source& source, Language language,
                 const std::map<std::string, std::vector<std::string>>& records,
                 std::vector<std::vector<Word>>& more_words)
      : source_(source), language_(language), records_(records), more_words_(more_words) {
    function_.name = source.name;
    function_.space = source.space;
  }

  /// The matrices at the top level of a module of SymPy.
  ProgramFunction module(const std::vector<std::string>& symbols) {
    for (const std::string& symbol : symbols) {
      Argument argument;
      argument.name = symbol;
      argument.parts = {symbol};
      function_.arguments.push_back(argument);
    }
    for (const Words& statement : source_.statements) {
      read_statement(statement);
    }
    find_angles();
    for (const Words& statement : source_.statements) {
      if (statement.size() < 4 || !statement[0].is_name() || !statement[1].is("=")) {
        continue;
      }
      const Words set = statement.subspan(2);
      std::optional<Given> given = derived_by(set);
      given = given ? given : value(set, 0);
      if (given && (given->rows > 1 || given->columns > 1 || !given->by.empty())) {
        given->name = statement[0].text;
        add_given(given);
      }
    }
    return std::move(function_);
  }

  ProgramFunction read() {
    for (const Words& parameter : parts(source_.parameters, ",")) {
      read_parameter(parameter);
    }
    for (const Words& statement : source_.statements) {
      read_statement(statement);
    }
    find_parts();
    find_angles();
    find_given();
    return std::move(function_);
  }

 private:
  [[nodiscard]] bool is_c() const { return language_ == Language::c || language_ == Language::cpp; }
  [[nodiscard]] std::size_t first_index() const { return language_ == Language::matlab ? 1 : 0; }

  // What it takes.
  void read_parameter(Words words) {
    words = words.subspan(0, find_mark(words, "="));  // a default
    Argument argument;
    if (is_c()) {
      std::size_t name = words.size();
      for (std::size_t at = 0; at < words.size(); ++at) {
        if (words[at].is("[")) {
          argument.is_array = true;
          if (at + 1 < words.size() && is_whole(words[at + 1])) {
            argument.size = number_of(words[at + 1]);
          }
          break;
        }
        argument.is_array = argument.is_array || words[at].is("*");
        name = words[at].is_name() ? at : name;
      }
      if (name == words.size() || (words.size() == 1 && words[0].is("void"))) {
        return;
      }
      static const std::set<std::string> numbers = {"double", "float", "int"};
      const bool has_name = !numbers.contains(words[name].text);
      argument.name = has_name ? words[name].text : "";
      std::vector<Word> type;
      for (const Word& word : words.subspan(0, name)) {
        if (!is_one_of(word, {"const", "&", "*", "restrict", "struct"})) {
          type.push_back(word);
        }
      }
      argument.type = spelled(type);
      static const std::regex of_reference("(?:Eigen::)?Ref<(.*)>");
      if (argument.type.size() <= longest_type) {
        argument.type = std::regex_replace(argument.type, of_reference, "$1");
      }
    } else {
      if (!words.empty() && words[0].is("{")) {  // an object of JavaScript, by its members
        for (const Words& member : parts(inside(words, 0), ",")) {
          argument.parts.push_back(member.empty() ? "" : member[0].text);
        }
        argument.kind = Argument::Kind::object;
        argument.members = argument.parts;
        function_.arguments.push_back(argument);
        return;
      }
      words = words.subspan(0, find_mark(words, ":"));
      if (words.empty() || !words[0].is_name()) {
        return;
      }
      argument.name = words[0].text;
    }
    function_.arguments.push_back(argument);
  }

  Argument* argument(const std::string& name) {
    const auto found = std::find_if(function_.arguments.begin(), function_.arguments.end(),
                                    [&](const Argument& each) { return each.name == name; });
    return found == function_.arguments.end() ? nullptr : &*found;
  }

  /// Names of the parts of lists and objects, in the order of their indices or members.
  void find_parts() {
    for (Argument& each : function_.arguments) {
      if (each.kind == Argument::Kind::output || each.name.empty()) {
        continue;
      }
      std::set<std::size_t> indices;
      std::vector<std::string> members;
      for (const Words& statement : source_.statements) {
        for (std::size_t at = 0; at + 2 < statement.size(); ++at) {
          if (!statement[at].is(each.name.c_str()) ||
              (at > 0 && is_one_of(statement[at - 1], {".", "->"}))) {
            continue;
          }
          const Words rest = statement.subspan(at + 1);
          if (rest.size() >= 3 && is_one_of(rest[0], {"[", "("}) && is_whole(rest[1]) &&
              is_one_of(rest[2], {"]", ")"})) {
            indices.insert(number_of(rest[1]));
          } else if (is_one_of(rest[0], {".", "->"}) && rest[1].is_name() &&
                     (rest.size() < 3 || !rest[2].is("(")) &&
                     std::find(members.begin(), members.end(), rest[1].text) == members.end()) {
            members.push_back(rest[1].text);
          }
        }
      }
      if (const auto record = records_.find(each.type); record != records_.end()) {
        members = record->second;
      }
      const auto unpacked = unpacked_.find(each.name);
      const bool by_name = by_name_.contains(each.name);
      if (unpacked != unpacked_.end()) {
        for (std::size_t at = 0; at < unpacked->second.size(); ++at) {
          indices.insert(at);
          function_.locals.try_emplace(unpacked->second[at],
                                       part_words(each.name, at, by_name, unpacked->second[at]));
        }
      }
      if (by_name) {
        members = unpacked->second;
      }
      if (each.kind == Argument::Kind::number && is_c()) {
        const std::optional<Size> size = size_of_type(each.type);
        each.size = size ? size->rows * size->columns : each.size;
      }
      if ((!indices.empty() || each.size > 0) && !by_name) {
        each.kind = Argument::Kind::list;
        const std::size_t used = indices.empty() ? 0 : *indices.rbegin() + 1 - first_index();
        each.size = std::min(std::max(each.size, used), most_entries);
        name_elements(each, first_index());
      } else if (!members.empty()) {
        each.kind = Argument::Kind::object;
        each.members = members;
        for (const std::string& member : members) {
          each.parts.push_back(each.name + "_" + member);
        }
      } else {
        each.parts = {each.name};
      }
    }
  }

  /// `q[1]` or `q.name`, which a variable stands for that takes it out of `q`.
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

  // Its statements.
  void read_statement(Words words) {
    while (!words.empty() && is_one_of(words[0], {"const", "let", "var", "static", "constexpr"})) {
      words = words.subspan(1);
    }
    if (words.empty()) {
      return;
    }
    if (words[0].is("return")) {
      returned_ = words.subspan(1);
      return;
    }
    if (const std::size_t at = find_mark(words, "<<"); at == 1 && words[0].is_name()) {
      filled_[words[0].text] = words.subspan(2);
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
    if ((names.size() > 1 && !is_c()) || in_brackets) {
      unpack(names, value, target[0].is("{"));
      return;
    }
    if (read_element(target, value)) {
      return;
    }
    read_declaration(target);
    if (target.back().is_name() && !(target.size() > 1 && target[target.size() - 2].is("."))) {
      function_.locals.try_emplace(target.back().text, value);
      last_value_[target.back().text] = value;
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
        function_.locals.try_emplace(list[at], values[at]);
      }
    } else if (value.size() == 1 && argument(value[0].text) != nullptr) {
      unpacked_[value[0].text] = list;
      if (by_name) {
        by_name_.insert(value[0].text);
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
    std::map<std::pair<std::size_t, std::size_t>, Words>& elements = elements_[target[0].text];
    const bool too_low =
        are_numbers && std::any_of(indices.begin(), indices.end(), [&](const Words& index) {
          return number_of(index[0]) < first_index();
        });
    if (at != target.size() || !are_numbers || too_low || indices.empty() || indices.size() > 2) {
      return true;  // an element, but it cannot be told which
    }
    const std::size_t row = number_of(indices[0][0]) - first_index();
    const std::size_t column = indices.size() == 2 ? number_of(indices[1][0]) - first_index() : 0;
    elements[{row, column}] = value;
    return true;
  }

  /// `Eigen::Matrix2d J`, `double J[2][2]`.
  void read_declaration(Words words) {
    if (!is_c() || words.size() < 2) {
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
    types_[words[name].text] = spelled(words.subspan(0, name));
    std::vector<std::size_t> sizes;
    for (std::size_t at = name + 1;
         at + 1 < words.size() && words[at].is("[") && is_whole(words[at + 1]);
         at = behind_bracket(words, at)) {
      sizes.push_back(number_of(words[at + 1]));
    }
    if (!sizes.empty()) {
      sizes_[words[name].text] = {sizes[0], sizes.size() > 1 ? sizes[1] : 1};
    }
  }

  // The symbols whose sine or cosine it takes.
  void find_angles() {
    for (const Words& statement : source_.statements) {
      for (std::size_t at = 0; at + 1 < statement.size(); ++at) {
        if (is_one_of(statement[at], {"sin", "cos", "tan"}) && statement[at + 1].is("(")) {
          add_angles(inside(statement, at + 1), 0);
        }
      }
    }
  }

  /// Sums of symbols and of their whole multiples are angles.
  void add_angles(Words words, int hops) {
    for (std::size_t at = 0; at < words.size(); ++at) {
      if (is_one_of(words[at], {"(", "["})) {
        at = behind_bracket(words, at) - 1;
        continue;
      }
      if (!words[at].is_name()) {
        continue;
      }
      const SymbolAt symbol = symbol_at(words, at);
      const bool is_factor =
          (at > 1 && is_one_of(words[at - 1], {"*", "/", ".*"}) &&
           words[at - 2].kind != Word::Kind::number) ||
          (symbol.end < words.size() && is_one_of(words[symbol.end], {"*", "/", ".*", "(", "["}));
      const auto local = function_.locals.find(words[at].text);
      if (!is_factor && local != function_.locals.end() && argument(words[at].text) == nullptr) {
        if (hops < most_hops && followed_.insert(words[at].text).second) {
          add_angles(local->second, hops + 1);
        }
      }
      if (!is_factor) {
        function_.angles.insert(symbol.name);
      }
      at = symbol.end - 1;
    }
  }

  // What it gives.
  void find_given() {
    for (const std::string& output : source_.outputs) {
      add_given(variable(output, 0));
    }
    if (source_.outputs.size() > 1) {
      gather_numbers();
    }
    for (Argument& each : function_.arguments) {
      if ((elements_.contains(each.name) || filled_.contains(each.name)) &&
          language_ != Language::matlab) {
        each.kind = Argument::Kind::output;
        each.parts.clear();
        add_given(variable(each.name, 0));
      }
    }
    if (!function_.given.empty() || returned_.empty()) {
      return;
    }
    const std::vector<Words> list = parts(returned_, ",");
    if (language_ == Language::python && list.size() > 1) {
      for (const Words& each : list) {
        add_given(value(each, 0));
      }
      gather_numbers();
      return;
    }
    std::optional<Given> given = value(returned_, 0);
    if (is_c()) {
      given = with_size(given, size_of_type(spelled(source_.head)));
    }
    add_given(given);
  }

  void add_given(std::optional<Given> given) {
    if (!given || given->rows * given->columns == 0 ||
        given->rows * given->columns > most_entries) {
      complete_ = false;
      return;
    }
    if (given->entries.size() != given->rows * given->columns) {
      given->entries.clear();
    }
    function_.given.push_back(std::move(*given));
  }

  /// Several numbers are one column.
  void gather_numbers() {
    std::vector<Given>& list = function_.given;
    const bool are_numbers = std::all_of(list.begin(), list.end(), [](const Given& each) {
      return each.rows * each.columns == 1 && each.entries.size() == 1;
    });
    if (!complete_) {
      list.clear();
    }
    if (list.size() < 2 || !are_numbers) {
      return;
    }
    Given column{"", list.size(), 1, {}, {}, {}};
    for (const Given& each : list) {
      column.entries.push_back(each.entries[0]);
      column.names.push_back(each.name);
    }
    list = {column};
  }

  static std::optional<Given> with_size(std::optional<Given> given, std::optional<Size> size) {
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

  std::optional<Given> variable(const std::string& name, int hops) {
    std::optional<Size> size;
    if (const auto found = sizes_.find(name); found != sizes_.end()) {
      size = found->second;
    } else if (const auto type = types_.find(name); type != types_.end()) {
      size = size_of_type(type->second);
    } else if (const Argument* const given = argument(name)) {
      size = size_of_type(given->type);
    }
    if (const auto found = filled_.find(name); found != filled_.end() && size) {
      Given given{name, size->rows, size->columns, parts(found->second, ","), {}, {}};
      name_entries(given);
      return given;
    }
    const auto set = last_value_.find(name);
    std::optional<Given> initial =
        set == last_value_.end() || hops > most_hops ? std::nullopt : value(set->second, hops + 1);
    if (initial) {
      initial->name = name;
    }
    const auto elements = elements_.find(name);
    if (elements == elements_.end()) {
      return with_size(initial, size);
    }
    if (initial && !size) {
      size = Size{initial->rows, initial->columns};
    }
    if (!size || size->rows * size->columns <= 1) {
      size = Size{0, 0};
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

  /// The variables that are entries give them names.
  static void name_entries(Given& given) {
    given.names.clear();
    for (const Words& entry : given.entries) {
      const bool is_name = entry.size() == 1 && entry[0].is_name();
      given.names.push_back(is_name ? entry[0].text : "");
    }
  }

  /// What an expression is, as far as that can be told: lists are matrices or columns, and what
  /// has no brackets around it is a number.
  std::optional<Given> value(Words words, int hops) {
    if (hops > most_hops || words.empty()) {
      return std::nullopt;
    }
    if (words[0].is("(") && is_whole_bracket(words)) {
      return value(inside(words, 0), hops + 1);
    }
    if (words.size() == 1 && words[0].is_name() && argument(words[0].text) == nullptr) {
      const std::string& name = words[0].text;
      const bool known = last_value_.contains(name) || elements_.contains(name) ||
                         filled_.contains(name) || types_.contains(name);
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
      if (const std::optional<Size> size = is_c() ? size_of_type(callee) : std::nullopt) {
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

  /// A list that is multiplied or added: its size is known, its entries are not.
  std::optional<Given> list_within(Words words) {
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

  /// `P.jacobian([a, b])`
  std::optional<Given> derived_by(Words words) {
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

  static std::size_t first_bracket(Words words) {
    std::size_t at = 0;
    while (at < words.size() && (words[at].is_name() || words[at].kind == Word::Kind::number ||
                                 is_one_of(words[at], {".", "::", "<", ">", ","}))) {
      ++at;
    }
    return at < words.size() && is_one_of(words[at], {"(", "{"}) ? at : words.size();
  }

  /// `zeros(2, 3)`, `np.zeros((2, 2))`.
  std::optional<Given> cleared(Words words) {
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

  std::optional<Given> list_of(Words content) {
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

  const Source& source_;
  Language language_;
  const std::map<std::string, std::vector<std::string>>& records_;
  std::vector<std::vector<Word>>& more_words_;
  ProgramFunction function_;
  Words returned_;
  std::map<std::string, Words> last_value_;
  std::map<std::string, std::map<std::pair<std::size_t, std::size_t>, Words>> elements_;
  std::map<std::string, Words> filled_;
  std::map<std::string, std::string> types_;
  std::map<std::string, Size> sizes_;
  std::map<std::string, std::vector<std::string>> unpacked_;
  std::set<std::string> by_name_;
  std::set<std::string> followed_;  ///< variables whose angles are found
  bool complete_ = true;
};

/// What a module of SymPy gives at its top level: matrices of its symbols.
ProgramFunction module_of_symbols(Words words) {
  Source source;
  std::vector<std::string> symbols;
  std::size_t from = 0;
  for (std::size_t at = 0; at < words.size(); ++at) {
    if (!words[at].ends_line()) {
      continue;
    }
    const Words line = words.subspan(from, at - from);
    from = at + 1;
    if (line.empty() || line[0].indent > 0) {
      continue;
    }
    source.statements.push_back(line);
    const std::size_t equals = find_mark(line, "=");
    const bool declares =
        equals < line.size() && std::any_of(line.begin(), line.end(), [](const Word& word) {
          return is_one_of(word, {"symbols", "Symbol"});
        });
    for (const Word& word : line.subspan(0, declares ? equals : 0)) {
      if (word.is_name()) {
        symbols.push_back(word.text);
      }
    }
  }
  std::vector<std::vector<Word>> none;
  return FunctionReader(source, Language::python, {}, none).module(symbols);
}

}  // namespace

std::vector<std::string> ProgramFunction::symbols() const {
  std::vector<std::string> list;
  for (const Argument& argument : arguments) {
    list.insert(list.end(), argument.parts.begin(), argument.parts.end());
  }
  return list;
}

SymbolAt symbol_at(Words words, std::size_t at) {
  SymbolAt symbol{words[at].text, at + 1};
  if (text::is_reserved_name(symbol.name)) {
    return symbol;
  }
  for (bool more = true; more;) {
    const Words rest = words.subspan(symbol.end);
    more = false;
    if (rest.size() >= 2 && is_one_of(rest[0], {".", "->"}) && rest[1].is_name() &&
        (rest.size() < 3 || !rest[2].is("("))) {
      symbol.name += "_" + rest[1].text;
      symbol.end += 2;
      more = true;
    } else if (rest.size() >= 3 && is_one_of(rest[0], {"[", "("}) && is_whole(rest[1]) &&
               is_one_of(rest[2], {"]", ")"})) {
      symbol.name += "_" + rest[1].text;
      symbol.end += 3;
      more = true;
    }
  }
  return symbol;
}

ProgramOutline program_outline(const std::string& code, Language language) {
  ProgramOutline outline;
  outline.words = program_words(code, language);
  ProgramSources file = program_sources(outline.words, language);
  for (const Source& source : file.functions) {
    if (text::is_identifier(source.name) && source.name != "main") {
      outline.functions.push_back(
          FunctionReader(source, language, file.records, file.more_words).read());
    }
  }
  unite_arguments(outline.functions, language == Language::matlab ? 1 : 0);
  outline.more_words = std::move(file.more_words);
  const bool has_sympy = code.find("import sympy") != std::string::npos ||
                         code.find("from sympy") != std::string::npos;
  if (language == Language::python && has_sympy) {
    ProgramFunction module = module_of_symbols(outline.words);
    if (!module.given.empty()) {
      outline.functions = {std::move(module)};
      outline.of_symbols = true;
    }
  }
  outline.has_numpy = code.find("import numpy as np") != std::string::npos;
  return outline;
}

}  // namespace assur::generator::audit::init
