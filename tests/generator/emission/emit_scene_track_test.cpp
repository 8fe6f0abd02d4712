// Law: `track` of an emitted solver stays on a branch of the library's sweep up to its end, goes no
// further, and refuses starts and targets that are on no branch.
#include <gtest/gtest.h>

#include <assur/status.hpp>
#include <set>

#include "generator/solver_comparison.hpp"
#include "whole_campaign.hpp"

namespace assur::test::emit_scene_track_test {
namespace {

using Json = nlohmann::ordered_json;

/// A scene whose first driver is the parameter that is swept.
struct Tracked {
  std::string name;    ///< `FourBar` of the solver
  std::string header;  ///< `four_bar`
  Json scene;
  std::string parameter;
  double from, to;
};

Tracked example(const std::string& stem, const std::string& name) {
  const Json scene = scene_json(std::filesystem::path(ASSUR_EXAMPLES) / (stem + ".json"));
  const double from = 0.1;  // apart from where links are in line
  return {name, stem, scene, scene["sweep"]["parameter"], from, from + 6.28};
}

/// The slider-crank driven at its slide: the crank's dead centres are folds.
Tracked driven_slide() {
  Tracked tracked = example("slider_crank", "DrivenSlide");
  tracked.header = "driven_slide";
  tracked.scene["parameters"]["stroke"] = 150;
  tracked.scene["drivers"] = {{"S", {{"position", "stroke"}, {"velocity", 1}}}};
  tracked.parameter = "stroke";
  tracked.from = 150;
  tracked.to = 230;
  return tracked;
}

/// The scenes to track. By default they have a single dyad, several dyads, slides, a triad and
/// folds.
std::vector<Tracked> tracked_scenes() {
  std::vector<Tracked> scenes = {example("four_bar_coupler_curve", "FourBarCouplerCurve"),
                                 example("shaper_quick_return", "ShaperQuickReturn"),
                                 example("stephenson_triad", "StephensonTriad"), driven_slide()};
  if (is_whole_campaign()) {
    scenes.insert(scenes.end(),
                  {example("jansen_leg", "JansenLeg"), example("slider_crank", "SliderCrank"),
                   example("zhauyt_2017_six_bar", "Zhauyt2017SixBar"),
                   example("quintero_2011_rrp_rrr", "Quintero2011RrpRrr")});
  }
  for (Tracked& tracked : scenes) {
    tracked.scene["want"] = {"position"};
  }
  return scenes;
}

/// `assur solve` of a sweep: the branch of each configuration at each step, and the values of the
/// parameter at which branches end, begin or meet.
struct SweptBranches {
  std::map<std::pair<int, int>, int> branches;  ///< by step and configuration
  std::vector<double> events;

