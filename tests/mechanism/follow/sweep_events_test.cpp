// Law: a sweep finds singular events, of the right type, where rigid bodies in long double have
// them and where singular configurations are known exactly.
#include <gtest/gtest.h>

#include <iostream>

#include "largest.hpp"
#include "mechanism/random_sweep.hpp"
#include "mechanism/sweep_runs.hpp"
#include "whole_campaign.hpp"

namespace assur::test::sweep_events_test {
namespace {

using Json = nlohmann::ordered_json;

/// The curve of poses q and parameter p near a fold. Newton's method finds its point in the plane
/// v . (q - q0) = offset, where the closure alone would be singular.
class FoldCurve {
 public:
  FoldCurve(RandomSweep& made, const SweepEventKept& event) : made_(made) {
    for (std::size_t body = 0; body < 4; ++body) {
      const auto row = 4 * static_cast<Eigen::Index>(body + 2);
      made.bodies.poses[body] = {event.pose(row), event.pose(row + 1),
                                 std::atan2(static_cast<Real>(event.pose(row + 3)),
                                            static_cast<Real>(event.pose(row + 2)))};
    }
    start_ = made.bodies.poses;
    parameter_ = event.parameter;
    made.set_parameter(parameter_);
    const RealMatrix jacobian = derivatives().leftCols(12);
    // A square matrix needs no preconditioner, which takes seconds to compile.
    const Eigen::JacobiSVD<RealMatrix, Eigen::NoQRPreconditioner> factors(jacobian,
                                                                          Eigen::ComputeFullV);
    null_ = factors.matrixV().col(11);
  }

  /// The parameter on the curve, and how far the pose there is from the start.
  std::pair<Real, Real> at(Real offset) {
    made_.bodies.poses = start_;
    Real p = parameter_;
    made_.set_parameter(p);
    RealVector moved = RealVector::Zero(12);
    for (int iteration = 0; iteration < 30; ++iteration) {
      RealMatrix matrix(13, 13);
      matrix.topRows(12) = derivatives();
      matrix.row(12).head(12) = null_.transpose();
      matrix(12, 12) = 0;
      RealVector miss(13);
      miss.head(12) = made_.bodies.residual();
      miss(12) = null_.dot(moved) - offset;
      const RealVector change = matrix.fullPivLu().solve(-miss);
      for (Eigen::Index index = 0; index < 12; ++index) {
        made_.bodies.coordinate(index) += change(index);
        moved(index) += change(index);
      }
      p += change(12);
      made_.set_parameter(p);
      current_ = p;
    }
    return {p, moved.norm()};
  }

 private:
  /// The derivatives of the closure with respect to the twelve pose coordinates and the parameter.
  RealMatrix derivatives() {
    constexpr Real step = 1e-6L;
    RealMatrix matrix(12, 13);
    for (Eigen::Index column = 0; column < 12; ++column) {
      Real& coordinate = made_.bodies.coordinate(column);
      const Real kept = coordinate;
      coordinate = kept + step;
      const RealVector above = made_.bodies.residual();
      coordinate = kept - step;
      matrix.col(column) = (above - made_.bodies.residual()) / (2 * step);
      coordinate = kept;
    }
    const Real p = current_.value_or(parameter_);
    made_.set_parameter(p + step);
    const RealVector above = made_.bodies.residual();
    made_.set_parameter(p - step);
    matrix.col(12) = (above - made_.bodies.residual()) / (2 * step);
    made_.set_parameter(p);
    return matrix;
  }

