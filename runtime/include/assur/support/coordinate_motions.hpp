// Kinematic coefficients of an emitted solver: derivatives with respect to the coordinates of its
// free drivers.
#pragma once

#include <array>
#include <assur/detail/index.hpp>
#include <assur/model.hpp>
#include <assur/support/placed_group.hpp>
#include <assur/support/redundant.hpp>
#include <assur/support/scene_access.hpp>
#include <cstddef>
#include <tuple>

namespace assur::support {

/// First and second derivatives of a few quantities with respect to the coordinates of the free
/// drivers.
template <typename Scalar, int Numbers, int Coordinates>
struct Coefficients {
  Matrix<Scalar, Numbers, Coordinates> first;  ///< one column for each coordinate
  /// second[i] holds the derivatives of `first` by coordinate i.
  std::array<Matrix<Scalar, Numbers, Coordinates>, static_cast<std::size_t>(Coordinates)> second;
  [[nodiscard]] auto members() { return std::tie(first, second); }
};

/// The rates of the angle from one frame to another.
template <typename Scalar, int Order, int Parameters>
[[nodiscard]] Matrix<Scalar, 1, Order> turning_rates(
    const Frame<Scalar, Order, Parameters>& one, const Frame<Scalar, Order, Parameters>& other) {
  Matrix<Scalar, 1, Order> rates;
  for (int order = 0; order < Order; ++order) {
    rates(order) = other.rates(2, order) - one.rates(2, order);
  }
  return rates;
}

/// Writes the rates of a few quantities into the rows of a list, from `First` on.
template <int First, typename Scalar, int Rows, int Order, int All>
void put_rates(const Matrix<Scalar, Rows, Order>& rates, Matrix<Scalar, All, Order>& list) {
  static_assert(First + Rows <= All);
  for (int row = 0; row < Rows; ++row) {
    for (int order = 0; order < Order; ++order) {
      list(First + row, order) = rates(row, order);
    }
  }
}

/// The rates r', r'' of a solver's quantities, in the order of its `list_rates`, for motions with
/// phi_i' = 1 and phi'' = 0: along one coordinate these are the first and second derivatives r_i
/// and r_ii; along two, r'' = r_ii + 2 r_ij + r_jj. Parameters are constant; drivers whose laws
/// read joints follow.
template <typename Solver, typename Scalar>
class CoordinateMotions {
  using Own = Access<Solver, Scalar>;
  using Parts = typename Own::Parts;
  using Placed = typename Own::Placed;
  using Rates = Matrix<Scalar, Parts::rated_numbers, Solver::order>;
  static constexpr int coordinates = Solver::coordinate_count;

 public:
  using SecondDerivatives = Matrix<Scalar, Parts::rated_numbers, coordinates * coordinates>;

  explicit CoordinateMotions(const Placed& standing) : standing_(standing) {
    for (int i = 0; i < coordinates; ++i) {
      detail::entry(along_, i) = rates_along(i, i);
    }
  }

  /// First derivatives of a few quantities with respect to each coordinate.
  template <int First, int Numbers>
  [[nodiscard]] Matrix<Scalar, Numbers, coordinates> first() const {
    Matrix<Scalar, Numbers, coordinates> result;
    for (int i = 0; i < coordinates; ++i) {
      for (int number = 0; number < Numbers; ++number) {
        result(number, i) = detail::entry(along_, i)(First + number, 0);
      }
    }
    return result;
  }

  /// Second derivatives of all quantities with respect to coordinates i and j in column i n + j,
  /// for n coordinates.
  [[nodiscard]] SecondDerivatives second() const {
    SecondDerivatives result;
    for (int i = 0; i < coordinates; ++i) {
      const Rates& by_i = detail::entry(along_, i);
      for (int number = 0; number < Parts::rated_numbers; ++number) {
        result(number, i * coordinates + i) = by_i(number, 1);
      }
      for (int j = 0; j < i; ++j) {
        const Rates& by_j = detail::entry(along_, j);
        const Rates both = rates_along(i, j);
        for (int number = 0; number < Parts::rated_numbers; ++number) {
          result(number, i * coordinates + j) = result(number, j * coordinates + i) =
              (both(number, 1) - by_i(number, 1) - by_j(number, 1)) / Scalar(2);
        }
      }
    }
    return result;
  }

  /// The coefficients of a few quantities; `second` holds their second derivatives.
  template <int First, int Numbers>
  [[nodiscard]] Coefficients<Scalar, Numbers, coordinates> coefficients(
      const SecondDerivatives& second) const {
    Coefficients<Scalar, Numbers, coordinates> result;
    result.first = first<First, Numbers>();
    for (int i = 0; i < coordinates; ++i) {
      for (int j = 0; j < coordinates; ++j) {
        for (int number = 0; number < Numbers; ++number) {
          detail::entry(result.second, i)(number, j) = second(First + number, i * coordinates + j);
        }
      }
    }
    return result;
  }

 private:
  [[nodiscard]] Rates rates_along(int i, int j) const {
    auto drivers = standing_.drivers;
    for (Scalar* rate : drivers.rates()) {  // including those of idle links
      *rate = Scalar(0);
    }
    int coordinate = 0;
    for (auto* driver : Parts::coordinates(drivers)) {
      driver->velocity = Scalar(coordinate == i || coordinate == j ? 1 : 0);
      ++coordinate;
    }
    Placed moving;
    moving.given_rates = Scalar(0);
    if constexpr (has_parameters<Solver>) {
      Parts::drive(drivers, standing_.parameters, moving);
    } else {
      Parts::drive(drivers, moving);
    }
    place_groups<0>(moving);
    if constexpr (Own::settles) {
      if (moving.regularity != Status::ok ||
          !(Own::gap(moving) <= redundancy_slack(Scalar(1), Status::ok))) {
        (void)Own::settle(moving);  // it has settled before
      }
    }
    Rates rates;
    Parts::list_rates(moving, rates);
    return rates;
  }
  /// Places the groups from `Place` on in their present configurations.
  template <std::size_t Place>
  void place_groups(Placed& moving) const {
    using Groups = typename Own::Groups;
    if constexpr (Place < std::tuple_size_v<Groups>) {
      using Group = std::tuple_element_t<Place, Groups>;
      HeldJoints<Group, Scalar, Solver::order, Solver::parameter_count> held;
      Own::hold(moving, held);
      const auto& solved = std::get<Place>(Parts::solved(standing_));
      const auto group = place_group(held, solved.q, solved.regularity);
      if (group.regularity != Status::ok) {
        moving.regularity = Status::near_singular;
      }
      Own::place(group, moving);
      place_groups<Place + 1>(moving);
    }
  }

  const Placed& standing_;
  std::array<Rates, static_cast<std::size_t>(coordinates)> along_;
};

}  // namespace assur::support
