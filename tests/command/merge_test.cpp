// Law: `assur merge` accepts exactly the rows that each shard should hold, in their order, and
// refuses every other file in one line that names the file and the row.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <vector>

#include "command/one_line.hpp"

namespace assur::test::merge_test {
namespace {

using Lines = std::vector<std::string>;

const std::string four_bar = ASSUR_EXAMPLES "/four_bar_coupler_curve.json";

Lines lines_of(const std::string& text) {
  Lines lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    lines.push_back(line);
  }
  return lines;
}

std::string text_of(const Lines& lines) {
  std::string text;
  for (const std::string& line : lines) {
    text += line + "\n";
  }
  return text;
}

/// The line with another text in one of its cells.
std::string with_cell(const std::string& line, std::size_t cell, const std::string& text) {
  std::size_t from = 0;
  for (; cell > 0; --cell) {
    from = line.find(',', from) + 1;
  }
  return line.substr(0, from) + text + line.substr(std::min(line.find(',', from), line.size()));
}

struct Campaign {
  const char* name;
  std::string call;
  std::string other_call;
  std::vector<std::size_t> determined;  ///< the cells of a row that follow from its number
};

/// The shards of a campaign, of which the second one is edited.
class Merge : public testing::TestWithParam<Campaign> {
 protected:
  void SetUp() override {
    for (const std::string shard : {"1", "2", "3"}) {
      ASSERT_EQ(compute(GetParam().call, shard + ".csv", shard + "/3"), 0);
    }
    shard_ = lines_of(read("2.csv"));
    while (shard_[head_].starts_with("# ")) {
      ++head_;
    }
    ++head_;  // the line of names
  }

  [[nodiscard]] std::string path(const std::string& name) const {
    return (directory_.path() / name).string();
  }
  [[nodiscard]] std::string read(const std::string& name) const { return read_file(path(name)); }
  [[nodiscard]] int compute(const std::string& call, const std::string& file,
                            const std::string& shard) const {
    return run_assur(call + " --output " + path(file) + " --shard " + shard).status;
  }
  [[nodiscard]] CommandResult merged(const std::string& second) const {
    return run_assur("merge " + path("1.csv") + " " + path(second) + " " + path("3.csv") +
                     " --force --output " + path("merged.csv"));
  }
  void expect_refusal(const std::string& text, const std::string& message) const {
    (void)directory_.write("edited.csv", text);
    SCOPED_TRACE(text);
    expect_one_line(merged("edited.csv"), message);
    EXPECT_FALSE(std::filesystem::exists(path("merged.csv")));
  }
  /// `edited.csv:LINE: `, for a row from 0.
  [[nodiscard]] std::string at(std::size_t row) const {
    return path("edited.csv") + ":" + std::to_string(row + 1) + ": ";
  }

