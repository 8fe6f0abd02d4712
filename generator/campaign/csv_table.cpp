#include "campaign/csv_table.hpp"

#include <algorithm>
#include <assur/text/error.hpp>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <string_view>

#include "campaign/short_number.hpp"

namespace assur::generator::campaign {

namespace {

using mechanism::Column;

/// No cell is wider: numbers take at most 24 characters.
constexpr std::size_t widest_cell = 32;
static_assert(std::ranges::all_of(mechanism::outcome_words,
                                  [](std::string_view word) { return word.size() < widest_cell; }));

/// Writes a cell into a buffer with room for the widest one, and returns its end.
char* put_cell(Column::Kind kind, double number, char* at) {
  switch (kind) {
    case Column::Kind::whole:
      return std::to_chars(at, at + widest_cell, static_cast<std::int64_t>(number)).ptr;
    case Column::Kind::outcome:
      return std::ranges::copy(mechanism::outcome_words[static_cast<std::size_t>(number)], at).out;
    case Column::Kind::real:
      break;
  }
  return std::isfinite(number) ? put_shortest(number + 0.0, at) : at;
}

class CsvWriter : public TableWriter {
 public:
  CsvWriter(PartialFile& file, const Description& description) : file_(file) {
    std::string head;
    for (const auto& [name, text] : description.written()) {
      head += "# " + name + ": " + text + "\n";
    }
    file_.write(head + csv_head(description.columns) + "\n");
  }

  void add(const std::vector<double>& /*rows*/, const std::string& text) override {
    file_.write(text);
  }
  [[nodiscard]] bool wants_text() const override { return true; }
  void finish() override { file_.flush(); }

 private:
  PartialFile& file_;
};

class CsvReader : public TableReader {
 public:
  explicit CsvReader(const std::filesystem::path& file)
      : name_(file.string()), in_(file, std::ios::binary) {
    if (!in_) {
      throw text::InputError(name_ + ": cannot be read (does it exist, and is it a file?)");
    }
    std::vector<std::pair<std::string, std::string>> written;
    while (next_line() && line_.starts_with("# ")) {
      const std::size_t colon = line_.find(": ");
      if (colon == std::string::npos) {
        refuse("expected a line '# name: text' of the description; remove it");
      }
      written.emplace_back(line_.substr(2, colon - 2), line_.substr(colon + 2));
    }
    description_ = Description::read(written, name_);
    if (!take_names(line_, description_.columns)) {
      refuse("expected a name for each column; compute the table again");
    }
    head_ = number_;
  }

  [[nodiscard]] std::string place_of(std::uint64_t row) const override {
    return name_ + ":" + std::to_string(head_ + row);
  }

  [[nodiscard]] bool next(std::vector<double>& rows) override {
    constexpr std::size_t most_rows = 4096;
    rows.clear();
    for (std::size_t row = 0; row < most_rows && next_line(); ++row) {
      add_row(rows);
    }
    return !rows.empty();
  }

 private:
  /// Reads the next line. Throws for a last line without a line end, which is incomplete, and for
  /// bytes that would end messages.
  bool next_line() {
    if (!std::getline(in_, line_)) {
      return false;
    }
    ++number_;
    if (in_.eof()) {
      refuse("it ends within a line; compute it again");
    }
    if (line_.find('\0') != std::string::npos) {
      refuse("the line holds a NUL byte; compute the table again");
    }
    return true;
  }

  void add_row(std::vector<double>& rows) const {
    const char* at = line_.data();
    const char* const end = at + line_.size();
    for (std::size_t column = 0; column < description_.columns.size(); ++column) {
      if (column > 0) {
        if (at == end || *at != ',') {
          refuse("it has fewer cells than there are columns");
        }
        ++at;
      }
      const char* const stop = std::find(at, end, ',');
      rows.push_back(
          number_in({at, static_cast<std::size_t>(stop - at)}, description_.columns[column].kind));
      at = stop;
    }
    if (at != end) {
      refuse("it has more cells than there are columns");
    }
  }

  [[nodiscard]] double number_in(std::string_view cell, Column::Kind kind) const {
    if (kind == Column::Kind::outcome) {
      const auto* const word = std::ranges::find(mechanism::outcome_words, cell);
      if (word == mechanism::outcome_words.end()) {
        refuse("'" + std::string(cell) + "' is not an outcome");
      }
      return static_cast<double>(word - mechanism::outcome_words.begin());
    }
    if (cell.empty() && kind == Column::Kind::real) {
      return std::numeric_limits<double>::quiet_NaN();
    }
    double number = 0;
    const auto [at, error] = std::from_chars(cell.data(), cell.data() + cell.size(), number);
    if (error != std::errc() || at != cell.data() + cell.size() || !std::isfinite(number)) {
      refuse("'" + std::string(cell) + "' is not a number");
    }
    return number;
  }

  [[noreturn]] void refuse(const std::string& what) const {
    throw text::InputError(name_ + ":" + std::to_string(number_) + ": " + what);
  }

  std::string name_;
  std::ifstream in_;
  std::string line_;
  std::size_t number_ = 0, head_ = 0;  ///< numbers of the current line and of the line of names
};

}  // namespace

std::string csv_head(const std::vector<Column>& columns) {
  std::string head;
  for (const Column& column : columns) {
    std::string cell;
    for (const char letter : column.name) {
      cell += static_cast<unsigned char>(letter) < 0x20 ? "?"
              : letter == '"'                           ? "\"\""
                                                        : std::string(1, letter);
    }
    const bool is_plain = cell.find_first_of(",\"#") == std::string::npos;
    head += (head.empty() ? "" : ",") + (is_plain ? cell : "\"" + cell + "\"");
  }
  return head;
}

std::vector<std::string> names_in_csv_head(const std::string& line) {
  std::vector<std::string> names = {""};
  bool quoted = false;
  for (std::size_t at = 0; at < line.size(); ++at) {
    if (line[at] == '"' && quoted && at + 1 < line.size() && line[at + 1] == '"') {
      names.back() += line[++at];
    } else if (line[at] == '"') {
      quoted = !quoted;
    } else if (line[at] == ',' && !quoted) {
      names.emplace_back();
    } else {
      names.back() += line[at];
    }
  }
  return names;
}

bool take_names(const std::string& line, std::vector<Column>& columns) {
  const std::vector<std::string> names = names_in_csv_head(line);
  if (names.size() != columns.size()) {
    return false;
  }
  for (std::size_t column = 0; column < names.size(); ++column) {
    columns[column].name = names[column];
  }
  return csv_head(columns) == line;
}

std::string csv_lines(const std::vector<Column>& columns, const std::vector<double>& rows) {
  std::string text(rows.size() * (widest_cell + 1), '\0');
  char* at = text.data();
  for (auto row = rows.begin(); row != rows.end();) {
    for (const Column& column : columns) {
      at = put_cell(column.kind, *row++, at);
      *at++ = ',';
    }
    at[-1] = '\n';
  }
  text.resize(static_cast<std::size_t>(at - text.data()));
  return text;
}

std::unique_ptr<TableWriter> csv_writer(PartialFile& file, const Description& description) {
  return std::make_unique<CsvWriter>(file, description);
}

std::unique_ptr<TableReader> csv_reader(const std::filesystem::path& file) {
  return std::make_unique<CsvReader>(file);
}

}  // namespace assur::generator::campaign
