// Turns expressions with roots of their own into points on all their branches, and values there.
#include <algorithm>

#include "closures/closure_points.hpp"
#include "equations/symbols.hpp"

namespace assur::generator::closures {

std::optional<ClosurePoints::Rooted> ClosurePoints::rooted(const GiNaC::ex& expression) {
  follow_system();
  const GiNaC::ex whole = system_.expanded(expression);
  if (!makes_roots(whole)) {
    return std::nullopt;
  }
  Rooted rooted{algebra_.extended(), whole, {}, algebra_.root_count()};
  rooted.form = rooted.algebra.algebraic(whole);
  if (rooted.algebra.root_count() == rooted.first_own) {
    return std::nullopt;
  }
  return rooted;
}

GiNaC::ex ClosurePoints::value(const Rooted& rooted, Point& point, unsigned reversed) {
  solve_for(rooted.whole, point);
  return rooted.algebra.at(rooted.form, point.values, reversed);
}

bool ClosurePoints::takes_either_sign(const AuditSymbol& symbol) {
  return symbol.unknown ||
         std::any_of(system_.closures().begin(), system_.closures().end(),
                     [&](const ClosureSystem::Closure& closure) {
                       const GiNaC::ex slope = system_.slope(closure.expression, symbol.symbol);
                       return GiNaC::is_a<GiNaC::numeric>(slope) && !slope.is_zero();
                     });
}

std::vector<GiNaC::ex> ClosurePoints::telling(const GiNaC::ex& expression) const {
  const GiNaC::exset occurring = equations::symbols_of(system_.expanded(expression));
  std::vector<GiNaC::ex> angles;
  std::vector<GiNaC::ex> lengths;
  for (const bool occurs : {true, false}) {
    for (const AuditSymbol& symbol : system_.symbols()) {
      if (occurring.contains(symbol.symbol) == occurs) {
        (symbol.angle ? angles : lengths).emplace_back(symbol.symbol);
      }
    }
  }
  std::vector<GiNaC::ex> list;
  for (const GiNaC::ex& angle : angles) {
    list.emplace_back(GiNaC::cos(angle));
    list.emplace_back(GiNaC::sin(angle));
  }
  list.insert(list.end(), lengths.begin(), lengths.end());
  for (const std::vector<GiNaC::ex>* several : {&angles, &lengths}) {
    for (std::size_t one = 0; one < several->size(); ++one) {
      for (std::size_t other = 0; other < one; ++other) {
        const GiNaC::ex difference = (*several)[one] - (*several)[other];
        const GiNaC::ex sum = (*several)[one] + (*several)[other];
        if (several == &lengths) {
          list.push_back(difference);
          list.push_back(sum);
          continue;
        }
        for (const GiNaC::ex& angle : {difference, sum}) {
          list.emplace_back(GiNaC::sin(angle));
          list.emplace_back(GiNaC::cos(angle));
        }
        list.push_back(GiNaC::sin((*several)[one]) * GiNaC::sin((*several)[other]));
        list.push_back(GiNaC::cos((*several)[one]) * GiNaC::cos((*several)[other]));
        list.push_back(GiNaC::sin((*several)[one]) * GiNaC::cos((*several)[other]));
        list.push_back(GiNaC::cos((*several)[one]) * GiNaC::sin((*several)[other]));
      }
      if (several == &angles) {
        list.emplace_back(GiNaC::sin(2 * (*several)[one]));
        list.emplace_back(GiNaC::cos(2 * (*several)[one]));
      }
    }
  }
  return list;
}

std::deque<ClosurePoints::Point> ClosurePoints::points_on_all_branches(const Rooted& rooted,
                                                                       bool assembled) {
  constexpr unsigned most_draws = 400;
  // Rates and total derivatives cost a linear system at each point.
  const bool follows = system_.follows_closures(rooted.whole);
  const std::size_t wanted = follows ? 16 : 64;
  std::vector<const AuditSymbol*> angles;  // those of the expression first
  std::vector<const AuditSymbol*> signed_lengths;
  std::vector<const AuditSymbol*> positive;
  for (const bool occurs : {true, false}) {
    for (const AuditSymbol& symbol : system_.symbols()) {
      if (symbol.angle && rooted.whole.has(symbol.symbol) == occurs) {
        angles.push_back(&symbol);
      } else if (!symbol.angle && occurs) {
        (takes_either_sign(symbol) ? signed_lengths : positive).push_back(&symbol);
      }
    }
  }
  std::deque<Point> points;
  for (const bool insists : {true, false}) {  // first only on positive lengths
    for (unsigned seed = 1; seed <= most_draws && points.size() < wanted; ++seed) {
      Point point{random_values(seed), {}};
      // The first three angles go through all their quadrants, the others through random ones.
      unsigned pattern = (seed & 63U) | (seed * 2654435761U >> 8U) << 6U;
      for (const AuditSymbol* angle : angles) {
        const equations::Vector2& direction = algebra_.direction(angle->symbol);
        for (const GiNaC::ex& part : {direction.x, direction.y}) {
          GiNaC::ex& value = point.values[part];
          const GiNaC::ex size = GiNaC::abs(value);
          value = (pattern & 1U) != 0 ? -size : size;
          pattern = pattern >> 1U | pattern << 31U;
        }
      }
      for (const AuditSymbol* length : signed_lengths) {
        pattern = pattern >> 1U | pattern << 31U;
        point.values[length->symbol] *= (pattern & 1U) != 0 ? -1 : 1;
      }
      try {
        if (assembled) {
          if (!assemble(point.values)) {
            return {};
          }
          if (follows) {
            invert_jacobian(point);
          }
        }
        const bool admitted =
            !insists ||
            std::all_of(positive.begin(), positive.end(), [&](const AuditSymbol* length) {
              return point.values.at(length->symbol).info(GiNaC::info_flags::positive);
            });
        if (admitted) {
          static_cast<void>(value(rooted, point));
          points.push_back(std::move(point));
        }
      } catch (const std::runtime_error&) {  // no real root, or a singular Jacobian, there
        continue;
      }
    }
    if (!points.empty()) {
      break;
    }
  }
  return points;
}

}  // namespace assur::generator::closures
