// Law: the kinematic coefficients and the equations of motion that an emitted solver tells are
// those of `assur solve`, derivatives of its own positions, and consistent with its efforts.
#include <gtest/gtest.h>

#include <assur/text/identifiers.hpp>
#include <iostream>

#include "generator/mixed_scene.hpp"
#include "generator/printed_states.hpp"
#include "mechanism/driven_scene_campaign.hpp"
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

/// C++ that prints all that a state `s` tells of motions, and its efforts.
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
  for (const mechanism::JointIndex joint : mechanism.joints().keys()) {
    if (mechanism.joints()[joint].between.size() == 2) {
      code += "  put(s.coefficients.joints." + joints[joint.place()] + ");\n";
    }
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

/// How far matrices are apart, in parts of the largest entry, or of one.
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
             Worst& worst) {
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
  for (const mechanism::JointIndex joint : mechanism.joints().keys()) {
    if (mechanism.joints()[joint].between.size() == 2) {
      compare(printed, known.joints[joint], size, here);
    }
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
    EXPECT_LT(here.most(), 1e-9);
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
  for_each_printed(scenes, printed_states(scenes, printing_code, scalar, printing_functions),
                   [&](const Solved& known, const Configuration& configuration,
                       std::istream& printed) { compare(known, configuration, printed, worst); });
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
  for_each_scene(2, 60, Places::anywhere, [&](const RandomDrivenScene& made, unsigned seed) {
    scenes.push_back({"scene_" + std::to_string(seed), loaded(made.scene(), seed)});
  });
  compare_all(scenes);
}

INSTANTIATE_TEST_SUITE_P(Ties, EmitMotionsOfScenes, testing::Values(Ties::drivers, Ties::groups),
                         name_of_ties);

TEST(EmitMotions, HoldParametersAndCountTheirRatesInTheBias) {
  compare_all({{"mixed", mixed_scene()}});
}

}  // namespace
}  // namespace assur::test::emit_motions_test
