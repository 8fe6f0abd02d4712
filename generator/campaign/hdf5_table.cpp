#include "campaign/hdf5_table.hpp"

#include <hdf5.h>

#include <algorithm>
#include <assur/text/error.hpp>
#include <cerrno>
#include <set>
#include <sstream>
#include <utility>

#include "campaign/csv_table.hpp"

namespace assur::generator::campaign {

namespace {

using mechanism::Column;

/// The number of rows that are written at once, whatever the sizes of the blocks: the bytes of the
/// file depend on the order of writing.
constexpr hsize_t rows_at_once = 16384;

/// An identifier of the HDF5 library, closed by the destructor.
class Handle {
 public:
  Handle(hid_t id, herr_t (*closing)(hid_t)) : id_(id), closing_(closing) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), closing_(other.closing_) {}
  Handle& operator=(Handle&&) = delete;
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() { (void)close(); }

  operator hid_t() const { return id_; }  // it stands for the identifier
  herr_t close() { return id_ >= 0 ? closing_(std::exchange(id_, -1)) : 0; }
  /// Leaves the identifier open.
  void abandon() { id_ = -1; }

 private:
  hid_t id_;
  herr_t (*closing_)(hid_t);
};

/// Otherwise the library prints its errors, and at program exit tries again to write what it could
/// not write, until it crashes.
void be_quiet() {
  (void)H5dont_atexit();
  (void)H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

/// Partial files are locked already, and the library's own lock would conflict.
Handle access() {
  Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
#if H5_VERSION_GE(1, 10, 7)
  (void)H5Pset_file_locking(access, false, true);
#endif
  return access;
}

Handle type_of(Column::Kind kind) {
  if (kind != Column::Kind::outcome) {
    return {H5Tcopy(kind == Column::Kind::whole ? H5T_STD_I64LE : H5T_IEEE_F64LE), H5Tclose};
  }
  Handle type(H5Tenum_create(H5T_STD_U8LE), H5Tclose);
  for (std::size_t outcome = 0; outcome < mechanism::outcome_words.size(); ++outcome) {
    const auto word = static_cast<std::uint8_t>(outcome);
    (void)H5Tenum_insert(type, std::string(mechanism::outcome_words[outcome]).c_str(), &word);
  }
  return type;
}

/// The names of the columns, made unique and without slashes, which would create groups.
std::vector<std::string> data_set_names(const std::vector<Column>& columns) {
  std::vector<std::string> names;
  std::set<std::string> taken;
  for (std::string name : names_in_csv_head(csv_head(columns))) {
    std::ranges::replace(name, '/', '_');
    while (!taken.insert(name).second) {
      name += '_';
    }
    names.push_back(name);
  }
  return names;
}

std::string lines_of(const Description& description) {
  std::string lines;
  for (const auto& [name, text] : description.written()) {
    lines += name + ": " + text + "\n";
  }
  return lines + csv_head(description.columns) + "\n";
}

class Hdf5Writer : public TableWriter {
 public:
  Hdf5Writer(PartialFile& file, const Description& description)
      : partial_(file), columns_(description.columns), held_(columns_.size()), file_(created()) {
    const std::string lines = lines_of(description);
    const Handle text(H5Tcopy(H5T_C_S1), H5Tclose);
    (void)H5Tset_size(text, lines.size());
    const Handle one(H5Screate(H5S_SCALAR), H5Sclose);
    Handle attribute(H5Acreate2(file_, "description", text, one, H5P_DEFAULT, H5P_DEFAULT),
                     H5Aclose);
    expect(H5Awrite(attribute, text, lines.data()));
    const std::vector<std::string> names = data_set_names(columns_);
    for (std::size_t column = 0; column < columns_.size(); ++column) {
      sets_.push_back(data_set(names[column], columns_[column].kind));
    }
  }

  [[nodiscard]] bool wants_text() const override { return false; }

  void add(const std::vector<double>& rows, const std::string& /*text*/) override {
    for (std::size_t at = 0; at < rows.size(); at += columns_.size()) {
      for (std::size_t column = 0; column < columns_.size(); ++column) {
        held_[column].push_back(rows[at + column]);
      }
      if (held_[0].size() == rows_at_once) {
        write_held();
      }
    }
  }

  void finish() override {
    write_held();
    for (Handle& set : sets_) {
      expect(set.close());
    }
    expect(H5Fflush(file_, H5F_SCOPE_GLOBAL));
    expect(file_.close());
    partial_.flush();
  }

 private:
  /// After an error abandons all identifiers, since closing them would try to write again.
  void expect(hid_t result) {
    if (result < 0) {
      const int reason = errno == 0 ? EIO : errno;
      for (Handle& set : sets_) {
        set.abandon();
      }
      file_.abandon();
      partial_.fail(reason);
    }
  }

  [[nodiscard]] Handle created() const {
    be_quiet();
    const Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
    (void)H5Pset_obj_track_times(creation, false);
    Handle file(H5Fcreate(partial_.path().c_str(), H5F_ACC_TRUNC, creation, access()), H5Fclose);
    if (file < 0) {
      partial_.fail(errno == 0 ? EIO : errno);
    }
    return file;
  }

  Handle data_set(const std::string& name, Column::Kind kind) {
    const hsize_t length = 0;
    const hsize_t longest = H5S_UNLIMITED;
    const Handle space(H5Screate_simple(1, &length, &longest), H5Sclose);
    const Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    (void)H5Pset_chunk(creation, 1, &rows_at_once);
    (void)H5Pset_obj_track_times(creation, false);
    const Handle type = type_of(kind);
    Handle set(H5Dcreate2(file_, name.c_str(), type, space, H5P_DEFAULT, creation, H5P_DEFAULT),
               H5Dclose);
    expect(set);
    return set;
  }

  void write_held() {
    const hsize_t count = held_[0].size();
    const hsize_t length = written_ + count;
    for (std::size_t column = 0; column < columns_.size() && count > 0; ++column) {
      expect(H5Dset_extent(sets_[column], &length));
      const Handle space(H5Dget_space(sets_[column]), H5Sclose);
      (void)H5Sselect_hyperslab(space, H5S_SELECT_SET, &written_, nullptr, &count, nullptr);
      const Handle memory(H5Screate_simple(1, &count, nullptr), H5Sclose);
      if (columns_[column].kind == Column::Kind::outcome) {  // the library cannot convert outcomes
        const std::vector<std::uint8_t> words(held_[column].begin(), held_[column].end());
        const Handle type = type_of(Column::Kind::outcome);
        expect(H5Dwrite(sets_[column], type, memory, space, H5P_DEFAULT, words.data()));
      } else {
        expect(H5Dwrite(sets_[column], H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT,
                        held_[column].data()));
      }
      held_[column].clear();
    }
    written_ = length;
  }

  PartialFile& partial_;
  std::vector<Column> columns_;
  std::vector<std::vector<double>> held_;  ///< rows not yet written, by columns
  hsize_t written_ = 0;
  Handle file_;
  std::vector<Handle> sets_;
};

class Hdf5Reader : public TableReader {
 public:
  explicit Hdf5Reader(const std::filesystem::path& file) : name_(file.string()), file_(open()) {
    read_description();
    for (const std::string& name : data_set_names(description_.columns)) {
      sets_.emplace_back(H5Dopen2(file_, name.c_str(), H5P_DEFAULT), H5Dclose);
      const Handle space(expected(H5Dget_space(sets_.back())), H5Sclose);
      hsize_t length = 0;
      if (H5Sget_simple_extent_ndims(space) != 1 ||
          H5Sget_simple_extent_dims(space, &length, nullptr) < 0 ||
          (sets_.size() > 1 && length != length_)) {
        refuse();
      }
      length_ = length;
    }
  }

  [[nodiscard]] std::string place_of(std::uint64_t row) const override {
    return name_ + ": row " + std::to_string(row);
  }

  [[nodiscard]] bool next(std::vector<double>& rows) override {
    const std::size_t columns = sets_.size();
    const hsize_t count = std::min(rows_at_once, length_ - read_);
    rows.resize(count * columns);
    std::vector<double> numbers(count);
    std::vector<std::uint8_t> words(count);
    const Handle memory(H5Screate_simple(1, &count, nullptr), H5Sclose);
    for (std::size_t column = 0; column < columns && count > 0; ++column) {
      const Handle space(H5Dget_space(sets_[column]), H5Sclose);
      (void)H5Sselect_hyperslab(space, H5S_SELECT_SET, &read_, nullptr, &count, nullptr);
      if (description_.columns[column].kind == Column::Kind::outcome) {
        const Handle type = type_of(Column::Kind::outcome);
        (void)expected(H5Dread(sets_[column], type, memory, space, H5P_DEFAULT, words.data()));
        if (std::ranges::any_of(
                words, [](std::uint8_t word) { return word >= mechanism::outcome_words.size(); })) {
          refuse();
        }
        numbers.assign(words.begin(), words.end());
      } else {
        (void)expected(
            H5Dread(sets_[column], H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, numbers.data()));
      }
      for (hsize_t row = 0; row < count; ++row) {
        rows[row * columns + column] = numbers[row];
      }
    }
    read_ += count;
    return count > 0;
  }

 private:
  [[noreturn]] void refuse() const {
    throw text::InputError(name_ +
                           ": it is not a complete table of a campaign in HDF5; compute it again");
  }
  [[nodiscard]] hid_t expected(hid_t result) const {
    if (result < 0) {
      refuse();
    }
    return result;
  }

  [[nodiscard]] Handle open() const {
    be_quiet();
    return {expected(H5Fopen(name_.c_str(), H5F_ACC_RDONLY, access())), H5Fclose};
  }

  void read_description() {
    const Handle attribute(expected(H5Aopen(file_, "description", H5P_DEFAULT)), H5Aclose);
    const Handle type(expected(H5Aget_type(attribute)), H5Tclose);
    if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) > 0) {
      refuse();
    }
    std::string lines(H5Tget_size(type), ' ');
    (void)expected(H5Aread(attribute, type, lines.data()));
    if (lines.find('\0') != std::string::npos) {
      refuse();
    }
    std::vector<std::pair<std::string, std::string>> written;
    std::istringstream in(lines);
    std::string line;
    while (std::getline(in, line) && !in.eof() &&
           (written.empty() || written.back().first != "columns")) {
      const std::size_t colon = line.find(": ");
      if (colon == std::string::npos) {
        refuse();
      }
      written.emplace_back(line.substr(0, colon), line.substr(colon + 2));
    }
    description_ = Description::read(written, name_);
    if (!take_names(line, description_.columns)) {
      refuse();
    }
  }

  std::string name_;
  Handle file_;
  std::vector<Handle> sets_;
  hsize_t length_ = 0, read_ = 0;
};

}  // namespace

TableWriter* assur_hdf5_writer(PartialFile* file, const Description* description) {
  return new Hdf5Writer(*file, *description);
}

TableReader* assur_hdf5_reader(const char* file) { return new Hdf5Reader(file); }

}  // namespace assur::generator::campaign
