// Law: the audit file that --init writes for a program is the pinned one; filled in where it is
// marked, the program agrees with it, and the same program with one slip does not.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <random>
#include <sstream>

#include "command/command.hpp"
#include "whole_campaign.hpp"

namespace assur::test::init_test {
namespace {

namespace fs = std::filesystem;

/// A program or paper of the folder `init`, what a user fills in, and a slip.
struct Drafted {
  const char* file;
  const char* right;
  const char* slip;                      ///< in place of what is right
  std::vector<const char*> filled = {};  ///< in place of the marks, in their order
  const char* branch = "";               ///< in place of the remark on branches
  const char* module = "";               ///< of Python that it imports
};

void PrintTo(const Drafted& drafted, std::ostream* out) { *out << drafted.file; }

/// Two programs for each language, and a paper. At most five lines are typed for any.
const std::vector<Drafted>& all_drafted() {
  static const std::vector<Drafted> list = {
      {"arm.mjs", "-b*sin(q[0] + q[1])],", "-a*sin(q[0] + q[1])],"},
      {"residual.cpp", "-p.l * s", "p.l * s"},
      {"arm.c", "J[0][1] = -b*sin(q2)", "J[0][1] = -b*cos(q2)"},
      {"arm.m", "J = [-a*sin(q1)", "J = [a*sin(q1)"},
      {"arm.py", "-b*s12],", "b*s12],"},
      {"closures.py", "J[0, 1] = -1", "J[0, 1] = 1", {}, "", "numpy"},
      {"arm_sympy.py", "-b*sp.sin(q1+q2)],", "-b*sp.sin(q1-q2)],", {}, "", "sympy"},
      {"four_bar.tex",
       "- a_4 \\cos",
       "a_4 \\cos",
       {"unknown theta_3 theta_4", "moving theta_2",
        "length a_1\nloop f1 f2 = polar(a_2, theta_2) + polar(a_3, theta_3) - polar(a_4, theta_4) "
        "- point(a_1, 0)",
        "J = matrix of f1..2 by theta_3 theta_4"}},
      {"slider.py",
       "asin(-r",
       "asin(r",
       {"loop f1 f2 = polar(r, th) + polar(l, phi) - point(x, 0)"},
       "  where cos(phi)"},
      {"fourbar.m",
       "K4 = d/b",
       "K4 = d/c",
       {"loop f1 f2 = polar(a, th2) + polar(b, th3) - polar(c, th4) - point(d, 0)"},
       "  where sin(th4 - th3)"},
      {"lever.py", "(th), p.a*np.cos(th)", "(th), p.a*np.sin(th)", {}, "", "numpy"},
      {"cam.c", "- e * e * sin(th)", "- e * sin(th)"},
      {"closures.cjs", "J[1][0] = p.l", "J[1][0] = p.r"},
      {"rod_sympy.py", "[l*cos(ph), 0]", "[r*cos(ph), 0]", {}, "", "sympy"},
      {"crank.cpp", "return -w * h", "return w * h"}};
  return list;
}

const fs::path here = ASSUR_DRAFTED;

fs::path pinned(const Drafted& drafted) {
  const std::string file = drafted.file;
  return here /
         (file.ends_with(".tex") ? file.substr(0, file.size() - 4) + ".map" : file + ".audit");
}

/// The lines that a user types; the marks and the remark on branches are gone.
std::string filled_in(const Drafted& drafted, const std::string& draft) {
  std::istringstream lines(draft);
  std::string text;
  std::size_t filled = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("# fill in: ")) {
      line = filled < drafted.filled.size() ? drafted.filled[filled] : "";
      ++filled;
    } else if (line.starts_with("  # if it takes one branch") && *drafted.branch != 0) {
      line = drafted.branch;
    }
    text += line + "\n";
  }
  EXPECT_EQ(filled, drafted.filled.size());
  return text;
}

/// A Python that has the module; empty if none does.
std::string python_with(const std::string& module) {
  for (const char* python : {"python3", "/usr/bin/python3"}) {
    const std::string test = std::string(python) + " -c 'import " + module + "' 2> /dev/null";
    if (std::system(test.c_str()) == 0) {
      return python;
    }
  }
  return "";
}

