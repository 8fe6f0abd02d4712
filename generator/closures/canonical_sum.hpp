// A canonical form of expressions: a sum of products whose order and signs depend only on the
// mathematics.
#pragma once

#include <ginac/ginac.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace assur::generator::closures {

class CanonicalSum;

/// An integer power of a factor with a text: a name, a function, a root, or a sum in parentheses.
struct CanonicalFactor {
  enum class Kind : unsigned char { plain, sum, root };

  Kind kind = Kind::plain;
  std::shared_ptr<const CanonicalSum> inside = nullptr;  ///< of a sum or a root
  GiNaC::numeric exponent = 1;
};

/// A number times factors, sorted by their texts.
struct CanonicalTerm {
  GiNaC::numeric coefficient = 1;
  std::map<std::string, CanonicalFactor> factors = {};

  /// The text without the sign of the coefficient.
  [[nodiscard]] std::string size_text() const;
};

/// GiNaC orders terms by addresses, and the signs of the sums in a product depend on that order:
/// 1/(a - b) is -1/(b - a) in some runs. Here terms are sorted by their texts, and a sum that is a
/// factor, or the argument of an odd or even function, begins with a plus; the product takes the
/// sign that this may require.
class CanonicalSum {
 public:
  explicit CanonicalSum(const GiNaC::ex& expression);

  /// The terms, sorted by their texts without signs.
  [[nodiscard]] const std::vector<CanonicalTerm>& terms() const { return terms_; }
  [[nodiscard]] std::string text() const;
  /// Whether this is the negative of the two opposite sums: its first term is negative.
  [[nodiscard]] bool is_reversed() const;
  [[nodiscard]] CanonicalSum scaled(const GiNaC::numeric& factor) const;

 private:
  explicit CanonicalSum(std::vector<CanonicalTerm> terms) : terms_(std::move(terms)) { gather(); }

  /// Adds up like terms, and sorts.
  void gather();
  /// The number that divides all coefficients into coprime integers, the first one positive.
  [[nodiscard]] GiNaC::numeric content() const;
  static void multiply(CanonicalTerm& product, const std::string& text, CanonicalFactor factor);
  static void multiply(CanonicalTerm& product, const CanonicalSum& sum,
                       const GiNaC::numeric& exponent);
  static void multiply(CanonicalTerm& product, const GiNaC::ex& factor);
  static void multiply_function(CanonicalTerm& product, const GiNaC::ex& function);
  static void multiply_power(CanonicalTerm& product, const GiNaC::ex& power);

  std::vector<CanonicalTerm> terms_;
};

}  // namespace assur::generator::closures
