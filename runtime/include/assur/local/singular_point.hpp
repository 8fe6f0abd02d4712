// The point near a given one at which constraints lose rank, and their residual there.
#pragma once

#include <algorithm>
#include <assur/local/elimination.hpp>
#include <assur/local/system.hpp>
#include <assur/numeric/precision.hpp>
#include <cmath>
#include <limits>

namespace assur::local {

/// A point at which F'(z) has lost rank, and F(z) + W mu = 0, where W spans the left null space of
/// F'. If mu is zero up to rounding, branches meet there; otherwise they pass each other, or end.
template <typename System>
struct SingularPoint {
  typename System::Point at;
  typename System::Scalar opening = 0;  ///< the largest entry of mu
  bool is_found = false;
};

/// Upper bounds of the matrices' sizes if these are fixed; zero otherwise.
template <typename System, bool IsFixed = has_fixed_size<System>>
struct MostOf {
  static constexpr int rows = 0, columns = 0, left = 0, right = 0, bordered = 0, equations = 0,
                       table = 0;
};
template <typename System>
struct MostOf<System, true> {
  static constexpr int rows = System::rows;
  static constexpr int columns = System::unknowns + 1;
  static constexpr int left = System::rows - System::unknowns + System::most_corank;
  static constexpr int right = 1 + System::most_corank;
  static constexpr int bordered = rows + right;
  static constexpr int equations = rows + left * right;
  static constexpr int table = (std::max)({bordered * (bordered + (std::max)(left, right)),
                                           equations*(columns + left + 1), rows*(columns + rows)});
};

/// Newton's method for a singular point: F + W mu = 0 and S = 0. N and W span the right and left
/// null space of F' at the first point, nearly, and [F' W; N' 0] [V; -S] = [0; 1]. The derivative
/// of S along e is Y' F''(e, V), where [F'^T N; W' 0] [Y; .] = [0; 1]. Dependent equations of S = 0
/// are left out.
template <typename System>
class SingularPointSearch {
  using Scalar = typename System::Scalar;
  using Point = typename System::Point;
  using Most = MostOf<System>;

 public:
  SingularPointSearch(const System& system, const Point& near, int corank)
      : system_(system),
        rank_(columns() - 1 - corank),
        N_(memory_of_N_, columns(), right()),
        W_(memory_of_W_, rows(), left()),
        V_(memory_of_V_, columns(), right()),
        Y_(memory_of_Y_, rows(), left()),
        S_(memory_of_S_, left(), right()),
        mu_(memory_of_mu_, left(), 1) {
    result_.at = near;
  }

  [[nodiscard]] SingularPoint<System> run() {
    constexpr int most_steps = 6;  // convergent runs take two or three
    WideOf<System> J = jacobian(system_, result_.at);
    find_lost_directions(J);
    for (int time = 0; time < most_steps; ++time) {
      solve_bordered(J);
      Scalar longest = 0;
      if (!take_step(J, longest)) {
        return result_;
      }
      if (longest <= numeric::half_of_digits<Scalar>) {
        result_.is_found = true;
        set_opening();
        return result_;
      }
      J = jacobian(system_, result_.at);
    }
    return result_;
  }

 private:
  // Constants where sizes are fixed, so that compilers remove the checks of indices below them.
  [[nodiscard]] int rows() const {
    return has_fixed_size<System> ? System::rows : system_.row_count();
  }
  [[nodiscard]] int columns() const {
    return has_fixed_size<System> ? columns_of<System> : system_.unknown_count() + 1;
  }
  [[nodiscard]] int right() const { return columns() - rank_; }
  [[nodiscard]] int left() const { return rows() - rank_; }

  void find_lost_directions(const WideOf<System>& J) {
    Table<Scalar> table(memory_, rows(), columns() + rows());
    for (int row = 0; row < rows(); ++row) {
      for (int column = 0; column < columns(); ++column) {
        table(row, column) = J(row, column);
      }
    }
    local::find_lost_directions(table, columns(), rank_, N_, W_, pivots_);
  }

