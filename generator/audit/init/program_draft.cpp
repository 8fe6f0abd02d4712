#include "audit/init/program_draft.hpp"

#include <algorithm>
#include <assur/text/error.hpp>
#include <assur/text/expression.hpp>
#include <assur/text/names.hpp>
#include <filesystem>
#include <optional>
#include <regex>

#include "audit/init/draft_text.hpp"
#include "audit/init/quantity_values.hpp"
#include "audit/init/written_call.hpp"

namespace assur::generator::audit::init {

namespace {

/// Names that formulas or the rows of a run have for themselves.
bool is_taken_by_formulas(const std::string& name) {
  static const std::set<std::string> more = {"rate", "rate2", "pow", "result", "i", "j"};
  return text::is_reserved_name(name) || more.contains(name);
}

/// Whether a name is that of a derivative, by what programs usually call one.
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

/// How many variables are followed to see whether one is an angle.
constexpr std::size_t most_followed = 100;
/// More than these are more than one draft can be about.
constexpr std::size_t most_quantities = 60;
constexpr std::size_t most_words = 200'000;
constexpr std::size_t most_nested = 200;

/// Throws InputError for a program that takes too long to read.
void expect_readable(Words words, const std::string& file) {
  std::size_t depth = 0;
  std::size_t deepest = 0;
  for (const Word& word : words) {
    depth += word.is("(") || word.is("[") || word.is("{") ? 1 : 0;
    depth -= depth > 0 && (word.is(")") || word.is("]") || word.is("}")) ? 1 : 0;
    deepest = std::max(depth, deepest);
  }
  if (words.size() > most_words || deepest > most_nested) {
    throw text::InputError(file + ": this is more than --init reads (" +
                           std::to_string(most_words) + " words, " + std::to_string(most_nested) +
                           " brackets in one another); put what is to be audited into a file of "
                           "its own");
  }
}

/// One thing that a function gives.
struct Quantity {
  std::size_t function;
  std::size_t given;
};

/// A derivative and the position that it is the derivative of.
struct Pair {
  Quantity position;
  Quantity derived;
  std::vector<std::string> by;      ///< parameters; empty for rates
  std::vector<std::string> moving;  ///< whose rates the derivative takes
  int order = 1;                    ///< of the rate
  bool guessed = false;             ///< from numbers of names alone
};

class DraftWriter {
 public:
  DraftWriter(const std::string& code, Language language, const std::string& file,
              const std::string& named)
      : language_(language), file_(file), named_(named) {
    expect_readable(program_words(code, language), file);
    outline_ = program_outline(code, language);
    std::erase_if(outline_.functions, [](const ProgramFunction& function) {
      return function.given.empty() || function.symbols().empty() ||
             !std::all_of(function.arguments.begin(), function.arguments.end(),
                          [](const Argument& each) {
                            return each.name.empty() || text::is_identifier(each.name);
                          }) ||
             !text::is_identifier("_" + text::joined(function.symbols(), "_"));
    });
    for (const ProgramFunction& function : outline_.functions) {
      angles_.insert(function.angles.begin(), function.angles.end());
      taken_.insert(function.name);
    }
    quote_file();
    if (quantities().size() > most_quantities) {
      throw text::InputError(file + ": this has more than " + std::to_string(most_quantities) +
                             " functions that can be audited; put those of interest into a file "
                             "of their own");
    }
  }

  std::string write() {
    find_pairs();
    find_others();
    if (pairs_.empty() && others_.empty()) {
      throw text::InputError(
          file_ +
          ": no function was found that takes numbers and gives positions or a matrix; "
          "write the audit file by hand");
    }
    choose_names();
    for (const Pair& pair : pairs_) {
      write_pair(pair);
    }
    if (pairs_.empty()) {
      for (const Quantity& other : others_) {
        write_other(other);
      }
    } else if (!others_.empty()) {
      runs_ +=
          "\n" +
          line("# not audited, since no other function gives its position or derivative: " +
               text::joined(others_, ", ", [&](const Quantity& other) { return label(other); }));
    }
    return head() + runs_;
  }

