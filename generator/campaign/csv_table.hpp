// Turns rows of numbers into lines of CSV below comments that describe them, and back.
#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "campaign/table_file.hpp"

namespace assur::generator::campaign {

/// The names of the columns as a line without its end, and the names in such a line.
[[nodiscard]] std::string csv_head(const std::vector<mechanism::Column>& columns);
[[nodiscard]] std::vector<std::string> names_in_csv_head(const std::string& line);
/// Gives columns the names in a line, and returns false if it is not the line of these columns.
[[nodiscard]] bool take_names(const std::string& line, std::vector<mechanism::Column>& columns);

/// Lines of rows. Numbers have the fewest digits that tell them from all others; a number that
/// does not exist is an empty cell.
[[nodiscard]] std::string csv_lines(const std::vector<mechanism::Column>& columns,
                                    const std::vector<double>& rows);

[[nodiscard]] std::unique_ptr<TableWriter> csv_writer(PartialFile& file,
                                                      const Description& description);
[[nodiscard]] std::unique_ptr<TableReader> csv_reader(const std::filesystem::path& file);

}  // namespace assur::generator::campaign
