// Law: nothing is run unless it is asked for, nothing is left behind, and the command says what,
// where and how the answer is to be taken.
#include <gtest/gtest.h>

#include "run_program.hpp"

namespace assur::test::run_command_test {
namespace {

const Program right = {"Right", "a.cpp", CPP("return {{-l*sin(theta), -1}, {l*cos(theta), 0}};"),
                       CALL,    0,       ""};

TEST(RunAudit, RunsNothingUnlessAsked) {
  const TemporaryDirectory directory;
  Program program = right;
  const std::string mark = (directory.path() / "mark").string();
  const std::string text =
      "#include <cstdio>\nstatic int x = (std::fopen(\"" + mark + "\", \"w\"), 1);\n" + right.text;
  program.text = text.c_str();
  const CommandResult result = audited(directory, program, "");
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.messages.find("nothing is run without --run"), std::string::npos);
  EXPECT_FALSE(fs::exists(mark));
  EXPECT_EQ(audited(directory, program, options_of(program)).status, 0);
  EXPECT_TRUE(fs::exists(mark));
}

TEST(RunAudit, RunsOnceWhereClosuresAreTurned) {
  const TemporaryDirectory directory;
  const std::string mark = (directory.path() / "mark").string();
  directory.write("a.cpp",
                  "#include <cstdio>\nstatic int x = std::fputs(\"run\", std::fopen(\"" + mark +
                      "\", \"a\"));\n" CPP("return {{l*sin(theta), 1}, {-l*cos(theta), 0}};"));
  const fs::path file = directory.write(
      "a.audit", slider_crank + "printed run J a.cpp of " CALL
                                "\n"
                                "printed closure (1) f1 : s - r*cos(phi) - l*cos(theta) = 0\n"
                                "printed closure (1) f2 : -r*sin(phi) - l*sin(theta) = 0\n");
  EXPECT_EQ(run_assur("audit --run " + file.string()).status, 0);
  EXPECT_EQ(read_file(mark), "run");
}

TEST(RunAudit, LeavesNothingBehind) {
  const auto directories = [] {
    std::ptrdiff_t count = 0;
    for (const auto& entry : fs::directory_iterator(fs::temp_directory_path())) {
      count += entry.path().filename().string().starts_with("assur-audit-") ? 1 : 0;
    }
    return count;
  };
  const TemporaryDirectory directory;
  const std::ptrdiff_t before = directories();
  EXPECT_EQ(audited(directory, right, options_of(right)).status, 0);
  EXPECT_LE(directories(), before + 8);  // other tests may run at the same time
  for (const auto& entry : fs::directory_iterator(directory.path())) {
    const std::string name = entry.path().filename().string();
    EXPECT_TRUE(name == "a.cpp" || name == "mine.audit") << name;
  }
}

TEST(RunAudit, AnswersTheSameBesideOthers) {
  const TemporaryDirectory directory;
  directory.write("a.py", PYTHON("return [[l*sin(theta), -1], [l*cos(theta), 0]]"));
  const std::string one = "printed run J a.py of f1 f2 by theta s\n  result f(l, theta)\n";
  const std::string others =
      "printed equation (1) : rate(s) = r*rate(phi)\nprinted matrix (2) of theta by r l\n  r, l\n";
  const auto answer = [&](const std::string& text) {
    const std::string file = directory.write("b.audit", slider_crank + text).string();
    const std::string output = run_assur("audit --run " + file).output;
    const std::size_t from = std::min(output.find("run J"), output.size());
    std::string own = output.substr(from, output.find('\n', output.find("note", from)) - from);
    for (std::size_t at = own.find(" (/"); at != std::string::npos; at = own.find(" (/")) {
      own.erase(at, own.find('\n', at) - at);  // the place, which does differ
    }
    return own;
  };
  const std::string alone = answer(one);
  EXPECT_NE(alone.find("differs by sign"), std::string::npos) << alone;
  EXPECT_EQ(answer(others + one), alone);
  EXPECT_EQ(answer(one + others), alone);
}

TEST(RunAudit, TheExampleIsFoundWrong) {
  const std::string eigen = ASSUR_EIGEN;
  const std::string example = std::string(ASSUR_EXAMPLES) + "/audit/running/shaper.audit";
  const CommandResult result = run_assur("audit " + example + " --run --flags \"-I" + eigen + "\"");
  EXPECT_EQ(result.status, 1) << result.messages;
  EXPECT_NE(result.output.find("14 of 16 agree"), std::string::npos) << result.output;
  EXPECT_NE(result.output.find("it is exchanged with (2,2)"), std::string::npos) << result.output;
}

TEST(RunAudit, TheRemarkSaysUnderWhichConditions) {
  const TemporaryDirectory directory;
  Program program = right;
  program.rows = CALL "\n  where cos(theta)\n  rounding 1e-6";
  const CommandResult result = audited(directory, program, options_of(program));
  EXPECT_NE(result.output.find(" points where cos(theta) > 0, to a relative 1e-06: evidence"),
            std::string::npos)
      << result.output;
}

TEST(RunAudit, ReadsPathsWithSpacesAndQuotes) {
  const TemporaryDirectory directory;
  for (const std::string folder : {"sp ace", "quo'te", "$HOME", "-dash"}) {
    fs::create_directory(directory.path() / folder);
    directory.write(folder + "/my code.cpp", right.text);
    directory.write(folder + "/a.audit",
                    slider_crank + "printed run J \"my code.cpp\" of " CALL "\n");
    const std::string quote = folder.find('\'') == std::string::npos ? "'" : "\"";
    const CommandResult result = run_assur("audit --run " + directory.path().string() + "/" +
                                           quote + folder + quote + "/a.audit");
    EXPECT_EQ(result.status, 0) << folder << result.messages;
  }
  fs::create_directory(directory.path() / "back\\slash");
  directory.write("back\\slash/a.cpp", right.text);
  const fs::path file =
      directory.write("back\\slash/a.audit", slider_crank + "printed run J a.cpp of " CALL "\n");
  const CommandResult result = run_assur("audit --run '" + file.string() + "'");
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.messages.find("no #include can name a path"), std::string::npos);
}

