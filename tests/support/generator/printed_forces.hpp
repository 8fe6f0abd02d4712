// Code that prints the forces in an emitted solver's state, and the reader of its output.
#pragma once

#include <assur/mechanism/forces.hpp>
#include <assur/text/identifiers.hpp>

#include "generator/printed_states.hpp"

namespace assur::test {

/// The forces in the first configuration, which show what forces are reported at all.
inline mechanism::Forces forces_in(const Solved& scene) {
  return scene.configurations().empty()
             ? mechanism::Forces{}
             : mechanism::forces_of(scene.values, scene.configurations().front());
}

/// C++ that prints every number of forces in a state `s`: efforts, the force on each link of each
/// joint, in order, with a slide's couple, and the resultant on the ground.
inline std::string code_that_prints_forces(const Solved& scene) {
  const mechanism::Mechanism& mechanism = scene.plan.mechanism();
  std::string code;
  const auto print_vector = [&code](const std::string& vector) {
    code += printing(vector + "(0)") + printing(vector + "(1)");
  };
  for (const mechanism::Driver& driver : mechanism.drivers()) {
    code += printing("s.efforts." +
                     text::member_names({mechanism.joints()[driver.joint].name}, {}).front());
  }
  const mechanism::Forces forces = forces_in(scene);
  std::vector<std::string> names;
  for (const mechanism::JointForce& joint : forces.joints) {
    names.push_back(joint.joint);
  }
  const std::vector<std::string> members = text::member_names(names, {"members"});
  for (std::size_t place = 0; place < members.size(); ++place) {
    const mechanism::JointForce& joint = forces.joints[place];
    const std::string member = "s.forces." + members[place];
    std::vector<std::string> links;
    for (const auto& [link, force] : joint.on) {
      links.push_back(mechanism.links()[link].name);
    }
    if (links.size() > 2) {
      for (const std::string& link : text::member_names(links, {"members"})) {
        print_vector(member + "." + link);
      }
    } else if (joint.has_moment) {
      print_vector(member + ".force");
      code += printing(member + ".moment");
    } else {
      print_vector(member);
    }
  }
  print_vector("s.ground.force");
  return code + printing("s.ground.moment");
}

/// What a solver told of one configuration.
inline mechanism::Forces read_forces(std::istream& printed, const Solved& scene) {
  const auto vector = [&printed] {
    const double x = read_number(printed);
    return Eigen::Vector2d(x, read_number(printed));
  };
  mechanism::Forces forces = forces_in(scene);
  for (double& effort : forces.efforts) {
    effort = read_number(printed);
  }
  for (mechanism::JointForce& joint : forces.joints) {
    if (joint.on.size() > 2) {
      for (auto& [link, force] : joint.on) {
        force = vector();
      }
    } else {
      joint.on[1].second = vector();
      joint.on[0].second = -joint.on[1].second;
      joint.moment = joint.has_moment ? read_number(printed) : 0;
    }
  }
  forces.ground.force = vector();
  forces.ground.moment = read_number(printed);
  return forces;
}

/// A reported number, with the name of its part. A vector is two of them.
struct ToldNumber {
  std::string of;
  double value;
};

/// All numbers of some forces.
inline std::vector<ToldNumber> numbers_of(const mechanism::Forces& forces) {
  std::vector<ToldNumber> numbers;
  for (const double effort : forces.efforts) {
    numbers.push_back({"effort", effort});
  }
  for (const mechanism::JointForce& joint : forces.joints) {
    for (const auto& [link, force] : joint.on) {
      numbers.push_back({joint.joint, force.x()});
      numbers.push_back({joint.joint, force.y()});
    }
    numbers.push_back({joint.joint, joint.moment});
  }
  for (const double part :
       {forces.ground.force.x(), forces.ground.force.y(), forces.ground.moment}) {
    numbers.push_back({"ground", part});
  }
  return numbers;
}

}  // namespace assur::test
