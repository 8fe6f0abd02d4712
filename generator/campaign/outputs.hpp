// Turns rows into a table and a picture of them, of which both are written or none.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "campaign/table_file.hpp"

namespace assur::generator::campaign {

/// Where the rows go, if they are kept, and where their picture goes, if there is one.
struct Outputs {
  std::filesystem::path table, picture;
  std::function<std::string()> drawing;  ///< the picture, once all rows are there
};

/// Files that take their names when both are whole.
class PendingOutputs {
 public:
  /// Throws InputError where a file cannot be made.
  PendingOutputs(const Outputs& outputs, const Description& description);

  void add(const std::vector<double>& rows, const std::string& text);
  /// Whether `add` needs the text that `csv_lines` makes of the rows.
  [[nodiscard]] bool wants_text() const { return writer_ && writer_->wants_text(); }
  /// Throws InputError where a file cannot be written; both names are as they were then.
  void finish();

 private:
  std::function<std::string()> drawing_;
  std::optional<PartialFile> table_, picture_;
  std::unique_ptr<TableWriter> writer_;
};

}  // namespace assur::generator::campaign
