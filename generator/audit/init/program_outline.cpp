#include "audit/init/program_outline.hpp"

#include <algorithm>
#include <assur/text/expression.hpp>

namespace assur::generator::audit::init {

namespace {

/// Finds the symbols whose sine or cosine a function takes.
class AngleFinder {
 public:
  AngleFinder(const std::vector<Argument>& arguments, const Assignments& assignments)
      : arguments_(arguments), set_(assignments) {}

  std::set<std::string> find(const std::vector<Words>& statements) {
    for (const Words& statement : statements) {
      for (std::size_t at = 0; at + 1 < statement.size(); ++at) {
        if (is_one_of(statement[at], {"sin", "cos", "tan"}) && statement[at + 1].is("(")) {
          add_angles(inside(statement, at + 1), 0);
        }
      }
    }
    return std::move(angles_);
  }

 private:
  /// Symbols in sums with whole multiples are angles.
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
      const auto local = set_.first_values.find(words[at].text);
      if (!is_factor && local != set_.first_values.end() &&
          find_argument(arguments_, words[at].text) == nullptr) {
        if (hops < most_hops && followed_.insert(words[at].text).second) {
          add_angles(local->second, hops + 1);
        }
      }
      if (!is_factor) {
        angles_.insert(symbol.name);
      }
      at = symbol.end - 1;
    }
  }

  const std::vector<Argument>& arguments_;
  const Assignments& set_;
  std::set<std::string> angles_;
  std::set<std::string> followed_;  ///< variables whose angles are found
};

/// The known matrices of a function.
class GivenList {
 public:
  void add(std::optional<Given> given) {
    if (!given || given->rows * given->columns == 0 ||
        given->rows * given->columns > most_entries) {
      complete_ = false;
      return;
    }
    if (given->entries.size() != given->rows * given->columns) {
      given->entries.clear();
    }
    list_.push_back(std::move(*given));
  }

  /// Gathers several numbers into one column.
  void gather_numbers() {
    const bool are_numbers = std::all_of(list_.begin(), list_.end(), [](const Given& each) {
      return each.rows * each.columns == 1 && each.entries.size() == 1;
    });
    if (!complete_) {
      list_.clear();
    }
    if (list_.size() < 2 || !are_numbers) {
      return;
    }
    Given column{"", list_.size(), 1, {}, {}, {}};
    for (const Given& each : list_) {
      column.entries.push_back(each.entries[0]);
      column.names.push_back(each.name);
    }
    list_ = {column};
  }

  [[nodiscard]] bool empty() const { return list_.empty(); }
  [[nodiscard]] std::vector<Given> take() { return std::move(list_); }

 private:
  std::vector<Given> list_;
  bool complete_ = true;
};

/// The matrices that a function returns or sets. Arguments that it sets become outputs.
std::vector<Given> given_by(const Source& source, Language language,
                            std::vector<Argument>& arguments, const Assignments& assignments) {
  const MatrixReader matrices(language, arguments, assignments);
  GivenList list;
  for (const std::string& output : source.outputs) {
    list.add(matrices.variable(output));
  }
  if (source.outputs.size() > 1) {
    list.gather_numbers();
  }
  for (Argument& each : arguments) {
    if ((assignments.elements.contains(each.name) || assignments.streamed.contains(each.name)) &&
        language != Language::matlab) {
      each.kind = Argument::Kind::output;
      each.parts.clear();
      list.add(matrices.variable(each.name));
    }
  }
  if (!list.empty() || assignments.returned.empty()) {
    return list.take();
  }
  const std::vector<Words> values = parts(assignments.returned, ",");
  if (language == Language::python && values.size() > 1) {
    for (const Words& each : values) {
      list.add(matrices.value(each));
    }
    list.gather_numbers();
    return list.take();
  }
  std::optional<Given> given = matrices.value(assignments.returned);
  if (is_c_or_cpp(language)) {
    given = with_size(given, size_of_type(spelled(source.head)));
  }
  list.add(given);
  return list.take();
}

ProgramFunction read_function(const Source& source, Language language,
                              const std::map<std::string, std::vector<std::string>>& records,
                              std::vector<std::vector<Word>>& more_words) {
  ProgramFunction function;
  function.name = source.name;
  function.space = source.space;
  function.arguments = declared_arguments(source.parameters, language);
  std::vector<std::string> names;
  for (const Argument& argument : function.arguments) {
    names.push_back(argument.name);
  }
  Assignments assignments = assignments_of(source, language, names, more_words);
  name_parts(function.arguments, source, language, assignments, records);
  function.angles = AngleFinder(function.arguments, assignments).find(source.statements);
  function.given = given_by(source, language, function.arguments, assignments);
  function.locals = std::move(assignments.first_values);
  return function;
}

/// The matrices at the top level of a module of SymPy.
ProgramFunction function_of_module(const Source& source, const std::vector<std::string>& symbols) {
  ProgramFunction function;
  for (const std::string& symbol : symbols) {
    Argument argument;
    argument.name = symbol;
    argument.parts = {symbol};
    function.arguments.push_back(argument);
  }
  std::vector<std::vector<Word>> no_more_words;  // nothing is unpacked
  Assignments assignments = assignments_of(source, Language::python, {}, no_more_words);
  function.angles = AngleFinder(function.arguments, assignments).find(source.statements);
  const MatrixReader matrices(Language::python, function.arguments, assignments);
  GivenList list;
  for (const Words& statement : source.statements) {
    if (statement.size() < 4 || !statement[0].is_name() || !statement[1].is("=")) {
      continue;
    }
    const Words set = statement.subspan(2);
    std::optional<Given> given = matrices.jacobian(set);
    given = given ? given : matrices.value(set);
    if (given && (given->rows > 1 || given->columns > 1 || !given->by.empty())) {
      given->name = statement[0].text;
      list.add(given);
    }
  }
  function.given = list.take();
  function.locals = std::move(assignments.first_values);
  return function;
}

/// The matrices at the top level of a SymPy module, in its symbols.
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
  return function_of_module(source, symbols);
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
      outline.functions.push_back(read_function(source, language, file.records, file.more_words));
    }
  }
  std::vector<std::span<Argument>> arguments;
  for (ProgramFunction& function : outline.functions) {
    arguments.emplace_back(function.arguments);
  }
  unite_arguments(arguments, language);
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
