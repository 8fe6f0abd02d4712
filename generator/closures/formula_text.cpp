#include "closures/formula_text.hpp"

#include <algorithm>
#include <sstream>
#include <vector>

namespace assur::generator {

namespace {

enum class Binding : unsigned char { sum, product, power };

std::string text(const GiNaC::ex& expression, Binding outside);

std::string plain(const GiNaC::ex& expression) {
  std::ostringstream out;
  out << expression;
  return out.str();
}

std::string enclosed(const std::string& inner, bool needed) {
  return needed ? "(" + inner + ")" : inner;
}

/// The terms of a sum by their texts, whatever their signs.
std::vector<std::string> sorted_terms(const GiNaC::ex& sum) {
  std::vector<std::string> terms;
  for (const GiNaC::ex& term : sum) {
    terms.push_back(text(term, Binding::sum));
  }
  const auto key = [](const std::string& term) {
    return std::pair(term[0] == '-' ? term.substr(1) : term, term[0] == '-');
  };
  std::sort(terms.begin(), terms.end(), [&](const std::string& left, const std::string& right) {
    return key(left) < key(right);
  });
  return terms;
}

/// Whether the opposite is shown in odd functions and in powers: GiNaC takes signs out of them, or
/// leaves them there, as its addresses fall.
bool is_reversed(const GiNaC::ex& expression) {
  const bool sum = GiNaC::is_a<GiNaC::add>(expression);
  return (sum ? sorted_terms(expression)[0] : text(expression, Binding::sum))[0] == '-';
}

std::string sum_text(const GiNaC::ex& sum) {
  std::vector<std::string> terms = sorted_terms(sum);
  // A sum begins with a plus where it can.
  std::stable_partition(terms.begin(), terms.end(),
                        [](const std::string& term) { return term[0] != '-'; });
  std::string all = terms[0];
  for (std::size_t place = 1; place < terms.size(); ++place) {
    const bool negative = terms[place][0] == '-';
    all += (negative ? " - " : " + ") + terms[place].substr(negative ? 1 : 0);
  }
  return all;
}

/// A whole power of a sum.
struct SumPower {
  bool negative = false;
  bool below = false;  ///< a fraction bar
  std::string text;
};

bool is_sum_power(const GiNaC::ex& expression) {
  return GiNaC::is_a<GiNaC::power>(expression) && GiNaC::is_a<GiNaC::add>(expression.op(0)) &&
         expression.op(1).info(GiNaC::info_flags::integer);
}

SumPower sum_power(const GiNaC::ex& power) {
  const bool reversed = is_reversed(power.op(0));
  const auto exponent = GiNaC::ex_to<GiNaC::numeric>(power.op(1));
  const GiNaC::ex base = reversed ? -power.op(0) : power.op(0);
  const GiNaC::numeric size = abs(exponent);
  return {reversed && exponent.is_odd(), exponent.is_negative(),
          text(base, Binding::power) + (size.is_equal(1) ? "" : "^" + plain(size))};
}

std::string function_text(const GiNaC::ex& function) {
  const std::string name = GiNaC::ex_to<GiNaC::function>(function).get_name();
  const bool odd = name == "sin" || name == "tan" || name == "asin" || name == "atan";
  if ((odd || name == "cos") && is_reversed(function.op(0))) {
    return (odd ? "-" : "") + name + "(" + text(-function.op(0), Binding::sum) + ")";
  }
  std::string inner;
  for (const GiNaC::ex& argument : function) {
    inner += (inner.empty() ? "" : ", ") + text(argument, Binding::sum);
  }
  return name + "(" + inner + ")";
}

std::string product_text(const GiNaC::ex& product) {
  GiNaC::numeric factor = 1;
  std::vector<std::string> above;
  std::vector<std::string> below;
  for (const GiNaC::ex& part : product) {
    if (GiNaC::is_a<GiNaC::numeric>(part)) {
      factor *= GiNaC::ex_to<GiNaC::numeric>(part);
    } else if (is_sum_power(part)) {
      const SumPower power = sum_power(part);
      factor *= power.negative ? -1 : 1;
      (power.below ? below : above).push_back(power.text);
    } else if (GiNaC::is_a<GiNaC::function>(part)) {
      const std::string shown = function_text(part);
      factor *= shown[0] == '-' ? -1 : 1;
      above.push_back(shown.substr(shown[0] == '-' ? 1 : 0));
    } else if (GiNaC::is_a<GiNaC::power>(part) && part.op(1).info(GiNaC::info_flags::negative)) {
      below.push_back(text(1 / part, Binding::product));
    } else {
      above.push_back(text(part, Binding::product));
    }
  }
  const auto names_first = [](const std::string& left, const std::string& right) {
    const bool calls = left.find('(') != std::string::npos;
    const bool other_calls = right.find('(') != std::string::npos;
    return calls != other_calls ? other_calls : left < right;
  };
  std::sort(above.begin(), above.end(), names_first);
  std::sort(below.begin(), below.end(), names_first);
  const GiNaC::numeric size = abs(factor);
  if (!size.numer().is_equal(1) || above.empty()) {
    above.insert(above.begin(), plain(size.numer()));
  }
  if (!size.denom().is_equal(1)) {
    below.insert(below.begin(), plain(size.denom()));
  }
  const auto joined = [](const std::vector<std::string>& parts) {
    std::string all = parts[0];
    for (std::size_t place = 1; place < parts.size(); ++place) {
      all += "*" + parts[place];
    }
    return all;
  };
  const std::string sign = factor.is_negative() ? "-" : "";
  if (below.empty()) {
    return sign + joined(above);
  }
  return sign + joined(above) + "/" + enclosed(joined(below), below.size() > 1);
}

std::string power_text(const GiNaC::ex& power) {
  const GiNaC::ex& base = power.op(0);
  const GiNaC::ex& exponent = power.op(1);
  if (exponent.info(GiNaC::info_flags::negative)) {
    return "1/" + text(1 / power, Binding::power);
  }
  if (exponent.is_equal(GiNaC::numeric(1, 2))) {
    return "sqrt(" + text(base, Binding::sum) + ")";
  }
  if ((2 * exponent).info(GiNaC::info_flags::integer) &&
      !exponent.info(GiNaC::info_flags::integer)) {
    return "sqrt(" + text(base, Binding::sum) + ")^" + plain(2 * exponent);
  }
  const std::string shown = plain(exponent);
  return text(base, Binding::power) + "^" +
         enclosed(shown, !exponent.info(GiNaC::info_flags::posint));
}

std::string text(const GiNaC::ex& expression, Binding outside) {
  if (GiNaC::is_a<GiNaC::add>(expression)) {
    return enclosed(sum_text(expression), outside != Binding::sum);
  }
  if (GiNaC::is_a<GiNaC::mul>(expression)) {
    return enclosed(product_text(expression), outside == Binding::power);
  }
  if (is_sum_power(expression)) {
    const SumPower power = sum_power(expression);
    const std::string shown =
        (power.negative ? "-" : "") + std::string(power.below ? "1/" : "") + power.text;
    return enclosed(shown,
                    outside == Binding::power || (power.negative && outside != Binding::sum));
  }
  if (GiNaC::is_a<GiNaC::power>(expression)) {
    const std::string inner = power_text(expression);
    return enclosed(inner, outside == Binding::power && inner.rfind("sqrt", 0) != 0);
  }
  if (GiNaC::is_a<GiNaC::function>(expression)) {
    const std::string shown = function_text(expression);
    return enclosed(shown, shown[0] == '-' && outside != Binding::sum);
  }
  const std::string shown = plain(expression);
  return enclosed(shown, outside != Binding::sum && shown.find_first_of("-/") != std::string::npos);
}

}  // namespace

std::string formula_text(const GiNaC::ex& expression) { return text(expression, Binding::sum); }

}  // namespace assur::generator
