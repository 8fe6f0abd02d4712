// Law: closures that cannot become a header are refused in one line that says where and why.
#include <gtest/gtest.h>

#include <algorithm>

#include "command/command.hpp"

namespace assur::test::refused_closures_test {
namespace {

namespace fs = std::filesystem;

/// A file that no header can be made of, and what the message says.
struct Refusal {
  const char* name;
  const char* text;
  const char* message;
};

void PrintTo(const Refusal& refusal, std::ostream* out) { *out << refusal.name; }

class Refused : public testing::TestWithParam<Refusal> {};

TEST_P(Refused, GetsOneLineAndWritesNothing) {
  const TemporaryDirectory directory;
  const fs::path file = directory.write("mine.audit", GetParam().text);
  const fs::path output = directory.path() / "output";
  const CommandResult result =
      run_assur("emit --closures " + file.string() + " --output " + output.string());
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.output, "");
  EXPECT_EQ(std::count(result.messages.begin(), result.messages.end(), '\n'), 1) << result.messages;
  EXPECT_NE(result.messages.find(GetParam().message), std::string::npos)
      << "expected: " << GetParam().message << "\nfound:    " << result.messages;
  EXPECT_FALSE(fs::exists(output));
}

#define DECLARED "length a s\nangle p q\nunknown q\nmoving p\n"
INSTANTIATE_TEST_SUITE_P(
    Closures, Refused,
    testing::Values(
        Refusal{"AModel", "model RRR-RRR\n", "mine.audit:1:1: closures are emitted as they are"},
        Refusal{"NoClosure", DECLARED, "mine.audit: there is no closure to emit"},
        Refusal{"NoUnknown", "angle p\nclosure f = cos(p)\n", "mine.audit: no symbol is unknown"},
        Refusal{"UndeclaredName", DECLARED "closure f = b*cos(q)\n",
                "mine.audit:5:13: no symbol named 'b'"},
        Refusal{"UnknownStatement", DECLARED "closur f = a*cos(q)\n",
                "mine.audit:5:1: no statement 'closur' (did you mean 'closure'?)"},
        Refusal{"WordOfOneSharedLetter", "New closures\n",
                "mine.audit:1:1: no statement 'New' (choose from "},
        Refusal{"BareAngle", DECLARED "closure f = a*q\n",
                "closure f: the angle 'q' stands outside a sine or cosine"},
        Refusal{"LengthAsAngle", DECLARED "closure f = cos(a + q)\n",
                "closure f: 'a' is used as an angle and is not declared as one"},
        Refusal{"HalfAnAngle", DECLARED "closure f = cos(q/2)\n",
                "'q/2' is not a whole multiple of a declared angle"},
        Refusal{"NumberAsAngle", DECLARED "closure f = cos(q + 0.3)\n",
                "is not a whole multiple of a declared angle; declare"},
        Refusal{"BareArc", DECLARED "closure f = acos(a/s) + cos(q)\n",
                "closure f: 'acos(a/s)' stands outside a sine or cosine"},
        Refusal{"NegativeRoot", DECLARED "closure f = sqrt(-4)*cos(q)\n", "is not a real number"},
        Refusal{"ZeroToZero", DECLARED "closure f = a*0.0^0 - cos(q)\n",
                "mine.audit:5:21: zero to the power of zero has no value"},
        Refusal{"LongPower", DECLARED "closure f = a*cos(q) - 7^1000000000\n",
                "mine.audit:5:36: the power of a number has too many digits"},
        Refusal{"Pole", DECLARED "closure f = a*tan(pi/2) - cos(q)\n",
                "mine.audit:5:15: the expression has no value here"},
        Refusal{"PowerOfAPower", DECLARED "closure f = (a^100)^100*cos(q)\n",
                "mine.audit:5:24: the degree of this, of numerator and denominator together, is "
                "higher than 1000"},
        Refusal{"ManyTerms", "length a b c e g\nunknown a\nclosure f = (a + b + c + e + g)^60\n",
                "closure f: it has too many terms when its powers and products are multiplied out"},
        Refusal{"UncountableTerms",
                "length a b c e g h i j k l m n o q r t u v x\nunknown x\n"
                "closure f = x - ((a+b+c+e+g+h+i+j+k+l+m+n+o+q+r+t+u+v)^54 + 1)^2\n",
                "closure f: it has too many terms when its powers and products are multiplied out"},
        Refusal{"ManyMultiples", DECLARED "angle r\nclosure f = cos(60*p + 60*q + 20*r)\n",
                "closure f: an angle has too many terms when its cosine is multiplied out"},
        Refusal{"NestedRoots",
                DECLARED "let k4 = sqrt(sqrt(sqrt(sqrt(a + s) + s) + s) + s)\n"
                         "let k8 = sqrt(sqrt(sqrt(sqrt(k4 + s) + s) + s) + s)\n"
                         "let k12 = sqrt(sqrt(sqrt(sqrt(k8 + s) + s) + s) + s)\n"
                         "closure f = acos(sqrt(k12)/s) - cos(q)\n",
                "closure f: more than 12 roots and inverse functions stand within one another"},
        Refusal{"HighPower", DECLARED "closure f = (a + cos(q))^65\n",
                "the power 65 is higher than 64"},
        Refusal{"ProductOfAngles", DECLARED "closure f = cos(p*q)\n", "closure f: 'p*q'"},
        Refusal{"RateInAClosure", DECLARED "closure f = a*cos(q) + rate(cos(p))\n",
                "is a derivative"},
        Refusal{"NoFile", "printed code J none.cpp J of f by q\n", "no closure to emit"}),
    [](const testing::TestParamInfo<Refusal>& at) { return std::string(at.param.name); });

/// Closures of which a header is made, although they do not determine the unknowns.
struct Warned {
  const char* name;
  const char* text;
  const char* warning;
};

void PrintTo(const Warned& warned, std::ostream* out) { *out << warned.name; }

class Undetermined : public testing::TestWithParam<Warned> {};

TEST_P(Undetermined, IsWarnedOfAndIsNotRigid) {
  const TemporaryDirectory directory;
  const std::string file = directory.write("mine.audit", GetParam().text).string();
  const std::string emit = "emit --closures " + file + " --output " + directory.path().string();
  const std::string warning = GetParam().warning;
  const CommandResult result = run_assur(emit);
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.messages, warning.empty() ? "" : "warning: " + file + ": " + warning + "\n");
  EXPECT_EQ(run_assur(emit + " --quiet").messages, "");
  const std::string header = read_file(directory.path() / "assur/closures/mine.hpp");
  EXPECT_NE(header.find(warning.empty() ? "rigid = true;" : "rigid = false;"), std::string::npos);
}

