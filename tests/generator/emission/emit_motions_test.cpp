// Law: the kinematic coefficients and the equations of motion of an emitted solver equal those of
// `assur solve`, are derivatives of its own positions, and are consistent with its efforts.
#include <gtest/gtest.h>

#include <assur/mechanism/held_pairs.hpp>
#include <assur/text/identifiers.hpp>
#include <iostream>

#include "generator/mixed_scene.hpp"
#include "generator/printed_states.hpp"
#include "mechanism/driven_scene_campaign.hpp"
#include "mechanism/five_bars.hpp"
#include "mechanism/loaded_scene.hpp"

namespace assur::test::emit_motions_test {
namespace {

/// Prints coefficients, the first ones and then the second ones, and the numbers of dynamics.
constexpr const char* printing_functions = R"(
template <typename Matrix>
void put_matrix(const Matrix& matrix) {
  for (int row = 0; row < static_cast<int>(matrix.rows()); ++row) {
    for (int column = 0; column < static_cast<int>(matrix.cols()); ++column) {
      std::printf("%.17g\n", static_cast<double>(matrix(row, column)));
    }
  }
}
template <typename Coefficients>
void put(const Coefficients& coefficients) {
  put_matrix(coefficients.first);
  for (const auto& second : coefficients.second) {
    put_matrix(second);
  }
}
)";

template <typename Parts>
std::vector<std::string> members_of(const Parts& parts) {
  std::vector<std::string> names;
  for (const auto& part : parts) {
    names.push_back(part.name);
  }
  return text::member_names(names, {"members", "drivers", "order", "parameters", "regularity"});
}

/// C++ that prints all results on motions in a state `s`, and its efforts.
std::string printing_code(const Solved& scene) {
  const mechanism::Mechanism& mechanism = scene.plan.mechanism();
  std::string code;
  const auto links = members_of(mechanism.links());
  for (const mechanism::LinkIndex link : mechanism.links().keys()) {
    if (link != mechanism.ground()) {
      code += "  put(s.coefficients.links." + links[link.place()] + ");\n";
    }
  }
  for (const std::string& output : members_of(mechanism.outputs())) {
    code += "  put(s.coefficients.outputs." + output + ");\n";
  }
  const auto joints = members_of(mechanism.joints());
  for (const mechanism::HeldPair& pair :
       mechanism::pairs_of_two_links(mechanism, scene.plan.redundant())) {
    const mechanism::JointIndex joint = text::index_of(mechanism.joints(), pair.joint);
    code += "  put(s.coefficients.joints." + (joint.exists() ? joints[joint.place()] : pair.joint) +
            ");\n";
  }
  code += "  put_matrix(s.dynamics.mass_matrix);\n  put_matrix(s.dynamics.bias);\n" +
          std::string("  put_matrix(s.dynamics.load);\n");
  for (const mechanism::DriverIndex driver : mechanism::free_drivers(mechanism)) {
    code += printing("s.efforts." + joints[mechanism.drivers()[driver].joint.place()]);
  }
  return code;
}

/// What a solver told of a matrix, by its rows.
Eigen::MatrixXd read_matrix(std::istream& printed, Eigen::Index rows, Eigen::Index columns) {
  Eigen::MatrixXd result(rows, columns);
  for (Eigen::Index row = 0; row < rows; ++row) {
    for (Eigen::Index column = 0; column < columns; ++column) {
      result(row, column) = read_number(printed);
    }
  }
  return result;
}

struct Worst {
  int configurations = 0, left_out = 0;
  double first = 0, second = 0, dynamics = 0, efforts = 0;

  [[nodiscard]] double most() const { return std::max({first, second, dynamics, efforts}); }
};

/// The largest difference of matrices, relative to the largest entry, or to one.
double apart(const Eigen::MatrixXd& told, const Eigen::MatrixXd& known, double size = 1) {
  return known.size() == 0
             ? 0
             : (told - known).cwiseAbs().maxCoeff() / std::max(size, known.cwiseAbs().maxCoeff());
}

template <int Numbers>
void compare(std::istream& printed, const mechanism::Derivatives<Numbers>& known, double size,
             Worst& worst) {
  const Eigen::Index count = known.first.cols();
  worst.first =
      largest(worst.first, apart(read_matrix(printed, Numbers, count), known.first, size));
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::MatrixXd told = read_matrix(printed, Numbers, count);
    for (std::size_t row = 0; row < Numbers; ++row) {
      worst.second = largest(worst.second, apart(told.row(static_cast<Eigen::Index>(row)),
                                                 known.second[row].row(i), size * size));
    }
  }
}

