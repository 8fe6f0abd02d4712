#include "latex/indices.hpp"

namespace assur::generator::latex {

Tokens with_index(const Tokens& tokens, const std::string& index, const std::string& value) {
  Tokens result;
  for (std::size_t at = 0; at < tokens.size(); ++at) {
    result.push_back(tokens[at]);
    if (!tokens[at].is("_") || at + 1 >= tokens.size()) {
      continue;
    }
    const std::size_t end = end_of_argument(tokens, at + 1);
    const bool group = tokens[at + 1].is("{");
    for (++at; at < end; ++at) {
      if (result.size() > longest_equation) {
        throw FormulaError("with the values of its indices, this has more than " +
                               std::to_string(longest_equation) + " tokens",
                           tokens[at].place);
      }
      if (tokens[at].text != index) {
        result.push_back(tokens[at]);
        continue;
      }
      Token part = tokens[at];
      for (const char digit : (group ? value : "{" + value + "}")) {
        part.text = std::string(1, digit);
        result.push_back(part);
      }
    }
    --at;
  }
  return result;
}

bool has_index(const Tokens& tokens, const std::string& index) {
  for (std::size_t at = 0; at + 1 < tokens.size(); ++at) {
    if (!tokens[at].is("_")) {
      continue;
    }
    const std::size_t end = end_of_argument(tokens, at + 1);
    for (std::size_t inside = at + 1; inside < end; ++inside) {
      if (tokens[inside].text == index) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace assur::generator::latex
