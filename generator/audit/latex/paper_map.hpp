// The map of a paper: rules that assign quantities to its notation.
#pragma once

#include <map>
#include <set>

#include "audit/equation_audit.hpp"
#include "closures/closure_reader.hpp"
#include "latex/displayed.hpp"
#include "latex/read_latex.hpp"

namespace assur::generator::audit::latex {

using generator::latex::DisplayCommand;
using generator::latex::Notations;
using generator::latex::Tokens;

/// The rules by which a paper is read; the format is in docs/reference/audit_format.md.
class PaperMap {
 public:
  /// Throws InputError.
  PaperMap(const std::string& text, const std::string& file);
  PaperMap(const PaperMap&) = delete;
  PaperMap& operator=(const PaperMap&) = delete;

  /// A notation that denotes a whole matrix.
  struct Matrix {
    std::vector<std::string> pattern;
    closures::PlacedText rows;  ///< empty: given by its titles
    closures::PlacedText columns;
    closures::Statement statement;
    std::vector<std::string> row_names{};  ///< or formulas, read when all names are known
  };

  [[nodiscard]] closures::ClosureReader& reader() { return reader_; }
  [[nodiscard]] const closures::ClosureSystem& system() const { return reader_.system(); }
  [[nodiscard]] const Notations& notations() const { return notations_; }
  [[nodiscard]] generator::latex::Reading reading() const {
    return {notations_, brackets_multiply_, blanks_are_zero_, summed_};
  }
  [[nodiscard]] const std::map<std::string, std::vector<std::string>>& indices() const {
    return indices_;
  }
  [[nodiscard]] const std::map<std::string, std::vector<std::string>>& summed() const {
    return summed_;
  }
  [[nodiscard]] const std::map<std::string, DisplayCommand>& commands() const { return commands_; }
  /// Finds the equations and sections of the paper that the map skips; before that, no section is
  /// skipped. Throws AuditSyntaxError if the map skips one that the paper does not have.
  void find_skipped(const std::set<std::string>& labels, const std::set<std::string>& sections);
  [[nodiscard]] bool skips(const std::string& label, const std::string& section) const {
    return skipped_.contains(label) || skipped_sections_.contains(section);
  }
  /// The rows and columns of the matrix that all these tokens denote, or nothing; both lists are
  /// empty where the matrix's titles give them. Throws FormulaError where a `?` is not a quantity.
  [[nodiscard]] std::optional<PrintedMatrix> matrix_frame(const Tokens& notation) const;
  /// The quantity that makes up a whole side, without a power or dots; empty for other sides.
  [[nodiscard]] std::optional<generator::latex::Meaning> quantity(const Tokens& side) const;
  /// The names of a list such as `f1 f2` or `a1..13`.
  [[nodiscard]] std::vector<std::string> names(const closures::PlacedText& list,
                                               bool symbols_only) const;

 private:
  void read(const closures::Statement& statement);
  void read_closures(const closures::PlacedText& file);
  void read_display(const closures::PlacedText& rest);
  void read_index(const closures::PlacedText& rest,
                  std::map<std::string, std::vector<std::string>>& list);
  [[nodiscard]] bool sums_itself(const std::string& index) const;
  void read_skip(const closures::PlacedText& rest);
  /// Skips the longest title that the parts at `from` spell. Returns the start of the next one.
  std::size_t skip_section(const std::vector<closures::PlacedText>& parts, std::size_t from,
                           const std::set<std::string>& sections);
  void read_notation(const closures::PlacedText& line);
  /// Throws if a notation has a meaning already: one of the two would be ignored.
  void expect_new(const closures::PlacedText& notation, const Tokens& tokens) const;
  /// Throws for names that the map declares nowhere.
  void expect_known_names();
  void expect_known_names(const text::Expression& tree, const closures::PlacedText& formula) const;
  /// The quantity that a symbol among the tokens stands for.
  [[nodiscard]] std::string quantity_named(const std::string& symbol, const Tokens& tokens) const;
  /// `place` lies in the joined text of the statement that is being read.
  [[noreturn]] void fail(closures::Place place, const std::string& what) const;

  /// A formula of the map, and the statement that it stands in.
  struct Formula {
    closures::Statement statement;
    closures::PlacedText text;
  };

  std::string file_;
  closures::Statement statement_;  ///< the one being read
  closures::ClosureReader reader_;
  Notations notations_;
  std::vector<Matrix> matrices_;
  std::map<std::string, std::vector<std::string>> indices_;
  std::map<std::string, std::vector<std::string>> summed_;
  std::map<std::string, DisplayCommand> commands_;
  std::map<std::string, closures::Place> skipped_;  ///< places in the file
  /// The parts between the commas of each statement. Titles may contain commas.
  std::vector<std::vector<closures::PlacedText>> section_lists_;
  std::set<std::string> skipped_sections_;
  std::vector<Formula> formulas_;
  bool brackets_multiply_ = false;
  bool blanks_are_zero_ = false;
};

}  // namespace assur::generator::audit::latex
