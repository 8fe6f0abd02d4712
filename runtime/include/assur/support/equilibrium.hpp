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
#include <initializer_list>
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
  /// The rounding error of equations and unknowns where directions are shortened to `least`: loads
  /// with a smaller residual are balanced, and smaller changes do not count.
  static constexpr Scalar negligible = std::numeric_limits<Scalar>::epsilon() / least;

  /// A force and a couple on one link, and their opposites on another. The ground is link -1.
  struct Reaction {
    int on = -1, from = -1;
    Scalar at_x = 0, at_y = 0, x = 0, y = 0, couple = 0;
  };
  struct PassedOn {
    int unknown = 0;
    Reaction reaction;
  };

 public:
  /// The unknowns of a bearing force, as it acts on the second link (sense 1) or the first (-1).
  struct Bearings {
    int first = 0, count = 0, sense = 1;
  };

  Equilibrium() = default;
  Equilibrium(const Equilibrium&) = delete;
  Equilibrium& operator=(const Equilibrium&) = delete;

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

  /// Finds the unknowns, up to the null directions of A and to what unknown loads change.
  /// Directions that A moves by less than `tolerance`, a length, count as null.
  ///
  /// If the loads cannot be balanced, or could not for some values of the unknown ones, forces
  /// along the null directions of A grow without bound near this configuration and depend on the
  /// path to it: then the equations of the links on which these forces act are left out.
  void solve(const Scalar& tolerance) {
    find_size();
    const auto known = [this](int row) { return is_known(row) ? load_of(row) : Scalar(0); };
    while (!(is_balanced(known, tolerance) && are_unknown_balanced(tolerance)) &&
           leave_out_movable()) {
    }
    (void)is_balanced(known, tolerance);
  }

  /// The effort of a driver, by its unknown. Efforts, couples and forces are sums of unknowns; NaN
  /// if a null direction of A changes the sum.
  [[nodiscard]] Scalar effort(int unknown) const { return couple({unknown}); }
  /// The couple of bearings.
  [[nodiscard]] Scalar couple(std::initializer_list<int> unknowns) const {
    const auto sum = [&](const auto& size_of) {
      Scalar result = 0;
      for (const int unknown : unknowns) {
        result += size_of(unknown);
      }
      return Vector<Scalar, 2>{result, Scalar(0)};
    };
    return told(sum)(0) * unit_of(*unknowns.begin());
  }
  /// The sum of bearing forces, unknown as a whole.
  [[nodiscard]] Vector<Scalar, 2> force(std::initializer_list<Bearings> bearings) const {
    return told([&](const auto& size_of) {
      Vector<Scalar, 2> sum{Scalar(0), Scalar(0)};
      for (const Bearings& part : bearings) {
        for (int unknown = part.first; unknown < part.first + part.count; ++unknown) {
          const Reaction& unit = units_[static_cast<std::size_t>(unknown)];
          const Scalar size = Scalar(part.sense) * size_of(unknown);
          sum(0) += size * unit.x;
          sum(1) += size * unit.y;
        }
      }
      return sum;
    });
  }

 private:
  void set_pivot(int link, const Pose<Scalar>& at) {
    if (link >= 0 && !has_pivot_[static_cast<std::size_t>(link)]) {
      has_pivot_[static_cast<std::size_t>(link)] = true;
      places_[static_cast<std::size_t>(link)] = at;
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
          const auto& pivot = places_[static_cast<std::size_t>(link)];
          const Scalar x = unit.at_x - pivot.x;
          const Scalar y = unit.at_y - pivot.y;
          longest = (std::max)(longest, sqrt(x * x + y * y));
        }
      }
    }
    size_ = longest > 0 ? longest : Scalar(1);
  }
  /// Adds a reaction to a column, `unit` times.
  void add(const Reaction& reaction, const Scalar& unit, int column) {
    for (const int sense : {1, -1}) {
      const int link = sense > 0 ? reaction.on : reaction.from;
      if (link >= 0) {
        const auto& pivot = places_[static_cast<std::size_t>(link)];
        const Scalar moment = reaction.couple + (reaction.at_x - pivot.x) * reaction.y -
                              (reaction.at_y - pivot.y) * reaction.x;
        const Scalar size = Scalar(sense) * unit;
        table_(3 * link, column) += size * reaction.x;
        table_(3 * link + 1, column) += size * reaction.y;
        table_(3 * link + 2, column) += size * moment / size_;
      }
    }
  }
  [[nodiscard]] Scalar unit_of(int unknown) const {
    return units_[static_cast<std::size_t>(unknown)].couple > 0 ? size_ : Scalar(1);
  }
  /// The load w in a row of the equilibrium.
  [[nodiscard]] Scalar load_of(int row) const {
    const LinkLoad<Scalar>& load = loads_[static_cast<std::size_t>(row / 3)];
    return row % 3 == 0   ? load.x
           : row % 3 == 1 ? load.y
                          : load.moment_about(places_[static_cast<std::size_t>(row / 3)]) / size_;
  }
  [[nodiscard]] bool is_known(int row) const { return std::isfinite(load_of(row)); }
  /// Solves the equations that are not left out, with the given loads. Returns whether they have a
  /// solution.
  template <typename Load>
  [[nodiscard]] bool is_balanced(const Load& load, const Scalar& tolerance) {
    fill(load);
    pivots_.begin(rows, columns);
    const Scalar largest = largest_load();
    const Scalar first = local::eliminate_largest(table_, columns, Scalar(0), pivots_);
    const Scalar bound = first * (std::max)(least, tolerance / size_);
    while (local::eliminate_largest(table_, columns, bound, pivots_) > 0) {
    }
    return leaves_at_most(negligible * largest);
  }
  /// Leaves out the links on which undetermined unknowns act. Returns whether there are more of
  /// them than before.
  bool leave_out_movable() {
    bool are_more = false;
    const auto leave_out = [&](const Reaction& reaction) {
      for (const int link : {reaction.on, reaction.from}) {
        for (int row = 3 * link; row >= 0 && row < 3 * link + 3; ++row) {
          bool& is_left_out = is_left_out_[static_cast<std::size_t>(row)];
          are_more = are_more || !is_left_out;
          is_left_out = true;
        }
      }
    };
    for (int unknown = 0; unknown < columns; ++unknown) {
      if (is_movable(unknown)) {
        leave_out(units_[static_cast<std::size_t>(unknown)]);
      }
    }
    for (const PassedOn& passed : passed_) {
      if (is_movable(passed.unknown)) {
        leave_out(passed.reaction);
      }
    }
    return are_more;
  }
  /// Fills in A and w, without the rows that are left out.
  template <typename Load>
  void fill(const Load& load) {
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        table_(row, column) = 0;
      }
    }
    for (int unknown = 0; unknown < columns; ++unknown) {
      add(units_[static_cast<std::size_t>(unknown)], unit_of(unknown), unknown);
    }
    for (const PassedOn& passed : passed_) {
      add(passed.reaction, unit_of(passed.unknown), passed.unknown);
    }
    for (int row = 0; row < rows; ++row) {
      table_(row, columns) = load(row);
      for (int column = 0; column <= columns && is_left_out_[static_cast<std::size_t>(row)];
           ++column) {
        table_(row, column) = 0;
      }
    }
  }
  [[nodiscard]] Scalar largest_load() const {
    Scalar largest = 0;
    for (int row = 0; row < rows; ++row) {
      largest = (std::max)(largest, std::abs(table_(row, columns)));
    }
    return largest;
  }
  /// Whether the residual of the rows without a pivot is small: then the loads can be balanced.
  [[nodiscard]] bool leaves_at_most(const Scalar& most) const {
    for (int row = 0; row < rows; ++row) {
      if (pivots_.column_of(row) < 0 && std::abs(table_(row, columns)) > most) {
        return false;
      }
    }
    return true;
  }
  /// The component of an unknown in the null direction in which the unknown of a column without a
  /// pivot is one.
  [[nodiscard]] Scalar null_component(int free, int unknown) const {
    const int row = pivots_.row_of(unknown);
    return row >= 0 ? -table_(row, free) : Scalar(unknown == free ? 1 : 0);
  }
  /// Whether a null direction of A changes a sum of unknowns, a function of their sizes.
  template <typename Sum>
  [[nodiscard]] bool is_movable(const Sum& sum) const {
    for (int free = 0; free < columns; ++free) {
      if (pivots_.row_of(free) >= 0) {
        continue;
      }
      const auto component = [&](int unknown) { return null_component(free, unknown); };
      Scalar square = 0;
      for (int unknown = 0; unknown < columns; ++unknown) {
        square += component(unknown) * component(unknown);
      }
      const Vector<Scalar, 2> change = sum(component);
      if (change(0) * change(0) + change(1) * change(1) > negligible * negligible * square) {
        return true;
      }
    }
    return false;
  }
  [[nodiscard]] bool is_movable(int unknown) const {
    return is_movable([&](const auto& size_of) {
      return Vector<Scalar, 2>{size_of(unknown), Scalar(0)};
    });
  }
  [[nodiscard]] Scalar found(int unknown) const {
    const int row = pivots_.row_of(unknown);
    return row >= 0 ? -table_(row, columns) : Scalar(0);
  }
  /// Whether unknown loads can be balanced whatever they are. Notes the unknowns that depend on
  /// them.
  [[nodiscard]] bool are_unknown_balanced(const Scalar& tolerance) {
    depends_.fill(false);
    for (int unknown_load = 0; unknown_load < rows; ++unknown_load) {
      if (is_known(unknown_load) || is_left_out_[static_cast<std::size_t>(unknown_load)]) {
        continue;
      }
      if (!is_balanced([&](int row) { return Scalar(row == unknown_load ? 1 : 0); }, tolerance)) {
        return false;
      }
      for (int unknown = 0; unknown < columns; ++unknown) {
        bool& depends = depends_[static_cast<std::size_t>(unknown)];
        depends = depends || std::abs(found(unknown)) > negligible;
      }
    }
    return true;
  }
  /// A sum of unknowns; NaN if it is not determined.
  template <typename Sum>
  [[nodiscard]] Vector<Scalar, 2> told(const Sum& sum) const {
    constexpr Scalar none = std::numeric_limits<Scalar>::quiet_NaN();
    bool depends = is_movable(sum);
    (void)sum([&](int unknown) {
      depends = depends || depends_[static_cast<std::size_t>(unknown)];
      return Scalar(0);
    });
    return depends ? Vector<Scalar, 2>{none, none}
                   : sum([&](int unknown) { return found(unknown); });
  }

  std::array<Reaction, static_cast<std::size_t>(columns)> units_;
  std::array<PassedOn, static_cast<std::size_t>(Passed)> passed_;
  std::array<LinkLoad<Scalar>, static_cast<std::size_t>(Links)> loads_;
  std::array<Pose<Scalar>, static_cast<std::size_t>(Links)> places_;  ///< of the links' pivots
  std::array<bool, static_cast<std::size_t>(Links)> has_pivot_{};
  std::array<bool, static_cast<std::size_t>(rows)> is_left_out_{};
  local::Memory<Scalar, rows*(columns + 1)> memory_;
  local::Table<Scalar> table_{memory_, rows, columns + 1};  ///< A and w, eliminated by `solve`
  local::Pivots<rows, columns> pivots_;
  std::array<bool, static_cast<std::size_t>(columns)> depends_{};  ///< on unknown loads
  Scalar size_ = 1;
  int unknowns_ = 0, passed_count_ = 0, pulls_ = 0;
};

}  // namespace assur::support
