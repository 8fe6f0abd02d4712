#include "campaign/table_file.hpp"

#include <assur/text/error.hpp>
#include <assur/text/quoted.hpp>

#include "campaign/csv_table.hpp"
#include "campaign/expected_rows.hpp"
#include "campaign/hdf5_table.hpp"

namespace assur::generator::campaign {

void expect_table_name(const std::filesystem::path& file, const std::string& option) {
  if (file.extension() == ".h5") {
    expect_hdf5(option + ": " + file.string());
  } else if (file.extension() != ".csv") {
    const std::string extension = file.extension().string();
    throw text::InputError(option + ": " + file.string() + ": " +
                           (extension.empty()
                                ? "the name has no extension"
                                : "the extension " + text::in_quotes(extension) + " is not known") +
                           "; give .csv, .h5 or .svg");
  }
}

std::unique_ptr<TableWriter> table_writer(PartialFile& file, const Description& description) {
  return file.target().extension() == ".h5" ? hdf5_writer(file, description)
                                            : csv_writer(file, description);
}

std::unique_ptr<TableReader> table_reader(const std::filesystem::path& file) {
  return file.extension() == ".h5" ? hdf5_reader(file) : csv_reader(file);
}

void for_each_row_block(TableReader& reader, const std::string& file,
                        const std::function<void(const std::vector<double>&)>& use) {
  ExpectedRows expected(reader.description());
  const std::size_t width = reader.description().columns.size();
  std::uint64_t row = 0;
  std::vector<double> rows;
  while (reader.next(rows)) {
    for (std::size_t at = 0; at < rows.size(); at += width) {
      ++row;
      if (const std::string fault = expected.fault(&rows[at]); !fault.empty()) {
        throw text::InputError(reader.place_of(row) + ": " + fault + "; compute the table again");
      }
    }
    use(rows);
  }
  if (const std::string lack = expected.lack(); !lack.empty()) {
    throw text::InputError(file + ": " + lack + "; compute it again");
  }
}

}  // namespace assur::generator::campaign
