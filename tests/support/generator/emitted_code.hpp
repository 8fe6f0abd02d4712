// Parts of an emitted solver's text: its code, its structs, and their declarations.
#pragma once

#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace assur::test {

/// The text without comments.
inline std::string code_of(const std::string& text) {
  std::istringstream in(text);
  std::string code;
  std::string line;
  while (std::getline(in, line)) {
    code += line.substr(0, line.find("//")) + "\n";
  }
  return code;
}

/// Every match of a regex's first group.
inline std::vector<std::string> matches_of(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern);
  std::vector<std::string> matches;
  for (std::sregex_iterator at(text.begin(), text.end(), regex), end; at != end; ++at) {
    matches.push_back((*at)[1]);
  }
  return matches;
}

/// How often each identifier occurs in the code.
inline std::map<std::string, int> words_of(const std::string& code) {
  std::map<std::string, int> words;
  std::string word;
  for (const char c : code + " ") {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_') {
      word += c;
    } else if (!word.empty()) {
      ++words[word];
      word.clear();
    }
  }
  return words;
}

/// The lines below the first that ends in `head`, to the one that closes its brace.
inline std::string block_of(const std::string& code, const std::string& head) {
  const std::size_t start = code.find(head + "\n");
  if (start == std::string::npos) {
    return "";
  }
  const std::size_t line = code.rfind('\n', start) + 1;
  const std::string indent(code.find_first_not_of(' ', line) - line, ' ');
  const std::size_t body = code.find('\n', start) + 1;
  return code.substr(body, code.find("\n" + indent + "}", body) + 1 - body);
}

/// A struct at the level of the namespace: a group or the solver.
struct EmittedStruct {
  std::string name;
  std::string code;  ///< of its members
};

inline std::vector<EmittedStruct> structs_of(const std::string& code) {
  std::vector<EmittedStruct> structs;
  for (const std::string& name : matches_of(code, R"(\nstruct (\w+) \{)")) {
    structs.push_back({name, block_of(code, "struct " + name + " {")});
  }
  return structs;
}

/// The functions of a struct, those of its own structs as `Inputs::members const`.
inline std::multiset<std::string> functions_of(const std::string& code) {
  const std::regex function(
      R"(^( +)(?:\[\[nodiscard\]\] )?(?:static )?[\w:]+(?:<.*>)? (\w+)\((?:.*\)( const) \{)?.*)");
  const std::regex nested(R"(^  struct (\w+) \{)");
  std::multiset<std::string> functions;
  std::string inside;
  std::istringstream in(code);
  std::string line;
  while (std::getline(in, line)) {
    std::smatch match;
    if (std::regex_search(line, match, nested)) {
      inside = match[1].str() + "::";
    } else if (line == "  };") {
      inside.clear();
    } else if (std::regex_match(line, match, function) &&
               match[1].length() == (inside.empty() ? 2 : 4)) {
      functions.insert(inside + match[2].str() + match[3].str());
    }
  }
  return functions;
}

}  // namespace assur::test
