#include "emission/scene/parameter_text.hpp"

#include <algorithm>
#include <assur/text/names.hpp>
#include <cctype>
#include <cmath>
#include <iterator>
#include <tuple>
#include <vector>

#include "emission/cpp/cpp_text.hpp"

namespace assur::generator::emission::scene {

namespace {

/// A product without its sign, and the sign.
struct SignedText {
  bool negative;
  std::string text;
};

class FormulaText {
 public:
  /// A sum: first the terms that are added, then those that are subtracted, in the order of texts.
  static SignedText sum(const GiNaC::ex& formula) { return joined(terms_of(formula)); }

  /// A sum as a factor: its sign is that of the term whose text comes first. GiNaC's own choice
  /// differs from run to run.
  static SignedText factor(const GiNaC::ex& formula) {
    std::vector<SignedText> terms = terms_of(formula);
    const auto first = std::min_element(
        terms.begin(), terms.end(),
        [](const SignedText& one, const SignedText& other) { return one.text < other.text; });
    const bool negative = first->negative;
    for (SignedText& term : terms) {
      term.negative = term.negative != negative;
    }
    return {negative, joined(std::move(terms)).text};
  }

  static std::string whole(const GiNaC::ex& formula) {
    const SignedText text = sum(formula);
    const bool is_sum = text.negative && GiNaC::is_a<GiNaC::add>(formula);
    return (text.negative ? "-" : "") + (is_sum ? "(" + text.text + ")" : text.text);
  }

 private:
  static std::vector<SignedText> terms_of(const GiNaC::ex& formula) {
    if (is_constant(formula)) {
      return {number(formula)};
    }
    if (!GiNaC::is_a<GiNaC::add>(formula)) {
      return {product(formula)};
    }
    std::vector<SignedText> terms;
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
  static SignedText joined(std::vector<SignedText> terms) {
    const auto is_number = [](const SignedText& term) {
      return std::isdigit(static_cast<unsigned char>(term.text.front())) != 0 &&
             term.text.find(' ') == std::string::npos;
    };
    std::sort(terms.begin(), terms.end(), [&](const SignedText& one, const SignedText& other) {
      return std::tuple(one.negative, is_number(one), one.text) <
             std::tuple(other.negative, is_number(other), other.text);
    });
    const bool negative = terms.front().negative;
    std::string text = terms.front().text;
    for (auto term = std::next(terms.begin()); term != terms.end(); ++term) {
      text += (term->negative == negative ? " + " : " - ") + term->text;
    }
    return {negative, text};
  }

  static SignedText number(const GiNaC::ex& formula) {
    const double value = GiNaC::ex_to<GiNaC::numeric>(formula.evalf()).to_double();
    return {value < 0, cpp::round_trip(std::abs(value))};
  }

  static SignedText product(const GiNaC::ex& formula) {
    Product product;
    if (GiNaC::is_a<GiNaC::mul>(formula)) {
      for (const GiNaC::ex& factor : formula) {
        product.multiply(factor);
      }
    } else {
      product.multiply(formula);
    }
    return product.text();
  }

  class Product {
   public:
    void multiply(const GiNaC::ex& factor) {
      if (is_constant(factor)) {
        number_ *= factor;
      } else if (!GiNaC::is_a<GiNaC::power>(factor)) {
        above_.push_back(atom(factor, true));
      } else {
        const GiNaC::ex& base = factor.op(0);
        const bool divides = factor.op(1).info(GiNaC::info_flags::negative);
        const GiNaC::ex exponent = divides ? GiNaC::ex(-factor.op(1)) : factor.op(1);
        std::vector<std::string>& side = divides ? below_ : above_;
        if (exponent.is_equal(GiNaC::numeric(1, 2))) {
          side.push_back("std::sqrt(" + whole(base) + ")");
        } else if (exponent.is_equal(1) || exponent.is_equal(2)) {
          const std::string text = atom(base, exponent.is_equal(1));
          side.insert(side.end(), exponent.is_equal(1) ? 1 : 2, text);
        } else {
          side.push_back("std::pow(" + power_base(base, exponent) + ", " + whole(exponent) + ")");
        }
      }
    }

    [[nodiscard]] SignedText text() {
      const SignedText number = FormulaText::number(number_);
      std::sort(above_.begin(), above_.end());
      std::sort(below_.begin(), below_.end());
      if (number.text != "1.0" || above_.empty()) {
        above_.insert(above_.begin(), number.text);
      }
      const auto times = [](const std::vector<std::string>& factors) {
        return text::joined(factors, " * ", [](const std::string& factor) { return factor; });
      };
      const std::string divisor = below_.size() > 1 ? "(" + times(below_) + ")" : times(below_);
      return {number.negative, times(above_) + (below_.empty() ? "" : " / " + divisor)};
    }

   private:
    /// A factor that is not a power. The sign of a sum goes to the number, if it `has_sign`.
    std::string atom(const GiNaC::ex& factor, bool has_sign) {
      if (GiNaC::is_a<GiNaC::symbol>(factor)) {
        return GiNaC::ex_to<GiNaC::symbol>(factor).get_name();
      }
      if (GiNaC::is_a<GiNaC::function>(factor)) {
        std::vector<std::string> arguments;
        std::transform(factor.begin(), factor.end(), std::back_inserter(arguments), whole);
        const std::string own_name = GiNaC::ex_to<GiNaC::function>(factor).get_name();
        if (own_name == "sense_of") {
          return "std::copysign(Scalar(1), " + arguments[0] + ")";
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
        return name + "(" +
               text::joined(arguments, ", ", [](const std::string& one) { return one; }) + ")";
      }
      const SignedText inner = FormulaText::factor(factor);
      if (inner.negative && has_sign) {
        number_ = -number_;
      }
      return "(" + inner.text + ")";
    }

    /// The base of a power. If the exponent is whole, GiNaC's choice of its sign is replaced.
    std::string power_base(const GiNaC::ex& base, const GiNaC::ex& exponent) {
      if (!exponent.info(GiNaC::info_flags::integer)) {
        return whole(base);
      }
      const SignedText inner = FormulaText::factor(base);
      if (inner.negative && exponent.info(GiNaC::info_flags::odd)) {
        number_ = -number_;
      }
      return inner.text;
    }

    GiNaC::ex number_ = 1;
    std::vector<std::string> above_, below_;
  };
};

}  // namespace

bool is_constant(const GiNaC::ex& formula) {
  // The evaluation may lose a symbol whose terms cancel by rounding alone.
  const bool has_symbol =
      std::any_of(formula.preorder_begin(), formula.preorder_end(),
                  [](const GiNaC::ex& part) { return GiNaC::is_a<GiNaC::symbol>(part); });
  return !has_symbol && GiNaC::is_a<GiNaC::numeric>(formula.evalf());
}

std::string cpp_formula(const GiNaC::ex& formula) { return FormulaText::whole(formula); }

}  // namespace assur::generator::emission::scene