void compare(const Solved& scene, const Configuration& configuration, std::istream& printed,
             double most, Worst& worst) {
  const mechanism::Mechanism& mechanism = scene.plan.mechanism();
  const RigidScene rigid(mechanism, scene.values);
  RealVector poses(rigid.size());
  for (const mechanism::LinkIndex link : mechanism.links().keys()) {
    if (const Eigen::Index first = rigid.coordinate(link); first >= 0) {
      const auto& pose = configuration.links[link].pose;
      poses.segment<3>(first) << pose.x, pose.y, angle_of(pose.direction);
    }
  }
  const bool counts = configuration.regularity == Status::ok && condition_of(rigid, poses) > 1e-3L;
  counts ? ++worst.configurations : ++worst.left_out;
  const mechanism::KinematicCoefficients known =
      mechanism::coefficients_of(scene.values, configuration);
  double size = 1;
  for (const auto& link : known.links) {
    size = std::max(size, link.first.size() == 0 ? 0 : link.first.cwiseAbs().maxCoeff());
  }
  Worst here;
  for (const mechanism::LinkIndex link : mechanism.links().keys()) {
    if (link != mechanism.ground()) {
      compare(printed, known.links[link], size, here);
    }
  }
  for (const auto& output : known.outputs) {
    compare(printed, output, size, here);
  }
  for (const mechanism::JointCoefficients& joint : known.joints) {
    compare(printed, joint.coordinate, size, here);
  }
  const mechanism::Dynamics dynamics = mechanism::dynamics_of(scene.values, configuration);
  const Eigen::Index count = std::ssize(known.drivers);
  const Eigen::MatrixXd mass = read_matrix(printed, count, count);
  const Eigen::VectorXd bias = read_matrix(printed, count, 1);
  const Eigen::VectorXd load = read_matrix(printed, count, 1);
  const Eigen::VectorXd efforts = read_matrix(printed, count, 1);
  Eigen::VectorXd accelerations(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    accelerations(i) = scene.values.motion(known.drivers[static_cast<std::size_t>(i)]).acceleration;
  }
  here.dynamics =
      std::max({apart(mass, dynamics.mass_matrix, size), apart(bias, dynamics.bias, size * size),
                apart(load, dynamics.load, size)});
  const Eigen::VectorXd follow = mass * accelerations + bias - load;
  here.efforts = apart(follow, efforts, size * size);
  if (counts) {
    EXPECT_LT(here.most(), most);
    worst.first = largest(worst.first, here.first);
    worst.second = largest(worst.second, here.second);
    worst.dynamics = largest(worst.dynamics, here.dynamics);
    worst.efforts = largest(worst.efforts, here.efforts);
  }
}

/// Emits a solver for each scene with all wishes, and compares what they tell.
void compare_all(std::vector<NamedScene> scenes, double most = 1e-9,
                 const std::string& scalar = "double") {
  for (NamedScene& scene : scenes) {
    scene.json["want"] = {"position", "forces", "coefficients", "dynamics"};
  }
  Worst worst;
  for_each_printed(
      scenes, printed_states(scenes, printing_code, scalar, printing_functions),
      [&](const Solved& known, const Configuration& configuration, std::istream& printed) {
        compare(known, configuration, printed, most, worst);
      });
  std::cout << worst.configurations << " configurations, " << worst.left_out
            << " left out as nearly singular; first coefficients " << worst.first << ", second "
            << worst.second << ", dynamics " << worst.dynamics << ", against efforts "
            << worst.efforts << "\n";
  EXPECT_GT(worst.configurations, 0);
  EXPECT_LT(worst.most(), most);
}

class EmitMotionsOfScenes : public DrivenScenes {};

/// Drivers anywhere, laws that read joints, racks, cylinders, pins of many links, slots.
TEST_P(EmitMotionsOfScenes, AreThoseOfSolve) {
  std::vector<NamedScene> scenes;
  for_each_scene(2, 20, Places::anywhere, [&](const RandomDrivenScene& made, unsigned seed) {
    scenes.push_back({"scene_" + std::to_string(seed), loaded(made.scene(), seed)});
  });
  compare_all(scenes);
}

