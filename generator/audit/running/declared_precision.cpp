// Whether a C or C++ file declares parameters of single precision.
#include <algorithm>
#include <cctype>
#include <set>
#include <vector>

#include "audit/running/drivers.hpp"

namespace assur::generator::audit::running {

namespace {

bool is_of_a_name(char letter) {
  return std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '_';
}

/// Names, and other single characters except white space; comments and quoted texts are left out.
std::vector<std::string> tokens(const std::string& text) {
  std::vector<std::string> list;
  for (std::size_t at = 0; at < text.size();) {
    const char letter = text[at];
    if (text.compare(at, 2, "//") == 0) {
      at = std::min(text.find('\n', at), text.size());
    } else if (text.compare(at, 2, "/*") == 0) {
      const std::size_t end = text.find("*/", at + 2);
      at = end == std::string::npos ? text.size() : end + 2;
    } else if (letter == '"' || letter == '\'') {
      for (++at; at < text.size() && text[at] != letter && text[at] != '\n'; ++at) {
        at += text[at] == '\\' ? 1 : 0;
      }
      ++at;
    } else if (is_of_a_name(letter)) {
      const std::size_t begin = at;
      for (; at < text.size() && is_of_a_name(text[at]); ++at) {
      }
      list.push_back(text.substr(begin, at - begin));
    } else {
      if (std::isspace(static_cast<unsigned char>(letter)) == 0) {
        list.emplace_back(1, letter);
      }
      ++at;
    }
  }
  return list;
}

}  // namespace

bool has_single_parameters(const std::string& file_text, const std::string& code) {
  const std::vector<std::string> calls = tokens(code);
  std::set<std::string> called;
  for (std::size_t at = 1; at < calls.size(); ++at) {
    if (calls[at] == "(" && is_of_a_name(calls[at - 1][0])) {
      called.insert(calls[at - 1]);
    }
  }
  const std::vector<std::string> file = tokens(file_text);
  for (std::size_t at = 1; at < file.size(); ++at) {
    if (file[at] != "(" || !called.contains(file[at - 1])) {
      continue;
    }
    // Up to the next parenthesis, which ends a list of parameters or of arguments.
    for (std::size_t inside = at + 1;
         inside < file.size() && file[inside] != ")" && file[inside] != "("; ++inside) {
      if (file[inside] == "float" && file[inside + 1 < file.size() ? inside + 1 : inside] != "(" &&
          (file[inside - 1] == "(" || file[inside - 1] == "," || file[inside - 1] == "const")) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace assur::generator::audit::running
