// Rows of numbers as lines of CSV below comments that describe them: writer and reader.
#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "campaign/table_file.hpp"

namespace assur::generator::campaign {

/// The names of the columns as a line without its end.
[[nodiscard]] std::string csv_head(const std::vector<mechanism::Column>& columns);
[[nodiscard]] std::vector<std::string> names_in_csv_head(const std::string& line);
/// Gives columns the names in a line; returns false if the line does not fit these columns.
[[nodiscard]] bool take_names(const std::string& line, std::vector<mechanism::Column>& columns);

/// The rows as lines. Numbers have the fewest digits that identify them; a missing number is an
/// empty cell.
[[nodiscard]] std::string csv_lines(const std::vector<mechanism::Column>& columns,
                                    const std::vector<double>& rows);

[[nodiscard]] std::unique_ptr<TableWriter> csv_writer(PartialFile& file,
                                                      const Description& description);
[[nodiscard]] std::unique_ptr<TableReader> csv_reader(const std::filesystem::path& file);

}  // namespace assur::generator::campaign