INSTANTIATE_TEST_SUITE_P(Ties, EmitMotionsOfScenes, testing::Values(Ties::drivers, Ties::groups),
                         name_of_ties);

TEST(EmitMotions, HoldParametersAndCountTheirRatesInTheBias) {
  compare_all({{"mixed", mixed_scene()}});
}

/// A five-bar with two drivers, whose own laws a third joint follows with rates that are given.
Json two_drivers() {
  return Json::parse(R"json({
    "links": {"ground": {"A": [0, 0], "E": [5, 0], "rail": {"through": [0, -2], "along": [1, 0]}},
      "left": {"A": [0, 0], "B": [2, 0]}, "lower": {"B": [0, 0], "C": [4, 0], "P": [5, 1]},
      "right": {"E": [0, 0], "D": [2, 0]}, "upper": {"D": [0, 0], "C": [4, 0]},
      "car": {"shoe": {"through": [0, 0], "along": [1, 0]}, "G": [0, 0]},
      "flap": {"G": [0, 0], "H": [0, 1]}},
    "joints": {"A": {"type": "revolute", "between": ["ground.A", "left.A"]},
      "B": {"type": "revolute", "between": ["left.B", "lower.B"]},
      "C": {"type": "revolute", "between": ["lower.C", "upper.C"]},
      "D": {"type": "revolute", "between": ["right.D", "upper.D"]},
      "E": {"type": "revolute", "between": ["ground.E", "right.E"]},
      "S": {"type": "prismatic", "between": ["ground.rail", "car.shoe"]},
      "G": {"type": "revolute", "between": ["car.G", "flap.G"]}},
    "parameters": {"lag": {"value": 0.3, "velocity": 0.7, "acceleration": -0.2}},
    "drivers": {"A": {"position": 2, "velocity": 3, "acceleration": -1},
      "E": {"position": 1, "velocity": -2, "acceleration": 0.5},
      "S": {"position": "sin(joint(A)) * joint(E) + lag", "velocity": 4, "acceleration": 2},
      "G": {"position": "joint(C)^2 + joint(S)"}},
    "gravity": [0.3, -9.81],
    "masses": {"left": {"mass": 1, "at": [1, 0.2], "inertia": 0.2},
      "lower": {"mass": 2, "at": [2, "lag"], "inertia": 0.4}, "car": {"mass": 3},
      "flap": {"mass": 0.5, "at": "H", "inertia": 0.1}},
    "loads": {"F": {"at": "lower.P", "force": ["2*joint(C)", 1]}, "T": {"on": "car", "moment": 1}},
    "springs": {"K": {"between": ["ground.A", "lower.P"], "stiffness": 3, "length": 1,
      "damping": 0.5}}, "outputs": {"P": "lower.P", "H": "flap.H"}})json");
}

/// Laws follow their joints along each coordinate, whatever rates are given for them.
TEST(EmitMotions, FollowLawsWithoutTheRatesThatAreGiven) {
  compare_all({{"two_drivers", two_drivers()}});
}

TEST(EmitMotions, AreTheSameInFloatToItsDigits) {
  compare_all({{"two_drivers", two_drivers()}}, 1e-3, "float");
}

/// All constraints of a parallelogram with three cranks together give its motion; of a wedge with
/// three slides one is half left out.
TEST(EmitMotions, FollowRedundantConstraints) {
  Json scene = five_bars(2, 1.5).json();
  scene["drivers"]["A"]["position"] = 0.7;
  scene["gravity"] = {0, -9.81};
  scene["masses"] = {{"coupler", {{"mass", 2}, {"at", {1, 0.5}}, {"inertia", 0.3}}},
                     {"third", {{"mass", 1}, {"at", {0.5, 0}}}}};
  const Json wedge = Json::parse(R"({
    "links": {"ground": {"floor": {"through": [0, 0], "along": [1, 0]},
        "wall": {"through": [1, 0], "along": [0, 1]}},
      "wedge": {"floor": {"through": [0, 0], "along": [1, 0]},
        "slope": {"through": [0, 0.2], "along": [2, 1]}},
      "follower": {"slope": {"through": [0, 0], "along": [2, 1]},
        "wall": {"through": [0, 0], "along": [0, 1]}}},
    "joints": {"floor": {"type": "prismatic", "between": ["ground.floor", "wedge.floor"]},
      "slope": {"type": "prismatic", "between": ["follower.slope", "wedge.slope"]},
      "wall": {"type": "prismatic", "between": ["follower.wall", "ground.wall"]}},
    "drivers": {"floor": {"position": 0.7, "velocity": 2}}, "gravity": [0, -10],
    "masses": {"follower": {"mass": 3}}})");
  compare_all({{"five_bars", scene}, {"wedge", wedge}});
}

