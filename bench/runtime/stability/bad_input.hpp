// The response of each method to inputs that are NaN or infinite.
#pragma once

#include <string>
#include <vector>

#include "measure.hpp"

namespace assur::stability {

/// One method on a geometry with one number replaced.
struct BadInputRow {
  std::string method;
  std::string input;
  Status status = Status::ok;
  bool finite = false;  ///< whether all numbers of the velocity returned are finite
};

[[nodiscard]] inline std::vector<BadInputRow> bad_input_rows() {
  using Model = Model01;
  struct Spoilt {
    const char* name;
    Geometry<Model, double> geometry;
  };
  const Geometry<Model, double> sound = make_member<ZeroBar>(0, 1).given;
  std::vector<Spoilt> list(4, Spoilt{"", sound});
  list[0].name = "dimension NaN";
  list[0].geometry.d.CD = std::numeric_limits<double>::quiet_NaN();
  list[1].name = "input infinite";
  list[1].geometry.u.x_B = std::numeric_limits<double>::infinity();
  list[2].name = "configuration NaN";
  list[2].geometry.q.theta_GF.sin = std::numeric_limits<double>::quiet_NaN();
  list[3].name = "rate NaN";
  list[3].geometry.u_rate(0) = std::numeric_limits<double>::quiet_NaN();
  std::vector<BadInputRow> rows;
  for (const Method<Model>& method : methods<Model>()) {
    for (const Spoilt& spoilt : list) {
      const Answer<Model> answer = method.answer(spoilt.geometry);
      rows.push_back({method.name, spoilt.name, answer.status, answer.motion.velocity.allFinite()});
    }
  }
  return rows;
}

}  // namespace assur::stability
