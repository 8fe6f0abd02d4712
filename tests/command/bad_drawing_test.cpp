// Law: a drawn scene that cannot be used gets exit status 2 and one line that names the place, the
// fault and the mend.
#include <gtest/gtest.h>

#include <array>
#include <nlohmann/json.hpp>

#include "command/one_line.hpp"

namespace assur::test::bad_drawing_test {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* four_bar = R"({
  "points": {"A": [0, 0], "B": [20, 34.6], "C": [3.1, -63.9], "D": [80, 0], "P": [-13.8, -162.5],
             "C2": [3.1, -63.9], "Q": [50, 50]},
  "links": {"ground": ["A", "D"], "crank": ["A", "B"], "coupler": ["B", "C", "P"],
            "rocker": ["D", "C"]},
  "drivers": {"A": {"velocity": 10}},
  "outputs": {"P": "P"}})";

/// A change of the four-bar that makes it unusable, and what the message must say.
struct Fault {
  const char* name;
  const char* patch;  ///< a JSON merge patch: null removes a member
  const char* message;
};

class BadDrawing : public testing::TestWithParam<Fault> {};

TEST_P(BadDrawing, GetsOneLine) {
  Json scene = Json::parse(four_bar);
  scene.merge_patch(Json::parse(GetParam().patch));
  const TemporaryDirectory directory;
  const auto file = directory.write("scene.json", scene.dump());
  expect_one_line(run_assur("solve " + file.string()),
                  std::string("scene.json: ") + GetParam().message);
}

TEST(GoodDrawing, IsSolved) {
  const TemporaryDirectory directory;
  EXPECT_EQ(run_assur("solve " + directory.write("scene.json", four_bar).string()).status, 0);
}

