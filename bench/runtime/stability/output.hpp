// Writes the rows of the stability table as JSON, gnuplot columns and Markdown tables.
#pragma once

#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <sstream>

#include "bad_input.hpp"
#include "rows.hpp"

namespace assur::stability {

[[nodiscard]] inline std::string text(double value) {
  std::ostringstream stream;
  stream << std::setprecision(2) << value;
  return stream.str();
}

/// Writes one line per quantity, so that a changed figure is a changed line. An error is null where
/// all members failed.
inline void write_json(const std::vector<Row>& rows, const std::vector<BadInputRow>& bad,
                       std::ostream& out) {
  out << "{\"seed\": " << seed << ", \"members_per_distance\": " << members_per_distance
      << ", \"wrong_error\": " << wrong_error << ", \"newton_neighbour\": " << newton_neighbour
      << ",\n\"rows\": [";
  const char* separator = "\n";
  for (const Row& row : rows) {
    for (const Quantity quantity : quantities) {
      if (quantity == Quantity::sensitivities && !row.has_sensitivities) {
        continue;
      }
      const auto place = static_cast<std::size_t>(quantity);
      const int failures = row.wrong[place] + row.refused_members;
      const auto error = [&](double largest) {
        return failures < members_per_distance ? text(largest) : std::string("null");
      };
      out << separator << "{\"family\": \"" << row.family
          << "\", \"distance\": " << text(row.distance) << ", \"kappa\": " << text(row.condition)
          << ", \"method\": \"" << row.method << "\", \"quantity\": \"" << quantity_names[place]
          << "\", \"error\": " << error(row.error[place])
          << ", \"error_as_given\": " << error(row.error_as_given[place])
          << ", \"refused\": " << row.refused_members << ", \"wrong\": " << row.wrong[place]
          << ", \"failed\": " << (failures > 0 ? "true" : "false") << ", \"status\": \""
          << to_string(row.status) << "\"}";
      separator = ",\n";
    }
  }
  out << "\n],\n\"bad_input\": [";
  separator = "\n";
  for (const BadInputRow& row : bad) {
    out << separator << "{\"method\": \"" << row.method << "\", \"input\": \"" << row.input
        << "\", \"status\": \"" << to_string(row.status)
        << "\", \"finite\": " << (row.finite ? "true" : "false") << "}";
    separator = ",\n";
  }
  out << "\n]}\n";
}

/// The families in order of appearance.
template <typename AnyRow>
[[nodiscard]] std::vector<std::string> families_of(const std::vector<AnyRow>& rows) {
  std::vector<std::string> families;
  for (const AnyRow& row : rows) {
    if (families.empty() || families.back() != row.family) {
      families.push_back(row.family);
    }
  }
  return families;
}

/// Two files per family. Errors, a block per method: distance, condition number, error. No error is
/// drawn where more than half of the members failed: the rest would make the method look good.
/// Failures: distance, number of the method, and gnuplot's point type, a cross for wrong or a ring
/// for refused.
inline void write_columns(const std::vector<Row>& rows, const std::filesystem::path& directory) {
  for (const std::string& family : families_of(rows)) {
    std::ofstream errors(directory / (family + ".dat"));
    std::ofstream failures(directory / (family + "-failures.dat"));
    failures << "1 0 2\n";
    int number = 0;
    for (const Method<Model01>& method : methods<Model01>()) {
      ++number;
      for (const Row& row : rows) {
        if (row.family != family || row.method != method.name) {
          continue;
        }
        const bool drawn = 2 * row.right_members() >= members_per_distance;
        errors << row.distance << ' ' << row.condition << ' '
               << (drawn ? text(row.largest_error()) : "NaN") << '\n';
        if (row.wrong_members > 0) {
          failures << row.distance << ' ' << number << " 2\n";
        }
        if (row.refused_members > 0) {
          failures << row.distance << ' ' << number << " 6\n";
        }
      }
      errors << "\n\n";
    }
  }
}

/// For each method and family, the largest error of the right answers, and how many members failed.
inline void write_worst(const std::vector<Row>& rows, std::ostream& out) {
  const std::vector<std::string> families = families_of(rows);
  out << "| method |";
  for (const std::string& family : families) {
    out << ' ' << family << " |";
  }
  out << "\n|---|";
  for (std::size_t count = 0; count < families.size(); ++count) {
    out << "---|";
  }
  out << '\n';
  for (const Method<Model01>& method : methods<Model01>()) {
    out << "| " << method.name << " |";
    for (const std::string& family : families) {
      double error = 0;
      int refused = 0;
      int wrong = 0;
      for (const Row& row : rows) {
        if (row.family == family && row.method == method.name) {
          error = std::max(error, row.largest_error());
          refused += row.refused_members;
          wrong += row.wrong_members;
        }
      }
      out << ' ' << (error > 0 ? text(error) : "-");
      if (refused + wrong > 0) {
        out << "; " << refused << ", " << wrong;
      }
      out << " |";
    }
    out << '\n';
  }
}

/// One line per method: for each bad input, whether it is refused, or what it returns as a result.
inline void write_bad_input(const std::vector<BadInputRow>& rows, std::ostream& out) {
  out << "| method |";
  std::string line = "\n|---|";
  for (const BadInputRow& row : rows) {
    if (row.method == rows.front().method) {
      out << ' ' << row.input << " |";
      line += "---|";
    }
  }
  out << line;
  std::string method;
  for (const BadInputRow& row : rows) {
    if (row.method != method) {
      method = row.method;
      out << "\n| " << method << " |";
    }
    if (!is_solvable(row.status)) {
      out << " refused: " << to_string(row.status) << " |";
    } else {
      out << (row.finite ? " a number |" : " NaN |");
    }
  }
  out << '\n';
}

}  // namespace assur::stability