  TemporaryDirectory directory_;
  Lines shard_;
  std::size_t head_ = 0;  ///< the number of lines before the rows
};

TEST_P(Merge, TakesWhatTheShardsHold) {
  EXPECT_EQ(merged("2.csv").status, 0);
  ASSERT_EQ(compute(GetParam().call, "whole.csv", "1/1"), 0);
  EXPECT_EQ(read("merged.csv"), read("whole.csv"));
}

TEST_P(Merge, RefusesRowsThatAreDoubledMissingOrSwapped) {
  for (std::size_t row = head_; row < shard_.size(); ++row) {
    const auto place = static_cast<std::ptrdiff_t>(row);
    const bool is_last = row + 1 == shard_.size();
    Lines doubled = shard_;
    doubled.insert(doubled.begin() + place, shard_[row]);
    expect_refusal(text_of(doubled), at(row + 1));
    Lines dropped = shard_;
    dropped.erase(dropped.begin() + place);
    expect_refusal(text_of(dropped),
                   is_last ? path("edited.csv") + ": the table is incomplete" : at(row));
    if (!is_last) {
      Lines swapped = shard_;
      std::swap(swapped[row], swapped[row + 1]);
      expect_refusal(text_of(swapped), at(row));
    }
  }
}

TEST_P(Merge, RefusesRowsThatAreEdited) {
  for (std::size_t row = head_; row < shard_.size(); row += 2) {
    const std::string& line = shard_[row];
    Lines edits = {line.substr(0, line.find(',')),
                   line + ",0",
                   "",
                   with_cell(line, 0, ""),
                   line + std::string(1, '\0'),
                   std::string(line).insert(3, 1, '\0'),
                   line + "\r"};
    for (const std::size_t cell : GetParam().determined) {
      for (const char* number : {"9", "0.5", "nan"}) {
        edits.push_back(with_cell(line, cell, number));
      }
    }
    for (const std::string& edit : edits) {
      Lines edited = shard_;
      edited[row] = edit;
      if (edit != line) {
        // The first row of a cell says how many follow, so that the next one may be the wrong one.
        expect_refusal(text_of(edited), path("edited.csv") + ":");
      }
    }
  }
  const std::string text = text_of(shard_);
  expect_refusal(text.substr(0, text.size() - 1), "it ends within a line");
  expect_refusal(text.substr(0, text.size() - 4), "it ends within a line");
}

TEST_P(Merge, RefusesDescriptionsThatAreEdited) {
  for (std::size_t row = 0; row < head_; ++row) {
    const auto place = static_cast<std::ptrdiff_t>(row);
    Lines doubled = shard_;
    doubled.insert(doubled.begin() + place, shard_[row]);
    Lines dropped = shard_;
    dropped.erase(dropped.begin() + place);
    Lines longer = shard_;
    longer[row] += std::string("\0x", 2);
    Lines other = shard_;
    other[row] += "9";
    for (const Lines& edited : {doubled, dropped, longer, other}) {
      expect_refusal(text_of(edited), path("edited.csv") + ":");
    }
  }
  Lines remark = shard_;
  remark.insert(remark.begin() + 1, "# a remark");
  expect_refusal(text_of(remark), at(1));
}

TEST_P(Merge, RefusesOtherShards) {
  const Lines third = lines_of(read("3.csv"));
  expect_refusal(text_of(shard_) + read("3.csv"), at(shard_.size()));
  expect_refusal(
      text_of(shard_) + text_of({third.begin() + static_cast<std::ptrdiff_t>(head_), third.end()}),
      at(shard_.size()) + "the row comes after the last one of the shard");
  Lines renamed = third;
  std::ranges::replace(renamed, "# shard: 3/3", "# shard: 2/3");
  expect_refusal(text_of(renamed), at(head_));
  const std::string& call = GetParam().call;
  const std::string scene = read_file(four_bar);
  (void)directory_.write("scene.json", scene + "\n");
  const Lines others = {
      call + " --set rocker=101",
      std::string(call).replace(call.find(four_bar), four_bar.size(), path("scene.json")),
      GetParam().other_call};
  for (const std::string& other : others) {
    ASSERT_EQ(compute(other, "edited.csv", "2/3 --force"), 0) << other;
    expect_refusal(read("edited.csv"), "it is not a part of the same campaign as ");
  }
}

INSTANTIATE_TEST_SUITE_P(
    Of, Merge,
    testing::Values(Campaign{"Samples",
                             "sample " + four_bar + " --seed 1 --count 17",
                             "sample " + four_bar + " --seed 2 --count 17",
                             {0}},
                    Campaign{"Maps",
                             "map " + four_bar + " --over 'phi=0.1:3:2,ground=20:280:7'",
                             "map " + four_bar + " --over 'phi=0.1:3:2,ground=20:280:8'",
                             {0, 1, 2, 3, 5}}),
    [](const auto& campaign) { return std::string(campaign.param.name); });

}  // namespace
}  // namespace assur::test::merge_test
