// The command `assur merge`: one table of all shards, its summary and its picture.
#include "campaign/merge.hpp"

#include <assur/text/error.hpp>

#include "campaign/grid_summary.hpp"
#include "campaign/partial_file.hpp"
#include "campaign/sample_summary.hpp"
#include "command/campaigns.hpp"
#include "command/output.hpp"

namespace assur::generator::command {

namespace {

template <typename Summary, typename Picture, typename Text>
void merge_and_report(const campaign::ShardFiles& shards, campaign::Outputs outputs,
                      const Picture& picture, const Text& text) {
  Summary summary(shards.description, shards.files.front().string());
  outputs.drawing = [&] { return picture(summary); };
  ProgressBar bar;
  std::uint64_t done = 0;
  campaign::merge(shards, outputs, [&](const std::vector<double>& rows) {
    summary.add(rows);
    done += rows.size() / shards.description.columns.size();
    bar.show(done, shards.description.items);
  });
  print(text(summary));
}

}  // namespace

void run_merge(const MergeOptions& options) {
  const campaign::Outputs files = files_of(options, options.files);
  if (!files.table.empty()) {
    campaign::expect_new(files.table, options.force);
  }
  const campaign::ShardFiles shards =
      campaign::shard_files({options.files.begin(), options.files.end()});
  const bool as_json = options.format == "json";
  const std::string kind = shards.description.text_of("assur");
  if (kind == "sample") {
    merge_and_report<campaign::SampleSummary>(
        shards, files, campaign::histogram_picture,
        as_json ? campaign::sample_json : campaign::sample_text);
  } else if (kind == "map") {
    if (!files.picture.empty()) {
      campaign::expect_drawable(shards.description, files.picture.string());
    }
    merge_and_report<campaign::GridSummary>(shards, files, campaign::grid_picture,
                                            as_json ? campaign::grid_json : campaign::grid_text);
  } else {
    throw text::InputError(options.files.front() + ": it is a table of '" + kind +
                           "', which is neither a sample nor a map");
  }
}

}  // namespace assur::generator::command
