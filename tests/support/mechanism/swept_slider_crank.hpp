// A slider-crank with a sweep, in a given unit of length and with given names.
#pragma once

#include <assur/mechanism/mechanism.hpp>
#include <assur/mechanism/request.hpp>
#include <string>

namespace assur::test {

/// A slider-crank with a swept crank and odd names, its lengths in any unit.
struct Made {
  mechanism::Mechanism mechanism;
  mechanism::Request request;
};
inline Made slider_crank(double unit, const std::string& mark = "") {
  Made made{mechanism::Mechanism("one & <two> \"three\" \x01" + mark), {}};
  mechanism::Mechanism& m = made.mechanism;
  m.set_unit(mark);
  m.add_parameter("phi", "40*deg");
  m.add_link("ground");
  m.add_point("ground.A", 3 * unit, -2 * unit);
  m.add_line("ground.bore", 0, 12 * unit, 1, 0.125);
  m.add_link("crank" + mark);
  m.add_point("crank" + mark + ".A", 0, 0);
  m.add_point("crank" + mark + ".B", 50 * unit, 0);
  m.add_link("rod");
  m.add_point("rod.B", 0, 0);
  m.add_point("rod.C", 160 * unit, 0);
  m.add_link("piston");
  m.add_point("piston.C", 0, 0);
  m.add_line("piston.axis", 0, 0, 1, 0);
  m.add_joint("A", mechanism::JointType::revolute, {"ground.A", "crank" + mark + ".A"});
  m.add_joint("B" + mark, mechanism::JointType::revolute, {"crank" + mark + ".B", "rod.B"});
  m.add_joint("C", mechanism::JointType::revolute, {"rod.C", "piston.C"});
  m.add_joint("S", mechanism::JointType::prismatic, {"ground.bore", "piston.axis"});
  m.add_driver("A", "phi");
  m.add_output("P" + mark, "rod.C");
  made.request.sweep = mechanism::Sweep{m.parameter_named("phi"), m.add_number(0, "sweep.from"),
                                        m.add_number("2*pi", "sweep.to"), 61};
  return made;
}

}  // namespace assur::test
