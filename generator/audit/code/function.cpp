#include "audit/code/function.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "audit/code/directives.hpp"
#include "audit/code/formula.hpp"

namespace assur::generator::audit::code {

namespace {

/// Words that make a statement more than a plain assignment, and what they introduce.
const std::map<std::string, std::string>& refused_words() {
  static const std::map<std::string, std::string> list = [] {
    std::map<std::string, std::string> words;
    const auto add = [&](const char* what, std::initializer_list<const char*> spelled) {
      for (const char* word : spelled) {
        words[word] = what;
      }
    };
    add("a condition", {"if", "else", "switch", "case", "default"});
    add("a loop", {"for", "while", "do", "break", "continue"});
    add("a jump", {"goto", "try", "catch", "throw", "co_return", "co_await", "co_yield"});
    add("a word for an operator", {"and", "or", "not", "xor", "bitand", "bitor", "compl", "and_eq",
                                   "or_eq", "xor_eq", "not_eq"});
    add("a definition inside a function",
        {"typedef", "template", "struct", "class", "union", "enum", "namespace", "operator"});
    add("a variable that outlives the call", {"thread_local", "extern"});
    add("an operation on memory", {"new", "delete", "asm", "__asm__", "volatile"});
    return words;
  }();
  return list;
}

class FileReader {
 public:
  FileReader(Tokens tokens, const std::string& array) : tokens_(tokens), array_(array) {}

  FillingFunction run() {
    check_directives(tokens_);
    while (at_ < tokens_.size()) {
      step();
    }
    if (open_ > 0) {
      throw CodeError("a bracket is not closed", tokens_.back().place);
    }
    if (!file_.is_function) {
      file_.statements = statements_of(outer_);
      return file_;
    }
    for (const Tokens& statement : outer_) {
      if (const Token* mention = mention_of(statement, array_)) {
        refuse_mention(*mention, "outside the function that fills it");
      }
    }
    file_.globals = statements_of(outer_);
    return file_;
  }

 private:
  [[noreturn]] void refuse_mention(const Token& token, const std::string& where) const {
    throw CodeError(array_ + " is mentioned " + where + by_running, token.place);
  }

  [[nodiscard]] Tokens rest() const { return tokens_.subspan(at_); }
  [[nodiscard]] bool next_is(const char* spelled) const {
    return at_ < tokens_.size() && tokens_[at_].is(spelled);
  }

  void step() {
    const Token& token = tokens_[at_];
    if (token.kind == Token::Kind::directive || token.is(";")) {
      ++at_;
    } else if (token.is("}")) {
      if (open_-- == 0) {
        throw CodeError("this bracket closes nothing", token.place);
      }
      ++at_;
    } else if (token.is("namespace") || (token.is("extern") && at_ + 1 < tokens_.size() &&
                                         tokens_[at_ + 1].kind == Token::Kind::text)) {
      enter_scope();
    } else if (token.is("template")) {
      skip_template();
    } else if (token.is("struct") || token.is("class") || token.is("union") || token.is("enum")) {
      skip_type();
    } else {
      read_declaration();
    }
  }

  void enter_scope() {
    const Token& first = tokens_[at_];
    while (at_ < tokens_.size() && !next_is("{") && !next_is(";") && !next_is("(")) {
      ++at_;
    }
    if (!next_is("{")) {
      throw CodeError("this declaration cannot be read" + by_running, first.place);
    }
    ++open_;
    ++at_;
  }

  void skip_template() {
    const Token& first = tokens_[at_];
    const std::size_t from = at_ + 2;
    int depth = 0;
    for (++at_; at_ < tokens_.size(); ++at_) {
      depth += next_is("<") ? 1 : next_is(">") ? -1 : next_is(">>") ? -2 : 0;
      if (depth <= 0) {
        break;
      }
    }
    if (at_ == tokens_.size()) {
      throw CodeError("this template cannot be read", first.place);
    }
    templated_.push_back(tokens_.subspan(from, at_ - std::min(from, at_)));
    ++at_;
  }

