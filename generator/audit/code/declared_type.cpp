#include "audit/code/declared_type.hpp"

#include <algorithm>
#include <set>

namespace assur::generator::audit::code {

namespace {

bool is_one_of(const Token& token, const std::set<std::string>& names) {
  return token.is_name() && names.contains(token.spelling);
}

/// `Matrix2f` for 'f', `VectorXi` for 'i': the names of Eigen's types with such numbers.
bool is_eigen_type_of(const Token& token, char numbers) {
  const std::string& name = token.spelling;
  return token.is_name() && name.size() > 6 && name.ends_with(numbers) &&
         (name.starts_with("Matrix") || name.starts_with("Array") || name.starts_with("Vector") ||
          name.starts_with("RowVector"));
}

bool is_whole_type(const Token& token) {
  static const std::set<std::string> types = {"int", "long", "signed", "Index", "ptrdiff_t"};
  const std::string& name = token.spelling;
  const bool sized = token.is_name() && name.starts_with("int") && name.ends_with("_t");
  return sized || is_one_of(token, types) || is_eigen_type_of(token, 'i');
}

/// Whether values of a type may differ from what was assigned, or sums of them may wrap round.
bool is_rounded_type(const Token& token) {
  static const std::set<std::string> types = {
      "float",   "float_t", "half",     "bfloat16", "bool",   "char",   "short",   "unsigned",
      "wchar_t", "char8_t", "char16_t", "char32_t", "size_t", "int8_t", "int16_t", "byte"};
  const std::string& name = token.spelling;
  const bool sized = token.is_name() && name.starts_with("uint") && name.ends_with("_t");
  return sized || is_one_of(token, types) || is_eigen_type_of(token, 'f');
}

bool is_type_word(const Token& token) {
  return token.is("const") || token.is("constexpr") || token.is("auto") || token.is("double") ||
         token.is("float") || token.is("static") || token.is("inline") || token.is("typename") ||
         is_whole_type(token) || is_rounded_type(token);
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
  // Where no name follows, the last one read is the variable's, and nothing is declared.
  return named && at < tokens.size() && tokens[at].is_name() ? at : 0;
}

ValueSort TypeNames::sort_of(const Token& token) const {
  const auto named = named_.find(token.spelling);
  return named != named_.end()          ? named->second
         : is_eigen_type_of(token, 'd') ? ValueSort::real
         : is_rounded_type(token)       ? ValueSort::rounded
         : is_whole_type(token)         ? ValueSort::whole
                                        : ValueSort::unknown;
}

ValueSort TypeNames::sort_of(Tokens type) const {
  // `long double` is real, `unsigned int` wraps round.
  for (const ValueSort sort : {ValueSort::rounded, ValueSort::real, ValueSort::whole}) {
    if (std::any_of(type.begin(), type.end(),
                    [&](const Token& token) { return sort_of(token) == sort; })) {
      return sort;
    }
  }
  return ValueSort::unknown;
}

void TypeNames::define(const std::string& name, Tokens type) { named_[name] = sort_of(type); }

const char* why_not_read(ValueSort sort) {
  return sort == ValueSort::rounded ? "its type does not keep every number as it is; write double"
                                    : "its type is not known; write double";
}

}  // namespace assur::generator::audit::code
