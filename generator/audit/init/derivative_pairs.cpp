// Pairs each position of a program with its derivatives, by values if possible, else by names.
#include <algorithm>
#include <regex>

#include "audit/init/program_quantities.hpp"

namespace assur::generator::audit::init {

namespace {

/// Whether a name is one that programs usually give to a derivative.
bool is_named_derivative(const std::string& name, const std::string& of = "") {
  constexpr std::size_t longest = 100;
  static const std::regex usual(
      "(^d[A-Za-z]?_|^d+[a-z]{1,3}$|jac|deriv|grad|vel|acc|rate|speed|dot|prime|_d[a-z]*$)",
      std::regex::icase);
  if (!of.empty() && name == "d" + of) {
    return true;
  }
  return name.size() <= longest && std::regex_search(name, usual);
}

bool same(const Quantity& one, const Quantity& other) {
  return one.function == other.function && one.given == other.given;
}

class PairFinder {
 public:
  explicit PairFinder(const ProgramQuantities& quantities) : quantities_(quantities) {}

  std::vector<DerivativePair> find() const {
    std::vector<DerivativePair> pairs;
    for (const Quantity& derived : quantities_.all()) {
      std::optional<DerivativePair> best;
      std::size_t best_score = 0;
      for (const Quantity& position : quantities_.all()) {
        if (same(position, derived) || quantities_.given(position).columns != 1 ||
            quantities_.given(position).rows != quantities_.given(derived).rows) {
          continue;
        }
        std::optional<DerivativePair> pair = pair_of(position, derived);
        if (!pair) {
          continue;
        }
        const std::size_t score = pair->guessed ? 1 : 2;
        if (score > best_score) {
          best = pair;
          best_score = score;
        }
      }
      if (best) {
        pairs.push_back(*best);
      }
    }
    return pairs;
  }

 private:
  std::optional<DerivativePair> pair_of(const Quantity& position, const Quantity& derived) const {
    const std::vector<std::string> more = quantities_.more_symbols(position, derived);
    const Given& matrix = quantities_.given(derived);
    DerivativePair pair{position, derived, {}, {}, 1, false};
    if (!matrix.by.empty()) {
      pair.by = matrix.by;
      return pair;
    }
    if (more.empty()) {
      pair.by = derived_by(quantities_.function(position), quantities_.given(position),
                           quantities_.function(derived), matrix);
      const bool known = std::none_of(pair.by.begin(), pair.by.end(),
                                      [](const std::string& name) { return name.empty(); });
      if (known) {
        return pair;
      }
      return guessed_columns(std::move(pair));
    }
    pair.moving = quantities_.angles_of(quantities_.function(position));
    const std::size_t count = pair.moving.size();
    if (!quantities_.more_symbols(derived, position).empty() || matrix.columns != 1 || count == 0 ||
        (more.size() != count && more.size() != 2 * count)) {
      return std::nullopt;
    }
    pair.order = more.size() == count ? 1 : 2;
    const bool follows = follows_rates(quantities_.function(position), quantities_.given(position),
                                       quantities_.function(derived), matrix, pair.moving, more);
    pair.guessed = !follows;
    return follows || may_be_guessed(pair) ? std::optional(pair) : std::nullopt;
  }

  /// Whether names may decide a pair that values do not confirm: all entries may have slips, or
  /// cannot be computed here.
  [[nodiscard]] bool may_be_guessed(const DerivativePair& pair) const {
    if (is_named_derivative(quantities_.label(pair.position))) {
      return false;
    }
    return is_named_derivative(quantities_.label(pair.derived), quantities_.label(pair.position)) ||
           !is_computable(quantities_.function(pair.position), quantities_.given(pair.position)) ||
           !is_computable(quantities_.function(pair.derived), quantities_.given(pair.derived));
  }

  /// Columns that cannot be computed, matched by their number. Those that can be must agree.
  [[nodiscard]] std::optional<DerivativePair> guessed_columns(DerivativePair pair) const {
    const std::size_t columns = quantities_.given(pair.derived).columns;
    const std::vector<std::string> guess =
        quantities_.columns_by_count(quantities_.function(pair.position), columns);
    if (guess.empty() || (columns == 1 && !is_named_derivative(quantities_.label(pair.derived),
                                                               quantities_.label(pair.position)))) {
      return std::nullopt;
    }
    bool any_known = false;
    for (std::size_t column = 0; column < columns; ++column) {
      if (!pair.by[column].empty() && pair.by[column] != guess[column]) {
        return std::nullopt;
      }
      any_known = any_known || !pair.by[column].empty();
    }
    if (!any_known && !may_be_guessed(pair)) {
      return std::nullopt;
    }
    pair.by = guess;
    pair.guessed = true;
    return pair;
  }

  const ProgramQuantities& quantities_;
};

}  // namespace

std::vector<DerivativePair> derivative_pairs(const ProgramQuantities& quantities) {
  return PairFinder(quantities).find();
}

std::vector<Quantity> without_pair(const ProgramQuantities& quantities,
                                   const std::vector<DerivativePair>& pairs) {
  std::vector<Quantity> others;
  for (const Quantity& quantity : quantities.all()) {
    const bool is_paired = std::any_of(pairs.begin(), pairs.end(), [&](const DerivativePair& pair) {
      return pair.position.function == quantity.function ||
             pair.derived.function == quantity.function;
    });
    if (!is_paired && !quantities.is_called(quantities.function(quantity).name)) {
      others.push_back(quantity);
    }
  }
  return others;
}

}  // namespace assur::generator::audit::init
