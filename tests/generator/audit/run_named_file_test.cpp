// Law: the file that an audit names is run, whatever other files stand beside it; a failing program
// hides no other verdict of the audit file.
#include <gtest/gtest.h>

#include <map>

#include "run_program.hpp"

namespace assur::test::run_named_file_test {
namespace {

#define OCTAVE_RIGHT "J = [-l*sin(theta), -1; l*cos(theta), 0];\nend\n"
#define OCTAVE_WRONG "J = [l*sin(theta), -1; l*cos(theta), 0];\nend\n"
#define PYTHON_RIGHT "    return [[-l*sin(theta), -1], [l*cos(theta), 0]]\n"

/// A folder of files, and what the audit of one of them answers.
struct Folder {
  const char* name;
  std::map<std::string, std::string> files;
  const char* audited;
  const char* rows;
  int status;
  const char* answer;
};

void PrintTo(const Folder& folder, std::ostream* out) { *out << folder.name; }

class NamedFile : public testing::TestWithParam<Folder> {};

TEST_P(NamedFile, IsRunAndNoOther) {
  const Folder& folder = GetParam();
  const TemporaryDirectory directory;
  for (const auto& [name, text] : folder.files) {
    directory.write(name, text);
  }
  expect_answer(directory, {folder.name, folder.audited, folder.files.at(folder.audited).c_str(),
                            folder.rows, folder.status, folder.answer});
}

std::vector<Folder> installed_folders(std::vector<Folder> folders) {
  std::erase_if(folders, [](const Folder& folder) {
    return installed({{folder.name, folder.audited, "", "", 0, ""}}).empty();
  });
  return folders;
}

INSTANTIATE_TEST_SUITE_P(
    Folders, NamedFile,
    testing::ValuesIn(installed_folders(
        {Folder{"OctaveOfAnotherFile",
                {{"garbage.m", "this is not even code ((\n"},
                 {"f.m", "function J = f(l, theta)\n" OCTAVE_RIGHT}},
                "garbage.m",
                CALL,
                2,
                "garbage.m cannot be audited: 'f' is not a function of it but of f.m; name that "
                "file"},
         Folder{"OctaveThatDoesNotParse",
                {{"garbage.m", "function J = garbage(l)\nJ = ((;\nend\n"}},
                "garbage.m",
                FRAME "  result garbage(l)",
                2,
                "it does not parse: parse error"},
         Folder{"OctaveThatIsAScript",
                {{"garbage.m", "this is not even code ((\n"}},
                "garbage.m",
                FRAME "  result garbage(l)",
                2,
                "garbage.m cannot be audited: invalid call to script"},
         Folder{"OctaveWithoutTheFunction",
                {{"g.m", "function J = g(l, theta)\n" OCTAVE_RIGHT}},
                "g.m",
                FRAME "  result zeros(2)",
                2,
                "the rows call no function of it; it has 'g'"},
         Folder{"OctaveByTheNameInTheFile",
                {{"f.m", "function J = f(l, theta)\n" OCTAVE_RIGHT},
                 {"g.m", "% a copy\nfunction J = f(l, theta)\n" OCTAVE_WRONG}},
                "g.m",
                CALL,
                1,
                "the sign is wrong"},
         Folder{"OctaveNamedAsOneOfOctave",
                {{"det.m", "function J = det(l, theta)\n" OCTAVE_RIGHT}},
                "det.m",
                FRAME "  result det(l, theta)",
                0,
                "all 4 agree"},
         Folder{"OctaveThatShadows",
                {{"f.m", "function J = f(l, theta)\n" OCTAVE_RIGHT},
                 {"fliplr.m", "function y = fliplr(x)\ny = 0*x;\nend\n"}},
                "f.m",
                FRAME "  result fliplr(fliplr(f(l, theta)))",
                0,
                "all 4 agree"},
         Folder{"OctaveWithAHelper",
                {{"f.m", "function J = f(l, theta)\nsin = @sine;\n" OCTAVE_RIGHT},
                 {"sine.m", "function y = sine(x)\ny = sin(x);\nend\n"}},
                "f.m",
                CALL,
                0,
                "all 4 agree"},
         Folder{"PythonThatShadows",
                {{"f.py",
                  "import random\nfrom math import sin, cos\nassert random.Random\n"
                  "def f(l, theta):\n" PYTHON_RIGHT},
                 {"random.py", "raise SystemExit('the wrong file')\n"},
                 {"ast.py", "raise SystemExit('the wrong file')\n"}},
                "f.py",
                CALL,
                0,
                "all 4 agree"},
         Folder{"PythonNamedAsOneOfPython",
                {{"math.py", "from math import sin, cos\ndef f(l, theta):\n" PYTHON_RIGHT}},
                "math.py",
                CALL,
                0,
                "all 4 agree"},
         Folder{"PythonWithAHelper",
                {{"f.py", "from a_helper_of_f import sin, cos\ndef f(l, theta):\n" PYTHON_RIGHT},
                 {"a_helper_of_f.py", "from math import *\n"}},
                "f.py",
                CALL,
                0,
                "all 4 agree"},
         Folder{"PythonOfAnotherFile",
                {{"g.py", "from math import sin, cos\ndef g(l, theta):\n" PYTHON_RIGHT},
                 {"f.py", "from math import sin, cos\ndef f(l, theta):\n" PYTHON_RIGHT}},
                "g.py",
                CALL,
                2,
                "g.py cannot be audited: it has no 'f'"},
         Folder{"JavaScriptWithAHelper",
                {{"f.mjs",
                  "import { sin } from './sine.mjs';\nexport function f(l, theta) { return "
                  "[[-l*sin(theta), -1], [l*Math.cos(theta), 0]]; }\n"},
                 {"sine.mjs", "export const sin = Math.sin;\n"}},
                "f.mjs",
                CALL,
                0,
                "all 4 agree"},
         Folder{"JavaScriptOfAnotherFile",
                {{"g.js", "function g() { return 0; }\n"},
                 {"f.js", JAVASCRIPT("return [[-l*sin(theta), -1], [l*cos(theta), 0]];")}},
                "g.js",
                CALL,
                2,
                "g.js cannot be audited: f is not defined"}})),
    [](const testing::TestParamInfo<Folder>& at) { return std::string(at.param.name); });

TEST(RunAudit, OneThatFailsHidesNoOtherVerdict) {
  const TemporaryDirectory directory;
  directory.write("root.py", "def f(r, l, th): return r\n");
  directory.write("crash.cpp", "#include <cstdlib>\ndouble f() { std::abort(); }\n");
  const fs::path file =
      directory.write("two.audit", slider_crank +
                                       "printed equation before : s = r*cos(phi) + l*cos(theta)\n"
                                       "printed run zero root.py of s\n  result f(r, l, theta)/0\n"
                                       "printed run crash crash.cpp of s\n  result f()\n"
                                       "printed equation after : s = l*cos(theta)\n");
  const CommandResult result = run_assur("audit --run --format json " + file.string());
  EXPECT_EQ(result.status, 1) << result.messages;
  std::string verdicts;
  const std::string key = "\"verdict\": \"";
  for (std::size_t at = result.output.find(key); at != std::string::npos;
       at = result.output.find(key, at + 1)) {
    const std::size_t begin = at + key.size();
    verdicts += result.output.substr(begin, result.output.find('"', begin) - begin) + ", ";
  }
  EXPECT_EQ(verdicts, "agrees, fails, fails, differs, ") << result.output;
  EXPECT_NE(result.output.find("ZeroDivisionError"), std::string::npos);
  EXPECT_NE(result.output.find("\"point\": \"r = "), std::string::npos) << result.output;
}

/// A difference so small that every guess would be true of it, too.
TEST(RunAudit, ATinyDifferenceIsNotExplained) {
  const TemporaryDirectory directory;
  const CommandResult result = audited(directory,
                                       {"", "a.cpp",
                                        "#include <cmath>\ndouble f(double l, double t) { return "
                                        "-l*std::sin(t)*(1 + 1e-10); }",
                                        "-l*sin(theta)\n  result f(l, theta)", 1, ""},
                                       "--run");
  EXPECT_EQ(result.status, 1) << result.messages;
  EXPECT_EQ(result.output.find("note"), std::string::npos) << result.output;
}

}  // namespace
}  // namespace assur::test::run_named_file_test
