// The place near a point at which constraints lose rank, and by how much they are open there.
#pragma once

#include <algorithm>
#include <array>
#include <assur/local/elimination.hpp>
#include <assur/local/system.hpp>
#include <assur/numeric/precision.hpp>
#include <cmath>
#include <cstddef>
#include <limits>

namespace assur::local {

/// A point at which F'(z) has lost ranks, and F(z) + W mu = 0 with W across the image of F'. Where
/// mu is no more than rounding, branches meet there; else they pass each other, or end.
template <typename System>
struct SingularPoint {
  typename System::Point at;
  typename System::Scalar opening = 0;  ///< the largest entry of mu
  bool is_found = false;
};

/// The largest sizes of what is computed, where they are fixed; else zero.
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

/// Finds the point where F' has lost `corank` ranks, at most System::most_corank, from one near it:
/// with N, W the directions that F' nearly loses there and [F' W; N' 0] [V; -S] = [0; 1], by
/// Newton's steps for F + W mu = 0 and S = 0, with Y' F''(., V) as the derivative of S, where
/// [F'' N; W' 0] [Y; .] = [0; 1]. Those of the equations S = 0 that say the same are left out.
template <typename System>
[[nodiscard]] SingularPoint<System> singular_point(const System& system,
                                                   const typename System::Point& near, int corank) {
  using Scalar = typename System::Scalar;
  using std::abs;
  constexpr int most_steps = 6;  // those that converge take two or three
  const Scalar least_firmness = 16 * std::sqrt(std::numeric_limits<Scalar>::epsilon());
  const int rows = row_count(system);
  const int columns = unknown_count(system) + 1;
  const int rank = columns - 1 - corank;
  const int right = columns - rank;
  const int left = rows - rank;
  const int bordered = rows + right;
  const int equations = rows + left * right;
  using Most = MostOf<System>;
  auto memory = memory_for<Scalar, Most::table>(
      (std::max)({bordered * (bordered + (std::max)(left, right)), equations * (columns + left + 1),
                  rows * (columns + rows)}));
  auto memory_of_N = memory_for<Scalar, Most::columns * Most::right>(columns * right);
  auto memory_of_W = memory_for<Scalar, Most::rows * Most::left>(rows * left);
  auto memory_of_V = memory_for<Scalar, Most::columns * Most::right>(columns * right);
  auto memory_of_Y = memory_for<Scalar, Most::rows * Most::left>(rows * left);
  auto S = memory_for<Scalar, Most::left * Most::right>(left * right);
  auto mu = memory_for<Scalar, Most::left>(left);
  auto column_of = memory_for<int, Most::equations>(equations);
  auto row_of = memory_for<int, Most::bordered>(bordered);

  SingularPoint<System> result;
  result.at = near;
  Table<Scalar> N(memory_of_N.data(), columns, right);
  Table<Scalar> W(memory_of_W.data(), rows, left);
  for (int time = 0; time < most_steps; ++time) {
    const WideOf<System> J = jacobian(system, result.at);
    if (time == 0) {
      Table<Scalar> table(memory.data(), rows, columns + rows);
      for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
          table(row, column) = J(row, column);
        }
      }
      find_lost_directions(table, columns, rank, N, W, column_of.data(), row_of.data());
    }
    // V and S, and Y.
    Table<Scalar> V(memory_of_V.data(), columns, right);
    Table<Scalar> Y(memory_of_Y.data(), rows, left);
    for (const bool transposed : {false, true}) {
      const int sides = transposed ? left : right;
      Table<Scalar> table(memory.data(), bordered, bordered + sides);
      const auto entry = [&](int row, int column) -> Scalar& {
        return transposed ? table(column, row) : table(row, column);
      };
      for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
          entry(row, column) = J(row, column);
        }
        for (int column = 0; column < left; ++column) {
          entry(row, columns + column) = W(row, column);
        }
      }
      for (int column = 0; column < columns; ++column) {
        for (int row = 0; row < right; ++row) {
          entry(rows + row, column) = N(column, row);
        }
      }
      for (int side = 0; side < sides; ++side) {
        table(bordered - sides + side, bordered + side) = 1;
      }
      (void)eliminate(table, bordered, bordered, column_of.data(), row_of.data());
      for (int side = 0; side < sides; ++side) {
        const auto solved = [&](int unknown) {
          const int row = row_of[static_cast<std::size_t>(unknown)];
          return row < 0 ? std::numeric_limits<Scalar>::quiet_NaN() : table(row, bordered + side);
        };
        if (transposed) {
          for (int row = 0; row < rows; ++row) {
            Y(row, side) = solved(row);
          }
        } else {
          for (int column = 0; column < columns; ++column) {
            V(column, side) = solved(column);
          }
          for (int index = 0; index < left; ++index) {
            S[static_cast<std::size_t>(index * right + side)] = -solved(columns + index);
          }
        }
      }
    }
    // Newton's step.
    const OpenOf<System> open = system.misses(result.at);
    const int size = columns + left;
    Table<Scalar> table(memory.data(), equations, size + 1);
    for (int row = 0; row < rows; ++row) {
      table(row, size) = -open(row);
      for (int column = 0; column < columns; ++column) {
        table(row, column) = J(row, column);
      }
      for (int index = 0; index < left; ++index) {
        table(row, columns + index) = W(row, index);
        table(row, size) -= W(row, index) * mu[static_cast<std::size_t>(index)];
      }
    }
    for (int side = 0; side < right; ++side) {
      StepOf<System> direction(columns);
      for (int column = 0; column < columns; ++column) {
        direction(column) = V(column, side);
      }
      const WideOf<System> bent = bends<System>(system, result.at, direction);
      for (int column = 0; column < columns; ++column) {
        for (int index = 0; index < left; ++index) {
          Scalar& along = table(rows + index * right + side, column);
          for (int row = 0; row < rows; ++row) {
            along += Y(row, index) * bent(row, column);
          }
        }
      }
      for (int index = 0; index < left; ++index) {
        table(rows + index * right + side, size) =
            -S[static_cast<std::size_t>(index * right + side)];
      }
    }
    const Scalar firmness = eliminate(table, size, size, column_of.data(), row_of.data());
    if (!(firmness > least_firmness)) {
      return result;
    }
    StepOf<System> move(columns);
    Scalar longest = 0;
    for (int column = 0; column < columns; ++column) {
      move(column) = table(row_of[static_cast<std::size_t>(column)], size);
      longest = (std::max)(longest, abs(move(column)));
    }
    if (!(longest < 1)) {
      return result;
    }
    system.move(move, result.at);
    for (int index = 0; index < left; ++index) {
      mu[static_cast<std::size_t>(index)] +=
          table(row_of[static_cast<std::size_t>(columns + index)], size);
    }
    if (longest <= numeric::half_of_digits<Scalar>) {
      Scalar left_over = 0;
      for (int row = 0; row < equations; ++row) {
        if (column_of[static_cast<std::size_t>(row)] < 0) {
          left_over = (std::max)(left_over, abs(table(row, size)));
        }
      }
      const OpenOf<System> there = system.misses(result.at);
      for (int index = 0; index < left; ++index) {
        Scalar miss = 0;
        for (int row = 0; row < rows; ++row) {
          miss += Y(row, index) * there(row);
        }
        result.opening = (std::max)(result.opening, abs(miss));
      }
      result.is_found = left_over <= least_firmness;
      return result;
    }
  }
  return result;
}

}  // namespace assur::local
