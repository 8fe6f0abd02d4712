// Campaign of all configurations over a grid of parameter values.
#include <algorithm>
#include <assur/text/quoted.hpp>
#include <memory>

#include "outcome.hpp"

namespace assur::mechanism::campaign {

namespace {

std::uint64_t cells_of(const std::vector<GridAxis>& axes) {
  double cells = 1;
  for (const GridAxis& axis : axes) {
    cells *= static_cast<double>(axis.count);
  }
  if (cells > static_cast<double>(most_cells)) {
    throw MechanismError("",
                         "the grid has more than 1e8 cells; take coarser axes, or a part "
                         "of their range");
  }
  return static_cast<std::uint64_t>(cells);
}

/// Solves one cell after the other in the same memory.
class GridWorker {
 public:
  GridWorker(std::shared_ptr<const Plan> plan, const std::vector<GridAxis>& axes)
      : plan_(std::move(plan)), axes_(axes), values_(plan_->values()) {
    for (const GridAxis& axis : axes) {
      place_.emplace_back(axis.parameter, axis.from);
    }
  }

  void add_rows(std::uint64_t cell, std::vector<double>& rows) {
    std::uint64_t rest = cell;
    for (std::size_t axis = axes_.size(); axis-- > 0;) {
      place_[axis].second = value_at(axes_[axis], rest % axes_[axis].count);
      rest /= axes_[axis].count;
    }
    const std::optional<Outcome> nothing = solve();
    const std::size_t count = nothing ? 0 : solution_.configurations.size();
    const auto add_head = [&](std::size_t number, Outcome outcome) {
      rows.push_back(static_cast<double>(cell));
      for (const auto& [parameter, value] : place_) {
        rows.push_back(value);
      }
      const std::size_t families = outcome == Outcome::refused ? 0 : solution_.families.size();
      for (const std::size_t whole : {count, families, number}) {
        rows.push_back(static_cast<double>(whole));
      }
      rows.push_back(static_cast<double>(outcome));
    };
    if (nothing) {
      add_head(0, *nothing);
      add_outputs(plan_->mechanism(), nullptr, rows);
    }
    for (std::size_t number = 0; number < count; ++number) {
      const Configuration& configuration = solution_.configurations[number];
      add_head(number + 1, outcome_of(configuration));
      add_outputs(plan_->mechanism(), &configuration, rows);
    }
  }

 private:
  /// Solves the cell. Returns its outcome if it has no configurations.
  std::optional<Outcome> solve() {
    try {
      values_.set(place_);
      plan_->solve(values_, solution_);
    } catch (const MechanismError&) {
      return Outcome::refused;
    }
    return solution_.configurations.empty()
               ? std::optional(outcome_without_configurations(solution_))
               : std::nullopt;
  }

  std::shared_ptr<const Plan> plan_;
  std::vector<GridAxis> axes_;
  Values values_;
  Solution solution_;
  std::vector<std::pair<ParameterIndex, double>> place_;
};

}  // namespace

}  // namespace assur::mechanism::campaign

namespace assur::mechanism {

double value_at(const GridAxis& axis, std::uint64_t place) {
  if (place == 0 || place + 1 == axis.count) {
    return place == 0 ? axis.from : axis.to;
  }
  const double share = static_cast<double>(place) / static_cast<double>(axis.count - 1);
  return axis.from + (axis.to - axis.from) * share;
}

Campaign grid_campaign(const Mechanism& mechanism, const Request& request,
                       const std::vector<GridAxis>& axes) {
  Campaign campaign{{{"cell", Column::Kind::whole}}, campaign::cells_of(axes), {}};
  for (auto axis = axes.begin(); axis != axes.end(); ++axis) {
    const std::string& name = mechanism.parameters()[axis->parameter].name;
    if (std::find_if(axes.begin(), axis, [axis](const GridAxis& other) {
          return other.parameter == axis->parameter;
        }) != axis) {
      throw MechanismError("", "the parameter " + text::in_quotes(name) +
                                   " is on two axes of the grid; leave one out");
    }
    campaign.columns.push_back({name, Column::Kind::real});
  }
  const auto plan = std::make_shared<const Plan>(mechanism, campaign::positions_alone(request));
  for (const char* name : {"configurations", "families", "configuration"}) {
    campaign.columns.push_back({name, Column::Kind::whole});
  }
  campaign.columns.push_back({"outcome", Column::Kind::outcome});
  campaign::add_output_columns(plan->mechanism(), campaign.columns);
  campaign.worker = [plan, axes] {
    return [worker = std::make_shared<campaign::GridWorker>(plan, axes)](
               std::uint64_t cell, std::vector<double>& rows) { worker->add_rows(cell, rows); };
  };
  return campaign;
}

}  // namespace assur::mechanism
