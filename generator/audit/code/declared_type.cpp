#include "audit/code/declared_type.hpp"

#include <set>

namespace assur::generator::audit::code {

bool is_whole_type(const Token& token) {
  static const std::set<std::string> types = {
      "int",     "long",    "short",   "unsigned",  "signed",   "char",
      "bool",    "Index",   "size_t",  "ptrdiff_t", "int8_t",   "int16_t",
      "int32_t", "int64_t", "uint8_t", "uint16_t",  "uint32_t", "uint64_t"};
  const std::string& name = token.spelling;
  const bool of_whole = name.size() > 6 && name.ends_with('i') &&
                        (name.starts_with("Matrix") || name.starts_with("Array") ||
                         name.starts_with("Vector") || name.starts_with("RowVector"));
  return token.is_name() && (types.contains(name) || of_whole);
}

namespace {

bool is_type_word(const Token& token) {
  return token.is("const") || token.is("constexpr") || token.is("auto") || token.is("double") ||
         token.is("float") || token.is("static") || token.is("inline") || token.is("typename") ||
         is_whole_type(token);
}

}  // namespace

std::size_t type_length(Tokens tokens) {
  std::size_t at = 0;
  bool named = false;
  while (at < tokens.size()) {
    if (is_type_word(tokens[at])) {
      named = named ||
              !(tokens[at].is("const") || tokens[at].is("constexpr") || tokens[at].is("static") ||
                tokens[at].is("inline") || tokens[at].is("typename"));
      ++at;
    } else if (!named && tokens[at].is_name()) {
      named = true;
      ++at;
      while (at + 1 < tokens.size() && tokens[at].is("::") && tokens[at + 1].is_name()) {
        at += 2;
      }
    } else if (named && tokens[at].is("<")) {
      int depth = 0;
      do {
        depth += tokens[at].is("<") ? 1 : tokens[at].is(">") ? -1 : tokens[at].is(">>") ? -2 : 0;
        ++at;
      } while (depth > 0 && at < tokens.size());
      while (at + 1 < tokens.size() && tokens[at].is("::") && tokens[at + 1].is_name()) {
        at += 2;
      }
    } else if (named && (tokens[at].is("&") || tokens[at].is("*") || tokens[at].is("&&"))) {
      ++at;
    } else {
      break;
    }
  }
  // The last name read is the variable's, unless one stands behind.
  return named && at < tokens.size() && tokens[at].is_name() ? at : 0;
}

}  // namespace assur::generator::audit::code
