// Turns what acts on all links of an emitted solver together into the forces in its joints, where
// these do not follow group by group: with redundant constraints, and at singular configurations.
#pragma once

#include <algorithm>
#include <array>
#include <assur/local/elimination.hpp>
#include <assur/model.hpp>
#include <assur/support/link_forces.hpp>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

namespace assur::support {

/// The equilibrium A x + w = 0 of links that move: three rows for each, the force and, divided by a
/// length, the moment about its pivot. An unknown x holds one coordinate of two features: it is the
/// force of a bearing, or a driver's effort; couples are in units of the length. `Passed` is the
/// number of times that a law of a driver reads a joint. Of `Springs` the pull may not be known.
template <int Links, int Unknowns, int Passed, int Springs, typename Scalar>
class Equilibrium {
  static constexpr int rows = 3 * Links;
  static constexpr int columns = Unknowns + 2 * Springs;
  /// Directions that A shortens to less than this part of its largest pivot count as null.
  static constexpr Scalar least = std::is_same_v<Scalar, float> ? Scalar(1e-3) : Scalar(1e-9);
  /// What is left of rounding there: an unknown that moves less along a null direction does not
  /// move, and loads of which less is left are balanced.
  static constexpr Scalar response = std::numeric_limits<Scalar>::epsilon() / least;

  /// A force and a couple on a link, and the opposite ones on another. The ground is link -1.
  struct Reaction {
    int on = -1, from = -1;
    Scalar at_x = 0, at_y = 0, x = 0, y = 0, couple = 0;
  };
  struct PassedOn {
    int unknown = 0;
    Reaction reaction;
  };
  using Table = local::Table<Scalar>;
  using Pivots = local::Pivots<rows, columns>;

 public:
  /// Two features, of which some coordinates (x, y, theta) of the second one in the frame of the
  /// first are held, each by the next unknown: it acts on the second one's link.
  void hold(int first, int second, const Pose<Scalar>& one, const Pose<Scalar>& other,
            const std::array<bool, 3>& holds) {
    set_pivot(first, other);
    set_pivot(second, other);
    for (int coordinate = 0; coordinate < 3; ++coordinate) {
      if (holds[static_cast<std::size_t>(coordinate)]) {
        units_[static_cast<std::size_t>(unknowns_++)] =
            along(first, second, one, other, coordinate, Scalar(1));
      }
    }
  }
  /// A driver acts at a joint that its law reads, too, by the law's derivative.
  void pass_on(int unknown, int first, int second, const Pose<Scalar>& one,
               const Pose<Scalar>& other, int coordinate, const Scalar& slope) {
    passed_[static_cast<std::size_t>(passed_count_++)] = {
        unknown, along(first, second, one, other, coordinate, -slope)};
  }
  /// A spring pulls the first of two links at a place toward the second. Where the pull is not
  /// known, it counts as two more unknowns.
  template <typename Place>
  void pull(int first, int second, const Place& at, const Vector<Scalar, 2>& pull) {
    if (std::isfinite(pull(0)) && std::isfinite(pull(1))) {
      return;
    }
    for (const int axis : {0, 1}) {
      units_[static_cast<std::size_t>(Unknowns + pulls_++)] = {
          first, second, at.x, at.y, Scalar(1 - axis), Scalar(axis), Scalar(0)};
    }
  }
  void load(int link, const LinkLoad<Scalar>& on) { loads_[static_cast<std::size_t>(link)] = on; }

  /// Finds the unknowns. Those that are not determined become NaN: those in which A has a null
  /// direction. Directions that A moves by less than `tolerance`, a length, count as null.
  ///
  /// The equations of links whose loads are not known are left out. Where nothing balances the
  /// loads, forces grow beyond bounds beside this configuration along the null directions of A, in
  /// a manner that depends on the way here: then the equations of the links on which these act are
  /// left out, too.
  void solve(const Scalar& tolerance) {
    find_size();
    leave_out_unknown_loads();
    local::Memory<Scalar, rows*(columns + 1)> memory;
    for (bool is_balanced = false; !is_balanced;) {
      Table table(memory, rows, columns + 1);
      fill(table);
      Pivots pivots;
      pivots.begin(rows, columns);
      const Scalar largest = largest_load(table);
      const Scalar first = local::eliminate_largest(table, columns, Scalar(0), pivots);
      const Scalar bound = first * (std::max)(least, tolerance / size_);
      while (local::eliminate_largest(table, columns, bound, pivots) > 0) {
      }
      find_movable(table, pivots);
      is_balanced = leaves_at_most(response * largest, table, pivots) || !leave_out_movable();
      for (int unknown = 0; unknown < Unknowns; ++unknown) {
        const int row = pivots.row_of(unknown);
        found_[static_cast<std::size_t>(unknown)] = movable_[static_cast<std::size_t>(unknown)]
                                                        ? std::numeric_limits<Scalar>::quiet_NaN()
                                                        : -table(row, columns);
      }
    }
  }

