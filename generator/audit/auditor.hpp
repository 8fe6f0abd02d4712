// Reads the statements of an audit file into declarations and findings.
#pragma once

#include <filesystem>

#include "audit/audit.hpp"
#include "audit/equation_audit.hpp"
#include "audit/finding.hpp"
#include "audit/numeric_example.hpp"
#include "audit/own_position.hpp"
#include "audit/run_audit.hpp"
#include "closures/closure_reader.hpp"
#include "structure/group.hpp"

namespace assur::generator::audit {

/// Reads statements in their order: each may use what earlier ones declare.
class Auditor {
 public:
  /// `turned`: names of closures that are read with all signs reversed.
  Auditor(const std::string& file, const SceneReader& scenes, const RunPermission& run,
          std::set<std::string> turned = {})
      : directory_(std::filesystem::path(file).parent_path()),
        scenes_(scenes),
        run_(run),
        turned_(std::move(turned)),
        reader_(file) {}
  Auditor(const Auditor&) = delete;
  Auditor& operator=(const Auditor&) = delete;

  void read(const closures::Statement& statement);
  /// Reads declarations and printed closures only; `turned` needs no more.
  void read_signs(const closures::Statement& statement);
  [[nodiscard]] AuditReport report() const;
  /// The closures whose every printed form has all signs reversed.
  [[nodiscard]] std::set<std::string> turned() const;

 private:
  void expect_no_rows(const closures::Statement& statement) const;
  [[nodiscard]] const structure::Group& group_by_name(const closures::PlacedText& name) const;

  [[nodiscard]] bool read_declaration(const closures::Statement& statement);
  void read_own(const closures::Statement& statement);
  void read_scene(const closures::PlacedText& rest);
  void read_group(const closures::PlacedText& rest);
  void read_given(const closures::PlacedText& rest);
  void read_value(const closures::PlacedText& rest);
  void define(const std::string& name, double value);

  void read_printed(const closures::Statement& statement, closures::PlacedText rest);
  void read_printed_closure(const closures::PlacedText& label, closures::PlacedText rest);
  void read_printed_matrix(const closures::Statement& statement, const closures::PlacedText& label,
                           const closures::PlacedText& rest);
  [[nodiscard]] closures::PlacedText take_code_file(closures::PlacedText& rest) const;
  void read_printed_code(const closures::PlacedText& label, closures::PlacedText rest);
  void read_printed_run(const closures::Statement& statement, const closures::PlacedText& label,
                        closures::PlacedText rest);
  [[nodiscard]] ExpectedMatrix expected_matrix(const closures::PlacedText& frame);
  [[nodiscard]] OwnDerivatives own_derivatives(const closures::PlacedText& frame) const;
  void read_printed_equation(const closures::PlacedText& label, closures::PlacedText rest);
  void read_printed_kinds(const closures::Statement& statement, const closures::PlacedText& label,
                          closures::PlacedText rest);
  void read_printed_number(const closures::PlacedText& rest);
  [[nodiscard]] PrintedMatrix matrix_frame(const closures::PlacedText& rest);
  void answer(const std::string& label, closures::Place place, std::size_t columns,
              std::vector<Finding> findings);

  std::filesystem::path directory_;
  const SceneReader& scenes_;
  const RunPermission& run_;
  std::set<std::string> turned_;
  std::map<std::string, bool> printed_closures_;  ///< whether all signs are reversed every time
  closures::ClosureReader reader_;
  closures::ClosurePoints points_{reader_.system()};
  NumericExample numbers_;
  std::vector<std::string> settings_;  ///< of given numbers, for the scene
  std::vector<AuditedStatement> statements_;
};

}  // namespace assur::generator::audit
