#include "closures/canonical_sum.hpp"

#include <algorithm>
#include <assur/text/names.hpp>
#include <sstream>

namespace assur::generator::closures {

namespace {

std::string plain(const GiNaC::ex& expression) {
  std::ostringstream out;
  out << expression;
  return out.str();
}

/// Names before calls and sums.
bool names_first(const std::string& left, const std::string& right) {
  const bool calls = left.find('(') != std::string::npos;
  const bool other_calls = right.find('(') != std::string::npos;
  return calls != other_calls ? other_calls : left < right;
}

}  // namespace

CanonicalSum::CanonicalSum(const GiNaC::ex& expression) {
  if (GiNaC::is_a<GiNaC::add>(expression)) {
    for (const GiNaC::ex& part : expression) {
      const CanonicalSum sum(part);
      terms_.insert(terms_.end(), sum.terms_.begin(), sum.terms_.end());
    }
    gather();
    return;
  }
  CanonicalTerm term;
  if (GiNaC::is_a<GiNaC::mul>(expression)) {
    for (const GiNaC::ex& factor : expression) {
      multiply(term, factor);
    }
  } else {
    multiply(term, expression);
  }
  // A number times a sum is a sum.
  if (term.factors.size() == 1 && term.factors.begin()->second.exponent.is_equal(1) &&
      term.factors.begin()->second.kind == CanonicalFactor::Kind::sum) {
    *this = term.factors.begin()->second.inside->scaled(term.coefficient);
  } else if (!term.coefficient.is_zero()) {
    terms_.push_back(std::move(term));
  }
}

void CanonicalSum::gather() {
  std::map<std::string, CanonicalTerm> alike;
  for (CanonicalTerm& term : terms_) {
    GiNaC::numeric coefficient = 1;
    std::swap(coefficient, term.coefficient);
    const auto [entry, is_new] = alike.try_emplace(term.size_text(), term);
    entry->second.coefficient = is_new ? coefficient : entry->second.coefficient + coefficient;
  }
  std::map<std::string, CanonicalTerm> sorted;
  for (auto& [text, term] : alike) {
    if (!term.coefficient.is_zero()) {
      std::string size = term.size_text();
      sorted.emplace(std::move(size), std::move(term));
    }
  }
  terms_.clear();
  for (auto& [text, term] : sorted) {
    terms_.push_back(std::move(term));
  }
}

bool CanonicalSum::is_reversed() const {
  return !terms_.empty() && terms_.front().coefficient.is_negative();
}

CanonicalSum CanonicalSum::scaled(const GiNaC::numeric& factor) const {
  std::vector<CanonicalTerm> terms = terms_;
  for (CanonicalTerm& term : terms) {
    term.coefficient *= factor;
  }
  return CanonicalSum(std::move(terms));
}

GiNaC::numeric CanonicalSum::content() const {
  GiNaC::numeric numerators = 0;
  GiNaC::numeric denominators = 1;
  for (const CanonicalTerm& term : terms_) {
    if (!term.coefficient.is_rational()) {
      return 1;
    }
    numerators = GiNaC::gcd(numerators, term.coefficient.numer());
    denominators = GiNaC::lcm(denominators, term.coefficient.denom());
  }
  const GiNaC::numeric size = GiNaC::abs(numerators / denominators);
  // The order of the terms may change when their coefficients become smaller.
  return scaled(size.inverse()).is_reversed() ? -size : size;
}

void CanonicalSum::multiply(CanonicalTerm& product, const std::string& text,
                            CanonicalFactor factor) {
  const auto entry = product.factors.find(text);
  if (entry != product.factors.end()) {
    factor.exponent += entry->second.exponent;
    product.factors.erase(entry);
  }
  if (factor.kind == CanonicalFactor::Kind::root && factor.exponent.is_even()) {
    multiply(product, *factor.inside, factor.exponent / 2);
  } else if (!factor.exponent.is_zero()) {
    product.factors.emplace(text, std::move(factor));
  }
}

void CanonicalSum::multiply(CanonicalTerm& product, const CanonicalSum& sum,
                            const GiNaC::numeric& exponent) {
  if (exponent.is_zero()) {
    return;
  }
  if (sum.terms_.empty()) {
    if (exponent.is_positive()) {
      product.coefficient = 0;
    } else {
      multiply(product, "0", {CanonicalFactor::Kind::plain, nullptr, exponent});
    }
  } else if (sum.terms_.size() == 1) {
    product.coefficient *= GiNaC::pow(sum.terms_.front().coefficient, exponent);
    for (const auto& [text, factor] : sum.terms_.front().factors) {
      CanonicalFactor power = factor;
      power.exponent *= exponent;
      multiply(product, text, std::move(power));
    }
  } else {
    const GiNaC::numeric content = sum.content();
    auto inside = std::make_shared<const CanonicalSum>(sum.scaled(content.inverse()));
    product.coefficient *= GiNaC::pow(content, exponent);
    const std::string text = "(" + inside->text() + ")";
    multiply(product, text, {CanonicalFactor::Kind::sum, std::move(inside), exponent});
  }
}

void CanonicalSum::multiply(CanonicalTerm& product, const GiNaC::ex& factor) {
  if (GiNaC::is_a<GiNaC::numeric>(factor) && factor.info(GiNaC::info_flags::real)) {
    product.coefficient *= GiNaC::ex_to<GiNaC::numeric>(factor);
  } else if (GiNaC::is_a<GiNaC::add>(factor) || GiNaC::is_a<GiNaC::mul>(factor)) {
    multiply(product, CanonicalSum(factor), 1);
  } else if (GiNaC::is_a<GiNaC::power>(factor)) {
    multiply_power(product, factor);
  } else if (GiNaC::is_a<GiNaC::function>(factor)) {
    multiply_function(product, factor);
  } else {
    multiply(product, plain(factor), CanonicalFactor{});
  }
}

void CanonicalSum::multiply_function(CanonicalTerm& product, const GiNaC::ex& function) {
  const std::string name = GiNaC::ex_to<GiNaC::function>(function).get_name();
  const bool odd = name == "sin" || name == "tan" || name == "asin" || name == "atan";
  std::vector<CanonicalSum> arguments;
  for (const GiNaC::ex& argument : function) {
    arguments.emplace_back(argument);
  }
  if ((odd || name == "cos") && arguments[0].is_reversed()) {
    arguments[0] = arguments[0].scaled(-1);
    product.coefficient *= odd ? -1 : 1;
  }
  const std::string inner = assur::text::joined(
      arguments, ", ", [](const CanonicalSum& argument) { return argument.text(); });
  multiply(product, name + "(" + inner + ")", CanonicalFactor{});
}

void CanonicalSum::multiply_power(CanonicalTerm& product, const GiNaC::ex& power) {
  const CanonicalSum base(power.op(0));
  const GiNaC::ex twice = 2 * power.op(1);
  if (power.op(1).info(GiNaC::info_flags::integer)) {
    multiply(product, base, GiNaC::ex_to<GiNaC::numeric>(power.op(1)));
  } else if (twice.info(GiNaC::info_flags::integer)) {
    multiply(product, "sqrt(" + base.text() + ")",
             {CanonicalFactor::Kind::root, std::make_shared<const CanonicalSum>(base),
              GiNaC::ex_to<GiNaC::numeric>(twice)});
  } else {
    const bool below = power.op(1).info(GiNaC::info_flags::negative);
    const std::string exponent = CanonicalSum(below ? -power.op(1) : power.op(1)).text();
    multiply(product, "(" + base.text() + ")^(" + exponent + ")",
             {CanonicalFactor::Kind::plain, nullptr, below ? -1 : 1});
  }
}

std::string CanonicalTerm::size_text() const {
  std::vector<std::string> above;
  std::vector<std::string> below;
  for (const auto& [text, factor] : factors) {
    const GiNaC::numeric size = GiNaC::abs(factor.exponent);
    (factor.exponent.is_negative() ? below : above)
        .push_back(size.is_equal(1) ? text : text + "^" + plain(size));
  }
  std::sort(above.begin(), above.end(), names_first);
  std::sort(below.begin(), below.end(), names_first);
  const GiNaC::numeric size = GiNaC::abs(coefficient);
  if (!size.numer().is_equal(1) || above.empty()) {
    above.insert(above.begin(), plain(size.numer()));
  }
  if (!size.denom().is_equal(1)) {
    below.insert(below.begin(), plain(size.denom()));
  }
  std::string text = assur::text::joined(above, "*");
  if (below.empty()) {
    return text;
  }
  return text + "/" + (below.size() > 1 ? "(" : "") + assur::text::joined(below, "*") +
         (below.size() > 1 ? ")" : "");
}

std::string CanonicalSum::text() const {
  std::string text;
  for (const bool negative : {false, true}) {  // a sum begins with a plus if it can
    for (const CanonicalTerm& term : terms_) {
      if (term.coefficient.is_negative() == negative) {
        text += text.empty() ? (negative ? "-" : "") : (negative ? " - " : " + ");
        text += term.size_text();
      }
    }
  }
  return text.empty() ? "0" : text;
}

}  // namespace assur::generator::closures
