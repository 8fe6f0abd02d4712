// Law: a DXF file, read back, has every pin of every configuration at its solved position, and uses
// only layers of its own table.
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <sstream>

#include "largest.hpp"
#include "mechanism/drawn_scene.hpp"
#include "scenes_of.hpp"

namespace assur::test::dxf_test {
namespace {

/// An entity of the file: its kind, which follows code 0, and its values by their codes.
struct Entity {
  std::string kind;
  std::map<int, std::string> values;

  [[nodiscard]] Eigen::Vector2d place() const {
    return {std::stod(values.at(10)), std::stod(values.at(20))};
  }
};

struct DxfFile {
  explicit DxfFile(const std::string& text) {
    std::istringstream in(text);
    std::string code;
    std::string value;
    std::string variable;
    while (std::getline(in, code) && std::getline(in, value)) {
      const int number = std::stoi(code);
      if (number == 0) {
        entities.push_back({value, {}});
      } else if (number == 9) {
        variable = value;
      } else if (!variable.empty() && entities.size() == 1) {
        header[variable] = value;
      } else {
        entities.back().values[number] = value;
      }
      last = value;
    }
  }

  std::vector<Entity> entities;
  std::map<std::string, std::string> header;
  std::string last;
};

class ExampleDxf : public testing::TestWithParam<std::string> {
 protected:
  ExampleDxf() : drawn_(drawn_scene(GetParam())), file_(drawing_dxf(drawn_.drawing)) {}

  const DrawnScene& drawn_;
  DxfFile file_;
};

TEST_P(ExampleDxf, HasEveryPinWhereItIsSolved) {
  const auto& [scene, plan, values, solution, drawing] = drawn_;
  double worst = 0;
  double size = 0;
  int count = 0;
  for (std::size_t place = 0; place < solution.configurations.size(); ++place) {
    const std::string layer = "C" + std::to_string(place + 1) + "_PINS";
    for (const mechanism::Joint& joint : plan.mechanism().joints()) {
      for (const mechanism::FeatureIndex at : joint.between) {
        const mechanism::Feature& feature = plan.mechanism().features()[at];
        if (feature.is_line) {
          continue;
        }
        const std::string& link = plan.mechanism().links()[feature.link].name;
        const Pose<double>& pose = solution.configurations[place].link(link).pose;
        const double x = values.value_of(feature.x);
        const double y = values.value_of(feature.y);
        const Eigen::Vector2d solved(pose.x + pose.direction.cos * x - pose.direction.sin * y,
                                     pose.y + pose.direction.sin * x + pose.direction.cos * y);
        double nearest = INFINITY;
        for (const Entity& entity : file_.entities) {
          if (entity.kind == "CIRCLE" &&
              (entity.values.at(8) == layer || entity.values.at(8) == "GROUND")) {
            nearest = std::min(nearest, (entity.place() - solved).norm());
          }
        }
        worst = largest(worst, nearest);
        size = largest(size, solved.norm());
        ++count;
      }
    }
  }
  EXPECT_GT(count, 0);
  EXPECT_LT(worst, 1e-13 * size);
}

TEST_P(ExampleDxf, IsWhole) {
  EXPECT_EQ(file_.last, "EOF");
  EXPECT_EQ(file_.header["$ACADVER"], "AC1009");
  std::set<std::string> layers;
  int open = 0;
  for (const Entity& entity : file_.entities) {
    open += entity.kind == "SECTION" ? 1 : entity.kind == "ENDSEC" ? -1 : 0;
    if (entity.kind == "LAYER") {
      EXPECT_TRUE(layers.insert(entity.values.at(2)).second);
      EXPECT_LE(entity.values.at(2).size(), 31U);
      EXPECT_EQ(entity.values.at(2).find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-"),
                std::string::npos);
    } else if (entity.values.contains(8)) {
      EXPECT_TRUE(layers.contains(entity.values.at(8))) << entity.values.at(8);
    }
  }
  EXPECT_EQ(open, 0);
}

INSTANTIATE_TEST_SUITE_P(Scenes, ExampleDxf, testing::ValuesIn(scenes_of(ASSUR_EXAMPLES)),
                         [](const auto& name) { return std::string(name.param); });

TEST(DxfUnits, AreTheScenes) {
  for (const auto& [unit, code] : {std::pair("mm", "4"), {"m", "6"}, {"in", "1"}, {"cubit", "0"}}) {
    mechanism::Drawing drawing = drawn_scene("slider_crank").drawing;
    drawing.unit = unit;
    DxfFile file(drawing_dxf(drawing));
    EXPECT_EQ(file.header["$INSUNITS"], code);
  }
}

}  // namespace
}  // namespace assur::test::dxf_test
