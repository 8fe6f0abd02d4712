#include "campaign/table_file.hpp"

#include <assur/mechanism/campaign.hpp>
#include <assur/text/error.hpp>
#include <assur/text/quoted.hpp>

#include "campaign/csv_table.hpp"
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
  const Description& description = reader.description();
  const auto [first, last] =
      mechanism::part_of(description.items, description.shard.number, description.shard.count);
  std::uint64_t next = first;  // an item that has no row yet
  std::vector<double> rows;
  while (reader.next(rows)) {
    for (std::size_t at = 0; at < rows.size(); at += description.columns.size()) {
      const bool is_next = next < last && rows[at] == static_cast<double>(next);
      const bool goes_on = next > first && rows[at] == static_cast<double>(next - 1);
      if (!is_next && !goes_on) {
        throw text::InputError(file + ": after item " + std::to_string(next) + " of " +
                               std::to_string(last) +
                               " the rows are not in order; compute the table again");
      }
      next += is_next ? 1 : 0;
    }
    use(rows);
  }
  if (next != last) {
    throw text::InputError(file + ": the table is incomplete: it ends at item " +
                           std::to_string(next) + " of " + std::to_string(last) +
                           "; compute it again");
  }
}

}  // namespace assur::generator::campaign
