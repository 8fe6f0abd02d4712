#include "closures/extent.hpp"

#include <algorithm>
#include <cmath>

namespace assur::generator::closures {

namespace {

/// The number of ways to choose `some` of `all`, or `uncountable` if it is larger.
double choices(double all, double some) {
  constexpr double uncountable = 1e9;
  const double fewer = std::ceil(std::min(some, all - some));
  if (!std::isfinite(all) || !std::isfinite(fewer)) {
    return uncountable;
  }
  // Each factor is at least 2, so the bound is reached after few of them.
  double ways = 1;
  for (double taken = 1; taken <= fewer && ways < uncountable; ++taken) {
    ways *= (all - fewer + taken) / taken;
  }
  return std::min(ways, uncountable);
}

Extent of_number(const GiNaC::numeric& number) {
  const int bits = number.numer().int_length() + number.denom().int_length();
  return {0, std::floor(bits / 64.0), 1};
}

}  // namespace

bool is_root(const GiNaC::ex& expression) {
  if (GiNaC::is_a<GiNaC::power>(expression)) {
    return !expression.op(1).info(GiNaC::info_flags::integer);
  }
  return GiNaC::is_a<GiNaC::function>(expression) &&
         GiNaC::ex_to<GiNaC::function>(expression).get_name().starts_with('a');
}

Extent ExtentMeter::of(const GiNaC::ex& expression) {
  if (GiNaC::is_a<GiNaC::numeric>(expression)) {
    const auto& number = GiNaC::ex_to<GiNaC::numeric>(expression);
    return number.is_rational() ? of_number(number) : Extent{};
  }
  if (GiNaC::is_a<GiNaC::add>(expression) || GiNaC::is_a<GiNaC::mul>(expression)) {
    const bool sum = GiNaC::is_a<GiNaC::add>(expression);
    Extent extent{0, 0, sum ? 0.0 : 1.0};
    for (const GiNaC::ex& part : expression) {
      const Extent one = of(part);
      const int nesting = std::max(extent.nesting, one.nesting);
      extent = sum ? Extent{std::max(extent.degree, one.degree), std::max(extent.words, one.words),
                            extent.terms + one.terms, nesting}
                   : Extent{extent.degree + one.degree, extent.words + one.words,
                            extent.terms * one.terms, nesting};
    }
    return extent;
  }
  if (GiNaC::is_a<GiNaC::power>(expression)) {
    return of_power(expression);
  }
  atoms_.insert(expression);
  Extent extent{1, 0, 1};
  if (GiNaC::is_a<GiNaC::function>(expression)) {
    for (const GiNaC::ex& argument : expression) {
      const Extent inner = of(argument);
      extent.degree = std::max(extent.degree, inner.degree);
      extent.words = std::max(extent.words, inner.words);
      extent.nesting = std::max(extent.nesting, inner.nesting);
    }
    extent.nesting += is_root(expression) ? 1 : 0;
    return extent;
  }
  if (abbreviations_ != nullptr) {
    if (const auto known = abbreviations_->find(expression); known != abbreviations_->end()) {
      return known->second;
    }
  }
  return extent;
}

Extent ExtentMeter::of_power(const GiNaC::ex& power) {
  const Extent base = of(power.op(0));
  if (!GiNaC::is_a<GiNaC::numeric>(power.op(1))) {
    return base;
  }
  const double exponent = std::abs(GiNaC::ex_to<GiNaC::numeric>(power.op(1)).to_double());
  const double whole = std::ceil(exponent);
  Extent extent{exponent * base.degree, exponent * base.words,
                choices(base.terms + whole - 1, whole), base.nesting};
  if (exponent != whole) {  // a root, possibly of a number
    atoms_.insert(power);
    extent.degree = std::max(extent.degree, 1.0);
    ++extent.nesting;
  }
  return extent;
}

std::size_t part_count(const GiNaC::ex& expression, std::size_t most) {
  std::size_t count = 0;
  for (auto part = expression.preorder_begin(); part != expression.preorder_end() && count <= most;
       ++part) {
    ++count;
  }
  return count;
}

bool can_be_multiplied_out(const GiNaC::ex& expression, double most) {
  ExtentMeter meter;
  const Extent extent = meter.of(expression);
  // Like terms become one: there are at most as many as products of the symbols.
  const auto atoms = static_cast<double>(meter.atom_count());
  const double terms = std::min(extent.terms, choices(atoms + std::ceil(extent.degree), atoms));
  // Long numbers make terms longer.
  return terms * (1 + extent.words / 64) <= most;
}

}  // namespace assur::generator::closures
