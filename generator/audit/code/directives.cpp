// Checks preprocessor lines: those that may change the meaning of the code are refused.
#include <algorithm>
#include <set>

#include "audit/code/cpp_file.hpp"

namespace assur::generator::audit::code {

namespace {

/// Whether a header is known not to change the meaning of the code.
bool is_standard_header(const std::string& name) {
  static const std::set<std::string> known = {"algorithm",
                                              "array",
                                              "cassert",
                                              "cfloat",
                                              "chrono",
                                              "climits",
                                              "cmath",
                                              "complex",
                                              "cstddef",
                                              "cstdint",
                                              "cstdio",
                                              "cstdlib",
                                              "cstring",
                                              "ctime",
                                              "deque",
                                              "float.h",
                                              "fstream",
                                              "functional",
                                              "initializer_list",
                                              "iomanip",
                                              "iostream",
                                              "istream",
                                              "iterator",
                                              "limits",
                                              "list",
                                              "map",
                                              "math.h",
                                              "memory",
                                              "numbers",
                                              "numeric",
                                              "optional",
                                              "ostream",
                                              "random",
                                              "set",
                                              "span",
                                              "sstream",
                                              "stdexcept",
                                              "stdint.h",
                                              "stdio.h",
                                              "stdlib.h",
                                              "string",
                                              "string.h",
                                              "string_view",
                                              "tuple",
                                              "type_traits",
                                              "unordered_map",
                                              "utility",
                                              "variant",
                                              "vector",
                                              "assert.h",
                                              "stddef.h",
                                              "stdbool.h"};
  return known.contains(name) || name.starts_with("Eigen/");
}

/// The words of a directive, without a trailing comment.
std::vector<std::string> words_of(const std::string& directive) {
  const std::size_t end = std::min(directive.find("//"), directive.find("/*"));
  std::vector<std::string> words;
  std::string word;
  for (const char letter : directive.substr(1, std::max<std::size_t>(end, 1) - 1) + " ") {
    if (letter == '<' && !word.empty()) {
      words.push_back(std::move(word));
      word = letter;
    } else if (letter != ' ' && letter != '\t' && letter != '\r') {
      word += letter;
    } else if (!word.empty()) {
      words.push_back(std::move(word));
      word.clear();
    }
  }
  return words;
}

bool includes_known(const std::vector<std::string>& words) {
  if (words.size() != 2 || words[0] != "include" || words[1].size() < 3) {
    return false;
  }
  const std::string& name = words[1];
  return name.front() == '<' && name.back() == '>' && name.find("..") == std::string::npos &&
         is_standard_header(name.substr(1, name.size() - 2));
}

/// Whether a name is a safe include guard: not predefined by compilers nor used by the code.
bool guards(const std::string& name, Tokens tokens) {
  return !name.starts_with("__") &&
         std::none_of(tokens.begin(), tokens.end(), [&](const Token& token) {
           return token.is_name() && token.spelling == name;
         });
}

}  // namespace

void check_directives(Tokens tokens) {
  std::vector<const Token*> all;
  for (const Token& token : tokens) {
    if (token.kind == Token::Kind::directive) {
      all.push_back(&token);
      const std::string& text = token.spelling;
      const std::size_t comment = text.find("/*");
      const std::size_t end =
          comment == std::string::npos ? std::string::npos : text.find("*/", comment + 2);
      const bool ends =
          end != std::string::npos && text.find_first_not_of(" \t\r", end + 2) == std::string::npos;
      if (comment < text.find("//") && !ends) {
        throw CodeError("a comment that begins here may hide what follows; end it in this line",
                        token.place);
      }
    }
  }
  const auto words = [&](std::size_t at) { return words_of(all[at]->spelling); };
  std::size_t from = 0;
  std::size_t to = all.size();
  if (to >= 3 && all[0] == &tokens.front() && all[1] == &tokens[1] &&
      all[to - 1] == &tokens.back()) {
    const std::vector<std::string> opened = words(0);
    const std::vector<std::string> defined = words(1);
    const std::vector<std::string> closed = words(to - 1);
    if (opened.size() == 2 && opened[0] == "ifndef" && defined.size() == 2 &&
        defined[0] == "define" && defined[1] == opened[1] && guards(opened[1], tokens) &&
        !closed.empty() && closed[0] == "endif") {
      from += 2;
      to -= 1;
    }
  }
  for (; from < to; ++from) {
    const std::vector<std::string> line = words(from);
    const std::string& text = all[from]->spelling;
    // `_USE_MATH_DEFINES` makes the header declare M_PI.
    if (includes_known(line) || line == std::vector<std::string>{"pragma", "once"} ||
        line == std::vector<std::string>{"define", "_USE_MATH_DEFINES"}) {
      continue;
    }
    const bool header = !line.empty() && line[0].starts_with("include");
    throw CodeError(
        header ? "a header of your own may define macros that change what this says" + by_running
               : "'" + text.substr(0, text.find('\n')) + "' may change what the code says" +
                     by_running,
        all[from]->place);
  }
}

}  // namespace assur::generator::audit::code
