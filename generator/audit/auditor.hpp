// Turns the statements of an audit file, one after the other, into what they say and answer.
#pragma once

#include <filesystem>
#include <optional>

#include "audit/equation_audit.hpp"
#include "audit/finding.hpp"
#include "audit/numeric_example.hpp"
#include "structure/group.hpp"

namespace assur::generator {

/// Reads statements in their order: each may use what earlier ones declare.
class Auditor {
 public:
  explicit Auditor(std::string file)
      : directory_(std::filesystem::path(file).parent_path()), numbers_(file) {
    report_.file = std::move(file);
  }

  void read(const Statement& statement);
  [[nodiscard]] const AuditReport& report() const { return report_; }
  [[nodiscard]] ClosureSystem& system() { return system_; }

 private:
  [[noreturn]] void fail(Place place, const std::string& what) const;
  [[nodiscard]] GiNaC::ex formula(const PlacedText& text);
  void expect_new(const PlacedText& name) const;
  void expect_no_rows(const Statement& statement) const;
  [[nodiscard]] std::vector<std::string> known_names(const PlacedText& list, bool symbols_only);
  [[nodiscard]] const Group& group_by_name(const PlacedText& name) const;
  [[nodiscard]] std::string read_file_beside(const PlacedText& name) const;

  void read_model(const PlacedText& kind);
  void read_symbols(const PlacedText& rest, bool angles);
  void read_unknowns(const PlacedText& rest);
  void read_moving(const PlacedText& rest);
  void read_abbreviation(const PlacedText& rest);
  void read_loop(const PlacedText& rest);
  void read_closure(const PlacedText& rest);
  void read_scene(const PlacedText& rest);
  void read_group(const PlacedText& rest);
  void read_given(const PlacedText& rest);
  void read_value(const PlacedText& rest);

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
  AuditReport report_;
  ClosureSystem system_;
  NumericExample numbers_;
  std::vector<std::string> settings_;  ///< of given numbers, for the scene
};

}  // namespace assur::generator
