#include "audit/init/program_sources.hpp"

#include <algorithm>

namespace assur::generator::audit::init {

namespace {

/// Reads the functions of a file.
class SourceReader {
 public:
  SourceReader(Words words, Language language) : words_(words), language_(language) {}

  std::vector<Source> run() {
    if (language_ == Language::python) {
      read_python();
    } else if (language_ == Language::matlab) {
      read_matlab();
    } else {
      read_braces();
    }
    return std::move(sources_);
  }
  std::map<std::string, std::vector<std::string>> records;  ///< types and their members
  std::vector<std::vector<Word>> more_words;                ///< words that are not in the file

 private:
  [[nodiscard]] std::size_t end_of_line(std::size_t at) const {
    while (at < words_.size() && !words_[at].ends_line()) {
      ++at;
    }
    return at;
  }

  /// Adds the statements between line ends and semicolons; in MATLAB also between commas.
  void add_lines(Words body, Source& source) const {
    std::size_t from = 0;
    const auto add = [&](std::size_t to) {
      if (to > from) {
        source.statements.push_back(body.subspan(from, to - from));
      }
      from = to + 1;
    };
    for (std::size_t at = 0; at < body.size(); ++at) {
      if (is_one_of(body[at], {"(", "[", "{"})) {
        at = std::max(behind_bracket(body, at), at + 1) - 1;
      } else if (body[at].ends_line() || body[at].is(";") ||
                 (language_ == Language::matlab && body[at].is(","))) {
        add(at);
      }
    }
    add(body.size());
  }

  void read_python() {
    for (std::size_t at = 0; at < words_.size(); at = end_of_line(at) + 1) {
      const bool is_function = at + 2 < words_.size() && words_[at].is("def") &&
                               words_[at].indent == 0 && words_[at + 2].is("(");
      if (!is_function) {
        continue;
      }
      Source source{words_[at + 1].text, "", {}, inside(words_, at + 2), {}, {}};
      std::size_t from = behind_bracket(words_, at + 2);
      while (from < words_.size() && !words_[from].is(":") && !words_[from].ends_line()) {
        ++from;
      }
      std::size_t to = end_of_line(from);
      while (to + 1 < words_.size() && words_[to + 1].indent > 0) {
        to = end_of_line(to + 1);
      }
      from = std::min(from + 1, to);
      add_lines(words_.subspan(from, to - from), source);
      sources_.push_back(source);
    }
  }

  /// Reads the first function of a file; rows of an audit file cannot call others.
  void read_matlab() {
    std::size_t at = 0;
    while (at < words_.size() && !words_[at].is("function")) {
      at = end_of_line(at) + 1;
    }
    if (at >= words_.size()) {
      return;
    }
    const std::size_t end = end_of_line(at);
    Words head = words_.subspan(at + 1, end - at - 1);
    const std::size_t equals = find_mark(head, "=");
    Source source;
    if (equals < head.size()) {
      for (const Word& word : head.subspan(0, equals)) {
        if (word.is_name()) {
          source.outputs.push_back(word.text);
        }
      }
      head = head.subspan(equals + 1);
    }
    if (head.empty() || !head[0].is_name()) {
      return;
    }
    source.name = head[0].text;
    source.parameters = head.size() > 1 ? inside(head, 1) : Words();
    std::size_t to = std::min(end + 1, words_.size());
    const std::size_t from = to;
    while (to < words_.size() && !words_[to].is("function")) {
      to = std::min(end_of_line(to) + 1, words_.size());
    }
    add_lines(words_.subspan(from, to - from), source);
    sources_.push_back(source);
  }