  /// What a driver exerts, by its unknown.
  [[nodiscard]] Scalar effort(int unknown) const {
    const Reaction& unit = units_[static_cast<std::size_t>(unknown)];
    return found_[static_cast<std::size_t>(unknown)] * (unit.couple > 0 ? size_ : Scalar(1));
  }
  /// The couple of a bearing.
  [[nodiscard]] Scalar couple(int unknown) const { return effort(unknown); }
  /// The force of bearings on the second link, by the first of their unknowns and their number. It
  /// is unknown as a whole.
  [[nodiscard]] Vector<Scalar, 2> force(int first, int count) const {
    Vector<Scalar, 2> sum{Scalar(0), Scalar(0)};
    for (int unknown = first; unknown < first + count; ++unknown) {
      const Scalar size = found_[static_cast<std::size_t>(unknown)];
      const Reaction& unit = units_[static_cast<std::size_t>(unknown)];
      sum(0) += std::isfinite(size) ? size * unit.x : size;
      sum(1) += std::isfinite(size) ? size * unit.y : size;
    }
    return sum;
  }

 private:
  void set_pivot(int link, const Pose<Scalar>& at) {
    if (link >= 0 && !has_pivot_[static_cast<std::size_t>(link)]) {
      has_pivot_[static_cast<std::size_t>(link)] = true;
      pivots_[static_cast<std::size_t>(link)] = at;
    }
  }
  /// A unit along a coordinate of two features, times a size.
  [[nodiscard]] static Reaction along(int first, int second, const Pose<Scalar>& one,
                                      const Pose<Scalar>& other, int coordinate,
                                      const Scalar& size) {
    const auto& [c, s] = one.direction;
    Reaction unit{second, first, other.x, other.y, Scalar(0), Scalar(0), Scalar(0)};
    unit.x = coordinate == 0 ? size * c : coordinate == 1 ? -size * s : Scalar(0);
    unit.y = coordinate == 0 ? size * s : coordinate == 1 ? size * c : Scalar(0);
    unit.couple = coordinate == 2 ? size : Scalar(0);
    return unit;
  }
  /// The longest distance of a link's pivot from where it is held.
  void find_size() {
    using std::sqrt;
    Scalar longest = 0;
    for (int unknown = 0; unknown < Unknowns; ++unknown) {
      const Reaction& unit = units_[static_cast<std::size_t>(unknown)];
      for (const int link : {unit.on, unit.from}) {
        if (link >= 0) {
          const auto& pivot = pivots_[static_cast<std::size_t>(link)];
          const Scalar x = unit.at_x - pivot.x;
          const Scalar y = unit.at_y - pivot.y;
          longest = (std::max)(longest, sqrt(x * x + y * y));
        }
      }
    }
    size_ = longest > 0 ? longest : Scalar(1);
  }
  /// Adds a reaction to a column, `unit` times.
  void add(const Reaction& reaction, const Scalar& unit, int column, Table& table) const {
    for (const int sense : {1, -1}) {
      const int link = sense > 0 ? reaction.on : reaction.from;
      if (link >= 0) {
        const auto& pivot = pivots_[static_cast<std::size_t>(link)];
        const Scalar moment = reaction.couple + (reaction.at_x - pivot.x) * reaction.y -
                              (reaction.at_y - pivot.y) * reaction.x;
        const Scalar size = Scalar(sense) * unit;
        table(3 * link, column) += size * reaction.x;
        table(3 * link + 1, column) += size * reaction.y;
        table(3 * link + 2, column) += size * moment / size_;
      }
    }
  }
  [[nodiscard]] Scalar unit_of(int unknown) const {
    return units_[static_cast<std::size_t>(unknown)].couple > 0 ? size_ : Scalar(1);
  }
  /// Force and moment of what acts on a link, as its rows have them.
  [[nodiscard]] std::array<Scalar, 3> load_of(int link) const {
    const LinkLoad<Scalar>& load = loads_[static_cast<std::size_t>(link)];
    return {load.x, load.y, load.moment_about(pivots_[static_cast<std::size_t>(link)]) / size_};
  }
  void leave_out_unknown_loads() {
    for (int link = 0; link < Links; ++link) {
      const std::array<Scalar, 3> parts = load_of(link);
      for (std::size_t part = 0; part < 3; ++part) {
        is_left_out_[static_cast<std::size_t>(3 * link) + part] = !std::isfinite(parts[part]);
      }
    }
  }
  /// Leaves out the links on which unknowns act that are not determined. Returns whether there are
  /// more of these than before.
  bool leave_out_movable() {
    bool are_more = false;
    const auto leave_out = [&](int unknown, const Reaction& reaction) {
      for (const int link : {reaction.on, reaction.from}) {
        for (int row = 3 * link; row >= 0 && row < 3 * link + 3; ++row) {
          bool& is_left_out = is_left_out_[static_cast<std::size_t>(row)];
          are_more = are_more || (movable_[static_cast<std::size_t>(unknown)] && !is_left_out);
          is_left_out = is_left_out || movable_[static_cast<std::size_t>(unknown)];
        }
      }
    };
    for (int unknown = 0; unknown < columns; ++unknown) {
      leave_out(unknown, units_[static_cast<std::size_t>(unknown)]);
    }
    for (const PassedOn& passed : passed_) {
      leave_out(passed.unknown, passed.reaction);
    }
    return are_more;
  }
  /// A and w, without the rows that are left out.
  void fill(Table& table) const {
    for (int unknown = 0; unknown < columns; ++unknown) {
      add(units_[static_cast<std::size_t>(unknown)], unit_of(unknown), unknown, table);
    }
    for (const PassedOn& passed : passed_) {
      add(passed.reaction, unit_of(passed.unknown), passed.unknown, table);
    }
    for (int row = 0; row < rows; ++row) {
      table(row, columns) = load_of(row / 3)[static_cast<std::size_t>(row % 3)];
      for (int column = 0; column <= columns && is_left_out_[static_cast<std::size_t>(row)];
           ++column) {
        table(row, column) = 0;
      }
    }
  }
  [[nodiscard]] static Scalar largest_load(const Table& table) {
    Scalar largest = 0;
    for (int row = 0; row < rows; ++row) {
      largest = (std::max)(largest, std::abs(table(row, columns)));
    }
    return largest;
  }
  /// Whether what the rows without a pivot leave of the loads is small: these can be balanced.
  [[nodiscard]] static bool leaves_at_most(const Scalar& most, const Table& table,
                                           const Pivots& pivots) {
    for (int row = 0; row < rows; ++row) {
      if (pivots.column_of(row) < 0 && std::abs(table(row, columns)) > most) {
        return false;
      }
    }
    return true;
  }
  /// The unknowns in which null directions of A have a part.
  void find_movable(const Table& table, const Pivots& pivots) {
    movable_.fill(false);
    for (int free = 0; free < columns; ++free) {
      if (pivots.row_of(free) >= 0) {
        continue;
      }
      movable_[static_cast<std::size_t>(free)] = true;
      Scalar square = 1;
      for (int row = 0; row < rows; ++row) {
        square += pivots.column_of(row) < 0 ? Scalar(0) : table(row, free) * table(row, free);
      }
      for (int row = 0; row < rows; ++row) {
        const int unknown = pivots.column_of(row);
        if (unknown >= 0 && table(row, free) * table(row, free) > response * response * square) {
          movable_[static_cast<std::size_t>(unknown)] = true;
        }
      }
    }
  }

  std::array<Reaction, static_cast<std::size_t>(columns)> units_;
  std::array<PassedOn, static_cast<std::size_t>(Passed)> passed_;
  std::array<LinkLoad<Scalar>, static_cast<std::size_t>(Links)> loads_;
  std::array<Pose<Scalar>, static_cast<std::size_t>(Links)> pivots_;
  std::array<bool, static_cast<std::size_t>(Links)> has_pivot_{};
  std::array<bool, static_cast<std::size_t>(columns)> movable_{};
  std::array<Scalar, static_cast<std::size_t>(Unknowns)> found_{};
  std::array<bool, static_cast<std::size_t>(rows)> is_left_out_{};
  Scalar size_ = 1;
  int unknowns_ = 0, passed_count_ = 0, pulls_ = 0;
};

}  // namespace assur::support