 private:
  [[nodiscard]] const ProgramFunction& function(const Quantity& quantity) const {
    return outline_.functions[quantity.function];
  }
  [[nodiscard]] const Given& given(const Quantity& quantity) const {
    return function(quantity).given[quantity.given];
  }
  [[nodiscard]] std::vector<Quantity> quantities() const {
    std::vector<Quantity> list;
    for (std::size_t at = 0; at < outline_.functions.size(); ++at) {
      for (std::size_t one = 0; one < outline_.functions[at].given.size(); ++one) {
        list.push_back({at, one});
      }
    }
    return list;
  }
  static bool same(const Quantity& one, const Quantity& other) {
    return one.function == other.function && one.given == other.given;
  }

  void quote_file() {
    if (named_.find(' ') != std::string::npos) {
      named_ = '"' + named_ + '"';
    }
  }

  // Which derivative belongs to which position.
  void find_pairs() {
    for (const Quantity& derived : quantities()) {
      std::optional<Pair> best;
      std::size_t best_score = 0;
      for (const Quantity& position : quantities()) {
        if (same(position, derived) || given(position).columns != 1 ||
            given(position).rows != given(derived).rows) {
          continue;
        }
        std::optional<Pair> pair = pair_of(position, derived);
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
        pairs_.push_back(*best);
      }
    }
  }

  std::optional<Pair> pair_of(const Quantity& position, const Quantity& derived) const {
    const std::vector<std::string> symbols = function(position).symbols();
    const std::vector<std::string> more = more_symbols(position, derived);
    const Given& matrix = given(derived);
    Pair pair{position, derived, {}, {}, 1, false};
    if (!matrix.by.empty()) {
      pair.by = matrix.by;
      return pair;
    }
    if (more.empty()) {
      pair.by = derived_by(function(position), given(position), function(derived), matrix);
      const bool known = std::none_of(pair.by.begin(), pair.by.end(),
                                      [](const std::string& name) { return name.empty(); });
      if (known) {
        return pair;
      }
      return guessed_columns(std::move(pair));
    }
    pair.moving = moving_angles(position);
    const std::size_t count = pair.moving.size();
    if (!more_symbols(derived, position).empty() || matrix.columns != 1 || count == 0 ||
        (more.size() != count && more.size() != 2 * count)) {
      return std::nullopt;
    }
    pair.order = more.size() == count ? 1 : 2;
    const bool follows = follows_rates(function(position), given(position), function(derived),
                                       matrix, pair.moving, more);
    pair.guessed = !follows;
    return follows || may_be_guessed(pair) ? std::optional(pair) : std::nullopt;
  }

  /// Whether a pair may be one although no number says so: a slip may be in all of them, or they
  /// cannot be computed here. The names decide then.
  [[nodiscard]] bool may_be_guessed(const Pair& pair) const {
    if (is_named_derivative(label(pair.position))) {
      return false;
    }
    return is_named_derivative(label(pair.derived), label(pair.position)) ||
           !is_computable(function(pair.position), given(pair.position)) ||
           !is_computable(function(pair.derived), given(pair.derived));
  }

