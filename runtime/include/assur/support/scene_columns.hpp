// Drivers and states of many instances of an emitted solver as columns of numbers.
#pragma once

#include <array>
#include <assur/model.hpp>
#include <assur/status.hpp>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <type_traits>
#include <utility>

namespace assur::support {

namespace columns {

template <typename Part, typename = void>
inline constexpr bool has_members = false;
template <typename Part>
inline constexpr bool has_members<Part, std::void_t<decltype(std::declval<Part&>().members())>> =
    true;

/// Calls `use` with every number of a part of a state; a direction begins with its cosine, and a
/// matrix goes column by column.
template <typename Scalar, typename Use>
void visit(Scalar& number, Use& use, Scalar* /*numbers*/) {
  use(number);
}
template <typename Scalar, typename Use>
void visit(Direction<Scalar>& direction, Use& use, Scalar* /*numbers*/) {
  use(direction.cos);
  use(direction.sin);
}
template <typename Scalar, typename Use>
void visit(Pose<Scalar>& pose, Use& use, Scalar* numbers) {
  use(pose.x);
  use(pose.y);
  visit(pose.direction, use, numbers);
}
template <typename Scalar, int Rows, int Columns, typename Use>
void visit(Matrix<Scalar, Rows, Columns>& matrix, Use& use, Scalar* /*numbers*/) {
  for (int place = 0; place < Rows * Columns; ++place) {
    use(matrix.data()[place]);
  }
}
template <typename Scalar, typename Part, std::size_t Count, typename Use>
void visit(std::array<Part, Count>& parts, Use& use, Scalar* numbers) {
  for (Part& part : parts) {
    visit(part, use, numbers);
  }
}
template <typename Scalar, typename Part, typename Use,
          std::enable_if_t<has_members<Part>, int> = 0>
void visit(Part& part, Use& use, Scalar* numbers) {
  std::apply([&](auto&... member) { (visit(member, use, numbers), ...); }, part.members());
}

template <typename Part, typename = void>
inline constexpr bool has_velocity = false;
template <typename Part>
inline constexpr bool has_velocity<Part, std::void_t<decltype(std::declval<Part&>().velocity)>> =
    true;
template <typename Part, typename = void>
inline constexpr bool has_acceleration = false;
template <typename Part>
inline constexpr bool
    has_acceleration<Part, std::void_t<decltype(std::declval<Part&>().acceleration)>> = true;

/// Calls `use` with every velocity and acceleration of a part of a state.
template <typename Scalar, typename Part, typename Use>
void visit_rates(Part& part, Use& use, Scalar* numbers) {
  if constexpr (has_velocity<Part>) {
    visit(part.velocity, use, numbers);
  }
  if constexpr (has_acceleration<Part>) {
    visit(part.acceleration, use, numbers);
  }
  if constexpr (!has_velocity<Part> && !has_acceleration<Part> && has_members<Part>) {
    std::apply([&](auto&... member) { (visit_rates(member, use, numbers), ...); }, part.members());
  }
}

/// The sum of all velocities and accelerations of a part of a state.
template <typename Scalar, typename Part>
[[nodiscard]] Scalar sum_of_rates(Part& part, Scalar* numbers) {
  Scalar sum(0);
  const auto add = [&](const Scalar& rate) { sum = sum + rate; };
  if constexpr (has_velocity<Part> || has_acceleration<Part>) {
    visit_rates(part, add, numbers);
  } else if constexpr (has_members<Part>) {
    // The sums of parts are independent of each other.
    std::apply([&](auto&... member) { (add(sum_of_rates(member, numbers)), ...); }, part.members());
  }
  return sum;
}

template <typename Part, typename = void>
inline constexpr bool has_position = false;
template <typename Part>
inline constexpr bool has_position<Part, std::void_t<decltype(std::declval<Part&>().position)>> =
    true;
template <typename Part, typename = void>
inline constexpr bool has_pose = false;
template <typename Part>
inline constexpr bool has_pose<Part, std::void_t<decltype(std::declval<Part&>().pose)>> = true;

/// Calls `use` with every position coordinate of links and points in a part of a state.
template <typename Scalar, typename Part, typename Use>
void visit_places(Part& part, Use& use, Scalar* numbers) {
  if constexpr (has_position<Part>) {
    visit(part.position, use, numbers);
  } else if constexpr (has_pose<Part>) {
    visit(part.pose, use, numbers);
  } else if constexpr (has_members<Part>) {
    std::apply([&](auto&... member) { (visit_places(member, use, numbers), ...); }, part.members());
  }
}

/// The number of numbers in a part.
template <typename Scalar>
constexpr std::size_t count(const Scalar* /*part*/, const Scalar* /*numbers*/) {
  return 1;
}
template <typename Scalar>
constexpr std::size_t count(const Pose<Scalar>* /*part*/, const Scalar* /*numbers*/) {
  return 4;
}
template <typename Scalar, int Rows, int Columns>
constexpr std::size_t count(const Matrix<Scalar, Rows, Columns>* /*part*/,
                            const Scalar* /*numbers*/) {
  return static_cast<std::size_t>(Rows) * static_cast<std::size_t>(Columns);
}
template <typename Scalar, typename Part, std::size_t Count>
constexpr std::size_t count(const std::array<Part, Count>* /*parts*/, const Scalar* numbers) {
  return Count * count(static_cast<const Part*>(nullptr), numbers);
}
template <typename Scalar, typename... Members>
constexpr std::size_t count_all(std::tuple<Members&...>* /*members*/, const Scalar* numbers);
template <typename Scalar, typename Part, std::enable_if_t<has_members<Part>, int> = 0>
constexpr std::size_t count(const Part* /*part*/, const Scalar* numbers) {
  using Members = decltype(std::declval<Part&>().members());
  return count_all(static_cast<Members*>(nullptr), numbers);
}
template <typename Scalar, typename... Members>
constexpr std::size_t count_all(std::tuple<Members&...>* /*members*/,
                                [[maybe_unused]] const Scalar* numbers) {
  return (std::size_t{0} + ... + count(static_cast<const Members*>(nullptr), numbers));
}

}  // namespace columns

/// The number of numbers in the drivers, the parameters or a state of a solver; each has a column
/// in a batch: column_count<Solver::State<double>>.
template <typename Variables>
inline constexpr std::size_t column_count = columns::count(static_cast<const Variables*>(nullptr),
                                                           static_cast<const double*>(nullptr));

/// Calls `use` with every number of drivers, parameters or a state, and with its column.
template <template <typename> class Variables, typename Scalar, typename Use>
void for_each_column(Variables<Scalar>& variables, const Use& use) {
  std::size_t column = 0;
  const auto use_next = [&](Scalar& number) { use(number, column++); };
  columns::visit(variables, use_next, static_cast<Scalar*>(nullptr));
}

/// Sets every number of a state to NaN, and its regularity to singular.
template <template <typename> class State, typename Scalar>
void clear_state(State<Scalar>& state) {
  for_each_column(state, [](Scalar& number, std::size_t) {
    number = std::numeric_limits<Scalar>::quiet_NaN();
  });
  state.regularity = Status::singular;
}

/// Whether the sum of all velocities and accelerations of a state is finite, and so each of them;
/// lane by lane for packs.
template <template <typename> class State, typename Scalar>
[[nodiscard]] auto is_sum_of_rates_finite(State<Scalar>& state) {
  const Scalar sum = columns::sum_of_rates(state, static_cast<Scalar*>(nullptr));
  return sum - sum == Scalar(0);
}

/// Whether the positions of all links and points in a state are finite; lane by lane for packs. A
/// formula in the solver's parameters may have no value.
template <template <typename> class State, typename Scalar>
[[nodiscard]] auto are_places_finite(State<Scalar>& state) {
  Scalar sum(0);
  const auto add = [&sum](const Scalar& coordinate) { sum = sum + (coordinate - coordinate); };
  columns::visit_places(state, add, static_cast<Scalar*>(nullptr));
  return sum == Scalar(0);
}

/// Marks a state with infinite rates as near-singular, and sets these rates to NaN.
template <template <typename> class State, typename Scalar>
void mark_infinite_rates(State<Scalar>& state) {
  if (!is_sum_of_rates_finite(state)) {
    const auto mark = [&](Scalar& rate) {
      if (!std::isfinite(rate)) {
        rate = std::numeric_limits<Scalar>::quiet_NaN();
        state.regularity = Status::near_singular;
      }
    };
    columns::visit_rates(state, mark, static_cast<Scalar*>(nullptr));
  }
}

/// The column of every number of a solver's drivers, parameters or states:
/// column_numbers<Solver::State>().outputs.P.position(0).
template <template <typename> class Variables>
[[nodiscard]] Variables<std::size_t> column_numbers() {
  Variables<std::size_t> numbers;
  for_each_column(numbers, [](std::size_t& number, std::size_t column) { number = column; });
  return numbers;
}

}  // namespace assur::support
