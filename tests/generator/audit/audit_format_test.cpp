// Law: findings of `assur audit` state what cannot be compared, its place, and an explanation.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "command/command.hpp"

namespace assur::test::audit_format_test {
namespace {

using Json = nlohmann::json;

/// A crank and a slider, as docs/reference/audit_format.md has them.
const std::string slider_crank =
    "length r l x_P\n"
    "angle crank rod\n"
    "unknown rod x_P\n"
    "moving crank\n"
    "loop f1 f2 = polar(r, crank) + polar(l, rod) - point(x_P, 0)\n";

/// The statements of the audit of a text in which something must disagree.
Json audit(const TemporaryDirectory& directory, const std::string& text) {
  const CommandResult result =
      run_assur("audit --format json " + directory.write("one.audit", text).string());
  EXPECT_EQ(result.status, 1) << result.messages;
  return result.status == 1 ? Json::parse(result.output)["files"][0]["statements"] : Json();
}

TEST(AuditFormat, AnAngleBesideALengthIsUndecided) {
  const TemporaryDirectory directory;
  const Json statements = audit(directory, slider_crank +
                                               "printed equation (1) : r*crank = l\n"
                                               "printed equation (2) : 2*crank = rod\n");
  const Json& finding = statements.at(0).at("findings").at(0);
  EXPECT_EQ(finding["verdict"], "undecided");
  EXPECT_NE(finding["evidence"].get<std::string>().find("stands outside a sine or cosine"),
            std::string::npos)
      << finding;
  EXPECT_FALSE(finding.contains("note"));
  EXPECT_EQ(statements.at(1).at("findings").at(0)["verdict"], "differs");
}

TEST(AuditFormat, PlacesInCodeAreInItsFile) {
  const TemporaryDirectory directory;
  directory.write("lever.cpp",
                  "void fill(Matrix& A) {\n"
                  "  const double s = std::sin(rod);\n"
                  "  A(0, 0) = l * s;\n"
                  "  A(0, 1) = -1;\n"
                  "}\n");
  const Json statements =
      audit(directory, slider_crank + "printed code (2) lever.cpp A of f1 by rod x_P\n");
  EXPECT_EQ(statements.at(0)["file"], (directory.path() / "lever.cpp").string());
  const Json& findings = statements.at(0).at("findings");
  EXPECT_EQ(findings.at(0)["verdict"], "differs by sign");
  EXPECT_EQ(findings.at(0)["line"], 3);
  EXPECT_EQ(findings.at(1)["verdict"], "agrees");
}

/// A length given as 5 is not 5.22, although 5.22 would be printed as 5.
TEST(AuditFormat, GivenNumbersAreExact) {
  const TemporaryDirectory directory;
  const Json statements =
      audit(directory, "given BE = 5\nvalue turns = 9\nprinted number (3) way = 47 is turns*BE\n");
  const Json& finding = statements.at(0).at("findings").at(0);
  EXPECT_EQ(finding["verdict"], "differs");
  EXPECT_EQ(finding["note"].get<std::string>().find("within their rounding"), std::string::npos);
}

/// A printed input is known to half a unit of its last digit, which may explain a difference.
TEST(AuditFormat, PrintedNumbersAreRounded) {
  const TemporaryDirectory directory;
  const Json statements = audit(directory,
                                "value speed = 5.41\nprinted number (4) w = 5 is speed\n"
                                "printed number (5) way = 47 is 9*w\n");
  EXPECT_EQ(statements.at(1).at("findings").at(0)["note"],
            "follows from the printed numbers within their rounding");
}

}  // namespace
}  // namespace assur::test::audit_format_test
