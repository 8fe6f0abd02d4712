#include "driver_laws.hpp"

#include <algorithm>
#include <assur/text/names.hpp>

namespace assur::mechanism::plan {

namespace {

class LawOrder {
 public:
  explicit LawOrder(const Mechanism& mechanism)
      : mechanism_(mechanism), marks_(mechanism.drivers().size(), Mark::untouched) {
    for (const DriverIndex driver : mechanism.drivers().keys()) {
      settle(driver);
    }
  }

  [[nodiscard]] std::vector<DriverIndex> take() { return std::move(order_); }

 private:
  enum class Mark : unsigned char { untouched, open, known };

  /// Puts a driver behind those whose laws its own law reads. The list of open drivers stands in
  /// for recursion, which a long chain of laws would exhaust.
  void settle(DriverIndex first) {
    open_ = {first};
    while (!open_.empty()) {
      const DriverIndex driver = open_.back();
      if (marks_[driver] == Mark::known) {
        open_.pop_back();
        continue;
      }
      marks_[driver] = Mark::open;
      if (const DriverIndex unsettled = first_unsettled(driver); unsettled.exists()) {
        open_.push_back(unsettled);
        if (marks_[unsettled] == Mark::open) {
          refuse();
        }
      } else {
        marks_[driver] = Mark::known;
        order_.push_back(driver);
        open_.pop_back();
      }
    }
  }

  /// The first of the drivers whose laws a law reads that has no place in the order yet.
  [[nodiscard]] DriverIndex first_unsettled(DriverIndex driver) const {
    for (const JointIndex joint : joints_in_law(mechanism_, driver)) {
      const DriverIndex read = mechanism_.driver_of(joint);
      if (read.exists() && marks_[read] != Mark::known) {
        return read;
      }
    }
    return {};
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
                                                 "let one of them not read the others");
  }
  [[nodiscard]] const std::string& name_of(DriverIndex driver) const {
    return mechanism_.joints()[mechanism_.drivers()[driver].joint].name;
  }

  const Mechanism& mechanism_;
  Table<DriverIndex, Mark> marks_;
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
  Table<JointIndex, bool> is_driven(mechanism.joints().size(), false);
  for (const Driver& other : mechanism.drivers()) {
    is_driven[other.joint] = true;
  }
  std::erase_if(result, [&](JointIndex read) { return is_driven[read]; });
  return result;
}

}  // namespace assur::mechanism::plan

namespace assur::mechanism {

std::vector<JointIndex> joints_in_laws(const Mechanism& mechanism, DriverIndex driver) {
  Table<JointIndex, DriverIndex> driver_of(mechanism.joints().size());
  for (const DriverIndex other : mechanism.drivers().keys()) {
    driver_of[mechanism.drivers()[other].joint] = other;
  }
  std::vector<JointIndex> result = plan::joints_in_law(mechanism, driver);
  Table<JointIndex, bool> is_found(mechanism.joints().size(), false);
  for (const JointIndex joint : result) {
    is_found[joint] = true;
  }
  for (std::size_t place = 0; place < result.size(); ++place) {
    if (const DriverIndex other = driver_of[result[place]]; other.exists()) {
      for (const JointIndex joint : plan::joints_in_law(mechanism, other)) {
        if (!is_found[joint]) {
          is_found[joint] = true;
          result.push_back(joint);
        }
      }
    }
  }
  return result;
}

}  // namespace assur::mechanism
