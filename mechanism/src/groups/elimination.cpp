#include "groups/elimination.hpp"

#include <algorithm>
#include <assur/loops/hidden_angle.hpp>
#include <cmath>
#include <map>
#include <utility>

namespace assur::mechanism::groups {

namespace {

using loops::AngleSet;
using loops::Complex;

/// In general position a coefficient of a row below this part of the largest one is structurally
/// zero, up to rounding.
constexpr double structural_zero = 1e-9;

/// The coefficients of one equation: for each product of reciprocal directions, the powers of x.
using Row = std::map<AngleSet, std::map<int, Complex>>;

double largest(const Row& row) {
  double result = 0;
  for (const auto& [product, powers] : row) {
    for (const auto& [power, value] : powers) {
      result = std::max(result, std::abs(value));
    }
  }
  return result;
}

/// Adds the elimination with a ground and a hidden angle, if it is usable.
void add(const LoopEquations& general, int ground, int hidden, Eliminations& result) {
  const loops::HiddenAngle<loops::AnySizes> equations(general, ground, hidden);
  AngleSet others = 0;
  for (int angle = 0; angle <= general.angle_count(); ++angle) {
    others |= angle == ground || angle == hidden ? 0 : loops::bit(angle);
  }
  std::vector<AngleSet> sets;
  std::vector<AngleSet> products;
  std::vector<int> lowest_powers;
  int degree = 0;
  for (AngleSet set = 0;; set = (set - others) & others) {
    Row row;
    equations.each_term(set, [&](AngleSet product, int power, const Complex& coefficient) {
      row[product][power] += coefficient;
    });
    const double size = largest(row);
    int lowest = 0;
    int highest = 0;
    bool is_used = false;
    for (const auto& [product, powers] : row) {
      const std::size_t before = products.size();
      for (const auto& [power, value] : powers) {
        if (std::abs(value) > structural_zero * size) {
          lowest = is_used ? std::min(lowest, power) : power;
          highest = is_used ? std::max(highest, power) : power;
          is_used = true;
          products.resize(before + 1, product);
        }
      }
    }
    if (is_used) {
      sets.push_back(set);
      lowest_powers.push_back(lowest);
      degree = std::max(degree, highest - lowest);
    }
    if (set == others) {
      break;
    }
  }
  std::ranges::sort(products);
  products.erase(std::ranges::unique(products).begin(), products.end());
  if (!sets.empty() && sets.size() == products.size() && degree > 0) {
    result.add(ground, hidden, degree, std::move(sets), std::move(products),
               std::move(lowest_powers));
  }
}

}  // namespace

void Eliminations::add(int ground, int hidden, int degree, std::vector<AngleSet> sets,
                       std::vector<AngleSet> products, std::vector<int> lowest_powers) {
  list_.push_back({ground, hidden, static_cast<int>(sets.size()), degree, sets.data(),
                   products.data(), lowest_powers.data()});
  sets_.push_back(std::move(sets));
  sets_.push_back(std::move(products));
  powers_.push_back(std::move(lowest_powers));
}

void Eliminations::put_smallest_first() {
  std::ranges::stable_sort(list_, {}, &loops::Elimination::eigenvalues);
}

Eliminations eliminations_of(const LoopEquations& general) {
  Eliminations result;
  if (general.angle_count() == 0) {
    result.add(0, loops::Elimination::none, 0, {}, {}, {});
  }
  for (int ground = 0; ground <= general.angle_count(); ++ground) {
    // Exchanging the ground's angle and the hidden one only replaces x by 1/x.
    for (int hidden = ground + 1; hidden <= general.angle_count(); ++hidden) {
      bool runs = true;
      for (const int angle : general.slide_angles) {
        runs = runs && (angle == ground || angle == hidden);
      }
      if (runs) {
        add(general, ground, hidden, result);
      }
    }
  }
  result.put_smallest_first();
  return result;
}

}  // namespace assur::mechanism::groups
