// Runs a sweep and keeps what it reports, for comparison with other runs of the same scene.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "scene/sweep.hpp"

namespace assur::test {

struct SweepRowKept {
  int step, configuration, branch;
  double parameter;
  Eigen::VectorXd pose;   ///< x, y, cos, sin of every link
  Eigen::VectorXd slope;  ///< its derivative with respect to the swept parameter
};

struct SweepEventKept {
  int step;
  std::string text;
  double parameter;
  double residual;
  Eigen::VectorXd pose;

  [[nodiscard]] std::string kind() const { return text.substr(0, text.find(' ')); }
};

struct SweepKept {
  std::vector<SweepRowKept> rows;
  std::vector<SweepEventKept> events;
  int steps = 0;

  /// Branch by step and configuration.
  [[nodiscard]] std::map<std::pair<int, int>, int> branches() const {
    std::map<std::pair<int, int>, int> result;
    for (const SweepRowKept& row : rows) {
      result[{row.step, row.configuration}] = row.branch;
    }
    return result;
  }
  [[nodiscard]] int count_of(const std::string& kind) const {
    int count = 0;
    for (const SweepEventKept& event : events) {
      count += event.kind() == kind ? 1 : 0;
    }
    return count;
  }
};

/// Every pair of a row and one of the next step.
inline std::vector<std::pair<const SweepRowKept*, const SweepRowKept*>> neighbours(
    const SweepKept& kept) {
  std::vector<std::pair<const SweepRowKept*, const SweepRowKept*>> result;
  for (std::size_t one = 0; one < kept.rows.size(); ++one) {
    const int step = kept.rows[one].step;
    for (std::size_t other = one; other < kept.rows.size() && kept.rows[other].step <= step + 1;
         ++other) {
      if (kept.rows[other].step == step + 1) {
        result.emplace_back(&kept.rows[one], &kept.rows[other]);
      }
    }
  }
  return result;
}

inline SweepKept run_sweep(const generator::Scene& scene) {
  SweepKept kept;
  const auto coordinates = [&](const generator::SweepRecord& record, bool slopes) {
    Eigen::VectorXd values(4 * static_cast<Eigen::Index>(record.state->links.size()));
    Eigen::Index row = 0;
    const auto add = [&](const generator::Dual& coordinate) {
      values(row++) =
          slopes ? coordinate.derivatives()(scene.sweep->parameter) : coordinate.value();
    };
    for (const generator::LinkState& link : record.state->links) {
      add(link.x);
      add(link.y);
      add(link.direction.cos);
      add(link.direction.sin);
    }
    return values;
  };
  const auto record = [&](const generator::SweepRecord& at) {
    const double parameter =
        at.values->parameters()[static_cast<std::size_t>(scene.sweep->parameter)].value();
    if (at.event.empty()) {
      kept.rows.push_back({at.step, at.configuration, at.branch, parameter, coordinates(at, false),
                           coordinates(at, true)});
    } else {
      kept.events.push_back(
          {at.step, at.event, parameter, at.state->residual, coordinates(at, false)});
    }
  };
  generator::sweep(
      scene, {record, [](const generator::Solution&) {}, [&](int done) { kept.steps = done; }});
  return kept;
}

/// The same scene with another number of steps.
inline SweepKept run_sweep(generator::Scene scene, int count) {
  scene.sweep->count = count;
  return run_sweep(scene);
}

/// How a sweep with few steps differs from one with `factor` times as many.
struct SweepDifference {
  int joins = 0;       ///< neighbouring samples on one branch, in the sweep with few steps
  int jumps = 0;       ///< of these, on different branches in the other sweep
  int breaks = 0;      ///< neighbouring samples on one branch in the other sweep alone
  int missed = 0;      ///< events of the other sweep less those of this one
  int mismatched = 0;  ///< samples with other configurations

  void add(const SweepDifference& other) {
    joins += other.joins;
    jumps += other.jumps;
    breaks += other.breaks;
    missed += other.missed;
    mismatched += other.mismatched;
  }
};

inline SweepDifference difference(const SweepKept& few, const SweepKept& many, int factor) {
  SweepDifference result;
  const auto many_branches = many.branches();
  for (const SweepRowKept& row : few.rows) {
    result.mismatched += many_branches.count({row.step * factor, row.configuration}) == 0 ? 1 : 0;
  }
  for (const auto& [row, next] : neighbours(few)) {
    const auto there = many_branches.find({row->step * factor, row->configuration});
    const auto later = many_branches.find({next->step * factor, next->configuration});
    const bool joined = row->branch == next->branch;
    const bool truly = there != many_branches.end() && later != many_branches.end() &&
                       later->second == there->second;
    result.joins += joined ? 1 : 0;
    result.jumps += joined && !truly ? 1 : 0;
    result.breaks += truly && !joined ? 1 : 0;
  }
  result.missed = static_cast<int>(many.events.size()) - static_cast<int>(few.events.size());
  return result;
}

}  // namespace assur::test
