#include "latex/displayed.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>

#include "latex/rows.hpp"

namespace assur::generator::latex {

namespace {

/// Environments that display equations, without a star.
struct Environment {
  std::string_view name;
  bool rows;              ///< each row is an equation
  bool argument = false;  ///< its argument describes its columns
};
constexpr std::array<Environment, 12> environments = {{{"equation", false},
                                                       {"align", true},
                                                       {"gather", true},
                                                       {"eqnarray", true},
                                                       {"flalign", true},
                                                       {"alignat", true, true},
                                                       {"xalignat", true, true},
                                                       {"xxalignat", true, true},
                                                       {"IEEEeqnarray", true, true},
                                                       {"dmath", false},
                                                       {"multline", false},
                                                       {"displaymath", false}}};

/// Equations belong to parts, chapters and sections, but not to subsections.
constexpr std::array<std::string_view, 4> headings = {"\\part", "\\chapter", "\\section",
                                                      "\\subsection"};

/// No title has this many tokens. A heading with an unclosed bracket or brace is read up to here.
constexpr std::size_t longest_title = 10'000;

/// No paper has this many equations, and counting from here cannot overflow.
constexpr int most_numbers = 1'000'000;

bool is_heading(const Token& token) {
  return std::find(headings.begin(), headings.end(), token.text) != headings.end();
}

/// Returns the title of the heading at a place, and moves the place to its end.
std::string take_title(const Tokens& tokens, std::size_t& at) {
  const std::size_t limit = std::min(at + longest_title, tokens.size());
  ++at;
  at += at < tokens.size() && tokens[at].is("*") ? 1 : 0;
  if (at < tokens.size() && tokens[at].is("[")) {  // the title in the table of contents
    const Place opened = tokens[at++].place;
    while (at < limit && !tokens[at].is("]")) {
      at = end_of_argument(tokens, at, limit);
    }
    if (at >= limit) {
      throw FormulaError("[ is not closed", opened);
    }
    ++at;
  }
  static_cast<void>(end_of_argument(tokens, at, limit));
  return letters_of(take_argument(tokens, at));
}

class Scanner {
 public:
  Scanner(const Tokens& tokens, const std::map<std::string, DisplayCommand>& commands)
      : tokens_(tokens), commands_(commands) {}

  std::vector<Displayed> run() {
    while (at_ < tokens_.size() && !ended_) {
      step();
    }
    return std::move(found_);
  }

 private:
  void step() {
    const Token& token = tokens_[at_];
    if (token.is("\\begin") || token.is("\\end")) {
      environment(token);
    } else if (token.is("\\[")) {
      shown_between("\\]");
    } else if (token.is("$")) {
      dollars();
    } else if (token.is("\\(")) {
      at_ = position_of("\\)", at_ + 1, token.place, token.text) + 1;
    } else if (const auto command = commands_.find(token.text); command != commands_.end()) {
      display_command(command->second);
    } else if (is_heading(token)) {
      heading(token);
    } else if (token.is("\\input") || token.is("\\include")) {
      throw FormulaError("the equations of another file are not followed; audit it by itself",
                         token.place);
    } else if (token.is("\\setcounter") || token.is("\\addtocounter")) {
      set_counter(token);
    } else if (token.text.starts_with("\\if") && in_body_) {
      throw FormulaError(token.text + " is not followed; take it out", token.place);
    } else {
      ++at_;
    }
  }

  [[nodiscard]] std::size_t position_of(const char* closing, std::size_t from, Place opened,
                                        const std::string& opening) const {
    for (std::size_t at = from; at < tokens_.size(); ++at) {
      if (tokens_[at].is(closing)) {
        return at;
      }
    }
    throw FormulaError(opening + " is not closed", opened);
  }

  void heading(const Token& token) {
    const std::string title = take_title(tokens_, at_);
    if (!token.is("\\subsection")) {
      section_ = title;
    }
  }

  void set_counter(const Token& token) {
    const bool added = token.is("\\addtocounter");
    const std::string counter = letters_of(take_argument(tokens_, ++at_));
    const std::string number = letters_of(take_argument(tokens_, at_));
    if (counter != "equation") {
      return;
    }
    int value = 0;
    const char* const end = number.data() + number.size();
    if (std::from_chars(number.data(), end, value).ptr != end) {
      throw FormulaError("the numbers of equations are set to '" + number +
                             "', which is not followed; write the number",
                         token.place);
    }
    if (value < -most_numbers || value > most_numbers) {
      throw FormulaError("the numbers of equations are set to more than " +
                             std::to_string(most_numbers) + "; write a smaller number",
                         token.place);
    }
    number_ = std::clamp(value + (added ? number_ : 0), -most_numbers, most_numbers);
  }

  void shown_between(const char* closing) {
    const std::size_t end = position_of(closing, at_ + 1, tokens_[at_].place, tokens_[at_].text);
    show(slice(tokens_, at_ + 1, end), false);
    at_ = end + 1;
  }

  void dollars() {
    const Token& opened = tokens_[at_];
    const bool two = at_ + 1 < tokens_.size() && tokens_[at_ + 1].is("$");
    const std::size_t from = at_ + (two ? 2 : 1);
    const std::size_t end = position_of("$", from, opened.place, two ? "$$" : "$");
    if (two) {
      if (end + 1 >= tokens_.size() || !tokens_[end + 1].is("$")) {
        throw FormulaError("$$ is not closed", opened.place);
      }
      show(slice(tokens_, from, end), false);
    }
    at_ = end + (two ? 2 : 1);
  }