  RandomSweep& made_;
  std::vector<BodyPose> start_;
  Real parameter_ = 0;
  std::optional<Real> current_;
  RealVector null_;
};

/// The fold is at the extremum of the parameter along the curve, found by differences.
TEST(SweepEvents, FoldsAreWhereRigidBodiesHaveThem) {
  constexpr Real offset = 1e-4L;
  int folds = 0;
  double parameter_error = 0;
  double across_error = 0;
  double along_error = 0;
  for (const char* kind : {"RRRRRR", "RRRRPR", "RPRRRR", "RRPRPR", "RPRPRR"}) {
    for (unsigned seed = 1; seed <= 6; ++seed) {
      RandomSweep made =
          random_sweep(kind, static_cast<RandomSweep::Swept>(seed % 3), 100 + seed, 41);
      for (const SweepEventKept& event : run_sweep(made.scene).events) {
        if (event.kind() != "fold" && event.kind() != "birth") {
          continue;
        }
        FoldCurve curve(made, event);
        const auto [middle, away] = curve.at(0);
        const Real below = curve.at(-offset).first;
        const Real above = curve.at(offset).first;
        const Real further = curve.at(2 * offset).first - curve.at(-2 * offset).first;
        const Real slope = (8 * (above - below) - further) / (12 * offset);
        const Real second = (above - 2 * middle + below) / (offset * offset);
        const Real extremum = middle - slope * slope / (2 * second);
        parameter_error =
            largest(parameter_error, static_cast<double>(std::abs(event.parameter - extremum)));
        along_error = largest(along_error, static_cast<double>(std::abs(slope / second)));
        across_error = largest(across_error, static_cast<double>(away));
        ++folds;
      }
    }
  }
  std::cout << folds << " folds: parameter within " << parameter_error << ", configuration within "
            << across_error << " across and " << along_error << " along the motion\n";
  EXPECT_GT(folds, 40);
  EXPECT_LT(parameter_error, 1e-13);
  EXPECT_LT(across_error, 1e-12);
  EXPECT_LT(along_error, 1e-11);
}

/// At p = 0 all joints are on the x-axis, at whole numbers, so that the configuration is exactly
/// its own mirror image. With `delta`, which moves E, the sweep has another end, so that no
/// interval's middle is at p = 0.
mechanism::Scene flat_scene(const std::array<int, 6>& x, double delta, int count) {
  const auto [b, c, g, d, f, e] = x;
  std::ostringstream e_text;
  e_text.precision(17);
  e_text << e << " + " << delta;
  Json links = {{"ground", {{"A", {0, 0}}, {"E", {e_text.str(), 0}}}},
                {"crank", {{"A", {0, 0}}, {"B", {b, 0}}}},
                {"BCG", {{"B", {0, 0}}, {"C", {c - b, 0}}, {"G", {g - b, 0}}}},
                {"EDF", {{"E", {0, 0}}, {"D", {d - e, 0}}, {"F", {f - e, 0}}}},
                {"CD", {{"C", {0, 0}}, {"D", {d - c, 0}}}},
                {"GF", {{"G", {0, 0}}, {"F", {f - g, 0}}}}};
  Json joints;
  for (const auto& [name, one, other] :
       std::vector<std::array<std::string, 3>>{{"A", "ground", "crank"},
                                               {"B", "crank", "BCG"},
                                               {"E", "ground", "EDF"},
                                               {"C", "BCG", "CD"},
                                               {"G", "BCG", "GF"},
                                               {"D", "EDF", "CD"},
                                               {"F", "EDF", "GF"}}) {
    joints[name] = {{"type", "revolute"}, {"between", {one + "." + name, other + "." + name}}};
  }
  const Json scene = {
      {"parameters", {{"p", 0}}},
      {"links", links},
      {"joints", joints},
      {"drivers", {{"A", {{"position", "p"}}}}},
      {"sweep",
       {{"parameter", "p"}, {"from", -1}, {"to", delta == 0 ? 1 : 1.03}, {"count", count}}}};
  return mechanism::parse_scene(scene.dump(), "flat");
}

struct FlatCase {
  std::array<int, 6> x;
  int branches;  ///< that cross at p = 0
};
const std::vector<FlatCase> flat_cases = {{{-2, 4, -6, 1, 7, -9}, 2},  {{-3, 5, -1, -7, 8, 4}, 2},
                                          {{-3, 9, -4, 5, -7, -5}, 2}, {{3, -1, 6, 2, -3, -7}, 2},
                                          {{4, -4, -7, 7, 1, 5}, 4},   {{6, -5, 8, -9, 5, 9}, 4},
                                          {{8, 9, 3, -8, 4, 5}, 4}};

/// The mirror image of a pose at p is a pose at -p, so a branch that crosses must go straight
/// through. By default two of the mechanisms are swept in the smallest steps, one for each number
/// of branches.
TEST(SweepEvents, FlattenedMechanismsCross) {
  double parameter_error = 0;
  double pose_error = 0;
  int pieces = 0;
  int number = 0;
  for (const FlatCase& flat : flat_cases) {
    SCOPED_TRACE(flat.x[0]);
    for (const int count : {8, 20, 21, 201, 2000}) {  // odd ones have a step at the crossing
      SCOPED_TRACE(count);
      if (count == 2000 && number++ % 6 != 0 && !is_whole_campaign()) {
        continue;
      }
      const SweepKept kept = run_sweep(flat_scene(flat.x, 0, count));
      ASSERT_EQ(kept.count_of("crossing"), 1);
      ASSERT_EQ(kept.count_of("unresolved"), 0);
      for (const SweepEventKept& event : kept.events) {
        if (event.kind() != "crossing") {
          continue;
        }
        EXPECT_EQ(std::count(event.text.begin(), event.text.end(), ' '), flat.branches);
        parameter_error = largest(parameter_error, std::abs(event.parameter));
        for (Eigen::Index row = 0; row < event.pose.size(); row += 4) {
          pose_error = largest(pose_error, std::abs(event.pose(row + 3)));
          pose_error = largest(pose_error, std::abs(event.pose(row + 2) - 1));
        }
      }
      // Straight through: the slope on both sides of p = 0 is nearly the same on a branch.
      if (count != 2000) {
        continue;
      }
      for (const auto& [row, next] : neighbours(kept)) {
        const bool beside = std::abs(row->parameter) < 1e-3 && std::abs(next->parameter) < 1e-3;
        if (beside && row->branch == next->branch) {
          EXPECT_LT((row->slope - next->slope).norm(), 0.05 * (1 + row->slope.norm()));
          ++pieces;
        }
      }
    }
  }
  std::cout << "crossings within " << parameter_error << " rad, their poses within " << pose_error
            << '\n';
  EXPECT_GT(pieces, is_whole_campaign() ? 20 : 4);
  EXPECT_LT(parameter_error, 1e-12);
  EXPECT_LT(pose_error, 1e-11);
}

/// The events' texts, sorted: a fold and a birth at one place have no order.
std::vector<std::string> texts(const SweepKept& kept) {
  std::vector<std::string> list;
  for (const SweepEventKept& event : kept.events) {
    list.push_back(event.text);
  }
  std::sort(list.begin(), list.end());
  return list;
}

/// Moving E opens the crossing. To one side, two branches then pass one another; to the other, the
/// mechanism is flat at two values, and at each of them two branches end and two others begin. A
/// sweep in few steps must find the same as one in many. By default one case in 17 is tried.
TEST(SweepEvents, CrossingsThatOpenAreSeenAtAnyStep) {
  const bool all = is_whole_campaign();
  int number = 0;
  int opened = 0;
  int passing = 0;
  for (const FlatCase& flat : flat_cases) {
    if (flat.branches != 2) {
      continue;
    }
    for (const double sign : {-1.0, 1.0}) {
      for (int power = 2; power <= 11; ++power) {
        if (number++ % 17 != 0 && !all) {
          continue;
        }
        SCOPED_TRACE(sign * power);
        const double delta = sign * std::pow(10.0, -power);
        const SweepKept few = run_sweep(flat_scene(flat.x, delta, 20));
        const SweepKept many = run_sweep(flat_scene(flat.x, delta, 191));
        EXPECT_EQ(few.count_of("crossing"), 0);
        if (power == 11) {  // rounding may leave it in doubt, but it is no crossing
          continue;
        }
        EXPECT_EQ(few.count_of("unresolved"), 0);
        ASSERT_EQ(few.events.size(), many.events.size());
        EXPECT_EQ(texts(few), texts(many));
        const SweepDifference found = difference(few, many, 10);
        EXPECT_EQ(found.jumps + found.breaks + found.mismatched, 0);
        int near = 0;
        for (const SweepEventKept& event : few.events) {
          near += std::abs(event.parameter) < 2 * std::sqrt(std::abs(delta)) ? 1 : 0;
        }
        EXPECT_TRUE(near == 0 || near == 4);
        (near == 4 ? opened : passing) += 1;
      }
    }
  }
  std::cout << opened << " open, " << passing << " pass\n";
  EXPECT_GT(opened, all ? 20 : 0);
  EXPECT_GT(passing, all ? 20 : 0);
}

/// Half a turn maps the group onto itself; the length of its two bars is swept. Two configurations
/// that the half turn exchanges end on one that it keeps.
TEST(SweepEvents, AFoldMayHaveABranchThrough) {
  const auto scene = [](int count) {
    return mechanism::parse_scene(R"({
      "parameters": {"L": 1},
      "links": {"ground": {"B": [-1, 0], "E": [1, 0]},
                "BCG": {"B": [0, 0], "C": [0.503, -1.738], "G": [-1.947, 1.35]},
                "EDF": {"E": [0, 0], "D": [-1.947, 1.35], "F": [0.503, -1.738]},
                "CD": {"C": [0, 0], "D": ["L", 0]}, "GF": {"G": [0, 0], "F": ["L", 0]}},
      "joints": {"B": {"type": "revolute", "between": ["ground.B", "BCG.B"]},
                 "E": {"type": "revolute", "between": ["ground.E", "EDF.E"]},
                 "C": {"type": "revolute", "between": ["BCG.C", "CD.C"]},
                 "G": {"type": "revolute", "between": ["BCG.G", "GF.G"]},
                 "D": {"type": "revolute", "between": ["EDF.D", "CD.D"]},
                 "F": {"type": "revolute", "between": ["EDF.F", "GF.F"]}},
      "sweep": {"parameter": "L", "from": 0.05, "to": 6, "count": )" +
                                      std::to_string(count) + "}}",
                                  "turned");
  };
  const SweepKept few = run_sweep(scene(41));
  const SweepKept many = run_sweep(scene(401));
  ASSERT_EQ(few.events.size(), many.events.size());
  int through = 0;
  for (std::size_t index = 0; index < few.events.size(); ++index) {
    const SweepEventKept& event = few.events[index];
    EXPECT_NEAR(event.parameter, many.events[index].parameter, 1e-11);
    if (event.text.find(" on ") != std::string::npos) {
      ++through;
      EXPECT_EQ(event.text, many.events[index].text);
      // Half a turn: the angles of BCG and EDF differ by pi.
      EXPECT_NEAR(event.pose(6) + event.pose(10), 0, 1e-10);
      EXPECT_NEAR(event.pose(7) + event.pose(11), 0, 1e-10);
    }
  }
  EXPECT_EQ(through, 2);
  const SweepDifference found = difference(few, many, 10);
  EXPECT_EQ(found.jumps + found.breaks + found.mismatched, 0);
}

}  // namespace
}  // namespace assur::test::sweep_events_test
