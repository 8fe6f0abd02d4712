// Tables of a campaign as files, in the format given by the extension.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "campaign/description.hpp"
#include "campaign/partial_file.hpp"

namespace assur::generator::campaign {

/// Takes rows in the order of their items. Every function throws InputError if the file cannot be
/// written.
class TableWriter {
 public:
  TableWriter() = default;
  TableWriter(const TableWriter&) = delete;
  TableWriter& operator=(const TableWriter&) = delete;
  virtual ~TableWriter() = default;

  /// `text`: the rows as printed by `csv_lines`, if `wants_text`.
  virtual void add(const std::vector<double>& rows, const std::string& text) = 0;
  [[nodiscard]] virtual bool wants_text() const = 0;
  /// Writes all rows to the disk.
  virtual void finish() = 0;
};

/// Reads a file's rows.
class TableReader {
 public:
  TableReader() = default;
  TableReader(const TableReader&) = delete;
  TableReader& operator=(const TableReader&) = delete;
  virtual ~TableReader() = default;

  [[nodiscard]] const Description& description() const { return description_; }
  /// The position of a row, counted from 1, for messages.
  [[nodiscard]] virtual std::string place_of(std::uint64_t row) const = 0;
  /// Replaces `rows` by the next rows, and returns false if there are none. Throws InputError if
  /// the file is incomplete.
  [[nodiscard]] virtual bool next(std::vector<double>& rows) = 0;

 protected:
  Description description_;
};

/// Throws InputError for an extension other than `.csv` and `.h5`, or if HDF5 files cannot be
/// written here; `option` names the file in messages.
void expect_table_name(const std::filesystem::path& file, const std::string& option);

[[nodiscard]] std::unique_ptr<TableWriter> table_writer(PartialFile& file,
                                                        const Description& description);
[[nodiscard]] std::unique_ptr<TableReader> table_reader(const std::filesystem::path& file);

/// Hands over a file's rows, and throws InputError if they are not those of its shard; the message
/// names the first wrong row.
void for_each_row_block(TableReader& reader, const std::string& file,
                        const std::function<void(const std::vector<double>&)>& use);

}  // namespace assur::generator::campaign