CommandResult audited(const Drafted& drafted, std::string program, const std::string& python) {
  const TemporaryDirectory directory;
  const fs::path file = directory.write(drafted.file, program);
  std::string draft = filled_in(drafted, read_file(pinned(drafted)));
  if (!python.empty()) {
    draft.insert(draft.find("\n", draft.find("printed run")), "\n  interpreter " + python);
  }
  const fs::path written = directory.write(pinned(drafted).filename().string(), draft);
  return written.extension() == ".map"
             ? run_assur("audit " + file.string() + " --map " + written.string())
             : run_assur("audit " + written.string() + " --run");
}

class Draft : public testing::TestWithParam<Drafted> {};

TEST_P(Draft, IsThePinnedOne) {
  const TemporaryDirectory directory;
  const fs::path file = directory.write(GetParam().file, read_file(here / GetParam().file));
  const fs::path written = directory.path() / "draft";
  const CommandResult result =
      run_assur("audit --init " + file.string() + " --output " + written.string());
  EXPECT_EQ(result.status, 0) << result.messages;
  EXPECT_EQ(read_file(written), read_file(pinned(GetParam())));
}

TEST_P(Draft, HasAtMostFiveLinesToFillIn) {
  std::string typed = GetParam().branch;
  std::ptrdiff_t lines = typed.empty() ? 0 : 1;
  for (const char* const filled : GetParam().filled) {
    const std::string text = filled;
    lines += 1 + std::count(text.begin(), text.end(), '\n');
  }
  EXPECT_LE(lines, 5);
}

TEST_P(Draft, SaysWhatIsToBeFilledIn) {
  const fs::path file = here / GetParam().file;
  const CommandResult result =
      pinned(GetParam()).extension() == ".map"
          ? run_assur("audit " + file.string() + " --map " + pinned(GetParam()).string())
          : run_assur("audit " + pinned(GetParam()).string());
  const bool is_marked = !GetParam().filled.empty();
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(std::count(result.messages.begin(), result.messages.end(), '\n'), 1);
  EXPECT_EQ(
      result.messages.find(":1: to be filled in, and this mark removed: ") != std::string::npos,
      is_marked)
      << result.messages;
}

INSTANTIATE_TEST_SUITE_P(Drafts, Draft, testing::ValuesIn(all_drafted()));

class DraftOfProgram : public testing::TestWithParam<Drafted> {};

TEST_P(DraftOfProgram, AgreesAndFindsASlip) {
  const Drafted& drafted = GetParam();
  const bool lacks_tool = (std::string(drafted.file).ends_with(".m") && !ASSUR_OCTAVE) ||
                          (std::string(drafted.file).ends_with("js") && !ASSUR_NODE);
  if (lacks_tool) {
    GTEST_SKIP() << "configuring says that its interpreter is not installed";
  }
  const std::string python = *drafted.module == 0 ? "" : python_with(drafted.module);
  if (*drafted.module != 0 && python.empty()) {
    GTEST_SKIP() << "no Python here has the module " << drafted.module;
  }
  std::string program = read_file(here / drafted.file);
  const CommandResult right = audited(drafted, program, python);
  EXPECT_EQ(right.status, 0) << right.output << right.messages;
  const std::size_t at = program.find(drafted.right);
  ASSERT_NE(at, std::string::npos);
  program.replace(at, std::string(drafted.right).size(), drafted.slip);
  const CommandResult wrong = audited(drafted, program, python);
  EXPECT_EQ(wrong.status, 1) << wrong.output << wrong.messages;
}

// Most of the time goes into starting interpreters and compilers.
INSTANTIATE_TEST_SUITE_P(Drafts, DraftOfProgram, testing::ValuesIn(share_of(all_drafted(), 7)));

struct Refused {
  const char* name;
  const char* file;
  const char* text;
  const char* options;
  const char* message;
};

void PrintTo(const Refused& refused, std::ostream* out) { *out << refused.name; }

class RefusedDraft : public testing::TestWithParam<Refused> {};

TEST_P(RefusedDraft, SaysWhyInOneLine) {
  const TemporaryDirectory directory;
  const fs::path file = directory.write(GetParam().file, GetParam().text);
  const fs::path there = directory.write("there.audit", "mine");
  std::string options = GetParam().options;
  if (const std::size_t at = options.find("DIR"); at != std::string::npos) {
    options.replace(at, 3, directory.path().string());
  }
  const CommandResult result = run_assur("audit --init " + file.string() + " " + options);
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.output, "");
  EXPECT_NE(result.messages.find(GetParam().message), std::string::npos) << result.messages;
  EXPECT_EQ(std::count(result.messages.begin(), result.messages.end(), '\n'), 1);
  EXPECT_EQ(read_file(there), "mine");
}

