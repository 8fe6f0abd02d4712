// Errors and failures of each method, family and distance: the rows of the stability table.
#pragma once

#include <string>
#include <vector>

#include "measure.hpp"

namespace assur::stability {

/// One method on all members of one family at one distance.
struct Row {
  std::string family;
  std::string title;
  std::string method;
  double distance = 0;
  double condition = 0;  ///< of J, the largest of the members
  /// The largest error over the members with a right answer, by quantity: against the assembled
  /// configuration, and against the configuration as given.
  std::array<double, 3> error{};
  std::array<double, 3> error_as_given{};
  std::array<int, 3> wrong{};  ///< members, by quantity
  int wrong_members = 0;       ///< in any quantity
  int refused_members = 0;
  bool has_sensitivities = true;
  Status status = Status::ok;  ///< the worst reported

  [[nodiscard]] double largest_error() const {
    return *std::max_element(error.begin(), error.end());
  }
  [[nodiscard]] int right_members() const {
    return members_per_distance - wrong_members - refused_members;
  }
};

/// Adds one method's answer for one member to its row.
template <typename Model>
void tally(const Answer<Model>& answer, const Member<Model>& member, Row& row) {
  row.status = std::max(row.status, answer.status);
  row.has_sensitivities = answer.has_sensitivities;
  if (!is_solvable(answer.status)) {
    ++row.refused_members;
    return;
  }
  bool any_wrong = false;
  for (const Quantity quantity : quantities) {
    if (!has(answer, quantity)) {
      continue;
    }
    const auto place = static_cast<std::size_t>(quantity);
    const double error = error_of(answer, member.truth, quantity);
    if (is_wrong(error)) {
      ++row.wrong[place];
      any_wrong = true;
      continue;
    }
    const double as_given = error_of(answer, member.truth_as_given, quantity);
    row.error[place] = std::max(row.error[place], error);
    row.error_as_given[place] = std::max(row.error_as_given[place], as_given);
  }
  row.wrong_members += any_wrong ? 1 : 0;
}

template <typename Family>
void append_rows(std::vector<Row>& rows) {
  using Model = typename Family::Model;
  const auto list = methods<Model>();
  for (const double distance : distances<Family>()) {
    std::vector<Row> of_methods(list.size());
    double condition = 0;
    for (int number = 0; number < members_per_distance; ++number) {
      const Member<Model> member = make_member<Family>(number, distance);
      condition = std::max(condition, member.truth.condition);
      for (std::size_t method = 0; method < list.size(); ++method) {
        tally(list[method].answer(member.given), member, of_methods[method]);
      }
    }
    for (std::size_t method = 0; method < list.size(); ++method) {
      Row& row = of_methods[method];
      row.family = Family::name;
      row.title = Family::title;
      row.method = list[method].name;
      row.distance = distance;
      row.condition = condition;
      rows.push_back(row);
    }
  }
}

[[nodiscard]] inline std::vector<Row> all_rows() {
  std::vector<Row> rows;
  std::apply([&](auto... family) { (append_rows<decltype(family)>(rows), ...); }, Families{});
  return rows;
}

}  // namespace assur::stability
