// Law: every generated function performs as many operations as its header states, counted by a
// scalar that counts; and the counts are those that docs/reports/operations.md prints.
#include <fstream>
#include <map>
#include <regex>
#include <sstream>

#include "counting.hpp"
#include "runtime/model_types.hpp"

namespace assur::test::operation_count_test {
namespace {

/// The counts that a model's header states, by function.
std::map<std::string, Count> stated_counts(int model, const std::string& group = "tetrad") {
  std::ostringstream name;
  name << ASSUR_GENERATED "/assur/" << group << "/model_" << (model < 10 ? "0" : "") << model
       << ".hpp";
  std::ifstream file(name.str());
  const std::regex row(R"(///   (\w+): +(\d+), (\d+), (\d+))");
  std::map<std::string, Count> counts;
  std::string line;
  while (std::getline(file, line)) {
    std::smatch match;
    if (std::regex_match(line, match, row)) {
      counts[match[1]] = {std::stoi(match[2]), std::stoi(match[3]), std::stoi(match[4])};
    }
  }
  return counts;
}

template <typename Model>
class Operations : public testing::Test {};

TYPED_TEST_SUITE(Operations, AllModels, ModelNames);

TYPED_TEST(Operations, AreAsManyAsTheHeaderStates) {
  using Model = TypeParam;
  const std::map<std::string, Count> stated = stated_counts(Model::number, Model::group);
  ASSERT_FALSE(stated.empty());
  std::size_t checked = 0;
  const auto check = [&](const char* name, auto function) {
    EXPECT_EQ(operations_of(function), stated.at(name)) << name;
    ++checked;
  };
  check("residual", &Model::template residual<Counting>);
  check("jacobian", &Model::template jacobian<Counting>);
  check("dimension_jacobian", &Model::template dimension_jacobian<Counting>);
  check("input_jacobian", &Model::template input_jacobian<Counting>);
  check("velocity_rhs", &Model::template velocity_rhs<Counting>);
  check("acceleration_rhs", &Model::template acceleration_rhs<Counting>);
  check("jerk_rhs", &Model::template jerk_rhs<Counting>);
  check("curvature_rhs", &Model::template curvature_rhs<Counting>);
  check("link_poses", &Model::template link_poses<Counting>);
  check("pose_jacobians", &Model::template pose_jacobians<Counting>);
  check("link_velocities", &Model::template link_velocities<Counting>);
  check("link_accelerations", &Model::template link_accelerations<Counting>);
  check("pose_curvatures", &Model::template pose_curvatures<Counting>);
  if constexpr (Model::compatibility_count > 0) {
    check("compatibility", &Model::template compatibility<Counting>);
  }
  if constexpr (Model::has_special_points) {
    check("special_point_lines", &Model::template special_point_lines<Counting>);
    check("special_point_lengths", &Model::template special_point_lengths<Counting>);
    check("special_point_velocities", &Model::template special_point_velocities<Counting>);
    check("special_point_accelerations", &Model::template special_point_accelerations<Counting>);
  }
  if constexpr (Model::rigid) {
    check("degeneracies", &Model::template degeneracies<Counting>);
    check("inverse_jacobian", &Model::template inverse_jacobian<Counting>);
    check("sensitivities", &Model::template sensitivities<Counting>);
    check("velocity", &Model::template velocity<Counting>);
    check("motion", &Model::template motion<Counting>);
    check("sensitivities_and_motion", &Model::template sensitivities_and_motion<Counting>);
    check("position_polynomial", &Model::template position_polynomial<Counting>);
    check("complete", &Model::template complete<Counting>);
    check("forces", &Model::template forces<Counting>);
    if constexpr (Model::second_unknown >= 0) {
      check("second_equations", &Model::template second_equations<Counting>);
    }
  }
  EXPECT_EQ(checked, stated.size());
}

TEST(OperationTable, IsWhatTheHeadersState) {
  std::ifstream file(ASSUR_DOCS "/reports/operations.md");
  const std::regex row(R"(\| (dyad|triad|tetrad) (\d+) \|.*)");
  const std::regex cell(R"((\d+), (\d+), (\d+))");
  const std::vector<std::string> columns = {"sensitivities", "motion", "sensitivities_and_motion",
                                            "inverse_jacobian", "position_polynomial"};
  int rows = 0;
  std::string line;
  while (std::getline(file, line)) {
    std::smatch match;
    if (!std::regex_match(line, match, row)) {
      continue;
    }
    ++rows;
    const std::map<std::string, Count> stated = stated_counts(std::stoi(match[2]), match[1]);
    std::size_t column = 0;
    for (std::sregex_iterator at(line.begin(), line.end(), cell), end; at != end; ++at, ++column) {
      ASSERT_LT(column, columns.size());
      EXPECT_EQ((Count{std::stoi((*at)[1]), std::stoi((*at)[2]), std::stoi((*at)[3])}),
                stated.at(columns[column]))
          << match[1] << " " << match[2] << ", " << columns[column];
    }
    EXPECT_EQ(column, columns.size());
  }
  const auto rigid = std::apply(
      [](auto... model) { return (0 + ... + (decltype(model)::rigid ? 1 : 0)); }, AllModelsTuple());
  EXPECT_EQ(rows, rigid);
}

TEST(OperationTable, KeepsWhatTheStructurePromises) {
  const Count count = stated_counts(1).at("sensitivities_and_motion");
  EXPECT_LE(count.multiplications, 158);
  EXPECT_LE(count.additions, 71);
  EXPECT_EQ(count.divisions, 1);
}

}  // namespace
}  // namespace assur::test::operation_count_test
