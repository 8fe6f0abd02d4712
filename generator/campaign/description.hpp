// The description of a campaign's table: named texts that can be compared, and its axes.
#pragma once

#include <assur/mechanism/campaign_columns.hpp>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace assur::generator::campaign {

/// One of equal parts of a campaign's items, numbered from 1.
struct Shard {
  std::uint64_t number = 1, count = 1;

  [[nodiscard]] bool is_whole() const { return count == 1; }
  /// `3/8`.
  [[nodiscard]] std::string text() const;
};

/// Reads `i/n`, with 1 <= i <= n <= 1e6; throws InputError with the option's name.
[[nodiscard]] Shard shard_of(const std::string& text, const std::string& option);

/// Describes a campaign's table by a hash of the scene's text, the options on which its rows
/// depend, and what a summary needs besides the rows. Files are parts of one table if their
/// descriptions are equal except for the shard.
struct Description {
  std::vector<std::pair<std::string, std::string>> entries;  ///< no text contains a line end
  std::vector<mechanism::Column> columns;
  std::uint64_t items = 0;
  Shard shard;

  void add(const std::string& name, const std::string& text);
  void add(const std::string& name, const std::vector<double>& numbers);
  /// The text of a name; empty if there is none.
  [[nodiscard]] std::string text_of(const std::string& name) const;
  /// The numbers of a name; NaN for `-`.
  [[nodiscard]] std::vector<double> numbers_of(const std::string& name) const;
  /// Whether the first columns have these kinds, and all others real numbers.
  [[nodiscard]] bool has_kinds(std::vector<mechanism::Column::Kind> first) const;
  /// The texts of a name that may occur several times.
  [[nodiscard]] std::vector<std::string> texts_of(const std::string& name) const;

  /// The description as named texts, and the description with given texts. `where` is the file, for
  /// messages; throws InputError, also for texts that `written` would not produce.
  [[nodiscard]] std::vector<std::pair<std::string, std::string>> written() const;
  [[nodiscard]] static Description read(
      const std::vector<std::pair<std::string, std::string>>& written, const std::string& where);
};

/// The first difference between two descriptions, except for their shards: `seed: 2 instead of 1`;
/// empty if they describe one table.
[[nodiscard]] std::string difference(const Description& one, const Description& other);

/// A number with the fewest digits that identify it; `-` if it is not finite.
[[nodiscard]] std::string number_text(double number);

/// The 64-bit FNV-1a hash in hexadecimal digits.
[[nodiscard]] std::string hash_of(const std::string& text);

/// An axis of the grid with its name.
struct NamedAxis {
  std::string name;
  double from, to;
  std::uint64_t count;
};

/// The entry of an axis in a description.
[[nodiscard]] std::string axis_text(const NamedAxis& axis);

/// The axes of a map, in order; empty for the table of a sample.
[[nodiscard]] std::vector<NamedAxis> axes_of(const Description& description);

}  // namespace assur::generator::campaign
