// Rows of numbers as columns of an HDF5 file: writer and reader.
#pragma once

#include <string>

#include "campaign/table_file.hpp"

namespace assur::generator::campaign {

/// Throws InputError, prefixed by `where`, if this program was built without HDF5, as `hdf5_writer`
/// and `hdf5_reader` do.
void expect_hdf5(const std::string& where);

/// One data set per column, with one element per row: 64-bit integers, outcomes as an enumeration,
/// doubles with NaN for a missing number. The attribute `description` contains the lines that a CSV
/// file has as comments, followed by the line of names.
[[nodiscard]] std::unique_ptr<TableWriter> hdf5_writer(PartialFile& file,
                                                       const Description& description);
[[nodiscard]] std::unique_ptr<TableReader> hdf5_reader(const std::filesystem::path& file);

/// The functions of the module. The caller deletes their results.
extern "C" {
[[nodiscard]] TableWriter* assur_hdf5_writer(PartialFile* file, const Description* description);
[[nodiscard]] TableReader* assur_hdf5_reader(const char* file);
}

}  // namespace assur::generator::campaign
