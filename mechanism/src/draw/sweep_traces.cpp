#include "draw/sweep_traces.hpp"

#include <algorithm>
#include <assur/mechanism/sweep.hpp>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>

namespace assur::mechanism::draw {

namespace {

/// The number of pieces of a curve, enough for a smooth appearance, whatever the steps of the
/// scene's own table are.
constexpr int pieces = 180;

class WayFollower {
 public:
  WayFollower(const Mechanism& mechanism, const Request& request,
              const std::vector<int>& configurations)
      : mechanism_(mechanism), request_(request), configurations_(configurations) {
    swept_.reaches.assign(configurations.size(), Reaches(mechanism.joints().size()));
  }

  SweepTraces followed() {
    const Plan plan(mechanism_, request_);
    const Values values = plan.values();
    const double from = values.value_of(request_.sweep->from);
    const double to = values.value_of(request_.sweep->to);
    const double here = values.parameter(request_.sweep->parameter);
    const bool one_alone = plan.most_configurations() > most_followed;
    if (request_.sweep->count < 2 || from == to || (one_alone && configurations_.size() > 1)) {
      return std::move(swept_);
    }
    one_alone_ = one_alone;
    const double part = (here - from) / (to - from);
    if (!(part >= 0 && part <= 1)) {
      if (!one_alone) {
        follow(from, to, pieces);
      }
      return std::move(swept_);
    }
    // A branch has the number of its configuration at the start of its sweep, so it is followed
    // from there in both directions.
    starts_here_ = true;
    follow(here, from, static_cast<int>(std::lround(part * pieces)));
    for (Trace& trace : swept_.traces) {
      std::reverse(trace.points.begin(), trace.points.end());
    }
    open_ = first_;
    last_step_.clear();
    follow(here, to, static_cast<int>(std::lround((1 - part) * pieces)));
    return std::move(swept_);
  }

 private:
  using TraceKey = std::pair<int, OutputIndex>;

  void follow(double from, double to, int steps) {
    if (from == to) {
      return;
    }
    Mechanism mechanism = mechanism_;
    Request request = request_;
    request.want = {true, false, false, false};
    request.covariance.reset();
    request.sweep->from = mechanism.add_number(from, "sweep.from");
    request.sweep->to = mechanism.add_number(to, "sweep.to");
    request.sweep->count = std::max(steps, 4) + 1;
    const Plan plan(mechanism, request);
    SweepObserver observer;
    observer.record = [&](const SweepRecord& row) {
      row.event.empty() ? add_row(plan, row) : add_event(plan, row);
    };
    if (one_alone_) {
      (void)sweep_branch(plan, static_cast<std::size_t>(configurations_[0]), observer);
    } else {
      (void)sweep(plan, observer);
    }
  }

  /// The index of a branch among the drawn configurations; their count if it is not among them.
  [[nodiscard]] std::size_t place_of(int branch) const {
    return static_cast<std::size_t>(
        std::find(configurations_.begin(), configurations_.end(), branch) -
        configurations_.begin());
  }

  void add_row(const Plan& plan, const SweepRecord& row) {
    const std::size_t place = place_of(row.branch);
    if (starts_here_ && place == configurations_.size()) {
      return;
    }
    if (starts_here_) {
      include_displacements(mechanism_, plan.mechanism(), *row.state, swept_.reaches[place]);
    }
    const auto last = last_step_.find(row.branch);
    const bool goes_on = last == last_step_.end() ? row.step == 0 : row.step == last->second + 1;
    last_step_[row.branch] = row.step;
    for (const OutputIndex output : plan.mechanism().outputs().keys()) {
      const TraceKey key(row.branch, output);
      const auto open = open_.find(key);
      if (open == open_.end() || !goes_on) {
        open_[key] = swept_.traces.size();
        swept_.traces.push_back(
            {starts_here_ ? row.branch : 0, plan.mechanism().outputs()[output].name, {}});
        if (row.step == 0) {
          first_[key] = open_[key];
        }
      } else if (row.step == 0) {
        continue;  // the other half has this point already
      }
      swept_.traces[open_[key]].points.push_back(row.state->outputs[output].position);
    }
  }

  void add_event(const Plan& plan, const SweepRecord& row) {
    const auto [kind, branches] = parts_of_event(row.event);
    Mark mark{kind, row.parameter, {}, {}};
    for (const int branch : branches) {
      if (!starts_here_ || place_of(branch) < configurations_.size()) {
        mark.configurations.push_back(starts_here_ ? branch : 0);
      }
    }
    for (const Point& point : row.state->outputs) {
      if (!point.position.allFinite()) {
        return;  // at an escape the points are at infinity
      }
      mark.points.push_back(point.position);
    }
    if (mark.configurations.empty()) {
      return;
    }
    for (const OutputIndex output : plan.mechanism().outputs().keys()) {
      for (const int branch : branches) {
        const auto open = open_.find(TraceKey(branch, output));
        if (kind == "fold" && open != open_.end()) {
          swept_.traces[open->second].points.push_back(mark.points[output.place()]);
        }
      }
    }
    const bool is_new =
        std::none_of(swept_.marks.begin(), swept_.marks.end(), [&](const Mark& one) {
          return one.event == mark.event && one.parameter == mark.parameter &&
                 one.configurations == mark.configurations;
        });
    if (is_new) {
      swept_.marks.push_back(std::move(mark));
    }
  }

  const Mechanism& mechanism_;
  const Request& request_;
  const std::vector<int>& configurations_;
  bool starts_here_ = false;
  bool one_alone_ = false;
  SweepTraces swept_;
  std::map<TraceKey, std::size_t> open_, first_;  ///< those that continue, and that begin here
  std::map<int, int> last_step_;
};

}  // namespace

std::pair<std::string, std::vector<int>> parts_of_event(const std::string& event) {
  std::vector<int> branches;
  for (std::size_t at = event.find(' '); at != std::string::npos; at = event.find(' ', at + 1)) {
    const std::string word = event.substr(at + 1, event.find(' ', at + 1) - at - 1);
    if (!word.empty() && std::isdigit(static_cast<unsigned char>(word[0])) != 0) {
      branches.push_back(std::stoi(word));
    }
  }
  return {event.substr(0, event.find(' ')), branches};
}

SweepTraces traces_of_sweep(const Mechanism& mechanism, const Request& request,
                            const std::vector<int>& configurations) {
  WayFollower follower(mechanism, request, configurations);
  return request.sweep ? follower.followed()
                       : SweepTraces{{},
                                     {},
                                     std::vector<Reaches>(configurations.size(),
                                                          Reaches(mechanism.joints().size()))};
}

}  // namespace assur::mechanism::draw
