// Drafts a program's audit file: its names and its statements.
#include <algorithm>
#include <assur/text/error.hpp>
#include <assur/text/expression.hpp>
#include <assur/text/names.hpp>
#include <filesystem>

#include "audit/init/draft_text.hpp"
#include "audit/init/program_quantities.hpp"
#include "audit/init/written_call.hpp"

namespace assur::generator::audit::init {

namespace {

/// Names that are reserved in formulas or in the rows of a run.
bool is_taken_by_formulas(const std::string& name) {
  static const std::set<std::string> more = {"rate", "rate2", "pow", "result", "i", "j"};
  return text::is_reserved_name(name) || more.contains(name);
}

/// The largest number of variables that are followed to see whether one is an angle.
constexpr std::size_t most_followed = 100;

class DraftWriter {
 public:
  DraftWriter(const std::string& code, Language language, const std::string& file,
              const std::string& named)
      : quantities_(code, language, file),
        language_(language),
        file_(file),
        named_(named.find(' ') == std::string::npos ? named : '"' + named + '"'),
        pairs_(derivative_pairs(quantities_)),
        others_(without_pair(quantities_, pairs_)) {
    for (const ProgramFunction& function : quantities_.outline().functions) {
      taken_.insert(function.name);
    }
  }

  std::string write() {
    if (pairs_.empty() && others_.empty()) {
      throw text::InputError(
          file_ +
          ": no function was found that takes numbers and gives positions or a matrix; "
          "write the audit file by hand");
    }
    choose_names();
    for (const DerivativePair& pair : pairs_) {
      write_pair(pair);
    }
    if (pairs_.empty()) {
      for (const Quantity& other : others_) {
        write_other(other);
      }
    } else if (!others_.empty()) {
      runs_ += "\n" +
               line("# not audited, since no other function gives its position or derivative: " +
                    text::joined(others_, ", ",
                                 [&](const Quantity& other) { return quantities_.label(other); }));
    }
    return head() + runs_;
  }

 private:
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
        (quantities_.is_angle(symbol) ? angle_list_ : length_list_).push_back(name);
      }
    };
    for (const DerivativePair& pair : pairs_) {
      declare(quantities_.function(pair.position));
      if (!pair.by.empty()) {
        declare(quantities_.function(pair.derived));
      }
      for (const std::string& name : pair.moving) {
        if (std::find(moving_.begin(), moving_.end(), names_.at(name)) == moving_.end()) {
          moving_.push_back(names_.at(name));
        }
      }
    }
    if (pairs_.empty()) {
      for (const Quantity& other : others_) {
        declare(quantities_.function(other));
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
    const Given& column = quantities_.given(position);
    const std::string& name = quantities_.function(position).name.empty()
                                  ? column.name
                                  : quantities_.function(position).name;
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
                   const DerivativePair* pair = nullptr) {
    std::map<std::string, std::string> rates;
    if (pair != nullptr && !pair->moving.empty()) {
      const std::vector<std::string> more = quantities_.more_symbols(pair->position, pair->derived);
      const std::size_t count = pair->moving.size();
      for (std::size_t at = 0; at < more.size(); ++at) {
        rates[more[at]] = (at < count ? "rate_" : "rate2_") + name_of(pair->moving[at % count]);
      }
    }
    return written_call(
        quantities_.function(quantity), quantities_.outline(), language_,
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

  void write_pair(const DerivativePair& pair) {
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
    runs_ += line("printed run " + quantities_.label(pair.derived) + " " + named_ + " of " + of +
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
    const Given& what = quantities_.given(quantity);
    std::string of;
    runs_ += "\n";
    if (what.columns == 1) {
      const std::vector<std::string>& names = components(quantity);
      for (std::size_t row = 0; row < names.size(); ++row) {
        std::set<std::string> seen;
        const bool is_angle =
            quantities_.is_angle(names[row]) ||
            (row < what.entries.size() &&
             gives_angle(quantities_.function(quantity), what.entries[row], seen));
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
      for (const std::string& symbol :
           quantities_.columns_by_count(quantities_.function(quantity), what.columns)) {
        columns.push_back(name_of(symbol));
      }
      if (columns.empty()) {
        runs_ += marked("in the next line, the quantities of the columns in place of u1, u2, ...");
        for (std::size_t column = 0; column < what.columns; ++column) {
          columns.push_back("u" + std::to_string(column + 1));
        }
        knows_unknowns_ = false;
      } else {
        runs_ += line("# a guess: the variables of the columns");
        for (const std::string& name : columns) {
          if (what.rows == what.columns &&
              std::find(unknowns_.begin(), unknowns_.end(), name) == unknowns_.end()) {
            unknowns_.push_back(name);
          }
        }
      }
      of = text::joined(rows, " ") + " by " + text::joined(columns, " ");
    }
    runs_ += line("printed run " + quantities_.label(quantity) + " " + named_ + " of " + of);
    std::set<std::string> taken = taken_;
    const WrittenCall written = call(quantity, taken);
    std::set<std::string> before;
    write_rows(written, before);
    runs_ += line("  result " + written.results[quantity.given]);
    if (what.columns == 1) {
      for (const std::string& symbol : quantities_.function(quantity).symbols()) {
        if (!quantities_.is_angle(symbol)) {
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
      if (inverse.contains(name) || quantities_.is_angle(name) ||
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

  ProgramQuantities quantities_;
  Language language_;
  std::string file_;
  std::string named_;
  std::set<std::string> taken_;
  std::vector<DerivativePair> pairs_;
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
