#include "elimination/record.hpp"

namespace assur::generator::elimination {

GiNaC::symbol RecordedStep::record(const std::string& name, const GiNaC::ex& value,
                                   const std::string& meaning) {
  quantities.push_back({GiNaC::symbol(name), value, meaning});
  return quantities.back().symbol;
}

equations::Vector2 RecordedStep::record(const std::string& name, const equations::Vector2& value,
                                        const std::string& meaning) {
  const auto component = [&](const std::string& axis, const GiNaC::ex& part) -> GiNaC::ex {
    return equations::is_plain(part) ? part
                                     : record(name + "_" + axis, part, meaning + ", " + axis);
  };
  const GiNaC::ex x = component("x", value.x);
  return {x, component("y", value.y)};
}

void RecordedStep::record_equation(const std::string& name, const GiNaC::ex& value,
                                   const std::string& meaning) {
  quantities.push_back({GiNaC::symbol(name), value, meaning, true});
}

}  // namespace assur::generator::elimination
