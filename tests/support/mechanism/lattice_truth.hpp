// Reads the table of exact answers for groups on a lattice.
#pragma once

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace assur::test {

/// What exact arithmetic says of a scene.
struct LatticeTruth {
  std::string kind;
  unsigned seed = 0;
  std::string exactness;
  bool known = false;  ///< false if exact arithmetic had no answer
  int mobility = 0;    ///< of the largest real family; 0 where there is none
  int isolated = 0;    ///< real configurations that are on no family
  int singular = 0;    ///< of these, the ones at which the loop equations are singular

  [[nodiscard]] int regular() const { return isolated - singular; }
};

/// The first rows of a table, `count` at most.
inline std::vector<LatticeTruth> read_lattice_truth(const std::string& file, std::size_t count) {
  std::ifstream lines(file);
  if (!lines) {
    throw std::runtime_error(file + ": cannot be read");
  }
  std::vector<LatticeTruth> result;
  std::string line;
  while (result.size() < count && std::getline(lines, line)) {
    std::istringstream words(line);
    LatticeTruth row;
    words >> row.kind >> row.seed >> row.exactness;
    if (line.empty() || line[0] == '#' || !words) {
      continue;
    }
    row.known = static_cast<bool>(words >> row.mobility >> row.isolated >> row.singular);
    result.push_back(row);
  }
  return result;
}

}  // namespace assur::test
