// Reads the declarations of an audit file into a closure system.
#pragma once

#include <set>

#include "closures/closure_system.hpp"
#include "closures/statement.hpp"

namespace assur::generator::closures {

/// Reads source, model, angle, length, unknown, moving, constant, let, loop and closure, one
/// statement after the other: each may use what earlier ones declare. Throws AuditSyntaxError.
class ClosureReader {
 public:
  explicit ClosureReader(std::string file) : file_(std::move(file)) {}

  /// Returns false if the statement is of another kind. `fail` refers to it in either case.
  [[nodiscard]] bool read(const Statement& statement);
  [[nodiscard]] const std::string& file() const { return file_; }
  [[nodiscard]] const std::string& source() const { return source_; }
  [[nodiscard]] ClosureSystem& system() { return system_; }
  [[nodiscard]] const ClosureSystem& system() const { return system_; }
  /// The first words of its statements.
  [[nodiscard]] static std::vector<std::string> keywords();

  /// The place in the file of a place in the statement's joined text.
  [[nodiscard]] Place place_in_file(Place joined) const { return place_in(statement_, joined); }
  /// Throws AuditSyntaxError; `joined` is a place in the statement's joined text.
  [[noreturn]] void fail(Place joined, const std::string& what) const;
  /// Throws unless a name can be declared for a number.
  void expect_new(const PlacedText& name) const;
  /// Throws unless a name can be declared for a symbol: no function of formulas may have it.
  void expect_new_in_formulas(const PlacedText& name) const;
  /// Reserves a name for something outside the system.
  void reserve(const std::string& name) { reserved_.insert(name); }
  /// The names in a list, of symbols only or of anything in the system. Throws for unknown names.
  [[nodiscard]] std::vector<std::string> known_names(const PlacedText& list, bool symbols_only);

 private:
  void read_source(const PlacedText& rest) { source_ = rest.text; }
  void read_model(const PlacedText& kind);
  void read_angles(const PlacedText& rest) { read_symbols(rest, true); }
  void read_lengths(const PlacedText& rest) { read_symbols(rest, false); }
  void read_symbols(const PlacedText& rest, bool angles);
  void read_unknowns(const PlacedText& rest);
  void read_moving(const PlacedText& rest);
  void read_constant(const PlacedText& rest);
  void read_abbreviation(const PlacedText& rest);
  void read_loop(const PlacedText& rest);
  void read_closure(const PlacedText& rest);

  struct Keyword;
  [[nodiscard]] static const std::vector<Keyword>& readers();

  std::string file_;
  std::string source_;
  Statement statement_;  ///< the one being read
  ClosureSystem system_;
  std::set<std::string> reserved_;
};

}  // namespace assur::generator::closures
