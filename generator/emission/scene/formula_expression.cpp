#include "emission/scene/formula_expression.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <tuple>
#include <vector>

#include "emission/cpp/statement_text.hpp"

namespace assur::generator::emission::scene {

namespace {

/// A product without its sign, and the sign. Terms and factors are sorted by text.
struct Signed {
  bool negative;
  cpp::Expression value;
  std::string text = cpp::printed(value);
};

class FormulaReader {
 public:
  explicit FormulaReader(const SymbolExpressions& symbols) : symbols_(symbols) {}

  /// A sum: first the terms that are added, then those that are subtracted, sorted by text.
  [[nodiscard]] Signed sum(const GiNaC::ex& formula) const { return joined(terms_of(formula)); }

  /// A sum as a factor: its sign is that of the term whose text comes first. GiNaC's own choice
  /// differs from run to run.
  [[nodiscard]] Signed factor(const GiNaC::ex& formula) const {
    std::vector<Signed> terms = terms_of(formula);
    const auto first = std::min_element(
        terms.begin(), terms.end(),
        [](const Signed& one, const Signed& other) { return one.text < other.text; });
    const bool negative = first->negative;
    for (Signed& term : terms) {
      term.negative = term.negative != negative;
    }
    return {negative, joined(std::move(terms)).value};
  }

  [[nodiscard]] cpp::Expression whole(const GiNaC::ex& formula) const {
    const Signed signed_sum = sum(formula);
    return signed_sum.negative ? cpp::negative(signed_sum.value) : signed_sum.value;
  }

  /// A symbol without an expression is a variable of its name.
  [[nodiscard]] cpp::Expression symbol(const GiNaC::ex& symbol) const {
    const std::string name = GiNaC::ex_to<GiNaC::symbol>(symbol).get_name();
    const auto found = symbols_.find(name);
    return found == symbols_.end() ? cpp::variable(name) : found->second;
  }

 private:
  [[nodiscard]] std::vector<Signed> terms_of(const GiNaC::ex& formula) const {
    if (is_constant(formula)) {
      return {number(formula)};
    }
    if (!GiNaC::is_a<GiNaC::add>(formula)) {
      return {product(formula)};
    }
    std::vector<Signed> terms;
    GiNaC::ex rest;
    for (const GiNaC::ex& term : formula) {
      if (is_constant(term)) {
        rest += term;
      } else {
        terms.push_back(product(term));
      }
    }
    if (!rest.is_zero()) {
      terms.push_back(number(rest));
    }
    return terms;
  }

  /// The sum is negative if all terms are. A number comes last among terms of its sign.
  static Signed joined(std::vector<Signed> terms) {
    std::sort(terms.begin(), terms.end(), [](const Signed& one, const Signed& other) {
      return std::tuple(one.negative, one.value.is_number(), one.text) <
             std::tuple(other.negative, other.value.is_number(), other.text);
    });
    const bool negative = terms.front().negative;
    std::vector<cpp::Expression> parts;
    for (const Signed& term : terms) {
      parts.push_back(term.negative == negative ? term.value : cpp::negative(term.value));
    }
    return {negative, cpp::sum(std::move(parts))};
  }

  static Signed number(const GiNaC::ex& formula) {
    const double value = GiNaC::ex_to<GiNaC::numeric>(formula.evalf()).to_double();
    return {value < 0, cpp::number(std::abs(value))};
  }

  [[nodiscard]] Signed product(const GiNaC::ex& formula) const {
    Product product(*this);
    if (GiNaC::is_a<GiNaC::mul>(formula)) {
      for (const GiNaC::ex& factor : formula) {
        product.multiply(factor);
      }
    } else {
      product.multiply(formula);
    }
    return product.value();
  }

  class Product {
   public:
    explicit Product(const FormulaReader& reader) : reader_(reader) {}

