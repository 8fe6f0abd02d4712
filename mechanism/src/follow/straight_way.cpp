#include "straight_way.hpp"

#include <assur/mechanism/sweep.hpp>
#include <map>
#include <string>

namespace assur::mechanism::follow {

namespace {

/// A name that the mechanism does not have yet.
std::string new_name(const Mechanism& mechanism, std::string name) {
  while (index_of(mechanism.parameters(), name).exists()) {
    name += "_";
  }
  return name;
}

}  // namespace

StraightWay::StraightWay(Mechanism mechanism, Request request,
                         const std::vector<ParameterIndex>& changing) {
  const std::string part = new_name(mechanism, "way");
  const ParameterIndex swept = mechanism.add_parameter(part, 0);
  for (const ParameterIndex parameter : changing) {
    const std::string from = new_name(mechanism, "way_from");
    mechanism.add_parameter(from, 0);
    const std::string to = new_name(mechanism, "way_to");
    mechanism.add_parameter(to, 0);
    mechanism.set_parameter(mechanism.parameters()[parameter].name,
                            from + "*(1 - " + part + ") + " + to + "*" + part);
    ends_.push_back({from, to});
  }
  request.want = {true, false, false, false};
  request.covariance.reset();
  request.sweep =
      Sweep{swept, mechanism.add_number(0, "sweep.from"), mechanism.add_number(1, "sweep.to"), 2};
  plan_.emplace(mechanism, request);
}

std::vector<StraightWay::ContinuedPair> StraightWay::branches(
    const Place& from, const Place& to,
    const std::vector<std::pair<std::string, double>>& others) const {
  std::vector<std::pair<std::string, double>> replaced = others;
  for (std::size_t at = 0; at < ends_.size(); ++at) {
    replaced.emplace_back(ends_[at].from, from[at]);
    replaced.emplace_back(ends_[at].to, to[at]);
  }
  std::multimap<int, int> branch_of;  // by the numbers of configurations at the start
  std::map<int, Configuration> end_of;
  SweepObserver observer;
  observer.record = [&](const SweepRecord& record) {
    if (record.branch > 0 && record.step == 0) {
      branch_of.emplace(record.configuration, record.branch);
    } else if (record.branch > 0) {
      end_of.emplace(record.branch, *record.state);
    }
  };
  sweep(*plan_, plan_->values(replaced), observer);
  std::vector<ContinuedPair> result;
  for (const auto& [number, branch] : branch_of) {
    const auto end = end_of.find(branch);
    if (branch_of.count(number) == 1 && end != end_of.end()) {
      result.push_back({number, end->second});
    }
  }
  return result;
}

}  // namespace assur::mechanism::follow
