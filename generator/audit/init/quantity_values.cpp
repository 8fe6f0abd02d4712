// Values of straight-line functions at points, on which drafts base their proposals.
#include <algorithm>
#include <assur/text/expression.hpp>
#include <cmath>
#include <optional>

#include "audit/init/program_quantities.hpp"

namespace assur::generator::audit::init {

namespace {

constexpr int point_count = 3;
constexpr double step = 1e-5;
constexpr double alike = 1e-6;
constexpr double second_step = 1e-3;
constexpr double second_alike = 1e-4;
constexpr int most_variables = 30;
constexpr std::size_t longest_formula = 4000;

using Point = std::map<std::string, double>;

/// The words of an expression in the syntax of formulas: `np.sin(q[0])**2` as `sin(q_0)^2`.
std::string formula_text(Words words) {
  static const std::map<std::string, std::string> names = {
      {"arcsin", "asin"}, {"arccos", "acos"}, {"arctan", "atan"}, {"arctan2", "atan2"}};
  static const std::map<std::string, std::string> marks = {
      {"**", "^"}, {".*", "*"}, {"./", "/"}, {".^", "^"}};
  static const std::set<std::string> libraries = {"np",  "numpy", "math", "Math",
                                                  "std", "sp",    "sympy"};
  std::string text;
  for (std::size_t at = 0; at < words.size();) {
    const Word& word = words[at];
    if (word.is_name() && libraries.contains(word.text) && at + 2 < words.size() &&
        (words[at + 1].is(".") || words[at + 1].is("::"))) {
      at += 2;
      continue;
    }
    if (word.is_name()) {
      const SymbolAt symbol = symbol_at(words, at);
      const auto name = names.find(symbol.name);
      text += (name == names.end() ? symbol.name : name->second) + " ";
      at = symbol.end;
      continue;
    }
    const auto mark = marks.find(word.text);
    text += mark == marks.end() ? word.text : mark->second;
    ++at;
  }
  return text;
}

/// The values of one function's variables at a point.
class Values {
 public:
  Values(const ProgramFunction& function, const Point& point)
      : function_(function), point_(point) {}

  /// Throws ExpressionError unless the words are a formula in known variables.
  double of(Words words) {
    const std::string text = formula_text(words);
    if (text.size() > longest_formula || ++hops_ > most_variables) {
      throw text::ExpressionError("too long", 1);
    }
    const double value = text::evaluate<double>(
        text::parse_expression(text), [&](const std::string& name) { return variable(name); });
    --hops_;
    return value;
  }

 private:
  double variable(const std::string& name) {
    const auto found = known_.find(name);
    if (found != known_.end()) {
      return found->second;
    }
    const auto local = function_.locals.find(name);
    const auto given = point_.find(name);
    const double value = given != point_.end()             ? given->second
                         : local != function_.locals.end() ? of(local->second)
                                                           : constant(name);
    known_[name] = value;
    return value;
  }

  /// A name that is not a variable of the function is a constant of the file: a number of its own.
  [[nodiscard]] double constant(const std::string& name) const {
    const std::string whole = name.substr(0, name.find('_', 1));
    if (function_.locals.contains(whole) || function_.locals.contains(name)) {
      throw text::ExpressionError("a part of a variable", 1);
    }
    double value = 0;
    for (const char letter : name) {
      value = std::fmod(0.618034 * value + 0.1 * static_cast<unsigned char>(letter), 1.0);
    }
    return 0.5 + value;
  }

