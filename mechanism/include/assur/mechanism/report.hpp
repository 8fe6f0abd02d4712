// Reports of a solution: text for people, JSON or CSV for programs.
#pragma once

#include <assur/mechanism/plan.hpp>
#include <assur/mechanism/sweep.hpp>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace assur::mechanism {

/// A solution, with the plan and the values from which it was computed.
struct Report {
  const Plan& plan;
  const Values& values;
  const Solution& solution;
  std::string title;  ///< for people, if the mechanism has no name
  int branch = 0;     ///< number of the only configuration to report, or 0 for all
  std::optional<Nearest> nearest =
      std::nullopt;  ///< set if it was requested, and then reported as such
  /// Whether the solution contains only the reported configuration; the number of the nearest one
  /// is then unknown.
  bool alone = false;
  /// The branches and circuits of the configurations in the sweep, if requested.
  std::optional<SweptPlaces> places = std::nullopt;
};

/// Returns the JSON object of the scene format (docs/reference/scene_format.md).
[[nodiscard]] std::string report_json(const Report& report);
/// Tables for people, angles in degrees.
[[nodiscard]] std::string report_text(const Report& report);
/// The head of a table with one row per configuration.
[[nodiscard]] std::string csv_header(const Plan& plan);
/// The rows of one solution, without a sweep.
[[nodiscard]] std::string csv_rows(const Report& report);

/// The rows of a sweep, below `csv_header`.
class SweepRows {
 public:
  /// The representation of links' angles.
  enum class Angles : unsigned char {
    principal,  ///< in (-pi, pi]
    unwrapped   ///< on each branch continued by whole turns from row to row
  };

  explicit SweepRows(const Plan& plan, Angles angles = Angles::principal)
      : plan_(plan), angles_(angles) {}

  /// Adds one row to a text: a configuration on its branch, or an event. The cell of its circuit is
  /// empty, since any later event may join two circuits.
  void add(const SweepRecord& record, std::string& text);

  /// Puts the circuit of its branch into a row; none if its branch has none.
  static void set_circuit(const Circuits& circuits, std::string& row);

 private:
  /// Makes the angles of a row continuous with those of the last row of its branch.
  void unwrap(int branch, std::vector<double>& angles);

  const Plan& plan_;
  Angles angles_;
  std::map<int, std::vector<double>> last_angles_;  ///< of each branch
};

}  // namespace assur::mechanism