#define LOST "; no rates and no sensitivities can be solved for"
INSTANTIATE_TEST_SUITE_P(
    Closures, Undetermined,
    testing::Values(
        Warned{"Determined",
               "length a x\nangle q\nunknown x q\nclosure f = a*cos(q) - x\n"
               "closure g = sqrt(a)*sin(q)/x - sqrt(1 - x^2)\n",
               ""},
        Warned{"OneTooFew", "length a x\nangle q\nunknown x q\nclosure f = a*cos(q) - x\n",
               "1 closure does not determine 2 unknowns" LOST},
        Warned{"TheSameTwice",
               "length a x\nangle q\nunknown x q\nclosure f = a*cos(q) - x\n"
               "closure g = 2*x - 2*a*cos(q)\n",
               "the Jacobian is singular everywhere: its rank is 1, and 2 unknowns need 2" LOST},
        Warned{"TheSumOfTwoOthers",
               "length k l m n o p x y z\nunknown x y z\nclosure f = k*x + (m + n)*y + o*z - k\n"
               "closure g = l*x + y + p*z - l\n"
               "closure h = (k + l)*x + (m + n + 1)*y + (o + p)*z - m\n",
               "the Jacobian is singular everywhere: its rank is 2, and 3 unknowns need 3" LOST},
        Warned{"TheSameUnderRoots",
               "length a x y\nunknown x y\nclosure f = sqrt(x + y) - a\n"
               "closure g = 1/sqrt(x + y) + a^2\n",
               "the Jacobian is singular everywhere: its rank is 1, and 2 unknowns need 2" LOST},
        Warned{"OfSmallNumbers", "length a x\nunknown x\nclosure f = (x/1000000)^8 - a\n", ""},
        Warned{"OfTinyNumbers", "length a x\nunknown x\nclosure f = 1e-45*x - a\n", ""},
        Warned{"OfTinyNumbersAndRoots",
               "length a x y\nunknown x y\nclosure f = 1e-45*sqrt(x) - a*y\n"
               "closure g = sqrt(x + y) - a\n",
               ""},
        Warned{"OfLengthsOfEitherSign", "length a x\nunknown x\nclosure f = sqrt(x^2) - x + a\n",
               ""},
        Warned{"OfPositiveLengths", "length a x\nunknown x\nclosure f = sqrt(x^2) + x - a\n", ""},
        Warned{"WithoutRealRoots", "length a x\nunknown x\nclosure f = sqrt(-1 - x^2) - a\n", ""},
        Warned{"ASumOfRootsAndItsSquare",
               "length a x y\nunknown x y\nclosure f = sqrt(x) + sqrt(y) - a\n"
               "closure g = sqrt(x*y)*2 + x + y - a^2\n",
               "the Jacobian is singular everywhere: its rank is 1, and 2 unknowns need 2" LOST},
        Warned{"AProductOfRootsAndTheRootOfIt",
               "length a x y\nunknown x y\nclosure f = sqrt(x)*sqrt(y) - a*x\n"
               "closure g = sqrt(x*y) - a*x\n",
               "the Jacobian is singular everywhere: its rank is 1, and 2 unknowns need 2" LOST},
        Warned{"RootsThatCancel",
               "length a x y\nunknown x\nclosure f = sqrt(x)*sqrt(y) - sqrt(x*y) - a\n",
               "the Jacobian is singular everywhere: its rank is 0, and 1 unknown needs 1" LOST},
        Warned{"OfNoUnknown", "length a x\nunknown x\nclosure f = a - 1\n",
               "the Jacobian is singular everywhere: its rank is 0, and 1 unknown needs 1" LOST}),
    [](const testing::TestParamInfo<Warned>& at) { return std::string(at.param.name); });

TEST(Refused, AMissingFileAndADirectoryAreRefused) {
  for (const std::string file : {"/nowhere.audit", "/"}) {
    for (const std::string command : {"emit --output /nowhere --closures ", "audit "}) {
      const CommandResult result = run_assur(command + file);
      EXPECT_EQ(result.status, 2);
      EXPECT_EQ(result.messages,
                "error: " + file + ": cannot be read (does it exist, and is it a file?)\n");
    }
  }
}

}  // namespace
}  // namespace assur::test::refused_closures_test
