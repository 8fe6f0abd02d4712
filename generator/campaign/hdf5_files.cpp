// Opens HDF5 files through the module that contains the HDF5 code.
#include <assur/text/error.hpp>

#include "campaign/hdf5_table.hpp"
#include "campaign/module.hpp"

namespace assur::generator::campaign {

namespace {

/// The module's function; throws InputError, prefixed by `where`, if there is no module.
template <typename Function>
Function* loaded(const char* name, const std::string& where) {
  void* const found = function_of_module("assur_hdf5", name);
  if (found == nullptr) {
    throw text::InputError(where +
                           ": this assur was built without HDF5; end the name in .csv, or install "
                           "libhdf5-dev and build it again");
  }
  return reinterpret_cast<Function*>(found);
}

}  // namespace

void expect_hdf5(const std::string& where) {
  (void)loaded<decltype(assur_hdf5_writer)>("assur_hdf5_writer", where);
}

std::unique_ptr<TableWriter> hdf5_writer(PartialFile& file, const Description& description) {
  const auto writer =
      loaded<decltype(assur_hdf5_writer)>("assur_hdf5_writer", file.target().string());
  return std::unique_ptr<TableWriter>(writer(&file, &description));
}

std::unique_ptr<TableReader> hdf5_reader(const std::filesystem::path& file) {
  const auto reader = loaded<decltype(assur_hdf5_reader)>("assur_hdf5_reader", file.string());
  return std::unique_ptr<TableReader>(reader(file.c_str()));
}

}  // namespace assur::generator::campaign