constexpr auto faults = std::to_array<Fault>({
    {"UnknownPoint", R"({"links": {"rocker": ["D", "Cc"]}})",
     "links.rocker[1]: no point named 'Cc' (did you mean 'C'"},
    {"PointTwice", R"({"links": {"rocker": ["D", "C", "D"]}})",
     "links.rocker[2]: the point 'D' is listed twice"},
    {"NoPoint", R"({"links": {"x": []}})", "links.x: expected one or more drawn points"},
    {"PointNoName", R"({"links": {"x": [7]}})", "links.x[0]: expected a text, found number"},
    {"PointsNoObject", R"({"points": []})", "points: expected an object {...}, found array"},
    {"PointNoPair", R"({"points": {"A": [0]}})", "points.A: expected two numbers [x, y]"},
    {"PointOfUnknownParameter", R"({"points": {"A": ["a", 0]}})",
     "points.A[0]: no parameter named 'a'"},
    {"PointNotFinite", R"({"points": {"A": ["1/0", 0]}})",
     "points.A[0]: the value is not a finite number"},
    {"PointWithDot", R"({"points": {"A.b": [0, 0]}})",
     "points: 'A.b' has a dot, which stands between the names of a link and its feature; write "
     "another letter"},
    {"PointWithoutName", R"({"points": {"": [0, 0]}})", "points: a name is empty"},
    {"CoincidingAxis", R"({"links": {"coupler": ["C", "C2", "B"]}})",
     "links.coupler: the points C and C2 coincide in the drawing, so that its x-axis has no "
     "direction; list another point second"},
    {"CoincidingLine",
     R"({"links": {"tube": ["C"], "rod": ["C2"]},
         "joints": {"S": {"type": "prismatic", "between": ["tube.C", "rod.C2"]}}})",
     "joints.S: the points C and C2 coincide in the drawing, so that the line has no direction"},
    {"CoincidingAlong",
     R"({"joints": {"S": {"type": "prismatic", "links": ["ground", "coupler"],
                          "along": ["C", "C2"]}}})",
     "joints.S: the points C and C2 coincide in the drawing, so that the line has no direction"},
    {"NoDirection",
     R"({"joints": {"S": {"type": "prismatic", "links": ["ground", "coupler"], "at": "C",
                          "direction": [0, 0]}}})",
     "joints.S.direction: [0, 0] has no direction; at least one of the numbers must not be zero"},
    {"UnknownLink",
     R"({"joints": {"S": {"type": "prismatic", "links": ["coupler", "grund"],
                          "along": ["A", "D"]}}})",
     "joints.S.links[1]: no link named 'grund' (did you mean 'ground'?)"},
    {"LinkWithFrame",
     R"({"links": {"piston": {"C": [0, 0]}},
         "joints": {"S": {"type": "prismatic", "links": ["ground", "piston"],
                          "along": ["A", "D"]}}})",
     "joints.S.links[1]: the link 'piston' has a frame of its own; join it with 'between', or "
     "list "
     "its drawn points"},
    {"LinkTwice", R"({"joints": {"S": {"type": "revolute", "links": ["ground", "ground"],
                                       "at": "A"}}})",
     "joints.S.links[1]: the link 'ground' occurs twice in one joint"},
    {"OneLink", R"({"joints": {"S": {"type": "revolute", "links": ["ground"], "at": "A"}}})",
     R"(joints.S.links: expected the links that the joint joins, ["a", "b"])"},
    {"NoLinks", R"({"joints": {"S": {"type": "revolute", "at": "A"}}})",
     R"(joints.S.links: expected the links that the joint joins, ["a", "b"])"},
    {"ThreeLinksOnALine",
     R"({"joints": {"S": {"type": "prismatic", "links": ["ground", "crank", "rocker"],
                          "along": ["A", "D"]}}})",
     "joints.S.links: expected two links"},
    {"LineMissing", R"({"joints": {"S": {"type": "prismatic", "links": ["ground", "coupler"]}}})",
     R"(joints.S: a line is missing: "along": ["A", "D"], or "direction": [dx, dy] with "at")"},
    {"SlotWithoutLine",
     R"({"joints": {"S": {"type": "pin-in-slot", "links": ["coupler", "ground"], "at": "P"}}})",
     R"(joints.S: a line is missing: "along": ["A", "D"], or "direction": [dx, dy] with "at")"},
    {"TwoLines",
     R"({"joints": {"S": {"type": "pin-in-slot", "links": ["coupler", "ground"], "at": "P",
                          "along": ["A", "D"], "direction": [1, 0]}}})",
     "joints.S: 'along' and 'direction' both give a line; leave one out"},
    {"LineOfOnePoint",
     R"({"joints": {"S": {"type": "prismatic", "links": ["ground", "coupler"], "along": ["A"]}}})",
     R"(joints.S.along: expected two drawn points ["A", "D"])"},
    {"LineOfUnknownPoint",
     R"({"joints": {"S": {"type": "prismatic", "links": ["ground", "coupler"],
                          "along": ["A", "Dd"]}}})",
     "joints.S.along[1]: no point named 'Dd' (did you mean 'D'"},
    {"PinAtUnknownPoint",
     R"({"joints": {"S": {"type": "revolute", "links": ["crank", "ground"]}}})",
     "joints.S.at: no point named 'S'"},
    {"BetweenAndLinks",
     R"({"joints": {"S": {"type": "revolute", "links": ["crank", "ground"],
                          "between": ["crank.A", "ground.A"]}}})",
     "joints.S: 'between' names features that say all; leave it out, or 'links', 'at', 'along' "
     "and "
     "'direction'"},
    {"BetweenOfUnknownPoint",
     R"({"joints": {"S": {"type": "revolute", "between": ["crank.Aa", "ground.A"]}}})",
     "joints.S.between[0]: no point named 'Aa' (did you mean 'A'"},
    {"NameOfAPin",
     R"({"joints": {"C": {"type": "pin-in-slot", "links": ["coupler", "ground"], "at": "P",
                          "along": ["A", "D"]}}})",
     "joints.C: the links coupler, rocker are pinned at the point C, and this joint, which has "
     "its "
     "name, does not join them all; name the joint otherwise, or name all links"},
    {"DriverWithoutSense", R"({"drivers": {"C": {}}})",
     "drivers.C: the joint C joins the moving links coupler and rocker; say from which to which "
     "it "
     R"(is measured: "joints": {"C": {"type": "revolute", "links": ["coupler", "rocker"]}})"},
    {"NoLinkCalledGround", R"({"links": {"ground": null, "base": ["A", "D"]}})",
     R"(drivers.A: the joint A joins the moving links base and crank; say from which to which it )"
     R"(is measured: "joints": {"A": {"type": "revolute", "links": ["base", "crank"]}}; or call )"
     "the link that stands still 'ground'"},
    {"OutputsOfOneName", R"({"outputs": "P"})",
     R"(outputs: expected a list of drawn points, ["P"], or an object {...}, found string)"},
    {"DriverWithoutSenseButPosition", R"({"drivers": {"C": {"position": 1}}})",
     "drivers.C: the joint C joins the moving links coupler and rocker; say from which"},
    {"LawWithoutSense", R"-({"drivers": {"A": {"position": "joint(C)"}}})-",
     "drivers.A.position: the joint C joins the moving links coupler and rocker; say from which"},
    {"ParameterWithoutSense", R"({"parameters": {"x": {"drawn": "C"}}})",
     "parameters.x.drawn: the joint C joins the moving links coupler and rocker; say from which"},
    {"DriverOfObjectLinks",
     R"({"links": {"ground": {"A": [0, 0], "D": [80, 0]}},
         "joints": {"A": {"type": "revolute", "between": ["ground.A", "crank.A"]},
                    "D": {"type": "revolute", "between": ["ground.D", "rocker.D"]}}})",
     "drivers.A.position: the joint 'A' has no coordinate in the drawing; give a value"},
    {"DriverOfThreeLinks", R"({"links": {"other": ["A", "Q"]}})",
     "drivers.A.position: the joint 'A' has no coordinate in the drawing; give a value"},
    {"ParameterOfThreeLinks", R"({"links": {"other": ["A", "Q"]}, "drivers": null,
                                  "parameters": {"x": {"drawn": "A"}}})",
     "parameters.x.drawn: the joint 'A' has no coordinate in the drawing; give a value"},
    {"OutputOfNoLink", R"({"outputs": {"Q": "Q"}})", "outputs.Q: no link lists the point 'Q'"},
    {"OutputOfNoPoint", R"({"outputs": ["P", "R"]})", "outputs.R: no point named 'R'"},
    {"OutputTwice", R"({"outputs": ["P", "P"]})", "outputs: the name 'P' is taken"},
    {"OutputOfUnknownPoint", R"({"outputs": {"R": "coupler.R"}})", "outputs.R: no point named 'R'"},
    {"LengthOfNoLink", R"({"parameters": {"AC": {"drawn": ["A", "C"]}}})",
     "parameters.AC.drawn: no link lists both A and C"},
    {"LengthOfNoPoint", R"({"parameters": {"AC": {"drawn": ["A", "Cc"]}}})",
     "parameters.AC.drawn: no point named 'Cc' (did you mean 'C'"},
    {"LengthOfOnePoint", R"({"parameters": {"AC": {"drawn": ["A", "A"]}}})",
     "parameters.AC.drawn: expected two points of one link, or the name of a joint"},
    {"LengthOfThreePoints", R"({"parameters": {"AC": {"drawn": ["A", "B", "C"]}}})",
     "parameters.AC.drawn: expected two points of one link, or the name of a joint"},
    {"LengthOfNothing", R"({"parameters": {"AC": {"drawn": []}}})",
     "parameters.AC.drawn: expected two points of one link, or the name of a joint"},
    {"LengthOfANumber", R"({"parameters": {"AC": {"drawn": 3}}})",
     "parameters.AC.drawn: expected two points of one link, or the name of a joint"},
    {"LengthAmongFurtherPoints",
     R"({"links": {"coupler": ["B", "C", "P", "Q"]}, "parameters": {"PQ": {"drawn": ["P", "Q"]}}})",
     "parameters.PQ.drawn: neither P nor Q is the first or second point of the link coupler; "
     "list "
     "one of them there"},
    {"LengthTwice", R"({"parameters": {"a": {"drawn": ["A", "B"]}, "b": {"drawn": ["B", "A"]}}})",
     "parameters.b.drawn: the distance of B and A is the parameter a already"},
    {"FlatTriangle",
     R"({"points": {"B": [0, 0], "C": [100, 0], "P": [200, 0], "A": [-40, 0]},
         "parameters": {"BP": {"drawn": ["B", "P"]}, "CP": {"drawn": ["C", "P"]}}})",
     "parameters.CP.drawn: B, C and P lie on one line in the link coupler, so that two of their "
     "distances settle the third; let 'CP' be a formula without 'drawn'"},
    {"NoTriangle",
     R"({"links": {"coupler": ["B", "C", "Q"]}, "outputs": null,
         "parameters": {"BQ": {"drawn": ["B", "Q"], "value": 1}, "CQ": {"drawn": ["C", "Q"],
                        "value": 2}, "BC": {"drawn": ["B", "C"], "value": 41.5}}})",
     "parameters.CQ: the distances BC = 41.5, BQ = 1 and CQ = 2 of the link coupler form no "
     "triangle"},
    {"SharedLengthWithoutValue", R"({"parameters": {"r": {"drawn": [["A", "B"], ["D", "C"]]}}})",
     "parameters.r: several distances share the parameter; give its 'value'"},
    {"CoordinateWithValue", R"({"parameters": {"phi": {"drawn": "A", "value": 1}}})",
     "parameters.phi: 'drawn' names a joint, so 'value' would not be used; leave one out"},
    {"CoordinateOfNoJoint", R"({"parameters": {"phi": {"drawn": "a"}}})",
     "parameters.phi.drawn: no joint named 'a' (did you mean 'A'"},
    {"LengthThatMakesItself",
     R"({"points": {"B": ["x", 0]}, "parameters": {"x": {"drawn": ["A", "B"]}}})",
     "parameters.x: the parameter depends on itself"},
    {"CoincidingRay",
     R"({"links": {"coupler": ["C", "B", "C2"]}, "outputs": null,
         "parameters": {"x": {"drawn": ["C", "C2"], "value": 1}}})",
     "parameters.x.drawn: a point of the link coupler coincides with C in the drawing, so that "
     "their distance has no direction"},
    {"LinkWithoutPins", R"({"links": {"rocker": {"D": [0, 0], "C": [100, 0]}}})",
     "links: under-constrained by 4: the links coupler, rocker can still move; drive one of "
     "their "
     "joints, or add a joint; the link rocker has a frame of its own, so that no point pins it: "
     "name its joints"},
    {"LineFromNoPoint",
     R"({"links": {"rocker": {"D": [0, 0], "C": [9, 0], "s": {"from": "D", "to": "Cc"}}}})",
     "links.rocker.s.to: link 'rocker' has no feature 'Cc' (did you mean 'C'"},
    {"LineToNothing", R"({"links": {"rocker": {"D": [0, 0], "s": {"from": "D"}}}})",
     "links.rocker.s: the key 'to' is missing"},
    {"LineFromLine",
     R"({"links": {"rocker": {"D": [0, 0], "g": {"through": [0, 0], "along": [1, 0]},
                              "s": {"from": "D", "to": "g"}}}})",
     "links.rocker.s.to: expected a point, and 'g' is a line"},
    {"LineOfOneFeature", R"({"links": {"rocker": {"D": [0, 0], "s": {"from": "D", "to": "D"}}}})",
     "links.rocker.s: the points D and D coincide, so that the line has no direction"},
});

INSTANTIATE_TEST_SUITE_P(Faults, BadDrawing, testing::ValuesIn(faults),
                         [](const auto& fault) { return std::string(fault.param.name); });

}  // namespace
}  // namespace assur::test::bad_drawing_test
