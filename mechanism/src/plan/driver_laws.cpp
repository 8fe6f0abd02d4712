#include "driver_laws.hpp"

#include <algorithm>
#include <assur/text/names.hpp>

namespace assur::mechanism::plan {

namespace {

class LawOrder {
 public:
  explicit LawOrder(const Mechanism& mechanism) : mechanism_(mechanism) {
    for (const DriverIndex driver : mechanism.drivers().keys()) {
      settle(driver);
    }
  }

  [[nodiscard]] std::vector<DriverIndex> take() { return std::move(order_); }

 private:
  void settle(DriverIndex driver) {
    if (std::ranges::find(order_, driver) != order_.end()) {
      return;
    }
    const bool is_open = std::ranges::find(open_, driver) != open_.end();
    open_.push_back(driver);
    if (is_open) {
      refuse();
    }
    for (const JointIndex joint : joints_in_law(mechanism_, driver)) {
      if (const DriverIndex read = mechanism_.driver_of(joint); read.exists()) {
        settle(read);
      }
    }
    open_.pop_back();
    order_.push_back(driver);
  }

  [[noreturn]] void refuse() const {
    const auto first = std::ranges::find(open_, open_.back());
    std::vector<std::string> names;
    for (auto driver = first; driver + 1 != open_.end(); ++driver) {
      names.push_back(name_of(*driver));
    }
    throw MechanismError("drivers." + name_of(*first) + ".position",
                         names.size() == 1 ? "the law reads its own joint; let it read another one"
                                           : "the laws of the joints " + text::listed(names) +
                                                 " read one another in a circle; "
                                                 "let one of them read none of the others");
  }
  [[nodiscard]] const std::string& name_of(DriverIndex driver) const {
    return mechanism_.joints()[mechanism_.drivers()[driver].joint].name;
  }

  const Mechanism& mechanism_;
  std::vector<DriverIndex> order_, open_;
};

}  // namespace

std::vector<JointIndex> joints_in_law(const Mechanism& mechanism, DriverIndex driver) {
  return mechanism.numbers()[mechanism.drivers()[driver].position].formula.joints();
}

std::vector<DriverIndex> laws_in_order(const Mechanism& mechanism) {
  return LawOrder(mechanism).take();
}

std::vector<JointIndex> joints_read(const Mechanism& mechanism, DriverIndex driver) {
  std::vector<JointIndex> result = joints_in_laws(mechanism, driver);
  std::erase_if(result, [&](JointIndex read) { return mechanism.driver_of(read).exists(); });
  return result;
}

}  // namespace assur::mechanism::plan

namespace assur::mechanism {

std::vector<JointIndex> joints_in_laws(const Mechanism& mechanism, DriverIndex driver) {
  std::vector<JointIndex> result = plan::joints_in_law(mechanism, driver);
  for (std::size_t place = 0; place < result.size(); ++place) {
    if (const DriverIndex other = mechanism.driver_of(result[place]); other.exists()) {
      for (const JointIndex joint : plan::joints_in_law(mechanism, other)) {
        if (std::ranges::find(result, joint) == result.end()) {
          result.push_back(joint);
        }
      }
    }
  }
  return result;
}

}  // namespace assur::mechanism
