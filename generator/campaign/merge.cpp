#include "campaign/merge.hpp"

#include <assur/text/error.hpp>
#include <assur/text/names.hpp>
#include <map>
#include <optional>

#include "campaign/csv_table.hpp"

namespace assur::generator::campaign {

namespace {

constexpr std::size_t most_named = 20;

void expect_all(const std::map<std::uint64_t, std::filesystem::path>& found, std::uint64_t count) {
  std::vector<std::string> missing;
  std::uint64_t number_missing = 0;
  for (std::uint64_t number = 1; number <= count; ++number) {
    if (!found.contains(number)) {
      ++number_missing;
      if (missing.size() < most_named) {
        missing.push_back(Shard{number, count}.text());
      }
    }
  }
  if (number_missing > 0) {
    const bool is_one = number_missing == 1;
    throw text::InputError(std::to_string(number_missing) + " of " + std::to_string(count) +
                           (is_one ? " shards is missing: " : " shards are missing: ") +
                           text::listed(missing) +
                           (number_missing > missing.size() ? ", ..." : "") + "; compute " +
                           (is_one ? "it" : "them") + " with --shard");
  }
}

}  // namespace

ShardFiles shard_files(const std::vector<std::filesystem::path>& files) {
  std::optional<Description> first;
  std::map<std::uint64_t, std::filesystem::path> found;
  for (const std::filesystem::path& file : files) {
    if (file.extension() != ".csv" && file.extension() != ".h5") {
      throw text::InputError(file.string() +
                             ": its name does not end in .csv or .h5; give tables that sample or "
                             "map has written");
    }
    expect_table_name(file, "merge");
    const Description description = table_reader(file)->description();
    if (!first) {
      first = description;
    }
    if (const std::string why = difference(description, *first); !why.empty()) {
      throw text::InputError(file.string() + ": it is not a part of the same campaign as " +
                             files.front().string() + ": " + why);
    }
    if (description.shard.count != first->shard.count) {
      throw text::InputError(file.string() + ": it is shard " + description.shard.text() +
                             ", and " + files.front().string() + " is one of " +
                             std::to_string(first->shard.count));
    }
    const auto [other, is_new] = found.emplace(description.shard.number, file);
    if (!is_new && other->second == file) {
      throw text::InputError(file.string() + ": it is given twice; leave one out");
    }
    if (!is_new) {
      throw text::InputError(file.string() + ": it is shard " + description.shard.text() +
                             ", and so is " + other->second.string() + "; leave one out");
    }
  }
  expect_all(found, first->shard.count);
  ShardFiles result{*first, {}};
  result.description.shard = {};
  for (const auto& [number, file] : found) {
    result.files.push_back(file);
  }
  return result;
}

void merge(const ShardFiles& shards, const Outputs& outputs,
           const std::function<void(const std::vector<double>&)>& use) {
  PendingOutputs pending(outputs, shards.description);
  for (const std::filesystem::path& shard : shards.files) {
    const std::unique_ptr<TableReader> reader = table_reader(shard);
    for_each_row_block(*reader, shard.string(), [&](const std::vector<double>& rows) {
      use(rows);
      pending.add(
          rows, pending.wants_text() ? csv_lines(shards.description.columns, rows) : std::string());
    });
  }
  pending.finish();
}

}  // namespace assur::generator::campaign
