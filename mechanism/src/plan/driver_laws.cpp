#include "driver_laws.hpp"

#include <assur/text/names.hpp>

#include "description/order_of_needs.hpp"

namespace assur::mechanism::plan {

std::vector<JointIndex> joints_in_law(const Mechanism& mechanism, DriverIndex driver) {
  return mechanism.numbers()[mechanism.drivers()[driver].position].formula.joints();
}

std::vector<DriverIndex> laws_in_order(const Mechanism& mechanism) {
  const auto needed_by = [&](DriverIndex driver) {
    std::vector<DriverIndex> read;
    for (const JointIndex joint : joints_in_law(mechanism, driver)) {
      if (const DriverIndex other = mechanism.driver_of(joint); other.exists()) {
        read.push_back(other);
      }
    }
    return read;
  };
  const auto refuse = [&](const std::vector<DriverIndex>& circle) {
    std::vector<std::string> names;
    for (const DriverIndex driver : circle) {
      names.push_back(mechanism.joints()[mechanism.drivers()[driver].joint].name);
    }
    throw MechanismError("drivers." + names[0] + ".position",
                         names.size() == 1 ? "the law reads its own joint; let it read another one"
                                           : "the laws of the joints " + text::listed(names) +
                                                 " read one another in a circle; "
                                                 "let one of them not read the others");
  };
  return description::order_of_needs<DriverIndex>(mechanism.drivers().size(), needed_by, refuse);
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
