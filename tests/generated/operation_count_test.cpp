// Law: every generated function performs as many operations as its header states, counted by a
// scalar that counts; and the counts are those that docs/operations.md prints.
#include <fstream>
#include <map>
#include <regex>
#include <sstream>

#include "runtime/model_types.hpp"

namespace assur::test::operation_count_test {
namespace {

struct Count {
  int multiplications = 0;
  int additions = 0;
  int divisions = 0;

  friend bool operator==(const Count&, const Count&) = default;
};

std::ostream& operator<<(std::ostream& out, const Count& count) {
  return out << count.multiplications << ", " << count.additions << ", " << count.divisions;
}

Count counted;

/// A number that counts what is done to it; a change of sign is free. Constants of the text divided
/// by each other are folded by every compiler and are free as well. It has no value, because no
/// generated function asks for one, and is passed by value and does not throw, because so its many
/// thousand uses cost least to compile.
struct Counting {
  bool constant = false;

  Counting() = default;
  explicit Counting(double /*number*/) noexcept : constant(true) {}
  static Counting result(bool is_constant) noexcept {
    Counting made;
    made.constant = is_constant;
    return made;
  }

  friend Counting operator+(Counting, Counting) noexcept {
    ++counted.additions;
    return result(false);
  }
  friend Counting operator-(Counting, Counting) noexcept {
    ++counted.additions;
    return result(false);
  }
  friend Counting operator-(Counting a) noexcept { return a; }
  friend Counting operator*(Counting, Counting) noexcept {
    ++counted.multiplications;
    return result(false);
  }
  friend Counting operator/(Counting a, Counting b) noexcept {
    const bool folded = a.constant && b.constant;
    counted.divisions += folded ? 0 : 1;
    return result(folded);
  }
};

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

/// Variables, none of which is a constant of the text.
template <typename Variables>
Variables variables() {
  Variables result;
  const auto set = [](auto& member) {
    if constexpr (std::is_same_v<std::decay_t<decltype(member)>, Counting>) {
      member = Counting();
    } else {
      member = {Counting(), Counting()};
    }
  };
  std::apply([&](auto&... member) { (set(member), ...); }, result.members());
  return result;
}

template <typename Use>
Count count_of(Use use) {
  counted = {};
  use();
  return counted;
}

template <typename Model>
class Operations : public testing::Test {};

TYPED_TEST_SUITE(Operations, AllModels, ModelNames);

TYPED_TEST(Operations, AreAsManyAsTheHeaderStates) {
  using Model = TypeParam;
  const std::map<std::string, Count> stated = stated_counts(Model::number, Model::group);
  ASSERT_FALSE(stated.empty());
  const auto d = variables<typename Model::template Dimensions<Counting>>();
  const auto u = variables<typename Model::template Inputs<Counting>>();
  const auto q = variables<typename Model::template Configuration<Counting>>();
  Matrix<Counting, Model::equation_count, Model::unknown_count> jacobian;
  Vector<Counting, Model::equation_count> rhs;
  Vector<Counting, Model::unknown_count> q1;
  Vector<Counting, Model::unknown_count> q2;
  const Vector<Counting, Model::dimension_count> d1;
  const Vector<Counting, Model::input_count> u1;
  EXPECT_EQ(count_of([&] { Model::residual(d, u, q, rhs); }), stated.at("residual"));
  EXPECT_EQ(count_of([&] { Model::jacobian(d, u, q, jacobian); }), stated.at("jacobian"));
  EXPECT_EQ(count_of([&] { Model::velocity_rhs(d, u, q, u1, rhs); }), stated.at("velocity_rhs"));
  EXPECT_EQ(count_of([&] { Model::acceleration_rhs(d, u, q, q1, u1, u1, rhs); }),
            stated.at("acceleration_rhs"));
  EXPECT_EQ(count_of([&] { Model::jerk_rhs(d, u, q, q1, q1, u1, u1, u1, rhs); }),
            stated.at("jerk_rhs"));
  EXPECT_EQ(count_of([&] { Model::curvature_rhs(d, u, q, q1, d1, u1, rhs); }),
            stated.at("curvature_rhs"));
  if constexpr (Model::rigid) {
    Matrix<Counting, Model::unknown_count, Model::equation_count> inverse;
    Matrix<Counting, Model::unknown_count, Model::dimension_count> s_d;
    Matrix<Counting, Model::unknown_count, Model::input_count> s_u;
    EXPECT_EQ(count_of([&] { Model::inverse_jacobian(d, u, q, inverse); }),
              stated.at("inverse_jacobian"));
    EXPECT_EQ(count_of([&] { Model::sensitivities(d, u, q, s_d, s_u); }),
              stated.at("sensitivities"));
    EXPECT_EQ(count_of([&] { Model::velocity(d, u, q, u1, q1); }), stated.at("velocity"));
    EXPECT_EQ(count_of([&] { Model::motion(d, u, q, u1, u1, q1, q2); }), stated.at("motion"));
    EXPECT_EQ(count_of([&] { Model::sensitivities_and_motion(d, u, q, u1, u1, s_d, s_u, q1, q2); }),
              stated.at("sensitivities_and_motion"));
  }
}

TEST(OperationTable, IsWhatTheHeadersState) {
  std::ifstream file(ASSUR_DOCS "/operations.md");
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
