#include "campaign/execution.hpp"

#include <assur/text/error.hpp>
#include <optional>

#include "campaign/csv_table.hpp"

namespace assur::generator::campaign {

bool is_computed(const Execution& execution) {
  if (execution.table.empty()) {
    return false;
  }
  std::error_code error;
  if (!std::filesystem::exists(execution.table, error)) {
    expect_new(execution.table, execution.may_replace);  // it may be a link that leads nowhere
    return false;
  }
  std::string why;
  try {
    const Description found = table_reader(execution.table)->description();
    why = difference(found, execution.description);
    if (why.empty() && found.shard.text() != execution.description.shard.text()) {
      why = "shard: " + found.shard.text() + " instead of " + execution.description.shard.text();
    }
    if (why.empty()) {
      return true;
    }
  } catch (const text::InputError&) {  // it is no table
  }
  if (!execution.may_replace) {
    throw text::InputError(execution.table.string() + ": the file exists" +
                           (why.empty() ? "" : " and holds another table (" + why + ")") +
                           "; give another name, or --force to replace it");
  }
  return false;
}

void execute(const Execution& execution,
             const std::function<void(const std::vector<double>&)>& use) {
  const Description& description = execution.description;
  if (is_computed(execution)) {
    const std::unique_ptr<TableReader> reader = table_reader(execution.table);
    for_each_row_block(*reader, execution.table.string(), use);
    return;
  }
  std::optional<PartialFile> file;
  std::unique_ptr<TableWriter> writer;
  if (!execution.table.empty()) {
    file.emplace(execution.table);
    writer = table_writer(*file, description);
  }
  std::function<std::string(const std::vector<double>&)> encode;
  if (writer && writer->wants_text()) {
    encode = [&description](const std::vector<double>& rows) {
      return csv_lines(description.columns, rows);
    };
  }
  const mechanism::ItemRange items =
      mechanism::part_of(description.items, description.shard.number, description.shard.count);
  mechanism::run_campaign(execution.campaign, items, execution.threads, encode,
                          [&](const mechanism::RowBlock& block) {
                            use(block.rows);
                            if (writer) {
                              writer->add(block.rows, block.text);
                            }
                            if (execution.progress) {
                              execution.progress(block.items.last - items.first);
                            }
                          });
  if (writer) {
    writer->finish();
  }
}

}  // namespace assur::generator::campaign
