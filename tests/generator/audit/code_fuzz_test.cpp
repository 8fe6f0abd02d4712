// Law: the readers of code answer any text or refuse it in one line, and code that they call right
// computes the right values.
#include <gtest/gtest.h>

#include <array>
#include <iostream>
#include <optional>
#include <random>

#include "audit/audit.hpp"
#include "command/command.hpp"
#include "whole_campaign.hpp"

namespace assur::test::code_fuzz_test {
namespace {

using namespace generator::audit;

constexpr unsigned seed = 1729;

const std::string closures =
    "length l s\nangle q\nunknown q s\nclosure f1 = l*cos(q) - s^2/2\nclosure f2 = l*sin(q)\n";
const std::string helpers =
    "#include <cmath>\n#include <utility>\n#include <algorithm>\n"
    "using std::sin; using std::cos;\n"
    "inline void fix(double (&a)[2][2]) { a[0][0] = 7; }\n"
    "inline double bump(double& a) { a += 1; return a; }\n";
const std::vector<std::string> body = {"J[0][0] = -l*sin(q);", "J[0][1] = -s;",
                                       "J[1][0] = l*cos(q);", "J[1][1] = 0;"};

std::string function_of(const std::vector<std::string>& statements) {
  std::string text = helpers + "void fill(double l, double s, double q, double (&J)[2][2]) {\n";
  for (const std::string& statement : statements) {
    text += "  " + statement + "\n";
  }
  return text + "}\n";
}

/// The audit of a file of code; nothing where the code is refused.
std::optional<AuditReport> read(const TemporaryDirectory& directory, const std::string& name,
                                const std::string& text) {
  directory.write(name, text);
  const std::string file =
      directory.write("read.audit", closures + "printed code J " + name + " J of f1 f2 by q s\n")
          .string();
  try {
    return audit_file(file, {});
  } catch (const text::InputError& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find(name + ":"), std::string::npos) << error.what();
    return std::nullopt;
  }
}

/// Whether the code computes the right values; empty if it does not compile.
std::optional<bool> runs_right(const TemporaryDirectory& directory, const std::string& name) {
  const std::string file =
      directory
          .write("run.audit", closures + "printed run J " + name +
                                  " of f1 f2 by q s\n  before double J[2][2] = {}; fill(l, s, q, "
                                  "J)\n  result J\n  points 6\n")
          .string();
  RunPermission permission;
  permission.given = true;
  try {
    return audit_file(file, {}, permission).agrees();
  } catch (const text::InputError& error) {
    const bool compiles = std::string(error.what()).find("does not compile") == std::string::npos;
    EXPECT_FALSE(compiles) << error.what();
    return std::nullopt;
  }
}

TEST(CodeFuzz, WhateverIsCalledRightComputesWhatIsRight) {
  const std::vector<std::string> inserted = {"fix(J);",
                                             "std::swap(J[0][0], J[1][0]);",
                                             "auto& K = J; K[0][0] = 7;",
                                             "double* p = &J[0][0]; *p = 7;",
                                             "return;",
                                             "if (l > 0) J[0][0] = 1;",
                                             "if (l > 99) return;",
                                             "{ double s = 2; J[0][1] = s; }",
                                             "l = l + 1;",
                                             "s = 2;",
                                             "const double m = l;",
                                             "double c = cos(q); J[1][0] = l*c;",
                                             "int n = l; J[0][0] = n;",
                                             "J[0][0] *= 1;",
                                             "auto g = [&] { J[0][0] = 0; }; g();",
                                             "J[1][1] = 1/2;",
                                             "J[1][1] = 2/4*l;",
                                             "J[1][0] = J[1][0];",
                                             "static double k = l; J[1][0] = k*cos(q);",
                                             "double t{l}; J[1][0] = t*cos(q);",
                                             "// careful \\",
                                             "bump(l);",
                                             "double u = bump(l);",
                                             "for (int i = 0; i < 2; ++i) J[i][1] = -s*(1 - i);",
                                             "l += 1;",
                                             "J[0][1] = -s, 3;",
                                             "const double& r = l; l = 2; J[1][0] = r*cos(q);",
                                             "J[0][1] = (1, -s);",
                                             "q = -q;",
                                             "J[0][0] = -J[0][0];",
                                             "double& r = s; r = 1;",
                                             "std::fill(&J[0][0], &J[0][0] + 4, 0.0);",
                                             "double cos = 1; (void)cos;",
                                             "l++;",
                                             "const double w = l++ + 0; (void)w;",
                                             "#define s 2",
                                             "#undef s",
                                             "goto end; end:;",
                                             "J[1][1] = 'a' - 'a';",
                                             "J[1][1] = 0x0;",
                                             "const float f = 0.1f; J[1][1] = f - f;",
                                             "const float f = 0.1; J[1][0] = f*10*l*cos(q);",
                                             "J[1][1] = l*(1 - 2u) + l;",
                                             "J[1][1] = 100000*100000 - 1e10;",
                                             "bool b = 2; J[1][1] = b - 2;",
                                             "double t[2] = {bump(l), 1}; (void)t;",
                                             "double r1 = bump(J[0][0]);",
                                             "J[1][1] = l > 0 ? 0 : 1;",
                                             "(void)(J[0][0] = 3);",
                                             "double v = J[0][0] = 3; (void)v;",
                                             "J[1][1] = 0;;",
                                             "J[1][1] = std::pow(l, 1/2) - 1;",
                                             "const auto h = 3; J[1][1] = h/2 - 1.5;",
                                             "unsigned z = 0; J[1][1] = z - 1;",
                                             "J[1][1] = -2 + 1 + 1u;",
                                             "J[1][1] = 1e0/3*3 - 1;",
                                             "/* */ J[1][1] = 0; // J[0][0] = 1;"};
  const TemporaryDirectory directory;
  std::mt19937 engine(seed);
  std::size_t refused = 0;
  std::size_t right = 0;
  const std::size_t pairs = is_whole_campaign() ? 1500 : 20;
  for (std::size_t count = 0; count < inserted.size() + pairs; ++count) {
    std::vector<std::string> statements = body;
    const std::size_t more = count < inserted.size() ? 1 : 2;
    for (std::size_t number = 0; number < more; ++number) {
      const std::string& line = more == 1 ? inserted[count] : inserted[engine() % inserted.size()];
      const auto at = static_cast<std::ptrdiff_t>(engine() % (statements.size() + 1));
      statements.insert(statements.begin() + at, line);
    }
    const std::string text = function_of(statements);
    const std::optional<AuditReport> answer = read(directory, "a.cpp", text);
    refused += answer ? 0 : 1;
    if (answer && answer->agrees()) {
      const std::optional<bool> computed = runs_right(directory, "a.cpp");
      EXPECT_NE(computed, false) << "called right, and wrong:\n" << text;
      right += computed == true ? 1 : 0;
    }
  }
  std::cout << refused << " of " << inserted.size() + pairs << " refused, " << right
            << " called right and so computed, seed " << seed << '\n';
  EXPECT_GE(refused, (inserted.size() + pairs) / 2);
  EXPECT_GE(right, 5U);
}

TEST(CodeFuzz, NoTextDoesMoreThanBeAnsweredOrRefused) {
  const std::array<std::pair<const char*, std::string>, 2> originals = {
      {{"a.cpp", function_of(body)},
       {"a.m",
        "function J = f(l, s, q) % it\nc = cos(q);\nJ = [-l*sin(q), -s; ...\n l*c 0];\nJ(1, 2) = "
        "-s;\nend\n"}}};
  const std::string letters = "(){}[]<>;:,.+-*/^%&|!~=?#'\"\\ \nJlsq019e_\x80";
  const TemporaryDirectory directory;
  std::mt19937 engine(seed);
  const std::size_t tries = is_whole_campaign() ? 20000 : 500;
  for (const auto& [name, original] : originals) {
    std::size_t answered = 0;
    for (std::size_t count = 0; count < tries; ++count) {
      std::string text = original;
      for (std::size_t change = 1 + engine() % 3; change > 0; --change) {
        const std::size_t at = engine() % text.size();
        const char letter = letters[engine() % letters.size()];
        switch (engine() % 3) {
          case 0:
            text[at] = letter;
            break;
          case 1:
            text.insert(at, 1, letter);
            break;
          default:
            text.erase(at, 1 + engine() % 4);
        }
      }
      answered += read(directory, name, text) ? 1 : 0;
    }
    EXPECT_GT(answered, 0U) << name << ", seed " << seed;
    EXPECT_LT(answered, tries) << name << ", seed " << seed;
  }
}

}  // namespace
}  // namespace assur::test::code_fuzz_test