  /// The columns that cannot be computed, by their number alone. Those that can be must agree.
  [[nodiscard]] std::optional<Pair> guessed_columns(Pair pair) const {
    const std::size_t columns = given(pair.derived).columns;
    const std::vector<std::string> guess = columns_by_count(function(pair.position), columns);
    if (guess.empty() ||
        (columns == 1 && !is_named_derivative(label(pair.derived), label(pair.position)))) {
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

  [[nodiscard]] std::vector<std::string> moving_angles(const Quantity& position) const {
    std::vector<std::string> list = function(position).symbols();
    std::erase_if(list, [&](const std::string& name) { return !angles_.contains(name); });
    return list;
  }

  /// The symbols of the derivative that the position does not take.
  [[nodiscard]] std::vector<std::string> more_symbols(const Quantity& position,
                                                      const Quantity& derived) const {
    std::vector<std::string> list = function(derived).symbols();
    const std::vector<std::string> known = function(position).symbols();
    std::erase_if(list, [&](const std::string& name) {
      return std::find(known.begin(), known.end(), name) != known.end();
    });
    return list;
  }

  /// The angles or the elements of a list, whichever are as many as the columns.
  [[nodiscard]] std::vector<std::string> columns_by_count(const ProgramFunction& function,
                                                          std::size_t columns) const {
    std::vector<std::string> angles = function.symbols();
    std::erase_if(angles, [&](const std::string& name) { return !angles_.contains(name); });
    std::vector<std::vector<std::string>> candidates;
    for (const Argument& argument : function.arguments) {
      if (argument.kind == Argument::Kind::list) {
        candidates.push_back(argument.parts);
      }
    }
    candidates.push_back(angles);
    const auto found = std::find_if(candidates.begin(), candidates.end(),
                                    [&](const auto& list) { return list.size() == columns; });
    return found == candidates.end() ? std::vector<std::string>() : *found;
  }

  /// What no pair has, and no other function of the file calls: its closures are not in the file.
  void find_others() {
    for (const Quantity& quantity : quantities()) {
      const bool is_paired = std::any_of(pairs_.begin(), pairs_.end(), [&](const Pair& pair) {
        return pair.position.function == quantity.function ||
               pair.derived.function == quantity.function;
      });
      if (!is_paired && !is_called(function(quantity).name)) {
        others_.push_back(quantity);
      }
    }
  }

  [[nodiscard]] bool is_called(const std::string& name) const {
    std::size_t mentions = 0;
    for (std::size_t at = 0; at + 1 < outline_.words.size(); ++at) {
      const bool is_mention = outline_.words[at].is(name.c_str()) && outline_.words[at + 1].is("(");
      const bool is_declaration =
          is_mention && at > 0 &&
          (outline_.words[at - 1].is("def") || outline_.words[at - 1].is("function"));
      mentions += is_mention && !is_declaration ? 1 : 0;
    }
    const bool declared_by_type = language_ == Language::c || language_ == Language::cpp;
    const bool declared_after_equals = language_ == Language::matlab;
    return mentions > (declared_by_type || declared_after_equals ? 1U : 0U);
  }

  // Names in the audit file.
  void choose_names() {
    const auto declare = [&](const ProgramFunction& function) {
      for (const std::string& symbol : function.symbols()) {
        if (names_.contains(symbol)) {
          continue;
        }
        std::string name = symbol;
        while (is_taken_by_formulas(name) || taken_.contains(name)) {
          name += "_";
        }
        taken_.insert(name);
        names_[symbol] = name;
        (angles_.contains(symbol) ? angle_list_ : length_list_).push_back(name);
      }
    };
    for (const Pair& pair : pairs_) {
      declare(function(pair.position));
      if (!pair.by.empty()) {
        declare(function(pair.derived));
      }
      for (const std::string& name : pair.moving) {
        if (std::find(moving_.begin(), moving_.end(), names_.at(name)) == moving_.end()) {
          moving_.push_back(names_.at(name));
        }
      }
    }
    if (pairs_.empty()) {
      for (const Quantity& other : others_) {
        declare(function(other));
      }
    }
  }

  [[nodiscard]] std::string name_of(const std::string& symbol) const {
    const auto found = names_.find(symbol);
    return found == names_.end() ? symbol : found->second;
  }

  std::string free_name(std::string name) {
    while (is_taken_by_formulas(name) || !taken_.insert(name).second) {
      name += "_";
    }
    return name;
  }

  /// The names of the components of a position, chosen once.
  const std::vector<std::string>& components(const Quantity& position) {
    std::vector<std::string>& list = components_[{position.function, position.given}];
    if (!list.empty()) {
      return list;
    }
    const Given& column = given(position);
    const std::string& name =
        function(position).name.empty() ? column.name : function(position).name;
    const std::string stem = text::is_identifier(column.name) ? column.name : name;
    for (std::size_t row = 0; row < column.rows; ++row) {
      const bool known = row < column.names.size() && text::is_identifier(column.names[row]);
      const std::string alone = text::is_identifier(column.name) ? column.name : name + "_value";
      list.push_back(free_name(known              ? column.names[row]
                               : column.rows == 1 ? alone
                                                  : stem + "_" + std::to_string(row + 1)));
    }
    return list;
  }

  // The statements.
  WrittenCall call(const Quantity& quantity, std::set<std::string>& taken,
                   const Pair* pair = nullptr) {
    std::map<std::string, std::string> rates;
    if (pair != nullptr && !pair->moving.empty()) {
      const std::vector<std::string> more = more_symbols(pair->position, pair->derived);
      const std::size_t count = pair->moving.size();
      for (std::size_t at = 0; at < more.size(); ++at) {
        rates[more[at]] = (at < count ? "rate_" : "rate2_") + name_of(pair->moving[at % count]);
      }
    }
    return written_call(
        function(quantity), outline_, language_,
        [&](const std::string& symbol) {
          const auto rate = rates.find(symbol);
          return rate == rates.end() ? name_of(symbol) : rate->second;
        },
        taken);
  }

  void write_rows(const WrittenCall& call, std::set<std::string>& written) {
    for (const std::string& before : call.before) {
      if (written.insert(before).second) {
        runs_ += line("  before " + before);
      }
    }
  }

  [[nodiscard]] std::string label(const Quantity& quantity) const {
    const std::string& name = function(quantity).name;
    return name.empty() || function(quantity).given.size() > 1
               ? given(quantity).name.empty() ? name : given(quantity).name
               : name;
  }

  void write_pair(const Pair& pair) {
    const std::vector<std::string>& names = components(pair.position);
    std::vector<std::string> by;
    for (const std::string& symbol : pair.by) {
      by.push_back(name_of(symbol));
    }
    std::string of = text::joined(names, " ") + " by " + text::joined(by, " ");
    if (by.empty()) {
      const std::string rate = pair.order == 1 ? "rate(" : "rate2(";
      of = text::joined(names, ", ", [&](const std::string& name) { return rate + name + ")"; });
    } else if (by.size() == 1) {
      of = text::joined(names, ", ",
                        [&](const std::string& name) { return "D(" + name + ", " + by[0] + ")"; });
    }
    runs_ += "\n";
    if (pair.guessed) {
      runs_ += line("# a guess");
    }
    runs_ += line("printed run " + label(pair.derived) + " " + named_ + " of " + of +
                  " against own position");
    std::set<std::string> taken = taken_;
    const WrittenCall position = call(pair.position, taken);
    const WrittenCall derived = pair.derived.function == pair.position.function
                                    ? position
                                    : call(pair.derived, taken, &pair);
    std::set<std::string> written;
    write_rows(position, written);
    write_rows(derived, written);
    runs_ += line("  position " + position.results[pair.position.given]);
    runs_ += line("  result " + derived.results[pair.derived.given]);
  }

  void write_other(const Quantity& quantity) {
    const Given& what = given(quantity);
    std::string of;
    runs_ += "\n";
    if (what.columns == 1) {
      const std::vector<std::string>& names = components(quantity);
      for (std::size_t row = 0; row < names.size(); ++row) {
        std::set<std::string> seen;
        const bool is_angle =
            angles_.contains(names[row]) ||
            (row < what.entries.size() && gives_angle(function(quantity), what.entries[row], seen));
        (is_angle ? angle_list_ : length_list_).push_back(names[row]);
        unknowns_.push_back(names[row]);
      }
      of = text::joined(names, ", ");
      closures_ = std::max(closures_, unknowns_.size());
    } else {
      std::vector<std::string> rows;
      for (std::size_t row = 0; row < what.rows; ++row) {
        rows.push_back("f" + std::to_string(row + 1));
      }
      closures_ = std::max(closures_, what.rows);
      std::vector<std::string> columns;
      for (const std::string& symbol : columns_by_count(function(quantity), what.columns)) {
        columns.push_back(name_of(symbol));
      }
      if (columns.empty()) {
        runs_ += marked("in the next line, the quantities of the columns in place of u1, u2, ...");
        for (std::size_t column = 0; column < what.columns; ++column) {
          columns.push_back("u" + std::to_string(column + 1));
        }
        knows_unknowns_ = false;
      } else {
        runs_ += line("# a guess: what the columns are derivatives by");
        for (const std::string& name : columns) {
          if (what.rows == what.columns &&
              std::find(unknowns_.begin(), unknowns_.end(), name) == unknowns_.end()) {
            unknowns_.push_back(name);
          }
        }
      }
      of = text::joined(rows, " ") + " by " + text::joined(columns, " ");
    }
    runs_ += line("printed run " + label(quantity) + " " + named_ + " of " + of);
    std::set<std::string> taken = taken_;
    const WrittenCall written = call(quantity, taken);
    std::set<std::string> before;
    write_rows(written, before);
    runs_ += line("  result " + written.results[quantity.given]);
    if (what.columns == 1) {
      for (const std::string& symbol : function(quantity).symbols()) {
        if (!angles_.contains(symbol)) {
          runs_ += line("  where " + name_of(symbol));
        }
      }
      runs_ += line("  # if it takes one branch: where FORMULA, which is positive there");
    }
  }

  /// Whether an entry is an angle: an inverse function, a symbol whose sine it takes, or a sum.
  [[nodiscard]] bool gives_angle(const ProgramFunction& function, Words entry,
                                 std::set<std::string>& seen) const {
    static const std::set<std::string> inverse = {"atan2",  "atan",   "asin",   "acos",
                                                  "arcsin", "arccos", "arctan", "arctan2"};
    for (std::size_t at = 0; at < entry.size(); ++at) {
      if (entry[at].is("(") || entry[at].is("[")) {
        at = behind_bracket(entry, at) - 1;
        continue;
      }
      if (!entry[at].is_name()) {
        continue;
      }
      const std::string& name = entry[at].text;
      const auto local = function.locals.find(name);
      if (inverse.contains(name) || angles_.contains(name) ||
          (local != function.locals.end() && seen.size() < most_followed &&
           seen.insert(name).second && gives_angle(function, local->second, seen))) {
        return true;
      }
    }
    return false;
  }

  [[nodiscard]] std::string head() const {
    std::string text = line("source " + std::filesystem::path(file_).filename().string());
    if (!length_list_.empty()) {
      text += line("length " + text::joined(length_list_, " "));
    }
    if (!angle_list_.empty()) {
      text += line("angle " + text::joined(angle_list_, " "));
    }
    std::vector<std::string> moving = moving_;
    if (pairs_.empty()) {
      for (const std::string& name : angle_list_) {
        if (std::find(unknowns_.begin(), unknowns_.end(), name) == unknowns_.end() &&
            std::find(moving.begin(), moving.end(), name) == moving.end()) {
          moving.push_back(name);
        }
      }
    }
    if (!unknowns_.empty()) {
      text += line("unknown " + text::joined(unknowns_, " "));
    } else if (!knows_unknowns_) {
      text += marked("what the closures determine: unknown NAME NAME");
    }
    if (!moving.empty() && (knows_unknowns_ || !moving_.empty())) {
      text += line("moving " + text::joined(moving, " "));
    }
    for (std::size_t closure = 1; closure <= closures_; closure += 2) {
      const std::string first = "f" + std::to_string(closure);
      const std::string second = "f" + std::to_string(closure + 1);
      text += closure == closures_ ? marked("what is zero: closure " + first + " = FORMULA")
                                   : marked("links around a loop: loop " + first + " " + second +
                                            " = polar(LENGTH, ANGLE) + ... - point(X, Y)");
    }
    return text;
  }

  ProgramOutline outline_;
  Language language_;
  std::string file_;
  std::string named_;
  std::set<std::string> angles_;
  std::set<std::string> taken_;
  std::vector<Pair> pairs_;
  std::vector<Quantity> others_;
  std::map<std::string, std::string> names_;  ///< of symbols in the audit file
  std::map<std::pair<std::size_t, std::size_t>, std::vector<std::string>> components_;
  std::vector<std::string> length_list_;
  std::vector<std::string> angle_list_;
  std::vector<std::string> unknowns_;
  std::vector<std::string> moving_;
  std::size_t closures_ = 0;
  bool knows_unknowns_ = true;
  std::string runs_;
};

}  // namespace

std::string program_draft(const std::string& code, Language language, const std::string& file,
                          const std::string& named) {
  return DraftWriter(code, language, file, named).write();
}

}  // namespace assur::generator::audit::init
