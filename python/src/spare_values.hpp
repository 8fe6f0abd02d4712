// Reuse of an earlier call's parameter values, which saves most of their cost.
#pragma once

#include <algorithm>
#include <assur/mechanism/plan.hpp>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace assur::python {

using Replaced = std::vector<std::pair<std::string, double>>;

/// If the same parameters are replaced as in an earlier call, only the quantities that depend on
/// them are evaluated again.
class SpareValues {
 public:
  /// Calls `use` with values in which numbers replace some parameters' formulas, and returns its
  /// result. Of threads that call at the same time, all but one construct new values.
  template <typename Use>
  auto with(const mechanism::Plan& plan, const Replaced& replaced, const Use& use) {
    std::optional<Values> values = take(replaced);
    if (values) {
      values->of.set(indexed(plan, replaced));
    } else {
      values.emplace(Values{replaced, plan.values(replaced)});
    }
    auto result = use(std::as_const(values->of));
    const std::scoped_lock lock(mutex_);
    spare_ = std::move(values);
    return result;
  }

 private:
  struct Values {
    Replaced replaced;
    mechanism::Values of;
  };

  [[nodiscard]] std::optional<Values> take(const Replaced& replaced) {
    const std::scoped_lock lock(mutex_);
    const auto same_name = [](const auto& one, const auto& other) {
      return one.first == other.first;
    };
    if (!spare_ || !std::ranges::equal(spare_->replaced, replaced, same_name)) {
      return std::nullopt;
    }
    return std::exchange(spare_, std::nullopt);
  }

  [[nodiscard]] static std::vector<std::pair<mechanism::ParameterIndex, double>> indexed(
      const mechanism::Plan& plan, const Replaced& replaced) {
    std::vector<std::pair<mechanism::ParameterIndex, double>> values;
    values.reserve(replaced.size());
    for (const auto& [name, value] : replaced) {
      values.emplace_back(plan.mechanism().parameter_named(name), value);
    }
    return values;
  }

  std::mutex mutex_;
  std::optional<Values> spare_;
};

}  // namespace assur::python
