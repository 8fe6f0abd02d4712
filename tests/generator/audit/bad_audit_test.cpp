// Law: an audit file that cannot be used gets one line with its place, what is wrong and the
// remedy.
#include <gtest/gtest.h>

#include <assur/text/error.hpp>

#include "audit/audit.hpp"

namespace assur::test::bad_audit_test {
namespace {

using namespace generator::audit;

struct Fault {
  const char* name;
  const char* text;
  const char* message;
};

std::string equation_of_27000() {
  std::string thirty;
  for (int name = 0; name < 30; ++name) {
    thirty += " a";
  }
  return "length a\nprinted equation (1) for x in" + thirty + ", y in" + thirty + ", z in" +
         thirty + " : a = a\n";
}
const std::string many_cases = equation_of_27000();

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int time = 0; time < times; ++time) {
    all += text;
  }
  return all;
}
const std::string many_letters = "length a\nprinted equation (1) for x in" + repeated(" a", 1500) +
                                 " : " + repeated("a + ", 2000) + "x = a\n";
const std::string many_entries = "length a\nclosure f = a\nprinted matrix J of" +
                                 repeated(" f", 201) + " by" + repeated(" a", 100) + "\n";
const std::string many_parts = [] {
  std::string text = "length a\nlet x0 = a\n";
  for (int level = 1; level <= 20; ++level) {
    const std::string before = "x" + std::to_string(level - 1);
    text += "let x" + std::to_string(level) + " = atan(" + before + ") + acos(" + before + ")\n";
  }
  return text;
}();

class BadAudit : public testing::TestWithParam<Fault> {};

