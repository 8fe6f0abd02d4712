// Law: a scene that cannot be used gets exit status 2, nothing on standard output, and one line on
// standard error that names the place, the fault and the remedy.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>
#include <utility>
#include <vector>

#include "command/one_line.hpp"

namespace assur::test::bad_input_test {
namespace {

using Json = nlohmann::ordered_json;

/// A change of the worked example that makes it unusable, and what the message must say.
struct Fault {
  const char* name;
  const char* pointer;  ///< JSON pointer of what is replaced
  const char* value;    ///< JSON; empty: the member is removed
  const char* message;
};

class BadScene : public testing::TestWithParam<Fault> {};

TEST_P(BadScene, GetsOneLine) {
  const Fault& fault = GetParam();
  Json scene = Json::parse(read_file(ASSUR_EXAMPLES "/quintero_2011_rrp_rrr.json"));
  const Json::json_pointer pointer(fault.pointer);
  if (*fault.value == '\0') {
    scene[pointer.parent_pointer()].erase(pointer.back());
  } else {
    scene[pointer] = Json::parse(fault.value);
  }
  const TemporaryDirectory directory;
  const auto file = directory.write("scene.json", scene.dump());
  expect_one_line(run_assur("solve " + file.string()), fault.message);
}

constexpr std::array<Fault, 105> faults = {{
    {"UnknownTopLevelKey", "/drivrs", "{}",
     "scene.json: unknown key 'drivrs' (did you mean 'drivers'?)"},
    {"LinksMissing", "/links", "", "the key 'links' is missing"},
    {"JointsMissing", "/joints", "", "the key 'joints' is missing"},
    {"LinksNoObject", "/links", "[]", "links: expected an object {...}, found array"},
    {"LinkNoObject", "/links/rod", "3", "links.rod: expected an object"},
    {"NameNoText", "/name", "7", "name: expected a text, found number"},
    {"NameThatTurnsRound", "/name", "\"a\\u202eb\"",
     "scene.json: name: the byte at offset 1 of 'a?b' is a control character; remove it"},
    {"NameThatRings", "/name", "\"\\u0007\"", "name: the byte at offset 0 of '?' is a control"},
    {"UnitThatTurnsRound", "/unit", "\"mm\\u2066\"", "unit: the byte at offset 2 of 'mm?'"},
    {"LinkThatTurnsRound", "/links/a\u200f", "{}", "links: the byte at offset 1 of 'a?' is"},
    {"FeatureThatTurnsRound", "/links/rod/P\u200e", "[0, 0]", "of 'P?' is a control character"},
    {"JointThatTurnsRound", "/joints/J\u061c", R"({"type": "revolute", "between": []})",
     "joints: the byte at offset 1 of 'J?' is a control character"},
    {"OutputThatTurnsRound", "/outputs/M\u200f", "\"rod.B\"",
     "outputs: the byte at offset 1 of 'M?' is a control character"},
    {"UnknownLink", "/joints/B/between/1", "\"rood.B\"",
     "joints.B.between[1]: no link named 'rood' (did you mean 'rod'?)"},
    {"UnknownFeature", "/joints/B/between/1", "\"rod.Z\"",
     "joints.B.between[1]: link 'rod' has no feature 'Z'"},
    {"ReferenceWithoutDot", "/joints/B/between/1", "\"rod\"", "expected 'link.feature'"},
    {"ReferenceNoText", "/joints/B/between/1", "1", "joints.B.between[1]: expected a text"},
    {"BetweenTooShort", "/joints/B/between", "[\"rod.B\"]", "expected two or more features"},
    {"BetweenNoList", "/joints/B/between", "\"rod.B\"", "expected two or more features"},
    {"LinkTwiceInJoint", "/joints/B/between/0", "\"rod.E\"", "occurs twice in one joint"},
    {"UnknownJointType", "/joints/B/type", "\"revolut\"",
     "joints.B.type: no joint type 'revolut' (did you mean 'revolute'?)"},
    {"JointTypeMissing", "/joints/B/type", "", "joints.B: the key 'type' is missing"},
    {"UnknownJointKey", "/joints/B/axis", "1", "joints.B: unknown key 'axis'"},
    {"PointInPrismatic", "/joints/S/between/1", "\"slider.D\"",
     "a prismatic joint joins two lines"},
    {"LineInRevolute", "/joints/D/between/1", "\"slider.slide\"", "a revolute joint joins points"},
    {"TwoPointsInSlot", "/joints/B/type", "\"pin-in-slot\"",
     "a pin-in-slot joint joins a point and a line"},
    {"PointOfThree", "/links/rod/B", "[0, 0, 0]", "links.rod.B: expected two numbers [x, y]"},
    {"PointOfText", "/links/rod/B", "\"origin\"", "links.rod.B: expected a point"},
    {"CoordinateNoNumber", "/links/rod/B", "[true, 0]",
     "links.rod.B[0]: expected a number or an expression, found boolean"},
    {"LineWithoutSense", "/links/rod/slide/along", "[0, 0]",
     "links.rod.slide.along: [0, 0] has no direction; at least one of the numbers must not be "
     "zero"},
    {"UnusedLineWithoutSense", "/links/rod/unused", R"({"through": [0, 0], "along": [0, "1 - 1"]})",
     "links.rod.unused.along: [0, 0] has no direction; at least one of the numbers must not be "
     "zero"},
    {"LineWithoutPoint", "/links/rod/slide/through", "", "the key 'through' is missing"},
    {"UnknownLineKey", "/links/rod/slide/angle", "0", "links.rod.slide: unknown key 'angle'"},
    {"UnknownParameter", "/links/rod/E", "[\"BEE\", 0]",
     "links.rod.E[0]: no parameter named 'BEE' (did you mean 'BE'?)"},
    {"BadExpression", "/links/rod/E", "[\"BE*\", 0]", "at column 4 of 'BE*'"},
    {"UnknownFunction", "/links/rod/E", "[\"sinh(1)\", 0]",
     "no function named 'sinh' (did you mean 'sin'?) at column 1"},
    {"WrongArity", "/links/rod/E", "[\"atan2(1)\", 0]", "atan2 takes two arguments"},
    {"UnclosedBracket", "/links/rod/E", "[\"(1 + 2\", 0]", "expected ')' at column 7"},
    {"NumberOutOfRange", "/links/rod/E", "[\"1e999\", 0]", "the number is outside the range"},
    {"DivisionByZero", "/links/rod/E", "[\"1/0\", 0]", "the value is not a finite number"},
    {"RootOfNegative", "/links/rod/E", "[\"sqrt(-1)\", 0]", "the value is not a finite number"},
    {"ParameterCycle", "/parameters/AB", "\"2*AB\"", "the parameter depends on itself"},
    {"ParameterReserved", "/parameters/pi", "3", "'pi' is the name of a function or constant"},
    {"ParameterName", "/parameters/1st", "3", "'1st' is not a name"},
    {"NegativeTolerance", "/parameters/AB/tolerance", "-1", "cannot be negative"},
    {"NegativeMiss", "/redundancy", R"({"tolerance": -1})",
     "redundancy.tolerance: a tolerance is a distance and cannot be negative"},
    {"UnknownParameterKey", "/parameters/AB/tol", "1", "parameters.AB: unknown key 'tol'"},
    {"UnknownDriver", "/drivers/AA", "{\"position\": 0}", "no joint named 'AA'"},
    {"DriverWithoutPosition", "/drivers/A/position", "",
     "drivers.A.position: the joint 'A' has no coordinate in the drawing; give a value"},
    {"OutputOfLine", "/outputs/E", "\"rod.slide\"", "an output is a point"},
    {"UnknownWant", "/want", "[\"speed\"]",
     "want[0]: no such result 'speed' (choose from position, velocity, acceleration, "
     "sensitivity, forces, dynamics, coefficients)"},
    {"SweepCount", "/sweep", "{\"parameter\": \"phi\", \"from\": 0, \"to\": 1, \"count\": 0}",
     "sweep.count: expected a whole number"},
    {"SweepParameter", "/sweep", "{\"parameter\": \"psi\", \"from\": 0, \"to\": 1, \"count\": 2}",
     "sweep.parameter: no parameter named 'psi' (did you mean 'phi'?)"},
    {"CovarianceNoObject", "/covariance", "[]", "covariance: expected an object"},
    {"UnknownCovarianceKey", "/covariance", "{\"parameter\": []}",
     "covariance: unknown key 'parameter' (did you mean 'parameters'?)"},
    {"CovarianceWithoutParameters", "/covariance", "{\"matrix\": []}",
     "covariance: the key 'parameters' is missing"},
    {"CovarianceWithoutMatrix", "/covariance", "{\"parameters\": [\"AB\"]}",
     "covariance: the key 'matrix' is missing"},
    {"CovarianceOfNothing", "/covariance", "{\"parameters\": [], \"matrix\": []}",
     "covariance.parameters: expected one or more names"},
    {"CovarianceOfNumber", "/covariance", "{\"parameters\": [1], \"matrix\": [[1]]}",
     "covariance.parameters[0]: expected a text, found number"},
    {"CovarianceOfUnknown", "/covariance",
     "{\"parameters\": [\"AB\", \"AC\"], \"matrix\": [[1, 0], [0, 1]]}",
     "covariance.parameters[1]: no parameter named 'AC' (did you mean"},
    {"CovarianceTwice", "/covariance",
     "{\"parameters\": [\"AB\", \"AB\"], \"matrix\": [[1, 0], [0, 1]]}",
     "covariance.parameters[1]: the parameter 'AB' occurs twice"},
    {"CovarianceNoMatrix", "/covariance", "{\"parameters\": [\"AB\"], \"matrix\": 1}",
     "covariance.matrix: expected a row for each of the parameters, 1 in all"},
    {"CovarianceRowMissing", "/covariance",
     "{\"parameters\": [\"AB\", \"AG\"], \"matrix\": [[1, 0]]}",
     "covariance.matrix: expected a row for each of the parameters, 2 in all"},
    {"CovarianceNumberMissing", "/covariance",
     "{\"parameters\": [\"AB\", \"AG\"], \"matrix\": [[1, 0], [1]]}",
     "covariance.matrix[1]: expected a number for each of the parameters, 2 in all"},
    {"CovarianceNoNumber", "/covariance", "{\"parameters\": [\"AB\"], \"matrix\": [[true]]}",
     "covariance.matrix[0][0]: expected a number or an expression"},
    {"CovarianceUnknownName", "/covariance", "{\"parameters\": [\"AB\"], \"matrix\": [[\"s^2\"]]}",
     "covariance.matrix[0][0]: no parameter named 's'"},
    {"CovarianceNotFinite", "/covariance",
     "{\"parameters\": [\"AB\"], \"matrix\": [[\"1/(AB - 100)\"]]}",
     "covariance.matrix[0][0]: the value is not a finite number"},
    {"CovarianceNegative", "/covariance",
     "{\"parameters\": [\"AB\", \"AG\"], \"matrix\": [[1, 0], [0, -1]]}",
     "covariance.matrix[1][1]: a variance cannot be negative"},
    {"CovarianceNotSymmetric", "/covariance",
     "{\"parameters\": [\"AB\", \"AG\"], \"matrix\": [[1, 0.5], [0.4, 1]]}",
     "covariance.matrix[1][0]: the matrix is not symmetric: 0.4 here, 0.5 in [0][1]"},
    {"CovarianceTooLarge", "/covariance",
     "{\"parameters\": [\"AB\", \"AG\"], \"matrix\": [[1, 6.000001], [6.000001, 36]]}",
     "covariance.matrix[1][0]: a covariance of 6 is more than its variances allow (at most 6,"},
    {"CovarianceOfConstant", "/covariance",
     "{\"parameters\": [\"AB\", \"AG\"], \"matrix\": [[1, 1e-9], [1e-9, 0]]}",
     "covariance.matrix[1][0]: a covariance of 1e-09 is more than"},
    {"CovarianceIndefinite", "/covariance",
     "{\"parameters\": [\"AB\", \"AG\", \"BE\"], \"matrix\": [[1, 0.9, 0], [0.9, 1, 0.9], [0, 0.9, "
     "1]]}",
     "covariance.matrix: no parameters can vary like this: the matrix is not positive "
     "semi-definite"},
    {"NoLinkIsGround", "", R"({"links": {"a": {}}, "joints": {}})",
     "links: no link is named 'ground', so nothing holds the mechanism"},
    {"UnitNoText", "/unit", "3", "unit: expected a text, found number"},
    {"ParameterWithoutValue", "/parameters/AB", R"({"tolerance": 1})",
     "parameters.AB: the key 'value' is missing"},
    {"VariableNoTruth", "/parameters/AB/variable", "1",
     "parameters.AB.variable: expected true or false"},
    {"RateOfUnknown", "/parameters/AB/velocity", "\"AX\"",
     "parameters.AB.velocity: no parameter named 'AX'"},
    {"ExpressionOfNothing", "/links/rod/E", R"(["", 0])",
     "links.rod.E[0]: the expression ends where a number, a name or '(' is expected at column 1"},
    {"ExpressionOfSigns", "/links/rod/E", "[\"2*)\", 0]",
     "links.rod.E[0]: expected a number, a name or '(', found ')' at column 3"},
    {"FunctionWithoutBracket", "/links/rod/E", R"(["sin 3", 0])",
     "links.rod.E[0]: expected '(' after the function sin at column 5"},
    {"InfiniteDerivative", "/links/rod/E", "[\"BE\", \"sqrt(AB - 100)\"]",
     "links.rod.E[1]: the derivative with respect to the parameters is not finite here"},
    {"CoordinateTooLarge", "/links/rod/E", "[1e200, 0]",
     "links.rod.E: a coordinate is larger than 2^400; give the lengths in another unit"},
    {"SlideOfThree", "/joints/S/between", R"(["rod.slide", "slider.slide", "ground.A"])",
     "joints.S.between: only a revolute joint may join more than two links"},
    {"LimitsOfOne", "/joints/A/limits", "[1]", "joints.A.limits: expected the limits [lowest, "},
    {"LimitsExchanged", "/joints/A/limits", "[2, 1]",
     "joints.A.limits: the lowest is above the highest; exchange the two"},
    {"UnknownDriverKey", "/drivers/A/positon", "3",
     "drivers.A: unknown key 'positon' (did you mean 'position'?)"},
    {"DriverNoObject", "/drivers/A", "3", "drivers.A: expected an object {...}, found number"},
    {"OutputNoText", "/outputs/E", "3", "outputs.E: expected a text, found number"},
    {"WantNoList", "/want", "\"position\"",
     "want: expected a list of position, velocity, acceleration, sensitivity"},
    {"ReportKey", "/report", R"({"link": []})",
     "report: unknown key 'link' (did you mean 'links'?)"},
    {"ReportNoList", "/report", R"({"links": "rod"})",
     "report.links: expected a list of the names of links"},
    {"ReportUnknownLink", "/report", R"({"links": ["rood"]})",
     "report.links[0]: no link named 'rood' (did you mean 'rod'?)"},
    {"EmptyJoint", "/joints", R"({"": {"type": "revolute", "between": ["ground.A", "crank.A"]}})",
     "joints: a name is empty; give each part a name"},
    {"EmptyFeature", "/links/crank/", "[0, 0]", "links.crank.: a name is empty; give each part"},
    {"EmptyOutput", "/outputs", R"({"": "crank.A"})", "outputs: a name is empty; give each part"},
    {"WantTwice", "/want", R"(["position", "position"])", "want[1]: 'position' occurs twice"},
    {"ReportTwice", "/report", R"({"links": ["rod", "rod"]})", "report.links: 'rod' occurs twice"},
    {"ReportOfPin", "/report", R"({"joints": ["B"]})",
     "report.joints: the joint 'B' is revolute and has no displacement"},
    {"ReferenceUnknownLink", "/reference", R"({"rood": 1})",
     "reference: no link named 'rood' (did you mean 'rod'?)"},
    {"ReferenceOfGround", "/reference", R"({"ground": 1})",
     "reference.ground: the ground stands still in all configurations; name a moving link"},
    {"UnknownRedundancyKey", "/redundancy", R"({"tol": 1})", "redundancy: unknown key 'tol'"},
    {"RedundancyWithoutTolerance", "/redundancy", "{}",
     "redundancy: the key 'tolerance' is missing"},
    {"UnknownSweepKey", "/sweep", R"({"parametr": "phi"})",
     "sweep: unknown key 'parametr' (did you mean 'parameter'?)"},
    {"UnderConstrained", "/joints/E", "",
     "links: under-constrained by 2: the links rod, lever, slider, bar can still move"},
    {"NoGround", "/links/ground", "", "no link named 'ground'"},
}};

INSTANTIATE_TEST_SUITE_P(Faults, BadScene, testing::ValuesIn(faults),
                         [](const auto& fault) { return std::string(fault.param.name); });

/// At AB = 100, (AB - 100)^1.5 has a gradient of zero and an infinite second derivative.
TEST(BadCovariance, NeedsSecondDerivatives) {
  Json scene = Json::parse(read_file(ASSUR_EXAMPLES "/quintero_2011_rrp_rrr.json"));
  scene["links"]["rod"]["E"] = {"BE", "(AB - 100)^1.5"};
  const TemporaryDirectory directory;
  EXPECT_EQ(run_assur("solve " + directory.write("scene.json", scene.dump()).string()).status, 0);
  scene["covariance"] = {{"parameters", {"AB"}}, {"matrix", Json::parse("[[1]]")}};
  expect_one_line(run_assur("solve " + directory.write("scene.json", scene.dump()).string()),
                  "links.rod.E[1]: the second derivative with respect to the parameters is not "
                  "finite here, and a covariance needs it");
}

TEST(BadFile, Missing) { expect_one_line(run_assur("solve /no/such/file.json"), "cannot be read"); }
TEST(BadFile, Directory) {
  const TemporaryDirectory directory;
  expect_one_line(run_assur("solve " + directory.path().string()), "cannot be read");
}
TEST(BadFile, NotJson) {
  const TemporaryDirectory directory;
  const auto file = directory.write("scene.json", "{\"links\": {,}}");
  expect_one_line(run_assur("solve " + file.string()), "not JSON: parse error at line 1");
}
TEST(BadFile, Empty) {
  const TemporaryDirectory directory;
  const auto file = directory.write("scene.json", " \n");
  expect_one_line(run_assur("solve " + file.string()),
                  "the text is empty; expected a scene in JSON, {...}");
}
TEST(BadFile, KeyTwice) {
  const TemporaryDirectory directory;
  const auto file = directory.write("scene.json", R"({"name": "a", "name": "b"})");
  expect_one_line(run_assur("solve " + file.string()), "the key 'name' occurs twice");
}
TEST(BadFile, NumberOutOfRange) {
  const TemporaryDirectory directory;
  const auto file = directory.write("scene.json", R"({"links": {"ground": {"A": [1e999, 0]}}})");
  expect_one_line(run_assur("solve " + file.string()), "not JSON: number overflow");
}
TEST(BadFile, Endless) { expect_one_line(run_assur("solve /dev/zero"), "longer than 8 MiB"); }
TEST(BadFile, Huge) {
  const TemporaryDirectory directory;
  const auto file = directory.write("scene.json", "{}");
  std::filesystem::resize_file(file, std::uintmax_t{1} << 30);
  expect_one_line(run_assur("solve " + file.string()), "longer than 8 MiB");
}
/// The text of an example with a NUL byte before the byte at a place, or behind its end.
std::string with_nul(const std::string& file, std::size_t place) {
  std::string text = read_file(file);
  return text.insert(std::min(place, text.size()), 1, '\0');
}

TEST(BadFile, NulBytes) {
  const TemporaryDirectory directory;
  const std::string scene = ASSUR_EXAMPLES "/four_bar_coupler_curve.json";
  const std::string audits = ASSUR_EXAMPLES "/audit/";
  const auto refused = [&](const std::string& call, const std::string& name,
                           const std::string& text, const std::string& place) {
    const std::string file = directory.write(name, text).string();
    expect_one_line(run_assur(call + file), file + ":" + place +
                                                ": a NUL byte; remove it, or save the file as "
                                                "UTF-8");
  };
  const std::size_t end = std::string::npos;
  const std::string out = " --output " + (directory.path() / "out").string();
  for (const auto& [at, place] : std::vector<std::pair<std::size_t, std::string>>{
           {0, "1:1"}, {1, "1:2"}, {2, "2:1"}, {13, "2:12"}, {end, "28:1"}}) {
    refused("solve ", "scene.json", with_nul(scene, at), place);
  }
  refused("solve ", "scene.json", with_nul(scene, end) + "text that nobody reads", "28:1");
  for (const std::string call :
       {"solve --format csv ", "draw --output DIR.svg ",
        "sample --count 2 --seed 1 --output DIR.csv ", "map --over phi=0:1:2 --output DIR.csv "}) {
    refused(std::regex_replace(call, std::regex(" --output DIR"), out), "scene.json",
            with_nul(scene, end), "28:1");
  }
  refused("emit" + out + " --scene ", "scene.json", with_nul(scene, end), "28:1");
  refused("emit" + out + " --closures ", "a.audit", with_nul(audits + "slider_crank.audit", 0),
          "1:1");
  refused("audit ", "a.audit", with_nul(audits + "slider_crank.audit", 0), "1:1");
  const std::string paper = audits + "quintero_2011";
  refused("audit --map " + paper + ".map ", "a.tex", with_nul(paper + ".tex", 0), "1:1");
  refused("audit " + paper + ".tex --map ", "a.map", with_nul(paper + ".map", 0), "1:1");
  // The message stands at the line of the audit that names the program.
  const std::string own = audits + "own_model/gear_five_bar";
  (void)directory.write("gear_five_bar.cpp", with_nul(own + ".cpp", end));
  const auto audit = directory.write("gear_five_bar.audit", read_file(own + ".audit"));
  expect_one_line(run_assur("audit " + audit.string()), ": a NUL byte; remove it");
  EXPECT_FALSE(std::filesystem::exists(directory.path() / "out"));
}

TEST(BadFile, ListsInLists) {
  const TemporaryDirectory directory;
  for (const std::string text : {"[", "{\"links\":"}) {
    std::string nested;
    for (int depth = 0; depth < 100000; ++depth) {
      nested += text;
    }
    expect_one_line(run_assur("solve " + directory.write("scene.json", nested).string()),
                    "the lists and objects are nested too deeply for a scene");
  }
}
TEST(BadFile, DeeplyNested) {
  const TemporaryDirectory directory;
  const auto file = directory.write("scene.json", R"({"joints": {}, "links": {"ground": {"A": [")" +
                                                      std::string(5000, '(') + R"(", 0]}}})");
  expect_one_line(run_assur("solve " + file.string()), "nested too deeply");
}

TEST(BadFile, EndlessExpression) {
  const TemporaryDirectory directory;
  std::string sum = "1";
  for (int term = 0; term < 100000; ++term) {
    sum += "+1";
  }
  const auto file = directory.write(
      "scene.json", R"({"joints": {}, "links": {"ground": {"A": [")" + sum + R"(", 0]}}})");
  expect_one_line(run_assur("solve " + file.string()), "longer than 10000 characters");
}

}  // namespace
}  // namespace assur::test::bad_input_test