  void read_braces() {
    std::size_t begin = 0;
    for (std::size_t at = 0; at < words_.size(); ++at) {
      const Words statement = words_.subspan(begin, at - begin);
      if (words_[at].is(";") || words_[at].is("}")) {
        begin = at + 1;
      } else if (words_[at].is("{")) {
        if (!statement.empty() && is_one_of(statement[0], {"namespace", "extern"})) {
          const std::string name = spelled(statement.subspan(1));
          if (statement[0].is("namespace") && !name.empty()) {
            space_ += (space_.empty() ? "" : "::") + name;
          }
          begin = at + 1;
          continue;
        }
        const std::size_t end = behind_bracket(words_, at);
        if (!add_function(statement, inside(words_, at))) {
          add_record(statement, inside(words_, at));
          at = end - 1;
          continue;  // `const x = {...};` continues
        }
        at = end - 1;
        begin = end;
      } else if (words_[at].is("=>") && at + 1 < words_.size() && !words_[at + 1].is("{")) {
        const Words rest = words_.subspan(at + 1);
        const std::size_t end = find_mark(rest, ";");
        Source source = head_of(statement);
        if (!source.name.empty()) {
          const Words body = rest.subspan(0, end);
          more_words.push_back({{Word::Kind::name, "return"}});
          more_words.back().insert(more_words.back().end(), body.begin(), body.end());
          source.statements = {Words(more_words.back())};
          sources_.push_back(source);
        }
        at += end;
        begin = at + 1;
      } else if (is_one_of(words_[at], {"(", "["})) {
        at = std::max(behind_bracket(words_, at), at + 1) - 1;
      }
    }
  }

  /// The name and the parameters of a function of C++, C or JavaScript.
  [[nodiscard]] Source head_of(Words statement) const {
    Source source;
    const std::size_t open = find_mark(statement, "(");
    if (open == statement.size() || statement.empty()) {
      return source;
    }
    const std::size_t equals = find_mark(statement, "=");
    if (language_ == Language::javascript && equals < open && equals > 0) {
      source.name = statement[equals - 1].text;
    } else if (equals == statement.size() && open > 0 && statement[open - 1].is_name() &&
               (language_ != Language::javascript || open > 1) &&
               !is_one_of(statement[0], {"template", "static_assert", "typedef", "if", "for",
                                         "while", "switch"})) {
      source.name = statement[open - 1].text;
      source.head = statement.subspan(0, open - 1);
    }
    source.parameters = inside(statement, open);
    // Member functions are defined with the name of their type before theirs.
    if (open > 1 && statement[open - 2].is("::")) {
      source.name.clear();
    }
    return source;
  }

  bool add_function(Words statement, Words body) {
    if (statement.empty() || is_one_of(statement.back(), {"="})) {
      return false;
    }
    Source source = head_of(statement);
    if (source.name.empty()) {
      return false;
    }
    source.space = space_;
    std::size_t from = 0;
    for (std::size_t at = 0; at < body.size(); ++at) {
      const bool opens_block =
          body[at].is("{") && (at == from || is_one_of(body[at - 1], {")", "else", "do", "try"}));
      if (body[at].is(";") || body[at].is("}") || opens_block) {
        if (at > from && !opens_block) {
          source.statements.push_back(body.subspan(from, at - from));
        }
        from = at + 1;
      } else if (is_one_of(body[at], {"(", "[", "{"})) {
        at = std::max(behind_bracket(body, at), at + 1) - 1;
      }
    }
    if (from < body.size()) {
      source.statements.push_back(body.subspan(from));
    }
    sources_.push_back(source);
    return true;
  }

  void add_record(Words statement, Words body) {
    const bool is_struct =
        statement.size() >= 2 && is_one_of(statement[0], {"struct"}) && statement.back().is_name();
    if (!is_struct) {
      return;
    }
    std::vector<std::string> members;
    for (const Words& line : parts(body, ";")) {
      if (find_mark(line, "(") < line.size()) {
        return;  // a type with functions is not constructed from a list of members
      }
      for (const Words& each : parts(line, ",")) {
        const Words declared = each.subspan(0, find_mark(each, "="));
        if (!declared.empty() && declared.back().is_name()) {
          members.push_back(declared.back().text);
        }
      }
    }
    records[statement.back().text] = members;
  }

  Words words_;
  Language language_;
  std::string space_;  ///< the namespaces opened so far
  std::vector<Source> sources_;
};

}  // namespace

ProgramSources program_sources(Words words, Language language) {
  SourceReader reader(words, language);
  std::vector<Source> functions = reader.run();
  return {std::move(functions), std::move(reader.records), std::move(reader.more_words)};
}

}  // namespace assur::generator::audit::init
