#include "audit/asked_points.hpp"

#include <algorithm>
#include <array>
#include <random>

#include "closures/read_formula.hpp"

namespace assur::generator::audit {

namespace {

constexpr std::size_t simple_points = 80;

/// Small values of few digits, so that a counterexample can be checked with a pencil.
class SimpleValues {
 public:
  GiNaC::numeric length() { return {1 + below(3)}; }
  GiNaC::numeric rate() { return {1 + below(2)}; }
  std::pair<GiNaC::numeric, GiNaC::numeric> direction() {
    constexpr std::array<std::array<int, 2>, 4> fifths = {{{3, 4}, {4, 3}, {0, 5}, {5, 0}}};
    const auto [x, y] = fifths[static_cast<std::size_t>(below(4))];
    const int side = below(4);
    return {GiNaC::numeric(side % 2 == 0 ? x : -x, 5), GiNaC::numeric(side < 2 ? y : -y, 5)};
  }

 private:
  int below(unsigned most) { return static_cast<int>(engine_() % most); }
  std::mt19937 engine_{1};
};

}  // namespace

std::vector<Asked> AskedPoints::drawn() {
  std::vector<Asked> asked;
  std::vector<Point> others;
  for (std::size_t index = 0; asked.size() < run_.points && index < 6 * run_.points; ++index) {
    const Point* const drawn = points_.point(index, assembled_);
    if (drawn == nullptr) {
      break;
    }
    // Unknown lengths have either sign: they are negated at every other point. Computed points keep
    // the signs of their solution.
    std::optional<Point> point = index % 2 == 0 || drawn->is_computed ? *drawn : turned(*drawn);
    if (!point || !is_allowed(*point)) {
      continue;
    }
    if (parameters_positive(*point)) {
      add_point(*point, asked);
    } else {
      others.push_back(*point);
    }
  }
  for (const Point& point : others) {
    if (asked.size() < run_.points) {
      add_point(point, asked);
    }
  }
  if (asked.size() < fewest_points) {
    throw closures::FormulaError(run_.program.file.filename().string() +
                                     ": no points were found at which " +
                                     (assembled_ ? "the closures hold and " : "") +
                                     (obstacle_.empty() ? "the program can be run"
                                                        : "the entries have values: " + obstacle_),
                                 run_.result.place);
  }
  return asked;
}

std::string AskedPoints::sort_of(const std::vector<Asked>& points) const {
  const auto computed =
      std::ranges::count_if(points, [](const Asked& asked) { return asked.point.is_computed; });
  const std::string assembled = assembled_ ? " assembled" : "";
  const std::string rational =
      std::to_string(std::ssize(points) - computed) + assembled + " rational points";
  const std::string solved = std::to_string(computed) + assembled + " " + closures::computed_sort;
  return computed == 0                    ? rational
         : computed == std::ssize(points) ? solved
                                          : rational + " and " + solved;
}

std::optional<AskedPoints::Point> AskedPoints::turned(const Point& point) {
  GiNaC::exmap values = point.values;
  for (const closures::AuditSymbol& symbol : points_.system().symbols()) {
    if (symbol.unknown && !symbol.angle) {
      values[symbol.symbol] = -values[symbol.symbol];
    }
  }
  try {
    return assembled_ ? points_.assembled_from(values) : Point{values, {}};
  } catch (const std::runtime_error&) {  // no configuration has these signs
    return std::nullopt;
  }
}

std::vector<Asked> AskedPoints::simple() {
  SimpleValues random;
  std::vector<Asked> list;
  for (std::size_t count = 0; count < simple_points; ++count) {
    GiNaC::exmap values;
    for (const closures::AuditSymbol& symbol : points_.system().symbols()) {
      if (symbol.angle) {
        const auto [cosine, sine] = random.direction();
        values[points_.direction(symbol.symbol).x] = cosine;
        values[points_.direction(symbol.symbol).y] = sine;
      } else {
        values[symbol.symbol] = random.length();
      }
      if (symbol.moving) {
        values[symbol.rate] = random.rate();
        values[symbol.second_rate] = symbol.steady ? GiNaC::numeric(0) : random.rate();
      }
    }
    std::optional<Point> point = assembled_ ? points_.assembled_from(values) : Point{values, {}};
    if (point && parameters_positive(*point) && is_allowed(*point)) {
      add_point(*point, list);
    }
  }
  return list;
}

double AskedPoints::value_at(const GiNaC::ex& expression, Point& point) {
  const GiNaC::ex value = points_.value(expression, point).evalf();
  if (!GiNaC::is_a<GiNaC::numeric>(value)) {
    throw closures::NotAlgebraic("it has no rational value");
  }
  return GiNaC::ex_to<GiNaC::numeric>(value).to_double();
}

bool AskedPoints::has_rates(const closures::AuditSymbol& symbol) const {
  const bool asked = mentions("rate_" + symbol.name) || mentions("rate2_" + symbol.name);
  return symbol.moving || (asked && symbol.unknown && assembled_);
}

bool AskedPoints::mentions(const std::string& name) const {
  std::string text = run_.program.result + " " + run_.position.text;
  for (const std::string& line : run_.program.before) {
    text += " " + line;
  }
  const auto in_name = [&](std::size_t at) {
    return at < text.size() &&
           (std::isalnum(static_cast<unsigned char>(text[at])) != 0 || text[at] == '_');
  };
  for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
    if ((at == 0 || !in_name(at - 1)) && !in_name(at + name.size())) {
      return true;
    }
  }
  return false;
}

bool AskedPoints::is_allowed(Point& point) {
  closures::ClosureSystem& system = points_.system();
  return std::all_of(run_.where.begin(), run_.where.end(), [&](const auto& condition) {
    const GiNaC::ex formula = closures::read_formula(condition, system);
    try {
      return points_.value(formula, point).evalf().info(GiNaC::info_flags::positive);
    } catch (const closures::NotAlgebraic& error) {  // an entry has no value at this point
      obstacle_ = error.what();
      return false;
    }
  });
}

bool AskedPoints::parameters_positive(const Point& point) const {
  const auto& symbols = points_.system().symbols();
  return std::all_of(symbols.begin(), symbols.end(), [&](const auto& symbol) {
    return symbol.angle || symbol.unknown ||
           point.values.at(symbol.symbol).info(GiNaC::info_flags::positive);
  });
}

bool AskedPoints::add_point(const Point& point, std::vector<Asked>& list) {
  Asked asked{point, {}, {}};
  try {
    complete(asked);
  } catch (const closures::NotAlgebraic& error) {
    obstacle_ = error.what();
    return false;
  }
  list.push_back(std::move(asked));
  return true;
}

void AskedPoints::complete(Asked& asked) {
  for (const GiNaC::ex& derived : expected_.derived) {
    static_cast<void>(value_at(derived, asked.point));  // solves for the derivatives in it
  }
  if (assembled_) {
    for (const closures::AuditSymbol* unknown : points_.system().unknowns()) {
      if (has_rates(*unknown)) {
        const GiNaC::ex rate = points_.system().rate(unknown->symbol);
        static_cast<void>(value_at(rate, asked.point));
        static_cast<void>(value_at(points_.system().rate(rate), asked.point));
      }
    }
  }
  asked.values = symbol_values(points_, asked.point);
}

}  // namespace assur::generator::audit