TEST_P(BadAudit, GetsOneLineWithItsPlace) {
  try {
    static_cast<void>(audit_text(GetParam().text, "f.audit"));
    FAIL() << "nothing was thrown";
  } catch (const text::InputError& error) {
    EXPECT_STREQ(error.what(), GetParam().message);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Faults, BadAudit,
    testing::Values(
        Fault{"NoStatement", "lenght a\n",
              "f.audit:1:1: no statement 'lenght' (did you mean 'length'?)"},
        Fault{"Twice", "length a\nangle a\n", "f.audit:2:7: 'a' is declared already"},
        Fault{
            "NoName", "length 2a\n",
            "f.audit:1:8: '2a' cannot be a name; use letters, digits and underscores, but no digit "
            "first"},
        Fault{"ControlCharacter", "length r\x01\n", "f.audit:1:9: a control character; remove it"},
        Fault{"TextThatTurnsRound", "length r # \xE2\x80\x8F\n",
              "f.audit:1:12: a control character; remove it"},
        Fault{"Reserved", "length sin\n",
              "f.audit:1:8: 'sin' cannot be a name: formulas give it a meaning"},
        Fault{"UnknownOfNothing", "length ab\nunknown ac\n",
              "f.audit:2:9: no symbol named 'ac' (did you mean 'ab'?)"},
        Fault{"FormulaOfALet", "let a = 2 + b*3\n", "f.audit:1:13: no symbol named 'b'"},
        Fault{"UnfinishedLet", "let a = (2\n", "f.audit:1:11: expected ')'"},
        Fault{"EmptyLet", "let a =\n", "f.audit:1:8: a formula is missing"},
        Fault{"Indented", "  length a\n", "f.audit:1:3: this indented line continues no statement"},
        Fault{"VectorOfNumbers", "length a\nloop x y = a\n",
              "f.audit:2:12: expected a sum of point(x, y) and polar(length, angle)"},
        Fault{"Rows", "length a\nclosure f = a\nprinted matrix J of f by a\n",
              "f.audit:3:1: expected 1 row, found 0"},
        Fault{"Entries", "length a\nclosure f = a\nprinted matrix J of f by a\n  1, 2\n",
              "f.audit:4:3: expected 1 entry, found 2"},
        Fault{"Cases", many_cases.c_str(),
              "f.audit:2:26: the names make more than 20000 equations of this one; leave some out"},
        Fault{
            "Letters", many_letters.c_str(),
            "f.audit:2:26: the names make more than 10000000 letters of this one; leave some out"},
        Fault{"ManyEntries", many_entries.c_str(),
              "f.audit:3:18: the matrix has more than 20000 entries; divide it"},
        Fault{"Parts", many_parts.c_str(),
              "f.audit:19:32: written out, this has more than 500000 parts"},
        Fault{"Pole", "length a\nlet v = a\nlet w = 2/(v - a)\n",
              "f.audit:3:18: the expression has no value here"},
        Fault{"PoleOfATangent", "let v = pi/2\nlet w = 1 + tan(v)\n",
              "f.audit:2:19: the expression has no value here"},
        Fault{"Printed", "printed matricks J\n",
              "f.audit:1:9: expected closure, matrix, code, run, equation, kinds or number after "
              "'printed'"},
        Fault{"NoClosure", "printed closure (1) f : 0\n",
              "f.audit:1:21: no closure named 'f' is derived"},
        Fault{"TwoEntries", "length a b\nclosure f = a\nprinted matrix J of f by a b\n  1\n",
              "f.audit:4:3: expected 2 entries, found 1"},
        Fault{"NoColumns", "length a\nclosure f = a\nprinted matrix J of f\n",
              "f.audit:3:18: expected 'of ROWS by COLUMNS' or 'transpose of ROWS by COLUMNS'"},
        Fault{"RowsOfNothing", "length a\nclosure f = a\nprinted matrix J of by a\n",
              "f.audit:3:20: the names are missing"},
        Fault{"NoRowsOfKinds", "printed kinds T of tetrad\n",
              "f.audit:1:1: expected rows 'NUMBER : KIND, KIND, ... [: FAMILY]'"},
        Fault{"UnknownClosure", "length a\nclosure f = a\nunknown f\n",
              "f.audit:3:9: 'f' is not the name of a length or an angle"},
        Fault{"NoLength", "length\n", "f.audit:1:7: the names are missing"},
        Fault{"NoAngle", "angle : phi\n", "f.audit:1:7: the names are missing"},
        Fault{"NoUnknown", "unknown\n", "f.audit:1:8: the names are missing"},
        Fault{"NamelessLet", "let = 2\n", "f.audit:1:5: a name is missing"},
        Fault{"LetOfNothing", "let a\n", "f.audit:1:6: a formula is missing"},
        Fault{"LoopOfNothing", "loop f3 f4\n", "f.audit:1:11: a formula is missing"},
        Fault{"GivenOfNothing", "given AB\n", "f.audit:1:9: a number is missing"},
        Fault{"ValueOfNothing", "value BD\n",
              "f.audit:1:9: the expression ends where a number, a name or '(' is expected"},
        Fault{"NamesOfALoop", "length a\nprinted equation (1) for k in : k = a\n",
              "f.audit:2:31: the names are missing"},
        Fault{"NameOfAClosure", "printed closure (1)\n",
              "f.audit:1:20: the name of a closure is missing"},
        Fault{"NameOfAFile", "printed code J\n", "f.audit:1:15: the name of a file is missing"},
        Fault{"NameOfAProgram", "printed run J\n", "f.audit:1:14: the name of a file is missing"},
        Fault{"NoProgram", "printed run J no.cpp\n  result f()\n",
              "f.audit:1:15: no.cpp: cannot be read (does it exist, and is it a file?)"},
        Fault{"PointsOfARun", "printed run J no.cpp\n  points x\n",
              "f.audit:2:10: expected a whole number from 3 to 400, found 'x'"},
        Fault{"HalfAPoint", "printed run J no.cpp\n  points 4.5\n",
              "f.audit:2:10: expected a whole number from 3 to 400, found '4.5'"},
        Fault{"RoundingOfARun", "printed run J no.cpp\n  rounding 1\n",
              "f.audit:2:12: expected a number from 0 to 0.01, found '1'"},
        Fault{"HighPower", "length r\nlet u = r^10000000\n",
              "f.audit:2:19: the degree of this, of numerator and denominator together, is higher "
              "than 1000, the highest that is read"},
        Fault{"PowerOfAPower", "length r\nlet u = ((r + 1)^100)^100\n",
              "f.audit:2:26: the degree of this, of numerator and denominator together, is higher "
              "than 1000, the highest that is read"},
        Fault{"PowerOfAnAbbreviation", "length r\nlet u = r^1000\nlet w = 1/u^2\n",
              "f.audit:3:14: the degree of this, of numerator and denominator together, is higher "
              "than 1000, the highest that is read"},
        Fault{"ProductOfPowers", "length r\nlet u = r^600*r^600\n",
              "f.audit:2:20: the degree of this, of numerator and denominator together, is higher "
              "than 1000, the highest that is read"},
        Fault{"ProductWithinAQuotient", "length a b\nlet u = (a/b)^1000\n",
              "f.audit:2:19: the degree of this, of numerator and denominator together, is higher "
              "than 1000, the highest that is read"},
        Fault{"LongNumbers", "length a\nlet u = (1e308*a)^70\n",
              "f.audit:2:21: the numbers in this have too many digits when it is multiplied out"},
        Fault{"ExponentOfZero", "length a\ngiven b = 0e99999999999\n",
              "f.audit:2:11: the exponent of '0e99999999999' is out of range"},
        Fault{"MissingKind", "model\n", "f.audit:1:6: a kind is missing"},
        Fault{"MissingGroup", "printed kinds T of\n",
              "f.audit:1:19: the name of a group is missing"},
        Fault{"MissingGroupOfNumbers", "group\n", "f.audit:1:6: the name of a group is missing"},
        Fault{"NoKind", "model RRR-RRX\n",
              "f.audit:1:7: no group has a kind 'RRR-RRX'; a tetrad's is spelled like RRP-RRR"},
        Fault{"NoGroup", "printed kinds T of tertad\n",
              "f.audit:1:20: no group named 'tertad'; the groups are dyad, triad and tetrad"},
        Fault{"NoRow", "printed kinds T of tetrad\n  25 : RRR-RRR\n",
              "f.audit:2:3: expected the number of a model, 1 to 24, found '25'"},
        Fault{"NoNumber", "given a = b\n", "f.audit:1:11: expected a number, found 'b'"},
        Fault{"NoFormula", "printed number a = 2\n",
              "f.audit:1:16: expected 'printed number [LABEL] NAME = NUMBER [UNIT] is FORMULA'"},
        Fault{"NothingPrinted", "length a\n",
              "f.audit: nothing to audit; say what the source prints with 'printed'"},
        Fault{"BehindTheFirstLine", "length a\nlet b = a +\n   2*a +\n  (c + 2)\n",
              "f.audit:4:4: no symbol named 'c' (choose from a)"},
        Fault{"NoConfiguration", "scene s.json branch 1a\n",
              "f.audit:1:21: expected the number of a configuration"},
        Fault{"NoCode", "length a\nclosure f = a\nprinted code J no.cpp J of f by a\n",
              "f.audit:3:16: no.cpp: cannot be read (does it exist, and is it a file?)"}),
    [](const testing::TestParamInfo<Fault>& fault) { return fault.param.name; });

}  // namespace
}  // namespace assur::test::bad_audit_test
