#include <algorithm>
#include <array>
#include <assur/text/identifiers.hpp>
#include <set>
#include <string_view>

namespace assur::text {

namespace {

constexpr std::array<std::string_view, 94> keywords = {
    "alignas",      "alignof",   "and",
    "and_eq",       "asm",       "auto",
    "bitand",       "bitor",     "bool",
    "break",        "case",      "catch",
    "char",         "char8_t",   "char16_t",
    "char32_t",     "class",     "compl",
    "concept",      "const",     "const_cast",
    "consteval",    "constexpr", "constinit",
    "continue",     "co_await",  "co_return",
    "co_yield",     "decltype",  "default",
    "delete",       "do",        "double",
    "dynamic_cast", "else",      "enum",
    "explicit",     "export",    "extern",
    "false",        "float",     "for",
    "friend",       "goto",      "if",
    "inline",       "int",       "long",
    "mutable",      "namespace", "new",
    "noexcept",     "not",       "not_eq",
    "nullptr",      "operator",  "or",
    "or_eq",        "private",   "protected",
    "public",       "register",  "reinterpret_cast",
    "requires",     "restrict",  "return",
    "short",        "typeof",    "signed",
    "sizeof",       "static",    "static_assert",
    "static_cast",  "struct",    "switch",
    "template",     "this",      "thread_local",
    "throw",        "true",      "try",
    "typedef",      "typeid",    "typename",
    "union",        "unsigned",  "using",
    "virtual",      "void",      "volatile",
    "wchar_t",      "while",     "xor",
    "xor_eq"};

/// Macros that compilers, a solver's headers, or other headers before these may define.
constexpr std::array<std::string_view, 23> macros = {
    "BUFSIZ", "EOF",      "HUGE_VAL", "I",      "INFINITY", "M_E",    "M_PI",      "NAN",
    "NULL",   "RAND_MAX", "complex",  "errno",  "far",      "linux",  "imaginary", "max",
    "min",    "near",     "noreturn", "stderr", "stdin",    "stdout", "unix"};

/// Types that the templates name: a member or a scene of that name would hide them.
constexpr std::array<std::string_view, 45> template_words = {
    "Assemblies",   "AssemblyStatus", "BatchSolutions",
    "Branch",       "BranchOf",       "Direction",
    "DriverState",  "Drivers",        "Eigen",
    "Frame",        "GivenColumns",   "Group",
    "Groups",       "HeldJoints",     "Lanes",
    "LinkFrame",    "LinkPoint",      "LinkSlide",
    "LinkState",    "Links",          "Matrix",
    "ModelUnknown", "OutputState",    "Outputs",
    "ParameterRow", "Parameters",     "Parts",
    "Placed",       "PlacedGroup",    "Point",
    "Pose",         "Poses",          "Rates",
    "Scalar",       "Slide",          "SlideState",
    "Slides",       "Solution",       "State",
    "Status",       "Track",          "TrigonometricPolynomial",
    "Unresolved",   "Vector",         "support"};

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace

std::string c_identifier(const std::string& text) {
  std::string result = !text.empty() && is_digit(text.front()) ? "_" : "";
  for (const char c : text) {
    result += is_letter(c) || is_digit(c) ? c : '_';
  }
  return result;
}

std::string header_name(const std::string& stem) {
  std::string result;
  for (const char c : stem) {
    if (is_letter(c) || is_digit(c)) {
      result += c;
    } else if (!result.empty() && result.back() != '_') {
      result += '_';
    }
  }
  if (!result.empty() && result.back() == '_') {
    result.pop_back();
  }
  return result.empty() ? "_" : c_identifier(result);
}

std::string struct_name(const std::string& stem, const std::string& word) {
  std::string result;
  bool capital = true;
  for (const char c : stem) {
    if (!is_letter(c) && !is_digit(c)) {
      capital = true;
      continue;
    }
    result += capital && c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    capital = false;
  }
  const auto is_result = [&](std::string_view taken) { return taken == result; };
  const bool prefixed = result.empty() || is_digit(result.front()) ||
                        std::any_of(template_words.begin(), template_words.end(), is_result) ||
                        std::any_of(macros.begin(), macros.end(), is_result);
  return prefixed ? word + result : result;
}

std::vector<std::string> member_names(const std::vector<std::string>& names,
                                      const std::vector<std::string>& taken) {
  std::set<std::string> used(taken.begin(), taken.end());
  used.insert(keywords.begin(), keywords.end());
  used.insert(macros.begin(), macros.end());
  used.insert(template_words.begin(), template_words.end());
  std::vector<std::string> members;
  for (const std::string& name : names) {
    // Names with two underscores, or one in front of a capital, are reserved for the compiler.
    std::string base;
    for (const char c : c_identifier(name)) {
      const bool again = c == '_' && (base.empty() || base.back() == '_');
      base += again ? "" : std::string(1, c);
    }
    if (base.empty() || is_digit(base.front())) {
      base = "n" + base;
    }
    std::string member = base;
    for (int number = 2; !used.insert(member).second; ++number) {
      member = base + (base.back() == '_' ? "" : "_") + std::to_string(number);
    }
    members.push_back(member);
  }
  return members;
}

}  // namespace assur::text
