// Writes the rows of configurations as JSON, gnuplot columns and a Markdown table.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "rows.hpp"
#include "stability/output.hpp"

namespace assur::stability {

/// One line for each family, method and distance.
inline void write_listing_json(const std::vector<ListingRow>& rows, std::ostream& out) {
  out << "{\"seed\": " << seed << ", \"members_per_distance\": " << members_per_distance
      << ", \"far_away\": " << far_away << ",\n\"rows\": [";
  const char* separator = "\n";
  for (const ListingRow& row : rows) {
    out << separator << "{\"family\": \"" << row.family << "\", \"kind\": \"" << row.kind
        << "\", \"distance\": " << text(row.distance) << ", \"method\": \"" << row.method
        << "\", \"configurations\": " << row.configurations << ", \"lost\": " << row.lost
        << ", \"invented\": " << row.invented << ", \"run_to_infinity\": " << row.far
        << ", \"of_these_listed\": " << row.far_listed << ", \"declared\": " << row.declared
        << ", \"error\": " << (row.configurations > row.lost ? text(row.error) : "null") << "}";
    separator = ",\n";
  }
  out << "\n]}\n";
}

/// The methods in the order of the rows.
[[nodiscard]] inline std::vector<std::string> methods_of(const std::vector<ListingRow>& rows) {
  std::vector<std::string> methods;
  for (const ListingRow& row : rows) {
    if (std::find(methods.begin(), methods.end(), row.method) == methods.end()) {
      methods.push_back(row.method);
    }
  }
  return methods;
}

/// A file per family, a block per method: position of the distance on the axis, lost, invented.
inline void write_listing_columns(const std::vector<ListingRow>& rows,
                                  const std::filesystem::path& directory) {
  const std::vector<double> distances = configuration_distances();
  for (const std::string& family : families_of(rows)) {
    std::ofstream out(directory / (family + ".dat"));
    for (const std::string& method : methods_of(rows)) {
      for (std::size_t place = 0; place < distances.size(); ++place) {
        for (const ListingRow& row : rows) {
          if (row.family == family && row.method == method && row.distance == distances[place]) {
            out << place + 1 << ' ' << row.lost << ' ' << row.invented << '\n';
          }
        }
      }
      out << "\n\n";
    }
  }
}

/// Writes, for all distances but 0 and for distance 0, how many configurations are lost and
/// invented, and the largest error.
inline void write_listing_table(const std::vector<ListingRow>& rows, std::ostream& out) {
  const std::vector<std::string> families = families_of(rows);
  out << "| method |";
  std::string line = "\n|---|";
  for (const std::string& family : families) {
    out << ' ' << family << " | at 0 |";
    line += "---|---|";
  }
  out << line << '\n';
  for (const std::string& method : methods_of(rows)) {
    out << "| " << method << " |";
    for (const std::string& family : families) {
      for (const bool at_zero : {false, true}) {
        ListingRow sum;
        for (const ListingRow& row : rows) {
          if (row.family == family && row.method == method && (row.distance == 0) == at_zero) {
            sum.configurations += row.configurations;
            sum.lost += row.lost;
            sum.invented += row.invented;
            sum.error = std::max(sum.error, row.error);
          }
        }
        out << ' ' << sum.lost << ", " << sum.invented << "; "
            << (sum.configurations > sum.lost ? text(sum.error) : "-") << " |";
      }
    }
    out << '\n';
  }
  out << "| configurations, and run to infinity |";
  for (const std::string& family : families) {
    for (const bool at_zero : {false, true}) {
      int configurations = 0;
      int far = 0;
      for (const ListingRow& row : rows) {
        if (row.family == family && row.method == rows.front().method &&
            (row.distance == 0) == at_zero) {
          configurations += row.configurations;
          far += row.far;
        }
      }
      out << ' ' << configurations << ", " << far << " |";
    }
  }
  out << '\n';
}

}  // namespace assur::stability
