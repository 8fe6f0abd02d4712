// A scalar that counts the operations of generated functions.
#pragma once

#include <Eigen/Core>
#include <ostream>
#include <tuple>
#include <type_traits>

namespace assur::test {

/// A change of sign is no operation, and a multiplication by 2 is one.
struct Count {
  int multiplications = 0;
  int additions = 0;
  int divisions = 0;

  friend bool operator==(const Count& a, const Count& b) {
    return a.multiplications == b.multiplications && a.additions == b.additions &&
           a.divisions == b.divisions;
  }
  friend bool operator!=(const Count& a, const Count& b) { return !(a == b); }
  friend std::ostream& operator<<(std::ostream& out, const Count& count) {
    return out << count.multiplications << ", " << count.additions << ", " << count.divisions;
  }
};

inline Count counted;

/// A number that counts the operations on it. Operations among constants of the text are folded by
/// every compiler and are free. It has no value, because no generated function asks for one, and is
/// passed by value and does not throw, because its many uses then compile fastest.
struct Counting {
  bool constant = false;

  Counting() = default;
  explicit Counting(double /*number*/) noexcept : constant(true) {}

  static Counting result(Counting a, Counting b, int Count::*operation) noexcept {
    Counting made;
    made.constant = a.constant && b.constant;
    counted.*operation += made.constant ? 0 : 1;
    return made;
  }
  friend Counting operator+(Counting a, Counting b) noexcept {
    return result(a, b, &Count::additions);
  }
  friend Counting operator-(Counting a, Counting b) noexcept {
    return result(a, b, &Count::additions);
  }
  friend Counting operator-(Counting a) noexcept { return a; }
  friend Counting operator*(Counting a, Counting b) noexcept {
    return result(a, b, &Count::multiplications);
  }
  friend Counting operator/(Counting a, Counting b) noexcept {
    return result(a, b, &Count::divisions);
  }
  friend Counting abs(Counting a) noexcept { return a; }
};

/// Makes the entries of an argument variables: by default a direction is the constant (1, 0).
template <typename Argument>
void set_variables(Argument& argument) {
  if constexpr (std::is_base_of_v<Eigen::MatrixBase<Argument>, Argument>) {
    argument.fill(Counting());
  }
}
template <template <typename> class Variables>
void set_variables(Variables<Counting>& variables) {
  const auto set = [](auto& member) {
    if constexpr (std::is_same_v<std::decay_t<decltype(member)>, Counting>) {
      member = Counting();
    } else {
      member = {Counting(), Counting()};
    }
  };
  std::apply([&](auto&... member) { (set(member), ...); }, variables.members());
}

/// One argument for each type of parameter, because tuples of them cost much to compile. An
/// argument that a function reads is const, which distinguishes it from the one that it writes.
template <typename Parameter>
Parameter argument() {
  static std::decay_t<Parameter> value;
  set_variables(value);
  return value;
}

/// The operations of a function with arguments that are not constants of the text.
template <typename... Parameters>
Count operations_of(void (*function)(Parameters...)) {
  counted = {};
  function(argument<Parameters>()...);
  return counted;
}

}  // namespace assur::test