TEST(RunAudit, AQuantityIsNotNamedAsTheResult) {
  const TemporaryDirectory directory;
  directory.write("a.cpp", right.text);
  const fs::path file = directory.write(
      "a.audit", "length result\n" + slider_crank + "printed run J a.cpp of " CALL "\n");
  const CommandResult result = run_assur("audit --run " + file.string());
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.messages.find("a.audit:7:15: a quantity is named 'result'"), std::string::npos)
      << result.messages;
}

TEST(AuditOutput, QuotesTheLineWithAMark) {
  const TemporaryDirectory directory;
  directory.write("a.cpp",
                  "void f(M& J) {\n\tJ(0, 0) = l*sin(theta); // \xfc\n"
                  "  J(0, 1) = -1; J(1, 0) = l*cos(theta);\n}\n");
  const fs::path file =
      directory.write("a.audit", slider_crank + "printed code J a.cpp J of f1 f2 by theta s\n");
  const CommandResult text = run_assur("audit " + file.string());
  EXPECT_EQ(text.status, 1);
  EXPECT_NE(text.output.find("    \tJ(0, 0) = l*sin(theta); // \xfc\n    \t          ^\n"),
            std::string::npos)
      << text.output;
  const CommandResult github = run_assur("audit --format github " + file.string());
  EXPECT_EQ(github.status, 1);
  EXPECT_TRUE(github.output.starts_with(
      "::error file=" + (directory.path() / "a.cpp").string() +
      ",line=2,col=12,title=code J (a.cpp) (1%2C1) d f1/d theta::differs by sign%0Aprinted: "
      "l*sin(theta)%0Aderived: -l*sin(theta)%0A"))
      << github.output;
  EXPECT_EQ(run_assur("audit --format json " + file.string()).status, 1);
}

TEST(AuditOutput, AFileInAnotherEncodingIsOneLine) {
  const TemporaryDirectory directory;
  const fs::path file = directory.write("a.audit", "source G\xf6ttingen\n" + slider_crank);
  directory.write("p.tex", "\\[ s = r \\]\n");
  EXPECT_EQ(
      run_assur("audit " + directory.path().string() + "/p.tex --map " + file.string()).messages,
      "error: " + file.string() + ": byte 8 is not UTF-8; save the file as UTF-8\n");
  const fs::path marked =
      directory.write("b.audit", "\xEF\xBB\xBF" + slider_crank + "printed equation (1) : r = r\n");
  EXPECT_EQ(run_assur("audit " + marked.string()).status, 0);
  for (const char* format : {"text", "markdown", "json", "github"}) {
    const CommandResult result =
        run_assur("audit --format " + std::string(format) + " " + file.string());
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.messages,
              "error: " + file.string() + ": byte 8 is not UTF-8; save the file as UTF-8\n");
  }
}

}  // namespace
}  // namespace assur::test::run_command_test
