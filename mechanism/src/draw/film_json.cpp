#include "draw/film_json.hpp"

#include <array>

namespace assur::mechanism::draw {

namespace {

constexpr std::array symbol_names = {"bar",  "plate", "slot", "guide", "block",
                                     "tube", "rod",   "pin",  "tracer"};

}  // namespace

Json film_json(const Mechanism& mechanism, const Request& request, const Film& film,
               const std::function<Json(const std::vector<double>&)>& told) {
  Json shapes = Json::array();
  for (const Shape& shape : film.shapes) {
    shapes.push_back({{"symbol", symbol_names[static_cast<std::size_t>(shape.symbol)]},
                      {"link", shape.link},
                      {"name", shape.name},
                      {"fixed", shape.fixed},
                      {"points", shape.points}});
  }
  Json branches = Json::array();
  for (const FilmedBranch& branch : film.branches) {
    branches.push_back({{"number", branch.number},
                        {"circuit", branch.circuit},
                        {"next", branch.next},
                        {"points", told(branch.points)},
                        {"outputs", told(branch.outputs)},
                        {"spreads", told(branch.spreads)},
                        {"angles", told(branch.angles)},
                        {"transmissions", told(branch.transmissions)},
                        {"forces", told(branch.forces)}});
  }
  Json events = Json::array();
  for (const FilmedEvent& event : film.events) {
    events.push_back(
        {{"event", event.event}, {"branches", event.branches}, {"parameter", event.parameter}});
  }
  Json outputs = Json::array();
  for (const Output& output : mechanism.outputs()) {
    outputs.push_back(output.name);
  }
  Json forces = Json::array();
  for (const FilmedForce& force : film.forces) {
    forces.push_back({{"joint", force.joint}, {"link", force.link}});
  }
  Json parameters = Json::array();
  for (const ParameterIndex index : mechanism.parameters().keys()) {
    const Parameter& parameter = mechanism.parameters()[index];
    const bool is_own = mechanism.numbers()[parameter.value].formula.parameters().empty();
    parameters.push_back(
        {{"name", parameter.name}, {"value", film.parameters[index.place()]}, {"own", is_own}});
  }
  return {{"title", mechanism.name()},
          {"unit", mechanism.unit()},
          {"parameter",
           request.sweep ? mechanism.parameters()[request.sweep->parameter].name : std::string()},
          {"from", film.from},
          {"to", film.to},
          {"count", film.count},
          {"chosen", film.chosen},
          {"left_out", film.left_out},
          {"nearest", film.nearest ? Json(*film.nearest) : Json(nullptr)},
          {"followed", film.is_followed},
          {"points", film.points},
          {"shapes", std::move(shapes)},
          {"outputs", std::move(outputs)},
          {"links", film.links},
          {"transmissions", film.transmissions},
          {"efforts", film.efforts},
          {"forces", std::move(forces)},
          {"parameters", std::move(parameters)},
          {"branches", std::move(branches)},
          {"events", std::move(events)},
          {"spread", request.covariance ? "one deviation" : "tolerances (rss)"}};
}

}  // namespace assur::mechanism::draw