/// First coefficients against differences of the solver's own positions, and second ones against
/// differences of its first ones, each with the error of the fourth order in the step.
TEST(EmitMotions, AreDerivativesOfTheSolversOwnPositions) {
  Json scene = two_drivers();
  scene["want"] = {"position", "coefficients"};
  const TemporaryDirectory directory;
  const std::string root = directory.path().string();
  emit_solver({directory.write("own.json", scene.dump()), "own", "", {}}, directory);
  const auto source = directory.write(
      "driver.cpp",
      R"cpp(#include <cmath>
#include <cstdio>
#include <assur/scenes/own.hpp>
            using S = assur::scenes::Own;
            static std::array<S::State<double>, S::max_configurations> solve(double a, double e) {
              std::array<S::State<double>, S::max_configurations> states;
              S::Drivers<double> drivers;
              drivers.A.position += a;
              drivers.E.position += e;
              if (S::solve(drivers, states).count != 2) {
                std::printf("other configurations\n");
              }
              return states;
            }
            template <typename Get>
            static double slope(int coordinate, const Get& get) {
              const double h = 1e-3;
              const auto at = [&](double step) {
                return get(solve(coordinate == 0 ? step : 0, coordinate == 0 ? 0 : step));
              };
              return (8 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12 * h);
            }
            int main() {
              const auto here = solve(0, 0);
              double first = 0, second = 0;
              for (std::size_t k = 0; k < 2; ++k) {
                for (int i = 0; i < 2; ++i) {
                  for (int row = 0; row < 2; ++row) {
                    const auto of_output = [&](auto output, auto coefficients) {
                      first = std::fmax(
                          first,
                          std::abs(coefficients(here[k]).first(row, i) -
                                   slope(i, [&](const auto& s) { return output(s[k])(row); })));
                      for (int j = 0; j < 2; ++j) {
                        second = std::fmax(
                            second,
                            std::abs(
                                coefficients(here[k]).second[static_cast<std::size_t>(i)](row, j) -
                                slope(i, [&](const auto& s) {
                                  return coefficients(s[k]).first(row, j);
                                })));
                      }
                    };
                    of_output([](const auto& s) { return s.outputs.P.position; },
                              [](const auto& s) { return s.coefficients.outputs.P; });
                    of_output([](const auto& s) { return s.outputs.H.position; },
                              [](const auto& s) { return s.coefficients.outputs.H; });
                  }
                }
              }
              std::printf("%g %g\n", first, second);
            }
      )cpp");
  compile_program(source, root + "/driver", directory);
  ASSERT_EQ(std::system((root + "/driver > " + root + "/printed").c_str()), 0);
  std::istringstream printed(read_file(directory.path() / "printed"));
  const double first = read_number(printed);
  const double second = read_number(printed);
  std::cout << "differences of fourth order: first " << first << ", second " << second << "\n";
  EXPECT_LT(first, 1e-8);
  EXPECT_LT(second, 1e-7);
}

