#include "motion_terms.hpp"

#include <algorithm>
#include <cmath>

namespace assur::mechanism::solve {

namespace {

/// Finds the longest of the lengths in a flat list of lengths and directions.
class Longest {
 public:
  explicit Longest(const double* numbers) : next_(numbers) {}

  void include(bool is_angle) {
    length_ = is_angle ? length_ : std::max(length_, std::abs(*next_));
    next_ += is_angle ? 2 : 1;
  }
  [[nodiscard]] double length() const { return length_; }

 private:
  const double* next_;
  double length_ = 0;
};

/// The longest length or displacement of a group.
double reach_of(const GroupModel& model, const Values::GroupNumbers& numbers,
                const models::FlatVariables& q) {
  Longest dimension(numbers.d.data());
  for (const bool is_angle : numbers.is_angle) {
    dimension.include(is_angle);
  }
  Longest unknown(q.data());
  for (const ModelUnknown& of : model.unknowns) {
    unknown.include(of.is_angle);
  }
  return std::max(dimension.length(), unknown.length());
}

/// The series `moving` with rates that are at least these. A second rate also counts as the first
/// rate to which it leads while it moves the number by about `size`.
models::Series with_terms(const models::Series& moving, double size, double rate = 0,
                          double second_rate = 0) {
  models::Series terms = moving;
  terms.c[2] = std::max(std::abs(moving.c[2]), second_rate / 2);
  terms.c[1] = std::max({std::abs(moving.c[1]), rate, std::sqrt(2 * terms.c[2] * size)});
  return terms;
}

bool moves(const models::Series& number) { return number.c[1] != 0 || number.c[2] != 0; }

/// A feature that moves on a link in any direction counts as moving along the link's lengths.
void add_dimensions(const Values::GroupNumbers& numbers, const ShapeSpeed& speed, double reach,
                    models::FlatSeries& dimensions) {
  const double along = std::max(speed.along, reach * speed.turn);
  const double turn_twice = speed.turn_twice + speed.turn * speed.turn;
  const double along_twice = speed.along_twice + speed.turn * along + reach * turn_twice;
  std::size_t place = 0;
  for (const bool is_angle : numbers.is_angle) {
    for (int part = is_angle ? 2 : 1; part > 0; --part, ++place) {
      models::Series& number = dimensions[place];
      if (moves(number)) {
        number = is_angle ? with_terms(number, 1, speed.turn, turn_twice)
                          : with_terms(number, reach, along, along_twice);
      }
    }
  }
}

void add_inputs(const Values::GroupNumbers& numbers, double reach, models::FlatSeries& inputs) {
  std::size_t place = 0;
  for (const values::HeldJoint& joint : numbers.held) {
    const std::size_t direction = place + 2;
    const std::size_t end = joint.prismatic ? direction + 2 : direction;
    for (; place < end; ++place) {
      inputs[place] = with_terms(inputs[place], place < direction ? reach : 1);
    }
  }
}

}  // namespace

MotionTerms motion_terms(const GroupModel& model, const Values::GroupNumbers& numbers,
                         const ShapeSpeed& speed, const models::FlatSeries& d,
                         const models::FlatSeries& u, const models::FlatVariables& q) {
  MotionTerms terms{d, u};
  const double reach = reach_of(model, numbers, q);
  add_dimensions(numbers, speed, reach, terms.d);
  add_inputs(numbers, reach, terms.u);
  return terms;
}

}  // namespace assur::mechanism::solve
