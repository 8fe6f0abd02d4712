#include "audit/code/cpp_file.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "audit/code/declared_type.hpp"

namespace assur::generator::audit::code {

namespace {

/// Keywords of statements other than plain assignments, and their explanations. Such statements are
/// refused in any case; this gives the better message.
const std::map<std::string, std::string>& explained_words() {
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
        {"template", "struct", "class", "union", "enum", "namespace", "operator"});
    add("a variable that outlives the call", {"thread_local", "extern"});
    add("an operation on memory", {"new", "delete", "asm", "__asm__", "volatile"});
    return words;
  }();
  return list;
}

class FileReader {
 public:
  explicit FileReader(Tokens tokens) : tokens_(tokens) {}

  std::vector<CppItem> run() {
    check_directives(tokens_);
    while (at_ < tokens_.size()) {
      step();
    }
    if (open_ > 0) {
      throw CodeError("a bracket is not closed", tokens_.back().place);
    }
    return std::move(items_);
  }

 private:
  [[nodiscard]] Tokens rest() const { return tokens_.subspan(at_); }
  [[nodiscard]] bool next_is(const char* spelled, std::size_t ahead = 0) const {
    return at_ + ahead < tokens_.size() && tokens_[at_ + ahead].is(spelled);
  }
  [[nodiscard]] bool next_is_name(std::size_t ahead) const {
    return at_ + ahead < tokens_.size() && tokens_[at_ + ahead].is_name();
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
    } else if (token.is("namespace")) {
      enter_namespace();
    } else if (token.is("extern") && at_ + 1 < tokens_.size() &&
               tokens_[at_ + 1].kind == Token::Kind::text) {
      open_ += next_is("{", 2) ? 1 : 0;
      at_ += next_is("{", 2) ? 3 : 2;
    } else if (token.is("template")) {
      skip_template();
    } else if (token.is("enum")) {
      read_enumeration();
    } else if (token.is("class") || token.is("union")) {
      refuse_type(token);
    } else if (is_structure()) {
      read_structure();
    } else {
      read_declaration();
    }
  }

  [[noreturn]] static void refuse_type(const Token& at) {
    throw CodeError("a type that is more than a list of members cannot be read" + by_running,
                    at.place);
  }

  void enter_namespace() {
    const Token& first = tokens_[at_++];
    while (next_is_name(0)) {
      expect_new_meaning(tokens_[at_]);
      at_ += next_is("::", 1) ? 2 : 1;
    }
    if (!next_is("{")) {
      throw CodeError("this declaration cannot be read" + by_running, first.place);
    }
    ++open_;
    ++at_;
  }

  void skip_template() {
    const Token& first = tokens_[at_];
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
    ++at_;
    templated_ = true;
  }

  /// `struct P {`, `struct P;`, `typedef struct {`, `typedef struct P {`, and longer statements
  /// that begin so.
  [[nodiscard]] bool is_structure() const {
    const std::size_t word = next_is("typedef") ? 1 : 0;
    if (!next_is("struct", word)) {
      return false;
    }
    const std::size_t named = next_is_name(word + 1) ? 1 : 0;
    return next_is("{", word + 1 + named) || next_is(":", word + 1 + named) ||
           next_is(";", word + 1 + named) || next_is("[", word + 1);
  }

  void read_structure() {
    const std::size_t from = at_;
    const bool defined = next_is("typedef");
    at_ += defined ? 2 : 1;
    const Token* name = next_is_name(0) ? &tokens_[at_++] : nullptr;
    if (next_is(";") && !defined) {
      return;  // it is declared and not defined
    }
    if (!next_is("{") || templated_) {
      refuse_type(tokens_[from]);
    }
    const std::size_t length = behind_closing(rest(), 0);
    const Tokens inside = rest().subspan(1, length - 2);
    at_ += length;
    const auto add = [&](const Token* named) {
      items_.push_back(
          {CppItem::Kind::structure, tokens_.subspan(from, at_ - from), named, {}, {}, inside});
    };
    if (defined && next_is_name(0)) {
      const Token* const other = &tokens_[at_++];
      if (name != nullptr && name->spelling != other->spelling) {
        add(name);
      }
      name = other;
    }
    if (!next_is(";") || name == nullptr ||
        std::any_of(inside.begin(), inside.end(), [](const Token& token) {
          return token.is("(") && !(&token)[1].is("&") && !(&token)[1].is("*");
        })) {
      refuse_type(tokens_[from]);
    }
    add(name);
  }

  void read_enumeration() {
    const std::size_t from = at_;
    while (at_ < tokens_.size() && !next_is("{") && !next_is(";") && !next_is("(")) {
      ++at_;
    }
    if (!next_is("{")) {
      throw CodeError("this declaration cannot be read" + by_running, tokens_[from].place);
    }
    const std::size_t length = behind_closing(rest(), 0);
    const Tokens inside = rest().subspan(1, length - 2);
    at_ += length;
    if (!next_is(";")) {
      throw CodeError("this declaration cannot be read" + by_running, tokens_[from].place);
    }
    items_.push_back(
        {CppItem::Kind::enumeration, tokens_.subspan(from, at_ - from), nullptr, {}, {}, inside});
  }

  /// A function, or a statement outside all functions.
  void read_declaration() {
    const std::size_t from = at_;
    const bool templated = std::exchange(templated_, false);
    expect_plain_words(tokens_.subspan(from, 1));
    bool assigned = false;
    std::size_t parameters = 0;
    while (at_ < tokens_.size() && !next_is(";") && !next_is("}")) {
      if (next_is("operator")) {
        throw CodeError("an operator of your own may change what the code says" + by_running,
                        tokens_[at_].place);
      }
      assigned = assigned || next_is("=") || next_is("<<");
      if (next_is("{") && !assigned && parameters > 0) {
        add_function(from, parameters, templated);
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
    items_.push_back({CppItem::Kind::statement, statement, nullptr, {}, {}, {}, templated});
  }

  void add_function(std::size_t from, std::size_t parameters, bool templated) {
    const std::size_t behind = parameters + behind_closing(tokens_.subspan(parameters), 0);
    const Tokens between = tokens_.subspan(behind, at_ - behind);
    const std::size_t body = at_;
    at_ += behind_closing(rest(), 0);
    const Token* const name = parameters > from ? &tokens_[parameters - 1] : nullptr;
    if (name == nullptr || !name->is_name()) {
      throw CodeError("this declaration cannot be read" + by_running, tokens_[from].place);
    }
    CppItem item{CppItem::Kind::function,
                 tokens_.subspan(from, at_ - from),
                 name,
                 tokens_.subspan(from, parameters - 1 - from),
                 tokens_.subspan(parameters + 1, behind - parameters - 2),
                 tokens_.subspan(body + 1, at_ - body - 2),
                 templated};
    // Between the parameters and the braces, `const` and `noexcept` are allowed.
    item.odd = std::find_if(between.begin(), between.end(), [](const Token& token) {
                 return !token.is("const") && !token.is("noexcept");
               }) != between.end();
    items_.push_back(item);
  }

  Tokens tokens_;
  std::size_t at_ = 0;
  int open_ = 0;  ///< namespaces
  bool templated_ = false;
  std::vector<CppItem> items_;
};

}  // namespace