  /// 0 where a configuration belongs to no branch.
  [[nodiscard]] int branch(int step, int configuration) const {
    const auto found = branches.find({step, configuration});
    return found == branches.end() ? 0 : found->second;
  }
};

SweptBranches swept(const Tracked& tracked, int steps, const TemporaryDirectory& directory) {
  Json scene = tracked.scene;
  scene["sweep"] = {{"parameter", tracked.parameter},
                    {"from", tracked.from},
                    {"to", tracked.to},
                    {"count", steps + 1}};
  const auto file = directory.write("swept.json", scene.dump());
  const CommandResult result = run_assur("solve " + file.string() + " --format csv");
  EXPECT_EQ(result.status, 0) << result.messages;
  SweptBranches sweep;
  std::istringstream rows(result.output);
  std::string row;
  std::getline(rows, row);
  EXPECT_TRUE(row.starts_with("step,configuration,branch," + tracked.parameter + ",")) << row;
  while (std::getline(rows, row)) {
    std::istringstream cells(row);
    std::string step;
    std::string configuration;
    std::string branch;
    std::string value;
    std::getline(std::getline(cells, step, ','), configuration, ',');
    std::getline(std::getline(cells, branch, ','), value, ',');
    if (configuration.empty()) {
      sweep.events.push_back(std::stod(value));
    } else if (!branch.empty()) {
      sweep.branches[{std::stoi(step), std::stoi(configuration)}] = std::stoi(branch);
    }
  }
  return sweep;
}

/// Calls of `Following` for one scene.
std::string calls(const Tracked& tracked, const std::vector<int>& steps) {
  std::string numbers;
  std::string lengths;
  for (const auto& [link, features] : tracked.scene["links"].items()) {
    if (link != "ground") {
      const std::string pose = "s.links." + link + ".pose.";
      numbers += pose + "x, " + pose + "y, " + pose + "direction.cos, " + pose + "direction.sin, ";
      lengths += "true, true, false, false, ";
    }
  }
  std::ostringstream code;
  code.precision(17);
  code << "  {\n    using S = assur::scenes::" << tracked.name
       << ";\n    const auto numbers = [](const S::State<double>& s) { return std::vector<double>{"
       << numbers << "}; };\n";
  for (const int count : steps) {
    code << "    const assur::test::Following<S> following_" << count << "(" << tracked.from << ", "
         << tracked.to << ", " << count << ", numbers, {" << lengths << "});\n    following_"
         << count << ".print(numbers);\n";
  }
  code << "    following_" << steps.front() << ".print_at_once();\n  }\n";
  return code.str();
}

/// One branch as the program prints it.
struct FollowedBranch {
  int last = 0, status = 0, stays = 0;
  double reached = 0, farthest = 0, missed = 0;
  std::vector<int> configurations;
};

std::istream& operator>>(std::istream& in, FollowedBranch& branch) {
  std::string farthest;
  in >> branch.last >> branch.status >> branch.reached >> branch.stays >> farthest >> branch.missed;
  branch.farthest = std::strtod(farthest.c_str(), nullptr);  // it may be infinite
  branch.configurations.resize(static_cast<std::size_t>(branch.last) + 1);
  for (int& configuration : branch.configurations) {
    in >> configuration;
  }
  return in;
}

/// Sums over all scenes, to see that there was something to find.
struct Totals {
  int ends = 0, whole = 0, points = 0;
  double largest = 0;   ///< distance from a listed configuration
  double earliest = 0;  ///< largest distance of an end from an event, in steps
};

void compare(const Tracked& tracked, int steps, const SweptBranches& sweep, std::istream& printed,
             Totals& totals) {
  SCOPED_TRACE(tracked.name + " in " + std::to_string(steps) + " steps");
  int count = 0;
  printed >> count;
  EXPECT_GT(count, 0);
  std::set<std::pair<int, int>> met;
  for (int number = 1; number <= count; ++number) {
    FollowedBranch followed;
    printed >> followed;
    SCOPED_TRACE("configuration " + std::to_string(number));
    EXPECT_LE(followed.farthest, 1e-9);
    totals.largest = std::max(totals.largest, followed.farthest);
    EXPECT_LE(followed.missed, 1e-9);
    EXPECT_EQ(followed.stays, 1);
    const int branch = sweep.branch(0, number);
    for (int step = 0; step <= followed.last; ++step) {
      const int configuration = followed.configurations[static_cast<std::size_t>(step)];
      EXPECT_TRUE(met.insert({step, configuration}).second) << "at step " << step;
      EXPECT_EQ(sweep.branch(step, configuration), branch) << "at step " << step;
      ++totals.points;
    }
    if (followed.last == steps) {
      ++totals.whole;
      continue;
    }
    ++totals.ends;
    EXPECT_EQ(followed.status, static_cast<int>(Status::no_convergence));
    const double width = (tracked.to - tracked.from) / steps;
    const double reached = tracked.from + (followed.last + followed.reached) * width;
    double nearest = std::numeric_limits<double>::infinity();
    for (const double event : sweep.events) {
      nearest = std::min(nearest, std::abs(event - reached) / width);
    }
    EXPECT_LE(nearest, 0.002) << "ends at " << reached;
    totals.earliest = std::max(totals.earliest, nearest);
  }
}

/// Starts and targets that are on no branch: `refusals` counts and prints wrong answers to them.
constexpr const char* refusals_code = R"(
int wrong = 0;
void expect(bool right, const char* what) {
  if (!right) {
    std::fprintf(stderr, "%s\n", what);
    ++wrong;
  }
}
int refusals() {
  using S = assur::scenes::FourBarCouplerCurve;
  using assur::Status;
  const double none = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  const S::Drivers<double> drivers;
  std::array<S::State<double>, S::max_configurations> states;
  const int count = S::solve(drivers, states).count;
  const auto driven = [](double position) {
    S::Drivers<double> moved;
    *moved.positions()[0] = position;
    return moved;
  };
  const double start = *S::Drivers<double>(drivers).positions()[0];
  S::State<double> state = states[0];
  const auto refused = [&](S::Branch branch, const S::Drivers<double>& to, Status status,
                           const char* what) {
    state.outputs.P.position(0) = 12345;
    const S::Track way = S::track(to, branch, state);
    expect(way.status == status && way.reached == 0, what);
    expect(state.outputs.P.position(0) == 12345, what);
  };
  for (const int number : {-1, count, std::numeric_limits<int>::max()}) {
    const S::Branch branch = S::branch(drivers, number);
    expect(branch.status == Status::no_convergence, "number out of range");
    refused(branch, driven(start + 0.1), Status::no_convergence, "no such configuration");
  }
  for (const double position : {none, infinite, -infinite}) {
    const S::Branch branch = S::branch(driven(position), 0);
    expect(branch.status == Status::not_finite, "begin at no number");
    refused(branch, drivers, Status::not_finite, "from no number");
    refused(S::branch(drivers, 0), driven(position), Status::not_finite, "to no number");
  }
  refused(S::Branch(), drivers, Status::singular, "of nothing");
  refused(S::branch(drivers, 0), driven(1e300), Status::no_convergence, "too many turns");
  // A refusal leaves the branch where it was.
  S::Branch branch = S::branch(drivers, 0);
  static_cast<void>(S::track(driven(none), branch, state));
  expect(S::track(drivers, branch, state).status == Status::ok, "after a refusal");
  expect((state.outputs.P.position - states[0].outputs.P.position).norm() < 1e-9, "moved");
  return wrong;
}
)";

TEST(EmitSceneTrack, StaysOnTheBranchesOfTheSweep) {
  const std::vector<int> counts = {200, 10};
  const std::vector<Tracked> scenes = tracked_scenes();
  const TemporaryDirectory directory;
  std::string includes;
  std::string body;
  for (const Tracked& tracked : scenes) {
    const auto file = directory.write(tracked.header + ".json", tracked.scene.dump());
    emit_solver({file, tracked.header, tracked.name, {}}, directory);
    includes += "#include <assur/scenes/" + tracked.header + ".hpp>\n";
    body += calls(tracked, counts);
  }
  const std::string head = includes + "#include \"" ASSUR_TESTS "/generator/following.hpp\"\n";
  const auto source = directory.write(
      "track.cpp", head + refusals_code + "int main() {\n" + body + "  return refusals();\n}\n");
  const std::string program = (directory.path() / "track").string();
  compile_program(source, program, directory);
  ASSERT_EQ(std::system((program + " > " + program + ".txt 2> " + program + ".wrong").c_str()), 0)
      << read_file(program + ".wrong");
  std::istringstream printed(read_file(program + ".txt"));
  Totals totals;
  for (const Tracked& tracked : scenes) {
    SweptBranches sweep;
    for (const int steps : counts) {
      sweep = swept(tracked, steps, directory);
      compare(tracked, steps, sweep, printed, totals);
    }
    // One call over the whole range follows exactly the branches that the sweep has at both ends.
    std::set<int> last;
    int count = 0;
    for (const auto& [place, branch] : sweep.branches) {
      if (place.first == counts.back()) {
        last.insert(branch);
      }
      count += place.first == 0 ? 1 : 0;
    }
    for (int number = 1; number <= count; ++number) {
      int whole = 0;
      printed >> whole;
      EXPECT_EQ(whole == 1, last.count(sweep.branch(0, number)) == 1)
          << tracked.name << " at once, configuration " << number;
    }
  }
  std::printf(
      "%d points, at most %.1e from solve's; %d branches followed to the end, %d to at most "
      "%.2g%% of a step before an event\n",
      totals.points, totals.largest, totals.whole, totals.ends, 100 * totals.earliest);
  EXPECT_GT(totals.points, is_whole_campaign() ? 4000 : 1000);
  EXPECT_GT(totals.ends, is_whole_campaign() ? 8 : 2);
}

}  // namespace
}  // namespace assur::test::emit_scene_track_test
