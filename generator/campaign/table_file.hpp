// Turns a campaign's rows into a file in the format that its extension says, and back.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "campaign/description.hpp"
#include "campaign/partial_file.hpp"

namespace assur::generator::campaign {

/// Takes rows in the order of their items. Every function throws InputError where the file cannot
/// be written.
class TableWriter {
 public:
  TableWriter() = default;
  TableWriter(const TableWriter&) = delete;
  TableWriter& operator=(const TableWriter&) = delete;
  virtual ~TableWriter() = default;

  /// `text` is what `csv_lines` makes of the rows; only a writer that wants it gets it.
  virtual void add(const std::vector<double>& rows, const std::string& text) = 0;
  [[nodiscard]] virtual bool wants_text() const = 0;
  /// Brings all rows to the disk.
  virtual void finish() = 0;
};

/// Gives a file's rows back.
class TableReader {
 public:
  TableReader() = default;
  TableReader(const TableReader&) = delete;
  TableReader& operator=(const TableReader&) = delete;
  virtual ~TableReader() = default;

  [[nodiscard]] const Description& description() const { return description_; }
  /// Where a row stands, from 1, for messages.
  [[nodiscard]] virtual std::string place_of(std::uint64_t row) const = 0;
  /// Replaces `rows` by the next rows, and returns false if there are none. Throws InputError where
  /// the file is not complete.
  [[nodiscard]] virtual bool next(std::vector<double>& rows) = 0;

 protected:
  Description description_;
};

/// Throws InputError for an ending that is neither `.csv` nor `.h5`, or where files of HDF5 cannot
/// be written here; `option` is what messages call the file.
void expect_table_name(const std::filesystem::path& file, const std::string& option);

[[nodiscard]] std::unique_ptr<TableWriter> table_writer(PartialFile& file,
                                                        const Description& description);
[[nodiscard]] std::unique_ptr<TableReader> table_reader(const std::filesystem::path& file);

/// Hands a file's rows over, and throws InputError where they are not those of its shard; the
/// message names the first row that is not.
void for_each_row_block(TableReader& reader, const std::string& file,
                        const std::function<void(const std::vector<double>&)>& use);

}  // namespace assur::generator::campaign
