#include "campaign/execution.hpp"

#include <assur/text/error.hpp>

#include "campaign/csv_table.hpp"

namespace assur::generator::campaign {

bool is_computed(const Execution& execution) {
  if (execution.outputs.table.empty()) {
    return false;
  }
  std::error_code error;
  if (!std::filesystem::exists(execution.outputs.table, error)) {
    expect_new(execution.outputs.table,
               execution.may_replace);  // it may be a dangling link
    return false;
  }
  std::string why;
  try {
    const Description found = table_reader(execution.outputs.table)->description();
    why = difference(found, execution.description);
    if (why.empty() && found.shard.text() != execution.description.shard.text()) {
      why = "shard: " + found.shard.text() + " instead of " + execution.description.shard.text();
    }
    if (why.empty()) {
      return true;
    }
  } catch (const text::InputError&) {  // it is not a table
  }
  if (!execution.may_replace) {
    throw text::InputError(execution.outputs.table.string() + ": the file exists" +
                           (why.empty() ? "" : " and holds another table (" + why + ")") +
                           "; give another name, or --force to replace it");
  }
  return false;
}

void execute(const Execution& execution,
             const std::function<void(const std::vector<double>&)>& use) {
  const Description& description = execution.description;
  if (is_computed(execution)) {
    PendingOutputs picture({{}, execution.outputs.picture, execution.outputs.drawing}, description);
    const std::unique_ptr<TableReader> reader = table_reader(execution.outputs.table);
    for_each_row_block(*reader, execution.outputs.table.string(), use);
    picture.finish();
    return;
  }
  PendingOutputs outputs(execution.outputs, description);
  std::function<std::string(const std::vector<double>&)> encode;
  if (outputs.wants_text()) {
    encode = [&description](const std::vector<double>& rows) {
      return csv_lines(description.columns, rows);
    };
  }
  const mechanism::ItemRange items =
      mechanism::part_of(description.items, description.shard.number, description.shard.count);
  mechanism::run_campaign(execution.campaign, items, execution.threads, encode,
                          [&](const mechanism::RowBlock& block) {
                            use(block.rows);
                            outputs.add(block.rows, block.text);
                            if (execution.progress) {
                              execution.progress(block.items.last - items.first);
                            }
                          });
  outputs.finish();
}

}  // namespace assur::generator::campaign
