// Runs a sweep and keeps what it reports, for comparison with other runs of the same scene.
#pragma once

#include <algorithm>
#include <assur/mechanism/scene_file.hpp>
#include <assur/mechanism/sweep.hpp>
#include <map>
#include <string>
#include <vector>

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

inline SweepKept run_sweep(const mechanism::Scene& scene) {
  SweepKept kept;
  const mechanism::Plan plan(scene);
  const mechanism::Values values = plan.values();
  const auto& columns = values.columns();
  const auto found = std::find(columns.begin(), columns.end(), scene.request.sweep->parameter);
  const Eigen::Index column = found - columns.begin();
  const auto pose_of = [](const mechanism::SweepRecord& record) {
    Eigen::VectorXd pose(4 * static_cast<Eigen::Index>(record.state->links.size()));
    Eigen::Index row = 0;
    for (const mechanism::Frame& link : record.state->links) {
      const Direction<double>& direction = link.pose.direction;
      pose.segment<4>(row) << link.pose.x, link.pose.y, direction.cos, direction.sin;
      row += 4;
    }
    return pose;
  };
  const auto slope_of = [&](const mechanism::SweepRecord& record) {
    Eigen::VectorXd slope(4 * static_cast<Eigen::Index>(record.state->links.size()));
    Eigen::Index row = 0;
    for (const mechanism::Frame& link : record.state->links) {
      const Direction<double>& direction = link.pose.direction;
      const Eigen::Vector3d rate = link.follows.first.col(column);
      slope.segment<4>(row) << rate(0), rate(1), -direction.sin * rate(2), direction.cos * rate(2);
      row += 4;
    }
    return slope;
  };
  const auto record = [&](const mechanism::SweepRecord& at) {
    if (at.event.empty()) {
      kept.rows.push_back(
          {at.step, at.configuration, at.branch, at.parameter, pose_of(at), slope_of(at)});
    } else {
      kept.events.push_back({at.step, at.event, at.parameter, at.state->residual, pose_of(at)});
    }
  };
  mechanism::sweep(plan, {record, [](double, const mechanism::Solution&) {},
                          [&](int done) { kept.steps = done; }});
  return kept;
}

/// The same scene with another number of steps.
inline SweepKept run_sweep(mechanism::Scene scene, int count) {
  scene.request.sweep->count = count;
  return run_sweep(scene);
}

/// The differences of a sweep with few steps from one with `factor` times as many.
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
    result.mismatched += many_branches.contains({row.step * factor, row.configuration}) ? 0 : 1;
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