void expect_plain_words(Tokens statement) {
  for (const Token& token : statement) {
    const auto word = explained_words().find(token.spelling);
    const bool of_using = statement[0].is("using") && token.is("namespace");
    if (token.is_name() && word != explained_words().end() && !of_using) {
      throw CodeError("'" + token.spelling + "': " + word->second +
                          " cannot be read; only what always runs once, line by line, can" +
                          by_running,
                      token.place);
    }
  }
}

std::vector<Tokens> statements_of(Tokens inside) {
  std::vector<Tokens> list;
  const auto add = [&](Tokens statement) {
    if (statement.empty()) {
      return;
    }
    if (!list.empty() && list.back()[0].is("return")) {
      throw CodeError("nothing after this 'return' runs" + by_running, list.back()[0].place);
    }
    expect_plain_words(statement);
    list.push_back(statement);
  };
  std::size_t first = 0;
  for (std::size_t at = 0; at < inside.size(); ++at) {
    if (inside[at].kind == Token::Kind::directive) {
      throw CodeError("a line for the preprocessor inside the function cannot be read" + by_running,
                      inside[at].place);
    }
    if (inside[at].is("{") && at == first) {
      throw CodeError("a block inside the function cannot be read" + by_running, inside[at].place);
    }
    if (inside[at].is("(") || inside[at].is("[") || inside[at].is("{")) {
      at = behind_closing(inside, at) - 1;
    } else if (inside[at].is(";")) {
      add(inside.subspan(first, at - first));
      first = at + 1;
    }
  }
  if (first != inside.size()) {
    add(inside.subspan(first));  // its error may say more
    throw CodeError("this statement has no semicolon", inside[first].place);
  }
  return list;
}

bool names_variable(Tokens tokens, std::size_t at, const std::string& name) {
  if (!tokens[at].is_name() || tokens[at].spelling != name) {
    return false;
  }
  const bool member = at > 0 && (tokens[at - 1].is(".") || tokens[at - 1].is("->"));
  return !member || (at > 1 && tokens[at - 2].is("this"));
}

const Token* mention_of(Tokens tokens, const std::string& name) {
  for (std::size_t at = 0; at < tokens.size(); ++at) {
    if (names_variable(tokens, at, name)) {
      return &tokens[at];
    }
  }
  return nullptr;
}

std::vector<CppItem> cpp_items(Tokens tokens) { return FileReader(tokens).run(); }

}  // namespace assur::generator::audit::code
