// Joint forces of an emitted solver from the equilibrium of all links together, for redundant
// constraints and singular configurations, where they do not follow group by group.
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

/// The equilibrium A x + w = 0 of the moving links: three rows for each, the force and, divided by
/// a length, the moment about its pivot. Each unknown x is the reaction of one held coordinate of
/// two features: a bearing force or a driver's effort; couples are divided by the length. `Passed`
/// is the number of readings of joints by laws of drivers, `Springs` the number of springs whose
/// force may be undetermined.
template <int Links, int Unknowns, int Passed, int Springs, typename Scalar>
class Equilibrium {
  static constexpr int rows = 3 * Links;
  static constexpr int columns = Unknowns + 2 * Springs;
  /// Directions that A shortens to less than this fraction of its largest pivot count as null.
  static constexpr Scalar least = std::is_same_v<Scalar, float> ? Scalar(1e-3) : Scalar(1e-9);
  /// The rounding error in null directions: an unknown with a smaller component does not take part
  /// in a null direction, and loads with a smaller residual are balanced.
  static constexpr Scalar response = std::numeric_limits<Scalar>::epsilon() / least;

  /// A force and a couple on one link, and their opposites on another. The ground is link -1.
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
  /// Adds an unknown for each held coordinate (x, y, theta) of the second feature in the frame of
  /// the first; it acts on the second feature's link.
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
  /// A driver also acts at a joint that its law reads, in proportion to the law's derivative.
  void pass_on(int unknown, int first, int second, const Pose<Scalar>& one,
               const Pose<Scalar>& other, int coordinate, const Scalar& slope) {
    passed_[static_cast<std::size_t>(passed_count_++)] = {
        unknown, along(first, second, one, other, coordinate, -slope)};
  }
  /// A spring pulls the first of two links at a point toward the second. An undetermined pull adds
  /// two unknowns.
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

  /// Finds the unknowns. Undetermined ones, which have a component in a null direction of A, become
  /// NaN. Directions that A moves by less than `tolerance`, a length, count as null.
  ///
  /// The equations of links with unknown loads are left out. If the loads cannot be balanced,
  /// forces along the null directions of A grow without bound near this configuration and depend on
  /// the path to it: then the equations of the links on which these forces act are left out, too.
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

  /// The effort of a driver, by its unknown.
  [[nodiscard]] Scalar effort(int unknown) const {
    const Reaction& unit = units_[static_cast<std::size_t>(unknown)];
    return found_[static_cast<std::size_t>(unknown)] * (unit.couple > 0 ? size_ : Scalar(1));
  }
  /// The couple of a bearing.
  [[nodiscard]] Scalar couple(int unknown) const { return effort(unknown); }
  /// The force of bearings on the second link, by the index of their first unknown and their
  /// number. If one component is unknown, both are NaN.
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
  /// The reaction of the given size along a coordinate of two features.
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
  /// Finds the longest distance of a held feature from its link's pivot.
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
  /// Force and moment on a link, as in its rows of the equilibrium.
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
  /// Leaves out the links on which undetermined unknowns act. Returns whether there are more of
  /// them than before.
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
  /// Fills in A and w, without the rows that are left out.
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
  /// Whether the residual of the rows without a pivot is small: then the loads can be balanced.
  [[nodiscard]] static bool leaves_at_most(const Scalar& most, const Table& table,
                                           const Pivots& pivots) {
    for (int row = 0; row < rows; ++row) {
      if (pivots.column_of(row) < 0 && std::abs(table(row, columns)) > most) {
        return false;
      }
    }
    return true;
  }
  /// Finds the unknowns with a component in a null direction of A.
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
