#include "audit/code/declared_shape.hpp"

#include <string_view>

namespace assur::generator::audit::code {

namespace {

std::optional<std::size_t> size_in(Tokens tokens) {
  return are(tokens, {"#"}) ? std::optional<std::size_t>(whole_number(tokens[0])) : std::nullopt;
}

/// `Matrix3d`, `Vector3d`, `RowVector3d`: the digit behind the name, and one letter at the end.
std::optional<std::size_t> digit_behind(const std::string& name, std::string_view begins) {
  const bool fits = name.starts_with(begins) && name.size() == begins.size() + 2 &&
                    name[begins.size()] >= '1' && name[begins.size()] <= '9';
  return fits ? std::optional<std::size_t>(name[begins.size()] - '0') : std::nullopt;
}

}  // namespace

DeclaredShape shape_of_type(Tokens type) {
  std::vector<std::size_t> arrays;
  for (std::size_t at = 0; at < type.size(); ++at) {
    const std::string& name = type[at].spelling;
    if (const auto size = digit_behind(name, "Matrix")) {
      return {size, size};
    }
    if (const auto size = digit_behind(name, "Vector")) {
      return {size, 1};
    }
    if (const auto size = digit_behind(name, "RowVector")) {
      return {1, size};
    }
    if ((name == "Matrix" || name == "Array") && at + 1 < type.size() && type[at + 1].is("<")) {
      std::size_t end = at + 2;
      while (end < type.size() && !type[end].is(">")) {
        ++end;
      }
      const std::vector<Tokens> parts = comma_parts(type.subspan(at + 2, end - at - 2));
      return parts.size() < 3 ? DeclaredShape{}
                              : DeclaredShape{size_in(parts[1]), size_in(parts[2])};
    }
    if (name == "array") {
      arrays.push_back(at);
    }
  }
  DeclaredShape shape;
  for (std::size_t at = 1; arrays.size() == 2 && at < type.size(); ++at) {
    if (type[at - 1].is(",")) {  // the inner array's size comes first
      (shape.columns ? shape.rows : shape.columns) = size_in(type.subspan(at, 1));
    }
  }
  return shape;
}

DeclaredShape leading_shape(Tokens tokens) {
  DeclaredShape shape;
  if (!tokens.empty() && tokens[0].is("(")) {
    const auto parts = comma_parts(tokens.subspan(1, behind_closing(tokens, 0) - 2));
    return parts.size() == 2 ? DeclaredShape{size_in(parts[0]), size_in(parts[1])} : shape;
  }
  for (auto* size : {&shape.rows, &shape.columns}) {
    if (tokens.empty() || !tokens[0].is("[")) {
      break;
    }
    const std::size_t end = behind_closing(tokens, 0);
    *size = size_in(tokens.subspan(1, end - 2));
    tokens = tokens.subspan(end);
  }
  return shape;
}

}  // namespace assur::generator::audit::code