  /// Keeps the members of a type, whose sorts matter, or the constants of an enumeration.
  void skip_type() {
    const std::size_t from = at_;
    while (at_ < tokens_.size() && !next_is("{") && !next_is(";") && !next_is("(")) {
      ++at_;
    }
    if (next_is("{")) {
      at_ += behind_closing(rest(), 0);
    }
    const std::size_t to = at_;
    while (at_ < tokens_.size() && !next_is(";")) {
      ++at_;
    }
    const Tokens type = tokens_.subspan(from, to - from);
    const auto call = std::find_if(type.begin(), type.end(), [](const Token& token) {
      return token.is("(") || token.is("operator");
    });
    if (call != type.end() || at_ != to || to == tokens_.size()) {
      throw CodeError("a type that is more than a list of members cannot be read" + by_running,
                      tokens_[from].place);
    }
    templated_.clear();
    const auto open =
        std::find_if(type.begin(), type.end(), [](const Token& token) { return token.is("{"); });
    const auto inside = static_cast<std::size_t>(open - type.begin());
    if (open == type.end()) {
      return;
    }
    std::size_t first = inside + 1;
    for (std::size_t at = first; at < type.size(); ++at) {
      if (tokens_[from].is("enum") && type[at].is_name()) {
        file_.constants.push_back(type[at]);
      } else if (type[at].is(";")) {
        file_.members.push_back(type.subspan(first, at - first));
        first = at + 1;
      }
    }
  }

  /// A function, or a statement outside all functions.
  void read_declaration() {
    const std::size_t from = at_;
    refuse_words(tokens_.subspan(from, 1));
    bool assigned = false;
    std::size_t parameters = 0;
    while (at_ < tokens_.size() && !next_is(";") && !next_is("}")) {
      if (next_is("operator")) {
        throw CodeError("an operator of your own may change what the code says" + by_running,
                        tokens_[at_].place);
      }
      assigned = assigned || next_is("=") || next_is("<<");
      if (next_is("{") && !assigned && parameters > 0) {
        read_function(from, parameters);
        return;
      }
      if (next_is("(") && parameters == 0 && !assigned) {
        parameters = at_;
      }
      at_ += next_is("(") || next_is("{") || next_is("[") ? behind_closing(rest(), 0) : 1;
    }
    const Tokens statement = tokens_.subspan(from, at_ - from);
    if (!next_is(";")) {
      throw CodeError("this statement has no semicolon", tokens_[from].place);
    }
    if (parameters == 0 || !is_prototype(statement, parameters - from)) {
      outer_.push_back(statement);
    }
  }

  /// `void fill(Matrix& J)`: a type, a name that is not the matrix's, and parameters.
  [[nodiscard]] bool is_prototype(Tokens statement, std::size_t parameters) {
    if (parameters < 2 || parameters >= statement.size()) {
      return false;
    }
    const Token& name = statement[parameters - 1];
    const Token& before = statement[parameters - 2];
    const bool typed = before.is_name() || before.is("&") || before.is("*") || before.is(">");
    if (!name.is_name() || !typed || name.is(array_.c_str()) || before.is("return")) {
      return false;
    }
    const Tokens taken =
        statement.subspan(parameters + 1, behind_closing(statement, parameters) - parameters - 2);
    refuse_known(name);
    file_.functions.push_back(name);
    const auto values = comma_parts(taken);
    return taken.empty() || std::all_of(values.begin(), values.end(), [](Tokens value) {
             return value.size() > 1 || (value.size() == 1 && value[0].is_name());
           });
  }

  static void refuse_known(const Token& name) {
    if (is_known_function(name.spelling) || name.is("Zero")) {
      throw CodeError(
          "a function '" + name.spelling + "' of your own is not the one of formulas" + by_running,
          name.place);
    }
  }