  const ProgramFunction& function_;
  const Point& point_;
  std::map<std::string, double> known_;
  int hops_ = 0;
};

std::optional<double> entry_value(const ProgramFunction& function, Words entry,
                                  const Point& point) {
  try {
    const double value = Values(function, point).of(entry);
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
  } catch (const text::ExpressionError&) {
    return std::nullopt;
  }
}

/// Numbers without a pattern, the same in each run.
Point point_number(int number, const ProgramFunction& one, const ProgramFunction& other) {
  Point point;
  double value = 0.3 + 0.17 * number;
  for (const ProgramFunction* function : {&one, &other}) {
    for (const std::string& symbol : function->symbols()) {
      if (point.emplace(symbol, value).second) {
        value = std::fmod(value + 0.618034, 1.3) + 0.2;
      }
    }
  }
  return point;
}

/// Whether an entry is, up to its sign, the derivative of a component with respect to a symbol.
bool is_derivative(const ProgramFunction& of, Words component, const ProgramFunction& derived,
                   Words entry, const std::string& by, bool& is_zero) {
  is_zero = true;
  for (int number = 0; number < point_count; ++number) {
    Point point = point_number(number, of, derived);
    const std::optional<double> value = entry_value(derived, entry, point);
    const double middle = point.at(by);
    point[by] = middle + step;
    const std::optional<double> above = entry_value(of, component, point);
    point[by] = middle - step;
    const std::optional<double> below = entry_value(of, component, point);
    if (!value || !above || !below) {
      return false;
    }
    const double slope = (*above - *below) / (2 * step);
    if (std::abs(std::abs(slope) - std::abs(*value)) > alike * (1 + std::abs(slope))) {
      return false;
    }
    is_zero = is_zero && std::abs(*value) < alike;
  }
  return true;
}

}  // namespace

bool is_computable(const ProgramFunction& function, const Given& given) {
  const Point point = point_number(0, function, function);
  return std::any_of(given.entries.begin(), given.entries.end(), [&](const Words& entry) {
    return (entry.size() > 1 || entry[0].is_name()) &&
           entry_value(function, entry, point).has_value();
  });
}

std::vector<std::string> derived_by(const ProgramFunction& of, const Given& position,
                                    const ProgramFunction& derived, const Given& matrix) {
  std::vector<std::string> columns(matrix.columns);
  const std::vector<std::string> symbols = of.symbols();
  if (position.entries.empty() || matrix.entries.empty()) {
    return columns;
  }
  std::set<std::string> taken;
  for (std::size_t column = 0; column < matrix.columns; ++column) {
    std::size_t best = 0;
    for (const std::string& symbol : symbols) {
      std::size_t score = 0;
      for (std::size_t row = 0; row < matrix.rows; ++row) {
        bool is_zero = false;
        if (is_derivative(of, position.entries[row], derived,
                          matrix.entries[row * matrix.columns + column], symbol, is_zero)) {
          score += is_zero ? 1 : 2 * matrix.rows;
        }
      }
      // Zeros alone prove nothing.
      if (score > best && score >= 2 * matrix.rows && !taken.contains(symbol)) {
        best = score;
        columns[column] = symbol;
      }
    }
    taken.insert(columns[column]);
  }
  return columns;
}

bool follows_rates(const ProgramFunction& of, const Given& position, const ProgramFunction& derived,
                   const Given& column, const std::vector<std::string>& moving,
                   const std::vector<std::string>& rates) {
  const bool second = rates.size() > moving.size();
  const double time = second ? second_step : step;
  std::size_t right = 0;
  for (std::size_t row = 0; row < position.entries.size() && row < column.entries.size(); ++row) {
    bool all = true;
    for (int number = 0; number < point_count && all; ++number) {
      const Point now = point_number(number, of, derived);
      const auto at = [&](double later) {
        Point point = now;
        for (std::size_t one = 0; one < moving.size(); ++one) {
          const double change = second ? now.at(rates[one + moving.size()]) * later * later / 2 : 0;
          point[moving[one]] += now.at(rates[one]) * later + change;
        }
        return entry_value(of, position.entries[row], point);
      };
      const std::optional<double> value = entry_value(derived, column.entries[row], now);
      const std::optional<double> above = at(time);
      const std::optional<double> below = at(-time);
      const std::optional<double> middle = at(0);
      all = value && above && below && middle;
      if (all) {
        const double slope = second ? (*above - 2 * *middle + *below) / (time * time)
                                    : (*above - *below) / (2 * time);
        all = std::abs(std::abs(slope) - std::abs(*value)) <
              (second ? second_alike : alike) * (1 + std::abs(slope));
      }
    }
    right += all ? 1 : 0;
  }
  return 2 * right >= position.rows && right > 0;
}

}  // namespace assur::generator::audit::init
