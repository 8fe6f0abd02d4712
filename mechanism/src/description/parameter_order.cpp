#include "description/parameter_order.hpp"

#include <algorithm>
#include <iterator>

namespace assur::mechanism::description {

namespace {

class OrderFinder {
 public:
  explicit OrderFinder(const Mechanism& mechanism)
      : mechanism_(mechanism), marks_(mechanism.parameters().size(), Mark::untouched) {
    for (const ParameterIndex parameter : mechanism.parameters().keys()) {
      settle(parameter);
    }
  }

  [[nodiscard]] std::vector<ParameterIndex> order() { return std::move(order_); }

 private:
  enum class Mark : unsigned char { untouched, open, known };

  [[nodiscard]] const Number& number(NumberIndex index) const {
    return mechanism_.numbers()[index];
  }

  /// `open` is a path of parameters, each read by the one before, and its last reads `needed`.
  [[nodiscard]] MechanismError depends_on_itself(const std::vector<ParameterIndex>& open,
                                                 ParameterIndex needed) const {
    const auto& parameters = mechanism_.parameters();
    const auto next = std::next(std::find(open.begin(), open.end(), needed));
    return {number(parameters[needed].value).part,
            "the parameter depends on itself" +
                (next == open.end()
                     ? "; its formula may not name it"
                     : " through '" + parameters[*next].name + "'; give one of them a number")};
  }

  /// Puts a parameter behind those that its formula names. The list of open parameters stands in
  /// for recursion, which a long chain of parameters would exhaust.
  void settle(ParameterIndex first) {
    std::vector<ParameterIndex> open = {first};
    while (!open.empty()) {
      const ParameterIndex parameter = open.back();
      if (marks_[parameter] == Mark::known) {
        open.pop_back();
        continue;
      }
      const Parameter& entry = mechanism_.parameters()[parameter];
      if (!entry.value.exists()) {
        throw MechanismError("parameters." + entry.name, "the parameter has no value; give it one");
      }
      marks_[parameter] = Mark::open;
      bool waits = false;
      for (const ParameterIndex needed : number(entry.value).formula.parameters()) {
        if (marks_[needed] == Mark::open) {
          throw depends_on_itself(open, needed);
        }
        if (marks_[needed] == Mark::untouched) {
          open.push_back(needed);
          waits = true;
          break;
        }
      }
      if (!waits) {
        marks_[parameter] = Mark::known;
        order_.push_back(parameter);
        open.pop_back();
      }
    }
  }

  const Mechanism& mechanism_;
  Table<ParameterIndex, Mark> marks_;
  std::vector<ParameterIndex> order_;
};

}  // namespace

std::vector<ParameterIndex> parameter_order(const Mechanism& mechanism) {
  return OrderFinder(mechanism).order();
}

}  // namespace assur::mechanism::description