  /// Computes V, S and Y.
  void solve_bordered(const WideOf<System>& J) {
    for (const bool transposed : {false, true}) {
      const int size = rows() + right();
      const int sides = transposed ? left() : right();
      Table<Scalar> table(memory_, size, size + sides);
      const auto entry = [&](int row, int column) -> Scalar& {
        return transposed ? table(column, row) : table(row, column);
      };
      for (int row = 0; row < rows(); ++row) {
        for (int column = 0; column < columns(); ++column) {
          entry(row, column) = J(row, column);
        }
        for (int column = 0; column < left(); ++column) {
          entry(row, columns() + column) = W_(row, column);
        }
      }
      for (int column = 0; column < columns(); ++column) {
        for (int row = 0; row < right(); ++row) {
          entry(rows() + row, column) = N_(column, row);
        }
      }
      for (int side = 0; side < sides; ++side) {
        table(size - sides + side, size + side) = 1;
      }
      (void)eliminate(table, size, size, pivots_);
      for (int side = 0; side < sides; ++side) {
        const auto solved = [&](int unknown) {
          const int row = pivots_.row_of(unknown);
          return row < 0 ? std::numeric_limits<Scalar>::quiet_NaN() : table(row, size + side);
        };
        for (int row = 0; transposed && row < rows(); ++row) {
          Y_(row, side) = solved(row);
        }
        for (int column = 0; !transposed && column < columns(); ++column) {
          V_(column, side) = solved(column);
        }
        for (int row = 0; !transposed && row < left(); ++row) {
          S_(row, side) = -solved(columns() + row);
        }
      }
    }
  }

  /// Takes one Newton step and sets `longest` to its largest entry. False if the step is too long,
  /// if the point is not isolated, or if an equation that was left out does not hold.
  [[nodiscard]] bool take_step(const WideOf<System>& J, Scalar& longest) {
    // The ratio of the least pivot to the largest must exceed the error of finite differences.
    const Scalar least_firmness = 16 * std::sqrt(std::numeric_limits<Scalar>::epsilon());
    const int size = columns() + left();
    Table<Scalar> table(memory_, rows() + left() * right(), size + 1);
    const OpenOf<System> open = system_.misses(result_.at);
    for (int row = 0; row < rows(); ++row) {
      table(row, size) = -open(row);
      for (int column = 0; column < columns(); ++column) {
        table(row, column) = J(row, column);
      }
      for (int index = 0; index < left(); ++index) {
        table(row, columns() + index) = W_(row, index);
        table(row, size) -= W_(row, index) * mu_(index, 0);
      }
    }
    StepOf<System> step(columns());
    for (int side = 0; side < right(); ++side) {
      for (int column = 0; column < columns(); ++column) {
        step(column) = V_(column, side);
      }
      const WideOf<System> bent = bends<System>(system_, result_.at, step);
      for (int index = 0; index < left(); ++index) {
        const int equation = rows() + index * right() + side;
        table(equation, size) = -S_(index, side);
        for (int column = 0; column < columns(); ++column) {
          for (int row = 0; row < rows(); ++row) {
            table(equation, column) += Y_(row, index) * bent(row, column);
          }
        }
      }
    }
    if (!(eliminate(table, size, size, pivots_) > least_firmness)) {
      return false;
    }
    longest = 0;
    for (int column = 0; column < columns(); ++column) {
      step(column) = table(pivots_.row_of(column), size);
      longest = (std::max)(longest, std::abs(step(column)));
    }
    if (!(longest < 1)) {
      return false;
    }
    system_.move(step, result_.at);
    for (int index = 0; index < left(); ++index) {
      mu_(index, 0) += table(pivots_.row_of(columns() + index), size);
    }
    Scalar left_over = 0;
    for (int row = 0; row < table.rows(); ++row) {
      if (pivots_.column_of(row) < 0) {
        left_over = (std::max)(left_over, std::abs(table(row, size)));
      }
    }
    return longest > numeric::half_of_digits<Scalar> || left_over <= least_firmness;
  }

  /// The largest entry of Y' F, which differs from that of mu by the square of the last step.
  void set_opening() {
    const OpenOf<System> open = system_.misses(result_.at);
    for (int index = 0; index < left(); ++index) {
      Scalar miss = 0;
      for (int row = 0; row < rows(); ++row) {
        miss += Y_(row, index) * open(row);
      }
      result_.opening = (std::max)(result_.opening, std::abs(miss));
    }
  }

  const System& system_;
  int rank_;
  SingularPoint<System> result_;
  Memory<Scalar, Most::table> memory_;
  Memory<Scalar, Most::columns * Most::right> memory_of_N_, memory_of_V_;
  Memory<Scalar, Most::rows * Most::left> memory_of_W_, memory_of_Y_;
  Memory<Scalar, Most::left * Most::right> memory_of_S_;
  Memory<Scalar, Most::left> memory_of_mu_;
  Table<Scalar> N_, W_, V_, Y_, S_, mu_;
  Pivots<Most::equations, Most::bordered> pivots_;
};

/// Finds the point near `near` at which F' loses `corank` ranks; at most System::most_corank if
/// sizes are fixed.
template <typename System>
[[nodiscard]] SingularPoint<System> singular_point(const System& system,
                                                   const typename System::Point& near, int corank) {
  return SingularPointSearch<System>(system, near, corank).run();
}

}  // namespace assur::local
