// Turns rows of numbers into columns of an HDF5 file, and back.
#pragma once

#include <string>

#include "campaign/table_file.hpp"

namespace assur::generator::campaign {

/// Throws InputError, with `where` in front, if this program was built without HDF5. `hdf5_writer`
/// and `hdf5_reader` throw it, too.
void expect_hdf5(const std::string& where);

/// One data set per column, with one element per row: 64-bit whole numbers, outcomes as an
/// enumeration, doubles with NaN for a number that does not exist. The attribute `description`
/// holds the lines that a file of CSV has as comments, with the line of names behind them.
[[nodiscard]] std::unique_ptr<TableWriter> hdf5_writer(PartialFile& file,
                                                       const Description& description);
[[nodiscard]] std::unique_ptr<TableReader> hdf5_reader(const std::filesystem::path& file);

/// The module's functions. The caller deletes what they return.
extern "C" {
[[nodiscard]] TableWriter* assur_hdf5_writer(PartialFile* file, const Description* description);
[[nodiscard]] TableReader* assur_hdf5_reader(const char* file);
}

}  // namespace assur::generator::campaign
