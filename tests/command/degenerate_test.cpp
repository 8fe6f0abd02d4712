// Law: degenerate dimensions get a verdict with a mobility, and never a spurious root or NaN.
#include <gtest/gtest.h>

#include <array>
#include <assur/assembly.hpp>
#include <assur/tetrad/models.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "command/command.hpp"

namespace assur::test::degenerate_test {
namespace {

using Json = nlohmann::ordered_json;
using tetrad::Model01;
using tetrad::Model11;
using tetrad::Model17;

Model01::Dimensions<double> some_dimensions() {
  Model01::Dimensions<double> d;
  d.BC = 1.25;
  d.x_G_BCG = 0.5;
  d.y_G_BCG = 0.75;
  d.ED = 1;
  d.x_F_EDF = 0.25;
  d.y_F_EDF = -0.5;
  d.CD = 1.5;
  d.GF = 1.75;
  return d;
}

TEST(Degenerate, CongruentLinksAndEqualBarsMoveFreely) {
  Model01::Dimensions<double> d = some_dimensions();
  d.ED = d.BC;
  d.x_F_EDF = d.x_G_BCG;
  d.y_F_EDF = d.y_G_BCG;
  Model01::Inputs<double> u;
  u.x_E = 1.5;
  u.y_E = 2;
  d.CD = d.GF = 2.5;  // |EB|: the bars stay parallel to the line of the external joints
  const auto found = assemblies<Model01>(d, u);
  EXPECT_EQ(found.status, AssemblyStatus::degenerate);
  EXPECT_EQ(found.count, 0);
  EXPECT_EQ(found.mobility, 1);
}

TEST(Degenerate, CoincidingExternalJointsTurnFreelyOrCannotBeAssembled) {
  Model01::Dimensions<double> d = some_dimensions();
  const Model01::Inputs<double> u;  // B = E
  // With E at B, only the angle between the ternary links determines |CD| and |GF|: cos 0.6.
  const double dx = d.BC - 0.6 * d.ED;
  const double dy = -0.8 * d.ED;
  const double gx = d.x_G_BCG - (0.6 * d.x_F_EDF - 0.8 * d.y_F_EDF);
  const double gy = d.y_G_BCG - (0.8 * d.x_F_EDF + 0.6 * d.y_F_EDF);
  d.CD = std::sqrt(dx * dx + dy * dy);
  d.GF = std::sqrt(gx * gx + gy * gy);
  const auto free = assemblies<Model01>(d, u);
  // The lengths are rounded, so the polynomial vanishes only to within rounding: no random root may
  // be listed as regular. Double-double may also see that the bars do not fit exactly.
  for (int index = 0; index < free.count; ++index) {
    EXPECT_NE(free.regularity[static_cast<std::size_t>(index)], Status::ok);
  }
  d.GF += 0.25;
  const auto impossible = assemblies<Model01>(d, u);
  EXPECT_EQ(impossible.count, 0);
  EXPECT_EQ(impossible.mobility, 0);
}

/// Both links could move together along parallel slides. But one bar requires a shift of sqrt(3)
/// between them along the slides, and the other one sqrt(4 - 1.25^2). Without bars the slides would
/// have to coincide.
TEST(Degenerate, ParallelExternalSlidesThatBarsHoldApartCannotBeAssembled) {
  Model11::Dimensions<double> d11;
  d11.x_G_BCG = 1;
  d11.y_G_BCG = 0.5;
  d11.x_F_EDF = 1;
  d11.y_F_EDF = 0.75;
  d11.CD = d11.GF = 2;
  Model11::Inputs<double> u11;
  u11.y_E = 1;  // both slides run along the x-axis
  const auto with_bars = assemblies<Model11>(d11, u11);
  EXPECT_EQ(with_bars.status, AssemblyStatus::ok);
  EXPECT_EQ(with_bars.count, 0);
  EXPECT_EQ(with_bars.mobility, 0);
  Model17::Dimensions<double> d17;
  Model17::Inputs<double> u17;
  u17.y_E = 1;
  const auto found = assemblies<Model17>(d17, u17);
  EXPECT_EQ(found.status, AssemblyStatus::ok);
  EXPECT_EQ(found.count, 0);
  EXPECT_EQ(found.mobility, 0);
}

TEST(Degenerate, InputsThatAreNoNumbersAreRefused) {
  Model01::Dimensions<double> d = some_dimensions();
  d.CD = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(assemblies<Model01>(d, {}).status, AssemblyStatus::not_finite);
  d.CD = std::numeric_limits<double>::infinity();
  EXPECT_EQ(assemblies<Model01>(d, {}).status, AssemblyStatus::not_finite);
}

TEST(Degenerate, AllZeroIsAVerdict) {
  const auto found = assemblies<Model01>({}, {});
  EXPECT_EQ(found.status, AssemblyStatus::degenerate);
  EXPECT_EQ(found.count, 0);
}

/// A link of length zero is answered as ever shorter links are: it cannot reach, or it spins.
TEST(Degenerate, ALinkWithoutLengthIsNamed) {
  const auto solved = [](const Json& scene) {
    const TemporaryDirectory directory;
    return Json::parse(
        run_assur("solve --format json " + directory.write("scene.json", scene.dump()).string())
            .output);
  };
  Json scene = Json::parse(read_file(ASSUR_EXAMPLES "/quintero_2011_rrp_rrr.json"));
  scene["links"]["bar"]["F"] = {0, 0};
  const Json apart = solved(scene);
  scene["links"]["bar"]["F"] = {1e-9, 0};
  const Json almost = solved(scene);
  EXPECT_EQ(apart["status"], "no-assembly");
  EXPECT_EQ(almost["status"], "no-assembly");
  const std::string reason = almost["reason"];
  EXPECT_EQ(apart["reason"], reason + "; the features of the link bar at the joints E, F coincide");
  Json four_bar = Json::parse(read_file(ASSUR_EXAMPLES "/four_bar_coupler_curve.json"));
  four_bar["links"]["rocker"]["C"] = {0, 0};
  EXPECT_EQ(solved(four_bar)["status"], "no-assembly");
  four_bar["links"]["coupler"]["C"] = {40, 0};
  four_bar["parameters"]["phi"] = 0;
  const Json spinning = solved(four_bar);
  EXPECT_EQ(spinning["status"], "degenerate");
  EXPECT_EQ(spinning["mobility"], 1);
}

TEST(Degenerate, LinksThatCannotReachAreNoAssembly) {
  const CommandResult result =
      run_assur("solve --format json " ASSUR_EXAMPLES "/quintero_2011_rrp_rrr.json --set EF=20");
  EXPECT_EQ(result.status, 0);
  const Json root = Json::parse(result.output);
  EXPECT_EQ(root["status"], "no-assembly");
  EXPECT_EQ(root["configurations"].size(), 0U);
}

/// What `assur solve` answers to a mechanism of pinned bars. `points` holds, for each "link.name",
/// the coordinates on the link; each entry of `joints` is a pair of points.
Json solved(const std::map<std::string, std::array<double, 2>>& points,
            const std::vector<std::array<std::string, 2>>& joints) {
  Json scene;
  for (const auto& [name, at] : points) {
    const auto dot = name.find('.');
    scene["links"][name.substr(0, dot)][name.substr(dot + 1)] = at;
  }
  for (const auto& pair : joints) {
    const std::string name = pair[0].substr(pair[0].find('.') + 1);
    scene["joints"][name] = {{"type", "revolute"}, {"between", pair}};
  }
  const TemporaryDirectory directory;
  const CommandResult result =
      run_assur("solve --format json " + directory.write("scene.json", scene.dump()).string());
  EXPECT_EQ(result.status, 0) << result.messages;
  return Json::parse(result.output);
}

/// A stretched dyad holds another stretched dyad. The second closes only if the first is known to
/// more digits than the root of its final polynomial.
TEST(Degenerate, AToggleThatHoldsAToggleIsOneConfiguration) {
  const Json apart = solved({{"ground.A", {0, 0}},
                             {"ground.D", {3, 3}},
                             {"ground.G", {1, 2}},
                             {"r0.A", {0, 0}},
                             {"r0.C", {2, 2}},
                             {"r0.B", {1, 0}},
                             {"o0.C", {2, 2}},
                             {"o0.D", {3, 3}},
                             {"r1.B", {0, 0}},
                             {"r1.E", {0, 1}},
                             {"o1.E", {0, 0}},
                             {"o1.G", {0, 1}}},
                            {{"ground.A", "r0.A"},
                             {"r0.C", "o0.C"},
                             {"ground.D", "o0.D"},
                             {"r0.B", "r1.B"},
                             {"r1.E", "o1.E"},
                             {"ground.G", "o1.G"}});
  const Json together = solved({{"ground.A", {0, 0}},
                                {"ground.D", {2, 2}},
                                {"ground.G", {0, 0}},
                                {"r0.A", {0, 0}},
                                {"r0.C", {1, 1}},
                                {"o0.C", {1, 1}},
                                {"o0.D", {2, 2}},
                                {"o0.B", {0, -1}},
                                {"r1.B", {0, 0}},
                                {"r1.E", {0, 2}},
                                {"o1.E", {0, 0}},
                                {"o1.G", {0, -1}}},
                               {{"ground.A", "r0.A"},
                                {"r0.C", "o0.C"},
                                {"ground.D", "o0.D"},
                                {"o0.B", "r1.B"},
                                {"r1.E", "o1.E"},
                                {"ground.G", "o1.G"}});
  for (const Json& root : {apart, together}) {
    EXPECT_EQ(root["status"], "ok");
    ASSERT_EQ(root["configurations"].size(), 1U);
    EXPECT_EQ(root["configurations"][0]["regularity"], "near-singular");
    for (const Json& link : root["configurations"][0]["links"]) {
      EXPECT_NEAR(link["theta"].get<double>(), 0, 1e-12);
    }
  }
}

/// The emitter's messages for a four-bar whose crank lies along the base.
std::string messages_of_emission(double crank, double coupler, double rocker, double base) {
  Json scene;
  scene["links"]["ground"] = {{"A", {0, 0}}, {"D", {base, 0}}};
  scene["links"]["crank"] = {{"A", {0, 0}}, {"B", {crank, 0}}};
  scene["links"]["coupler"] = {{"B", {0, 0}}, {"C", {coupler, 0}}};
  scene["links"]["rocker"] = {{"D", {0, 0}}, {"C", {rocker, 0}}};
  for (const auto& [joint, one, other] :
       {std::array{"A", "ground.A", "crank.A"}, std::array{"B", "crank.B", "coupler.B"},
        std::array{"C", "coupler.C", "rocker.C"}, std::array{"D", "ground.D", "rocker.D"}}) {
    scene["joints"][joint] = {{"type", "revolute"}, {"between", {one, other}}};
  }
  scene["drivers"]["A"] = {{"position", 0}};
  const TemporaryDirectory directory;
  const CommandResult result =
      run_assur("emit --scene " + directory.write("scene.json", scene.dump()).string() +
                " --output " + directory.path().string());
  EXPECT_EQ(result.status, 0) << result.messages;
  EXPECT_TRUE(std::filesystem::exists(directory.path() / "assur/scenes/scene.hpp"));
  return result.messages;
}

TEST(Degenerate, TheEmitterWarnsOfTheScenesOwnNumbers) {
  EXPECT_EQ(messages_of_emission(1, 3, 3, 2), "");
  const auto warns = [](const std::string& messages, const std::string& of) {
    return messages.starts_with("warning: ") && messages.find(of) != std::string::npos;
  };
  EXPECT_PRED2(warns, messages_of_emission(2, 3, 2, 3), "near-singular");
  EXPECT_PRED2(warns, messages_of_emission(2, 3, 3, 2),
               "the solution at the scene's own numbers has a family: the closure of the joints");
  EXPECT_PRED2(warns, messages_of_emission(2, 3, 9, 3), "cannot be assembled");
}

}  // namespace
}  // namespace assur::test::degenerate_test