const char* const one_function = "def f(x):\n    return [x, x]\n";

INSTANTIATE_TEST_SUITE_P(
    Drafts, RefusedDraft,
    testing::Values(
        Refused{"language", "a.rs", "fn f() {}", "", "a.rs: its language is not known; --init"},
        Refused{"empty", "a.py", "", "", "a.py: no function was found that takes numbers"},
        Refused{"no_result", "a.c", "void f(double x) { }", "", "no function was found"},
        Refused{"brackets", "a.m", "function y = f(x)\n y = ((((((x;\n", "", "no function"},
        Refused{"paper", "a.tex", "no equation", "", "no displayed equation has a symbol"},
        Refused{"exists", "a.py", one_function, "--output DIR/there.audit",
                "there.audit: the file exists; give another name, or --force to replace it"},
        Refused{"itself", "a.py", one_function, "--force --output DIR/a.py",
                "a.py: writing it would replace the input"},
        Refused{"folder", "a.py", one_function, "--output DIR/none/a.audit",
                "there is no directory"},
        Refused{"two", "a.py", one_function, "DIR/there.audit", "give one program or paper"},
        Refused{"map", "a.py", one_function, "--map b.map", "exclude each other"},
        Refused{"run", "a.py", one_function, "--run", "exclude each other"}),
    [](const testing::TestParamInfo<Refused>& one) { return std::string(one.param.name); });

TEST(Draft, ReplacesAFileIfItMay) {
  const TemporaryDirectory directory;
  const fs::path file = directory.write("a.py", one_function);
  const fs::path there = directory.write("there.audit", "mine");
  const CommandResult result =
      run_assur("audit --init " + file.string() + " --force --output " + there.string());
  EXPECT_EQ(result.status, 0) << result.messages;
  EXPECT_NE(read_file(there).find("printed run f a.py of "), std::string::npos);
}

/// Changes a text at a few random places.
std::string damaged(std::string text, std::mt19937& engine) {
  static const std::vector<std::string> bits = {
      "(",         ")",         "[",  "]",    "{",      "}",      ",",
      ";",         "=",         "\n", "...",  "\"",     "'",      "`",
      "return ",   "=>",        "<<", "def ", "J(0,1)", "[0][1]", "*",
      "1",         "\\",        "%",  "#",    "&",      "\\sin",  "\\begin{matrix}",
      "function ", "namespace "};
  const auto any = [&](std::size_t below) {
    return std::uniform_int_distribution<std::size_t>(0, below)(engine);
  };
  for (std::size_t change = 1 + any(5); change > 0; --change) {
    const std::size_t at = any(text.size());
    if (any(1) == 0) {
      text.insert(at, bits[any(bits.size() - 1)]);
    } else {
      text.erase(at, any(30));
    }
  }
  return text;
}

TEST(DraftFuzz, EndsWithADraftOrOneLine) {
  constexpr unsigned seed = 57;
  std::mt19937 engine(seed);
  const int rounds = is_whole_campaign() ? 100 : 2;
  int drafts = 0;
  const TemporaryDirectory directory;
  for (int round = 0; round < rounds; ++round) {
    for (const Drafted& drafted : all_drafted()) {
      const fs::path file =
          directory.write(drafted.file, damaged(read_file(here / drafted.file), engine));
      const CommandResult result = run_assur("audit --init " + file.string());
      drafts += result.status == 0 ? 1 : 0;
      ASSERT_TRUE(result.status == 0 || result.status == 2) << read_file(file);
      ASSERT_EQ(std::count(result.messages.begin(), result.messages.end(), '\n'),
                result.status == 0 ? 0 : 1)
          << result.messages;
      ASSERT_EQ(result.messages.find("internal"), std::string::npos) << result.messages;
    }
  }
  std::cout << drafts << " drafts of " << rounds * static_cast<int>(all_drafted().size())
            << " damaged files, seed " << seed << '\n';
}

}  // namespace
}  // namespace assur::test::init_test
