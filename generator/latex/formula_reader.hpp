// Recursive-descent reader of LaTeX formulas into trees; its parts share one position.
#pragma once

#include "latex/read_latex.hpp"

namespace assur::generator::latex {

using text::Expression;
using text::Operation;

struct Function;

/// The kind of a factor, which decides what may follow it without a sign.
enum class FactorKind : unsigned char { number, symbol, closed, bare_function };

struct Factor {
  Expression tree;
  FactorKind kind;
};

[[nodiscard]] bool is_fraction(const Token& token);

/// The state of reading one formula, shared by the readers of its parts.
struct Progress {
  std::vector<Place> places;
  std::size_t work = 0;  ///< tokens that were copied, and characters of the map's formulas
};

/// Reads one range of tokens to its end. Every function throws FormulaError at the place of the
/// error.
class FormulaReader {
 public:
  FormulaReader(Tokens tokens, const Reading& reading, Progress& progress, Place place, int depth);

  Expression whole();

 private:
  // The position in the tokens, and trees with their places.
  [[noreturn]] void fail(const std::string& what, std::size_t at) const;
  void skip_spaces();
  Expression read(Tokens tokens, std::size_t at);
  [[nodiscard]] Place place_of(std::size_t at) const;
  std::size_t column(std::size_t at);
  /// Throws if reading the formula would take too long.
  void spend(std::size_t work, std::size_t at);
  Expression call(const std::string& name, Operation operation, std::vector<Expression> arguments,
                  std::size_t at);
  Expression binary(const std::string& name, Operation operation, Expression left, Expression right,
                    std::size_t at);
  Expression number_tree(const std::string& digits, std::size_t at);

  // Sums and products.
  Expression sum();
  /// The next plus or minus outside brackets and groups.
  [[nodiscard]] std::size_t end_of_term() const;
  /// A product, summed over its indices.
  Expression term(const Tokens& tokens, std::size_t at);
  Expression summed(const Tokens& tokens, const std::string& index,
                    const std::vector<std::string>& values, std::size_t at);
  /// \sum_{i=1}^{4} and the product after it.
  Expression explicit_sum(const Tokens& tokens, std::size_t behind, std::size_t at);
  Expression product();
  /// Whether `\frac12`, a fraction of two numbers, begins at a place.
  [[nodiscard]] bool is_fraction_of_numbers(std::size_t at) const;
  /// Throws unless a factor may follow another one without a sign between them.
  void expect_clear_product(const Factor& left, const Token& next, bool spaced) const;

  // Factors.
  /// Adds the power after a factor, if there is one.
  Expression raised(Expression base);
  Expression powered(Expression base, const Tokens& exponent, std::size_t at);
  Factor factor();
  [[noreturn]] void refuse(const Token& token) const;
  Expression number();
  /// The tree of a notation's formula, as if it stood at this place.
  Expression quantity(const Meaning& meaning);
  Expression formula_of(const Meaning& meaning, std::size_t at);
  static void move_to(Expression& tree, std::size_t column);
  /// The tokens between brackets; moves past the closing one.
  Tokens take_brackets();
  Expression bracketed();
  /// Braces are not printed: they must contain one factor, or a product at the end.
  Factor group();
  Expression root();
  Expression fraction();

  // Functions and their arguments.
  /// The function whose name begins at a place.
  [[nodiscard]] const Function* find_function(std::size_t at) const;
  /// `\cos^2\theta`, `\sin(a + b)`, `\operatorname{atan2}(y, x)`.
  Factor called(const Function& function);
  std::pair<std::vector<Expression>, bool> function_arguments(const Function& function,
                                                              std::size_t at);
  /// Removes braces around brackets, which are not printed: `\sin{\left(\theta \right)}`.
  void unwrap_brackets();
  /// `\theta_1`, `2\theta_1`, `\frac{...}{...}`.
  Expression bare_argument();
  Expression bare_symbol();

  // Derivatives.
  /// \frac{\partial^2 x}{\partial a \partial b}, from the tokens after the first signs.
  Expression derivative(const Tokens& of, const Tokens& by, std::size_t at);
  /// A variable of differentiation, and the order.
  struct By {
    Expression symbol;
    int times;
  };
  By read_by(const Tokens& tokens, std::size_t at);
  /// The place after a sign of differentiation; the place itself if there is none.
  using BehindSign = std::function<std::size_t(const Tokens&, std::size_t)>;
  /// The derivatives of a tree with respect to all variables below the bar.
  Expression by_all(const std::string& name, Expression tree, int order, const Tokens& by,
                    const BehindSign& behind_sign, std::size_t at);
  [[nodiscard]] int order_of(const std::string& digits, std::size_t at) const;
  /// The operand of \frac{d}{d t}: a bracket, or the rest of the product.
  Expression operand();
  /// The time derivative of an order.
  Expression rates(Expression of, int order, std::size_t at);
  /// \partial a/\partial b
  Expression inline_derivative();
  /// \frac{d x}{d t}, \frac{d^2 x}{d \theta^2} and \frac{d}{d t}(x)
  Expression total_derivative(const Tokens& above, const Tokens& below, std::size_t at);

  Tokens tokens_;
  const Reading& reading_;
  Progress& progress_;
  Place place_;
  int depth_;
  std::size_t at_ = 0;
};

}  // namespace assur::generator::latex