/// Batches and C tell the same numbers as one call in C++.
TEST(EmitMotions, AreTheSameInBatchesAndInC) {
  Json scene = two_drivers();
  scene["want"] = {"position", "coefficients", "dynamics"};
  const TemporaryDirectory directory;
  const std::string root = directory.path().string();
  emit_solver({directory.write("own.json", scene.dump()), "own", "", {}}, directory,
              "--interface c");
  const auto source = directory.write(
      "driver.cpp",
      R"cpp(#include <cstdio>
#include <assur/scenes/own.cpp>
#include <vector>
            using S = assur::scenes::Own;
            int main() {
              constexpr std::size_t count = 9, columns = assur::support::column_count<S::State<double>>;
              constexpr std::size_t most = static_cast<std::size_t>(S::max_configurations);
              std::vector<double> given(6 * count), states(most * columns * count);
              std::vector<assur::AssemblyStatus> status(count);
              std::vector<assur::Status> regularity(most * count);
              std::vector<int> found(count), families(count), mobility(count);
              S::Drivers<double> drivers;
              for (std::size_t i = 0; i < count; ++i) {
                drivers.A.position = 1.8 + 0.05 * static_cast<double>(i);
                assur::support::for_each_column(drivers, [&](double& number, std::size_t column) {
                  given[column * count + i] = number;
                });
              }
              S::BatchSolutions result;
              result.status = status.data();
              result.count = found.data();
              result.families = families.data();
              result.mobility = mobility.data();
              result.regularity = regularity.data();
              result.states = states.data();
              result.stride = count;
              (void)S::solve_batch(count, {given.data(), count}, result);
              int compared = 0, differ = 0;
              for (std::size_t i = 0; i < count; ++i) {
                drivers.A.position = 1.8 + 0.05 * static_cast<double>(i);
                std::array<S::State<double>, most> lone;
                const int n = S::solve(drivers, lone).count;
                own_drivers given_in_c;
                own_defaults(&given_in_c);
                given_in_c.A.position = drivers.A.position;
                static own_solution in_c;
                (void)own_solve(&given_in_c, &in_c);
                differ += n != found[i] || n != in_c.count;
                for (std::size_t k = 0; k < static_cast<std::size_t>(n); ++k) {
                  assur::support::for_each_column(lone[k], [&](double& number, std::size_t column) {
                    differ += number != result.column(k, column)[i];
                    ++compared;
                  });
                  const auto& c = in_c.states[k];
                  const auto& s = lone[k];
                  const auto& of_link = s.coefficients.links.flap;
                  for (int row = 0; row < 3; ++row) {
                    for (int a = 0; a < own_coordinate_count; ++a) {
                      differ += c.coefficients.links.flap.first[row][a] != of_link.first(row, a);
                      for (int b = 0; b < own_coordinate_count; ++b) {
                        differ += c.coefficients.links.flap.second[a][row][b] !=
                                  of_link.second[static_cast<std::size_t>(a)](row, b);
                        differ += c.dynamics.mass_matrix[a][b] != s.dynamics.mass_matrix(a, b);
                      }
                      differ += c.dynamics.bias[a] != s.dynamics.bias(a);
                      differ += c.dynamics.load[a] != s.dynamics.load(a);
                    }
                  }
                  differ += c.coefficients.joints.C.second[1][0][0] != s.coefficients.joints.C.second[1](0, 0);
                }
              }
              std::printf("%d %s\n", differ, compared > 1000 ? "of many" : "of few");
            }
      )cpp");
  compile_program(source, root + "/driver", directory);
  check_by_clang(source, directory, true);
  ASSERT_EQ(std::system((root + "/driver > " + root + "/printed").c_str()), 0);
  EXPECT_EQ(read_file(directory.path() / "printed"), "0 of many\n");
}

/// Where a parallelogram lies in one line, the motion of its bars is not determined, that of its
/// crank is; a structure has no coordinates, and tells nothing.
TEST(EmitMotions, AreNotToldWhereTheyAreNotDetermined) {
  Json scene = Json::parse(R"({
    "links": {"ground": {"A": [0, 0], "D": [4, 0]}, "one": {"A": [0, 0], "B": [2, 0]},
      "bar": {"B": [0, 0], "C": [4, 0]}, "two": {"D": [0, 0], "C": [2, 0]}},
    "joints": {"A": {"type": "revolute", "between": ["ground.A", "one.A"]},
      "B": {"type": "revolute", "between": ["one.B", "bar.B"]},
      "C": {"type": "revolute", "between": ["bar.C", "two.C"]},
      "D": {"type": "revolute", "between": ["ground.D", "two.D"]}},
    "drivers": {"A": {"position": 0}}, "want": ["position", "coefficients"]})");
  const auto printed = printed_states({{"in_line", scene}}, [](const Solved&) {
    return printing("s.coefficients.links.one.first(2, 0)") +
           printing("s.coefficients.links.two.first(2, 0)") +
           printing("s.coefficients.joints.D.first(0, 0)");
  });
  EXPECT_EQ(printed.str(), "1\n1\nnan\nnan\nend\n");
}

}  // namespace
}  // namespace assur::test::emit_motions_test