    void multiply(const GiNaC::ex& factor) {
      if (is_constant(factor)) {
        number_ *= factor;
      } else if (!GiNaC::is_a<GiNaC::power>(factor)) {
        above_.push_back(atom(factor, true));
      } else {
        const GiNaC::ex& base = factor.op(0);
        const bool divides = factor.op(1).info(GiNaC::info_flags::negative);
        const GiNaC::ex exponent = divides ? GiNaC::ex(-factor.op(1)) : factor.op(1);
        std::vector<cpp::Expression>& side = divides ? below_ : above_;
        if (exponent.is_equal(GiNaC::numeric(1, 2))) {
          side.push_back(cpp::call(cpp::scalar_only("std::sqrt"), {reader_.whole(base)}));
        } else if (exponent.is_equal(1) || exponent.is_equal(2)) {
          side.insert(side.end(), exponent.is_equal(1) ? 1 : 2, atom(base, exponent.is_equal(1)));
        } else {
          side.push_back(cpp::call(cpp::scalar_only("std::pow"),
                                   {power_base(base, exponent), reader_.whole(exponent)}));
        }
      }
    }

    [[nodiscard]] Signed value() {
      const Signed number = FormulaReader::number(number_);
      sort(above_);
      sort(below_);
      if (!number.value.is_number(1) || above_.empty()) {
        above_.insert(above_.begin(), number.value);
      }
      const cpp::Expression above = cpp::product(above_);
      return {number.negative, below_.empty() ? above : cpp::quotient(above, cpp::product(below_))};
    }

   private:
    static void sort(std::vector<cpp::Expression>& factors) {
      std::sort(factors.begin(), factors.end(),
                [](const cpp::Expression& one, const cpp::Expression& other) {
                  return cpp::printed(one) < cpp::printed(other);
                });
    }

    /// A factor that is not a power. The sign of a sum goes to the number, if it `has_sign`.
    cpp::Expression atom(const GiNaC::ex& factor, bool has_sign) {
      if (GiNaC::is_a<GiNaC::symbol>(factor)) {
        return reader_.symbol(factor);
      }
      if (GiNaC::is_a<GiNaC::function>(factor)) {
        std::vector<cpp::Expression> arguments;
        for (const GiNaC::ex& argument : factor) {
          arguments.push_back(reader_.whole(argument));
        }
        const std::string own_name = GiNaC::ex_to<GiNaC::function>(factor).get_name();
        if (own_name == "sense_of") {
          const cpp::Expression one = cpp::call("Scalar", {cpp::word("1")});
          return cpp::call(cpp::scalar_only("std::copysign"), {one, std::move(arguments[0])});
        }
        std::string name = own_name == "absolute"     ? "std::abs"
                           : own_name == "smaller_of" ? "std::min<Scalar>"
                           : own_name == "larger_of"  ? "std::max<Scalar>"
                                                      : "std::" + own_name;
        if (arguments.size() == 4) {
          const auto order = [&factor](std::size_t place) {
            return std::to_string(GiNaC::ex_to<GiNaC::numeric>(factor.op(place)).to_int());
          };
          name = "support::power_derivative<" + order(2) + ", " + order(3) + ">";
          arguments.resize(2);
        }
        return cpp::call(cpp::scalar_only(name), std::move(arguments));
      }
      const Signed inner = reader_.factor(factor);
      if (inner.negative && has_sign) {
        number_ = -number_;
      }
      return cpp::parentheses(inner.value);
    }

    /// The base of a power. With an integer exponent, GiNaC's choice of its sign is replaced.
    cpp::Expression power_base(const GiNaC::ex& base, const GiNaC::ex& exponent) {
      if (!exponent.info(GiNaC::info_flags::integer)) {
        return reader_.whole(base);
      }
      const Signed inner = reader_.factor(base);
      if (inner.negative && exponent.info(GiNaC::info_flags::odd)) {
        number_ = -number_;
      }
      return inner.value;
    }

    const FormulaReader& reader_;
    GiNaC::ex number_ = 1;
    std::vector<cpp::Expression> above_, below_;
  };

  const SymbolExpressions& symbols_;
};

}  // namespace

bool is_constant(const GiNaC::ex& formula) {
  // Evaluation may lose a symbol whose terms cancel only by rounding.
  const bool has_symbol =
      std::any_of(formula.preorder_begin(), formula.preorder_end(),
                  [](const GiNaC::ex& part) { return GiNaC::is_a<GiNaC::symbol>(part); });
  return !has_symbol && GiNaC::is_a<GiNaC::numeric>(formula.evalf());
}

cpp::Expression expression_of(const GiNaC::ex& formula, const SymbolExpressions& symbols) {
  return FormulaReader(symbols).whole(formula);
}

}  // namespace assur::generator::emission::scene