  void display_command(const DisplayCommand& command) {
    const Token called = tokens_[at_++];
    std::vector<Tokens> arguments;
    while (arguments.size() < command.arguments) {
      arguments.push_back(take_argument(tokens_, at_));
    }
    if (!in_body_) {
      return;  // only its definition
    }
    const std::string number = command.number == 0 ? "" : letters_of(arguments[command.number - 1]);
    expect_readable_size(arguments[command.equation - 1]);
    found_.push_back({number.empty() ? line_label(called) : "(" + number + ")", section_,
                      called.place, arguments[command.equation - 1]});
  }

  void environment(const Token& token) {
    const bool begins = token.is("\\begin");
    ++at_;
    std::string name = letters_of(take_argument(tokens_, at_));
    if (name == "document") {
      in_body_ = begins;
      ended_ = !begins;
      return;
    }
    if (name == "subequations") {
      part_ = begins ? 'a' : '\0';
      number_ += begins ? 1 : 0;
      return;
    }
    const bool starred = name.ends_with('*');
    const std::string plain = starred ? name.substr(0, name.size() - 1) : name;
    const auto* const known =
        std::find_if(environments.begin(), environments.end(),
                     [&](const Environment& each) { return each.name == plain; });
    if (begins && (plain == "empheq" || plain == "darray")) {
      throw FormulaError("what is in '" + name + "' is not read; write equation or align",
                         token.place);
    }
    if (!begins || known == environments.end()) {
      return;
    }
    Tokens inside = take_environment(tokens_, at_, name, token);
    if (known->argument) {
      std::size_t behind = 0;
      static_cast<void>(take_argument(inside, behind));
      inside = slice(inside, behind, inside.size());
    }
    const bool counted = !starred && name != "displaymath";
    if (!known->rows) {
      show(inside, counted);
      return;
    }
    // A row that begins with a sign or relation continues the one before it.
    std::vector<Tokens> equations;
    for (const Tokens& row : rows_of(inside)) {
      if (!equations.empty() && continues(row)) {
        equations.back().insert(equations.back().end(), row.begin(), row.end());
      } else if (!row.empty()) {
        equations.push_back(row);
      }
    }
    for (const Tokens& equation : equations) {
      show(equation, counted);
    }
  }

  static std::string line_label(const Token& token) {
    return "line " + std::to_string(token.place.line);
  }

  /// Adds an equation, with its tag if there is one, or else with the next number if it is counted.
  void show(const Tokens& equation, bool counted) {
    if (equation.empty()) {
      return;
    }
    expect_readable_size(equation);
    Tokens rest;
    std::string tag;
    for (std::size_t at = 0; at < equation.size();) {
      const Token& token = equation[at];
      if (token.is("\\tag")) {
        at += at + 1 < equation.size() && equation[at + 1].is("*") ? 2 : 1;
        tag = "(" + letters_of(take_argument(equation, at)) + ")";
      } else if (token.is("\\label")) {
        static_cast<void>(take_argument(equation, ++at));
      } else if (token.is("\\nonumber") || token.is("\\notag")) {
        counted = false;
        ++at;
      } else {
        rest.push_back(token);
        ++at;
      }
    }
    if (tag.empty() && counted) {
      if (part_ > 'z') {
        throw FormulaError("these subequations have more numbers than letters; divide them",
                           equation[0].place);
      }
      tag = part_ == '\0' ? "(" + std::to_string(++number_) + ")"
                          : "(" + std::to_string(number_) + std::string(1, part_++) + ")";
    }
    found_.push_back({tag.empty() ? line_label(equation[0]) : tag, section_, equation[0].place,
                      std::move(rest)});
  }

  const Tokens& tokens_;
  const std::map<std::string, DisplayCommand>& commands_;
  std::size_t at_ = 0;
  bool in_body_ = true;
  bool ended_ = false;
  std::string section_;
  int number_ = 0;
  char part_ = '\0';  ///< for subequations
  std::vector<Displayed> found_;
};

}  // namespace

std::set<std::string> section_titles(const Tokens& tokens) {
  std::set<std::string> titles;
  for (std::size_t at = 0; at < tokens.size();) {
    const Token& token = tokens[at];
    if (!is_heading(token)) {
      ++at;
      continue;
    }
    const std::size_t begin = at;
    try {
      const std::string title = take_title(tokens, at);
      if (!token.is("\\subsection")) {
        titles.insert(title);
      }
    } catch (const FormulaError&) {
      at = begin + 1;  // a definition of the layout of headings
    }
  }
  return titles;
}

std::vector<Displayed> displayed(const Tokens& tokens,
                                 const std::map<std::string, DisplayCommand>& commands) {
  const bool whole = std::any_of(tokens.begin(), tokens.end(),
                                 [](const Token& token) { return token.is("\\documentclass"); });
  if (!whole) {
    return Scanner(tokens, commands).run();
  }
  // Text before the body displays nothing.
  const auto is_begin = [&](std::size_t at) {
    return tokens[at].is("\\begin") && letters_of(slice(tokens, at + 1, at + 11)) == "{document}";
  };
  for (std::size_t at = 0; at < tokens.size(); ++at) {
    if (is_begin(at)) {
      return Scanner(slice(tokens, at, tokens.size()), commands).run();
    }
  }
  return {};
}

}  // namespace assur::generator::latex
