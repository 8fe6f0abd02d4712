// The table and the picture of a campaign, written both or neither.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "campaign/table_file.hpp"

namespace assur::generator::campaign {

/// The table's file, if it is kept, and the picture's, if there is one.
struct Outputs {
  std::filesystem::path table, picture;
  std::function<std::string()> drawing;  ///< the picture, drawn after the last row
};

/// Files that are renamed when both are complete.
class PendingOutputs {
 public:
  /// Throws InputError if a file cannot be created.
  PendingOutputs(const Outputs& outputs, const Description& description);

  void add(const std::vector<double>& rows, const std::string& text);
  /// Whether `add` needs the text that `csv_lines` produces from the rows.
  [[nodiscard]] bool wants_text() const { return writer_ && writer_->wants_text(); }
  /// Throws InputError if a file cannot be written; then both names are as before.
  void finish();

 private:
  std::function<std::string()> drawing_;
  std::optional<PartialFile> table_, picture_;
  std::unique_ptr<TableWriter> writer_;
};

}  // namespace assur::generator::campaign