  void read_function(std::size_t from, std::size_t parameters) {
    const std::vector<Tokens> templated = std::exchange(templated_, {});
    const Tokens whole = tokens_.subspan(from);
    const std::size_t body = at_ - from;
    const std::size_t end = behind_closing(whole, body);
    at_ = from + end;
    if (parameters > from) {
      refuse_known(tokens_[parameters - 1]);
      file_.functions.push_back(tokens_[parameters - 1]);
    }
    const Token* const mention = mention_of(whole.first(end), array_);
    if (mention == nullptr) {
      return;
    }
    if (file_.is_function) {
      refuse_mention(*mention, "in a second function");
    }
    const std::size_t head = parameters - from;
    const std::size_t head_end = behind_closing(whole, head);
    if (std::any_of(whole.begin() + static_cast<std::ptrdiff_t>(head_end),
                    whole.begin() + static_cast<std::ptrdiff_t>(body),
                    [](const Token& token) { return token.is(":") || token.is("try"); })) {
      refuse_mention(*mention, "in a constructor");
    }
    file_.is_function = true;
    file_.templated = templated;
    file_.parameters = whole.subspan(head + 1, head_end - head - 2);
    const Tokens inside = whole.subspan(body + 1, end - body - 2);
    std::vector<Tokens> list;
    std::size_t first = 0;
    for (std::size_t at = 0; at < inside.size(); ++at) {
      if (inside[at].kind == Token::Kind::directive) {
        throw CodeError(
            "a line for the preprocessor inside the function cannot be read" + by_running,
            inside[at].place);
      }
      if (inside[at].is("{") && at == first) {
        throw CodeError("a block inside the function cannot be read" + by_running,
                        inside[at].place);
      }
      if (inside[at].is("(") || inside[at].is("[") || inside[at].is("{")) {
        at = behind_closing(inside, at) - 1;
      } else if (inside[at].is(";")) {
        list.push_back(inside.subspan(first, at - first));
        first = at + 1;
      }
    }
    if (first != inside.size()) {
      list.push_back(inside.subspan(first));
      static_cast<void>(statements_of(list));  // its error may say more
      throw CodeError("this statement has no semicolon", inside[first].place);
    }
    file_.statements = statements_of(list);
  }

  static void refuse_words(Tokens tokens) {
    for (const Token& token : tokens) {
      const auto refused = refused_words().find(token.spelling);
      const bool of_using = tokens[0].is("using") && token.is("namespace");
      if (token.is_name() && refused != refused_words().end() && !of_using) {
        throw CodeError("'" + token.spelling + "': " + refused->second +
                            " cannot be read; only what always runs once, line by line, can" +
                            by_running,
                        token.place);
      }
    }
  }

  /// Leaves out empty ones. Throws CodeError unless all are plain and none follows a `return`.
  static std::vector<Tokens> statements_of(const std::vector<Tokens>& list) {
    std::vector<Tokens> statements;
    for (const Tokens& statement : list) {
      if (statement.empty()) {
        continue;
      }
      if (!statements.empty() && statements.back()[0].is("return")) {
        throw CodeError("nothing after this 'return' runs" + by_running,
                        statements.back()[0].place);
      }
      refuse_words(statement);
      statements.push_back(statement);
    }
    return statements;
  }

  Tokens tokens_;
  const std::string& array_;
  std::size_t at_ = 0;
  int open_ = 0;  ///< namespaces
  std::vector<Tokens> outer_;
  std::vector<Tokens> templated_;  ///< parameters of the templates before the next declaration
  FillingFunction file_;
};

}  // namespace

bool names_matrix(Tokens tokens, std::size_t at, const std::string& array) {
  if (!tokens[at].is_name() || tokens[at].spelling != array) {
    return false;
  }
  const bool member = at > 0 && (tokens[at - 1].is(".") || tokens[at - 1].is("->"));
  return !member || (at > 1 && tokens[at - 2].is("this"));
}

const Token* mention_of(Tokens tokens, const std::string& array) {
  for (std::size_t at = 0; at < tokens.size(); ++at) {
    if (names_matrix(tokens, at, array)) {
      return &tokens[at];
    }
  }
  return nullptr;
}

FillingFunction filling_function(Tokens tokens, const std::string& array) {
  return FileReader(tokens, array).run();
}

}  // namespace assur::generator::audit::code
