// Reads the symbols of a paper, with accents, indices and primes, as names of quantities.
#pragma once

#include <functional>
#include <optional>

#include "latex/tokens.hpp"

namespace assur::generator::latex {

/// A letter, a Greek letter or an upright word, with accents, index, superscript and primes.
/// Different spellings of one symbol, such as `\dot\theta_1` and `\dot{\theta}_{1}`, have one name.
struct Atom {
  std::string name;  ///< `theta_1`, without dots and superscript
  std::string superscript;
  Tokens power;  ///< the superscript's tokens, if it could be a power
  int dots = 0;
  std::size_t end = 0;  ///< the token after it
};

/// The symbol that begins at a token, or empty. Throws FormulaError for a second index.
[[nodiscard]] std::optional<Atom> read_atom(const Tokens& tokens, std::size_t at);

/// The meaning of a notation of the map.
struct Meaning {
  std::string formula;  ///< in the syntax of audit files; empty: the paper defines it
  std::string name;     ///< as written in the paper
  Tokens power;         ///< of the power after it
  int dots = 0;         ///< above it, apart from those of the notation
  std::size_t end = 0;  ///< the token after it
};

/// The notations of a map.
class Notations {
 public:
  /// Whether a name is that of a quantity.
  using Declared = std::function<bool(const std::string&)>;

  explicit Notations(Declared declared) : declared_(std::move(declared)) {}

  /// A notation may be several symbols. Each `?` in it matches any text, which replaces the `?` of
  /// the formula in order, with commas as underscores; the last text also replaces all further
  /// ones. With an empty formula, the paper defines the quantity.
  void add(const Tokens& notation, const std::string& formula);
  /// Whether a notation has been added, in any spelling.
  [[nodiscard]] bool contains(const Tokens& notation) const;

  /// The meaning at a token by the longest notation of the map, or else by a quantity with the same
  /// name as the symbol, `a_{1}` as `a_1` or `a1`. Empty if there is none. Throws FormulaError for
  /// letters that may be one name or a product.
  [[nodiscard]] std::optional<Meaning> at(const Tokens& tokens, std::size_t at) const;

 private:
  struct Notation {
    std::vector<std::string> pattern;
    std::string formula;
  };

  [[nodiscard]] static std::optional<Meaning> match(const Notation& notation, const Tokens& tokens,
                                                    std::size_t at);
  [[nodiscard]] std::optional<Meaning> by_spelling(const Tokens& tokens, std::size_t at) const;
  void refuse_words(const Tokens& tokens, std::size_t at) const;

  Declared declared_;
  std::vector<Notation> notations_;  ///< the longest first
};

/// The symbols of a whole side, so that different spellings compare equal.
[[nodiscard]] std::vector<std::string> symbols_of(const Tokens& tokens);
/// The matches of the `?` of a pattern in symbols, if it matches them.
[[nodiscard]] std::optional<std::vector<std::string>> matched(
    const std::vector<std::string>& pattern, const std::vector<std::string>& symbols);
/// The formula with each `?` replaced. Throws FormulaError at the place if the formula becomes too
/// long.
[[nodiscard]] std::string filled(const std::string& formula,
                                 const std::vector<std::string>& captured, Place place);

}  // namespace assur::generator::latex
