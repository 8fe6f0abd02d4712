// Law: arguments that cannot be used get exit status 2, nothing on standard output, and one line on
// standard error that names the argument, the fault and the remedy.
#include <gtest/gtest.h>

#include <array>
#include <nlohmann/json.hpp>
#include <vector>

#include "command/one_line.hpp"

namespace assur::test::bad_arguments_test {
namespace {

using Json = nlohmann::ordered_json;

TEST(BadArguments, UnknownSetting) {
  expect_one_line(run_assur("solve " ASSUR_EXAMPLES "/quintero_2011_rrp_rrr.json --set AC=3"),
                  "--set: no parameter named 'AC'");
}
TEST(BadArguments, SettingWithoutValue) {
  expect_one_line(run_assur("solve " ASSUR_EXAMPLES "/quintero_2011_rrp_rrr.json --set A=3"),
                  "--set: 'A' is a driver, not a parameter; let its 'position' be a formula in a "
                  "parameter, and set that");
  expect_one_line(run_assur("solve " ASSUR_EXAMPLES "/quintero_2011_rrp_rrr.json --set AB=50mm"),
                  "--set AB: expected an operator, found 'm' (a product is written with '*')");
  expect_one_line(run_assur("solve " ASSUR_EXAMPLES "/quintero_2011_rrp_rrr.json --set AB"),
                  "--set: expected NAME=EXPR");
  expect_one_line(
      run_assur("solve " ASSUR_EXAMPLES "/quintero_2011_rrp_rrr.json --set 'AB=6\u00b0'"),
      "--set AB: expected an operator, found '\u00b0' (write '*deg')");
}
TEST(BadArguments, MapForAnAuditFile) {
  const std::string file = ASSUR_EXAMPLES "/audit/own_model/gear_five_bar.audit";
  expect_one_line(run_assur("audit " + file + " --map " + file),
                  file + ": a map belongs to a paper (.tex); leave --map out");
}
TEST(BadArguments, UnknownResult) {
  expect_one_line(run_assur("emit --scene " ASSUR_EXAMPLES
                            "/four_bar_coupler_curve.json --want postion --output ."),
                  "--want: no result named 'postion' (did you mean 'position'?)");
}
TEST(BadArguments, UnknownSubcommand) {
  const CommandResult result = run_assur("solv");
  expect_one_line(result, "see assur --help");
  expect_one_line(result, "no subcommand 'solv' (did you mean 'solve'?)");
}
TEST(BadArguments, NameTheirSubcommand) {
  expect_one_line(run_assur("solve a b"),
                  "solve: the argument 'b' is one too many; leave it out (see assur solve --help)");
  expect_one_line(run_assur("derive"),
                  "derive: KIND_OR_MODEL is required (see assur derive --help)");
}
TEST(BadArguments, MissingOrRepeated) {
  const std::string scene = ASSUR_EXAMPLES "/four_bar_coupler_curve.json";
  const std::vector<std::array<std::string, 2>> calls = {
      {"solve", "error: solve: SCENE is required (see assur solve --help)\n"},
      {"merge", "error: merge: FILE is required (see assur merge --help)\n"},
      {"audit", "error: audit: FILE is required (see assur audit --help)\n"},
      {"solve " + scene + " --branch", "error: solve: --branch needs a value (see assur solve"},
      {"solve " + scene + " --format", "error: solve: --format needs a value (see assur solve"},
      {"solve " + scene + " --branch 1 --branch 2",
       "error: solve: --branch may be given only once (see assur solve"},
      {"emit",
       "error: emit: --output is required, and exactly one of --all, --model, --scene, --closures "
       "(see assur emit"},
      {"emit --all", "error: emit: --output is required (see assur emit"},
      {"emit --output .",
       "error: emit: give exactly one of --all, --model, --scene, --closures (see assur emit"},
      {"emit --all --model 1 --output .",
       "error: emit: give exactly one of --all, --model, --scene, --closures (see assur emit"},
      {"emit --all --group dyad --output .",
       "error: emit: --group has an effect only with --model; add --model, or leave --group out"}};
  for (const auto& [call, message] : calls) {
    expect_one_line(run_assur(call), message);
  }
}

/// Messages show values of any length and with any characters on one line, shortened.
TEST(BadArguments, OfAnyLengthAndLetters) {
  const std::string scene = ASSUR_EXAMPLES "/four_bar_coupler_curve.json";
  const std::string endless(70000, 'x');
  const std::string shown = "'" + std::string(40, 'x') + "...'";
  const std::vector<std::array<std::string, 2>> calls = {
      {"solve " + scene + " --format " + endless, "--format: " + shown + " is not one of text"},
      {"solve " + scene + " --branch " + endless, "--branch: expected a whole number from 1 on"},
      {"sample " + scene + " --threads " + endless, "--threads: expected a whole number from 1"},
      {"sample " + scene + " --count " + endless + " --seed 1 --output x.csv",
       "--count: expected a whole number from 1 to 10000000000, found " + shown},
      {"audit a.audit --run --time-limit " + endless, "expected a number from 0.1 to 3600, found "},
      {"derive " + endless, "derive: no kind " + shown},
      {endless, "no subcommand " + shown},
      {"solve --" + endless, "no option '--" + std::string(38, 'x') + "...'"},
      {"solve 'a\nb'", "a?b: cannot be read"},
      {"solve a 'b\033c'", "the argument 'b?c' is one too many"}};
  for (const auto& [call, message] : calls) {
    expect_one_line(run_assur(call), message);
  }
}

TEST(BadArguments, SuggestWhatWasMeant) {
  const std::string scene = ASSUR_EXAMPLES "/four_bar_coupler_curve.json";
  const std::vector<std::array<std::string, 2>> calls = {
      {"sovle " + scene,
       "error: no subcommand 'sovle' (did you mean 'solve'?); the subcommands are "},
      {"solve --fromat json " + scene, "solve: no option '--fromat' (did you mean '--format'?)"},
      {"solve --fromat=json", "solve: no option '--fromat' (did you mean '--format'?)"},
      {"emit --sceen " + scene, "emit: no option '--sceen' (did you mean '--scene'?)"},
      {"solve --format jsn " + scene,
       "--format: 'jsn' is not one of text, json, csv (did you mean 'json'?)"},
      {"derive RRR-RRR --group tetrd",
       "--group: 'tetrd' is not one of dyad, triad, tetrad (did you mean"},
      {"solve --branch 0 " + scene, "--branch: expected a whole number from 1 on, found '0' (see"},
      {"solve --branch -1 " + scene,
       "--branch: expected a whole number from 1 on, found '-1' (see"},
      {"emit --all --variable x --output .",
       "--variable: only scenes have parameters; give it with"},
      {"emit --all --want position --output .",
       "--want: only solvers of scenes give results; give it with"},
      {"emit --all --interface c --output .",
       "--interface: only solvers of scenes have a C interface; give it"},
      {"emit --model 1 --with force --output .",
       "--with: 'force' is not one of forces, jerk, rates, special-points (did you mean "
       "'forces'?)"},
      {"emit --scene " + scene + " --with jerk --output .",
       "--with: only models have functions on request; give it with --model or --all"},
      {"emit --model 24 --with forces --output .",
       "--with forces: tetrad model 24 (PPP-PPP) is degenerate, so that the equilibrium of its "
       "links"},
      {"draw --output a.SVG " + scene,
       "the extensions are .svg, .html, .dxf (did you mean '.svg'?)"},
      {"derive RXR", "derive: no kind 'RXR' (did you mean 'RRR'?); give a kind such as RRR or a"},
      {"solve --nearest " + scene,
       "reference: the nearest configuration needs a reference; give the angles of"},
      {"map --over coupler=-1e308:1e308:3 --output x.csv " + scene,
       "--over: the range from FROM to TO is not finite"},
      {"solve --branch 99999999999999999999 " + scene,
       "--branch: the number 99999999999999999999 is too large; give one up to 2147483647 (see"},
      {"solve --branch -99999999999 " + scene,
       "--branch: expected a whole number from 1 on, found '-99999999999' (see"},
      {"solve --branch 99999999999x " + scene,
       "--branch: expected a whole number from 1 on, found '99999999999x' (see"},
      {"solve --branch 1 --nearest " + scene,
       "--branch and --nearest exclude each other; leave one of them out (see"},
      {"solve --format 'a requires b' " + scene,
       "--format: 'a requires b' is not one of text, json, csv"},
      {"solve --branch 'x excludes y' " + scene,
       "--branch: expected a whole number from 1 on, found 'x excludes y' (see"},
      {"solve --branch 010 " + scene, "--branch: expected a whole number from 1 on, found '010'"},
      {"sample --threads 0 " + scene,
       "--threads: expected a whole number from 1 on, found '0' (see"},
      {"sample --threads 1025 " + scene,
       "--threads: the number 1025 is too large; give one up to 1024 (see"},
      {"audit a.audit --run --time-limit 0",
       "--time-limit: expected a number from 0.1 to 3600, found '0' (see"},
      {"emit --model x --output .", "--model: expected a whole number from 1 on, found 'x' (see"},
      {"emit --want position,position --output . --scene " + scene,
       "--want: 'position' occurs twice; leave one out"},
      {"emit --variable crank,crank --output . --scene " + scene,
       "--variable: 'crank' occurs twice; leave one out"},
      {"audit a.audit --flags -O2",
       "audit: --flags has an effect only with --run; add --run, or leave --flags out (see"},
      {"audit a.audit --time-limit 5",
       "audit: --time-limit has an effect only with --run; add --run, or leave --time-limit out"}};
  for (const auto& [call, message] : calls) {
    expect_one_line(run_assur(call), message);
  }
}

/// A cylinder without a direction: `position`, a number or a parameter, makes its ends meet.
Json cylinder(const Json& position) {
  Json scene;
  const Json axis = {{"through", {0, 0}}, {"along", {1, 0}}};
  scene["parameters"]["long"] = 0;
  scene["links"]["ground"] = {{"A", {0, 0}}, {"Q", {3, 0}}};
  scene["links"]["crank"] = {{"A", {0, 0}}, {"P", {3, 0}}};
  scene["links"]["tube"] = {{"Q", {0, 0}}, {"axis", axis}};
  scene["links"]["rod"] = {{"P", {0, 0}}, {"axis", axis}};
  const auto pin = [](const char* one, const char* other) {
    return Json{{"type", "revolute"}, {"between", Json::array({one, other})}};
  };
  scene["joints"] = {
      {"A", pin("ground.A", "crank.A")},
      {"Q", pin("ground.Q", "tube.Q")},
      {"P", pin("rod.P", "crank.P")},
      {"S", {{"type", "prismatic"}, {"between", Json::array({"tube.axis", "rod.axis"})}}}};
  scene["drivers"]["S"]["position"] = position;
  return scene;
}

TEST(BadArguments, EmissionOfALengthThatIsZero) {
  const TemporaryDirectory directory;
  const std::string root = directory.path().string();
  const std::string file = directory.write("cylinder.json", cylinder(0).dump()).string();
  expect_one_line(run_assur("emit --scene " + file + " --output " + root),
                  "a length that depends on drivers.S.position is zero at the scene's own numbers");
}

/// A branch that does not exist is refused without remarks on the steps of the sweep.
TEST(BadArguments, BranchOfASweepThatIsDegenerate) {
  const TemporaryDirectory directory;
  Json scene = cylinder("long");
  scene["sweep"] = {{"parameter", "long"}, {"from", 0}, {"to", 0}, {"count", 3}};
  const std::string file = directory.write("cylinder.json", scene.dump()).string();
  expect_one_line(run_assur("solve --format csv --branch 3 " + file),
                  "there is no branch 3; the sweep has none");
}

TEST(BadArguments, SettingThatASweepOverrides) {
  const std::string scene = ASSUR_EXAMPLES "/four_bar_coupler_curve.json";
  expect_one_line(
      run_assur("solve --format csv --set phi=1 " + scene),
      "--set phi: the sweep gives 'phi' its values; leave this out, or change the sweep");
  EXPECT_EQ(run_assur("solve --format json --set phi=1 " + scene).status, 0);
}
TEST(BadArguments, NoSubcommand) { expect_one_line(run_assur(""), "subcommand"); }
TEST(BadArguments, UnknownFormat) {
  expect_one_line(run_assur("catalogue --format xml"), "--format");
}
TEST(BadArguments, UnknownModel) {
  expect_one_line(run_assur("emit --model 25 --output /tmp"), "no tetrad model 25");
}
TEST(BadArguments, UnknownModelOfAGroup) {
  expect_one_line(run_assur("emit --group triad --model 21 --output /tmp"),
                  "no triad model 21; the models are 1 to 20");
}
TEST(BadArguments, UnknownGroup) {
  expect_one_line(run_assur("emit --group pentad --model 1 --output /tmp"),
                  "--group: 'pentad' is not one of dyad, triad, tetrad");
}
TEST(BadArguments, OutputNotWritable) {
  expect_one_line(run_assur("emit --model 1 --output /dev/null/x"), " cannot be written: ");
}

}  // namespace
}  // namespace assur::test::bad_arguments_test
