// Indices with a type for each table, and tables that accept only their own type of index.
#pragma once

#include <compare>
#include <cstddef>
#include <utility>
#include <vector>

namespace assur::text {

/// An index into a table of `Tag`s; by default none.
template <typename Tag>
class Index {
 public:
  constexpr Index() = default;
  constexpr explicit Index(std::size_t place) : value_(static_cast<int>(place)) {}

  /// Whether it is an index, not none.
  [[nodiscard]] constexpr bool exists() const { return value_ >= 0; }
  /// The index, from 0; requires exists().
  [[nodiscard]] constexpr std::size_t place() const { return static_cast<std::size_t>(value_); }
  /// The index as the row or column of a matrix.
  [[nodiscard]] constexpr std::ptrdiff_t row() const { return value_; }

  // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 takes the zero of orderings for a pointer
  friend constexpr auto operator<=>(const Index&, const Index&) = default;

 private:
  int value_ = -1;
};

/// The keys of a table, in order.
template <typename Key>
class KeyRange {
 public:
  class Iterator {
   public:
    explicit Iterator(std::size_t place) : place_(place) {}
    Key operator*() const { return Key(place_); }
    Iterator& operator++() {
      ++place_;
      return *this;
    }
    bool operator!=(const Iterator& other) const { return place_ != other.place_; }

   private:
    std::size_t place_;
  };

  explicit KeyRange(std::size_t count) : count_(count) {}
  [[nodiscard]] Iterator begin() const { return Iterator(0); }
  [[nodiscard]] Iterator end() const { return Iterator(count_); }

 private:
  std::size_t count_;
};

/// A vector that is accessed only by its own type of index.
template <typename Key, typename Item>
class Table {
 public:
  Table() = default;
  explicit Table(std::size_t count, const Item& item = Item()) : items_(count, item) {}
  explicit Table(std::vector<Item> items) : items_(std::move(items)) {}

  /// Adds an item; returns its index.
  Key add(Item item) {
    items_.push_back(std::move(item));
    return Key(items_.size() - 1);
  }
  [[nodiscard]] decltype(auto) operator[](Key key) { return items_[key.place()]; }
  [[nodiscard]] decltype(auto) operator[](Key key) const { return items_[key.place()]; }

  [[nodiscard]] std::size_t size() const { return items_.size(); }
  [[nodiscard]] bool empty() const { return items_.empty(); }
  [[nodiscard]] KeyRange<Key> keys() const { return KeyRange<Key>(items_.size()); }
  void assign(std::size_t count, const Item& item) { items_.assign(count, item); }
  void resize(std::size_t count) { items_.resize(count); }
  void reserve(std::size_t count) { items_.reserve(count); }

  [[nodiscard]] auto begin() { return items_.begin(); }
  [[nodiscard]] auto end() { return items_.end(); }
  [[nodiscard]] auto begin() const { return items_.begin(); }
  [[nodiscard]] auto end() const { return items_.end(); }
  [[nodiscard]] const std::vector<Item>& items() const { return items_; }

  /// Compares tables by their items, as vectors are compared.
  // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 takes the zero of orderings for a pointer
  friend auto operator<=>(const Table&, const Table&) = default;

 private:
  std::vector<Item> items_;
};

/// The index of the first item with a name; none if there is no such item.
template <typename Key, typename Item>
[[nodiscard]] Key index_of(const Table<Key, Item>& table, const auto& name) {
  for (const Key key : table.keys()) {
    if (table[key].name == name) {
      return key;
    }
  }
  return Key();
}

/// The names of all items.
template <typename Key, typename Item>
[[nodiscard]] auto names_of(const Table<Key, Item>& table) {
  std::vector<decltype(Item::name)> names;
  names.reserve(table.size());
  for (const Item& item : table) {
    names.push_back(item.name);
  }
  return names;
}

}  // namespace assur::text
