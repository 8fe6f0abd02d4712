// Turns the statements of an audit file, one after the other, into what they say and answer.
#pragma once

#include <filesystem>

#include "audit/equation_audit.hpp"
#include "audit/finding.hpp"
#include "audit/numeric_example.hpp"
#include "closures/closure_reader.hpp"
#include "structure/group.hpp"

namespace assur::generator {

/// Reads statements in their order: each may use what earlier ones declare.
class Auditor {
 public:
  explicit Auditor(const std::string& file)
      : directory_(std::filesystem::path(file).parent_path()), reader_(file) {}
  Auditor(const Auditor&) = delete;
  Auditor& operator=(const Auditor&) = delete;

  void read(const Statement& statement);
  [[nodiscard]] AuditReport report() const;

 private:
  void expect_no_rows(const Statement& statement) const;
  [[nodiscard]] const Group& group_by_name(const PlacedText& name) const;

  void read_own(const Statement& statement);
  void read_scene(const PlacedText& rest);
  void read_group(const PlacedText& rest);
  void read_given(const PlacedText& rest);
  void read_value(const PlacedText& rest);
  void define(const std::string& name, double value);

  void read_printed(const Statement& statement, PlacedText rest);
  void read_printed_closure(const PlacedText& label, PlacedText rest);
  void read_printed_matrix(const Statement& statement, const PlacedText& label,
                           const PlacedText& rest);
  void read_printed_code(const PlacedText& label, PlacedText rest);
  void read_printed_equation(const PlacedText& label, PlacedText rest);
  void read_printed_kinds(const Statement& statement, const PlacedText& label, PlacedText rest);
  void read_printed_number(const PlacedText& rest);
  [[nodiscard]] PrintedMatrix matrix_frame(const PlacedText& rest);
  void answer(const std::string& label, Place place, std::size_t columns,
              std::vector<Finding> findings);

  std::filesystem::path directory_;
  ClosureReader reader_;
  ClosurePoints points_{reader_.system()};
  NumericExample numbers_;
  std::vector<std::string> settings_;  ///< of given numbers, for the scene
  std::vector<AuditedStatement> statements_;
};

}  // namespace assur::generator
