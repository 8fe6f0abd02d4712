// Law: programs in C, Python, Octave and JavaScript are judged by what they compute, as those in
// C++ are.
#include <gtest/gtest.h>

#include "run_program.hpp"
#include "whole_campaign.hpp"

namespace assur::test::run_languages_test {
namespace {

#define FULL_RIGHT "return [[-l*sin(theta), -1], [l*cos(theta), 0]];"

class RunLanguage : public testing::TestWithParam<Program> {};

TEST_P(RunLanguage, IsJudgedByWhatItComputes) { expect_judged(GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    OtherLanguages, RunLanguage,
    testing::ValuesIn(installed(share_of<Program>(
        {Program{
             "C", "a.c",
             "#include <math.h>\nstatic double J[2][2];\nvoid f(double l, double t) { J[0][0] = "
             "-l*sin(t); J[0][1] = -1; J[1][0] = l*cos(t); }",
             FRAME "  before f(l, theta)\n  result J", 0, "all 4 agree"},
         Program{"CFlat", "a.c",
                 "#include <math.h>\nvoid f(double l, double t, double* J) { J[0] = l*sin(t); "
                 "J[1] = -1; J[2] = l*cos(t); J[3] = 0; }",
                 FRAME "  before double J[4]; f(l, theta, J)\n  result J\n  entry result[2*i + j]",
                 1, "the sign is wrong"},
         Program{"Python", "a.py", PYTHON("return [[-l*sin(theta), -1], (l*cos(theta), 0)]"), CALL,
                 0, "all 4 agree"},
         Program{"PythonWrong", "a.py", PYTHON("return [[-l*sin(theta), 1], [l*cos(theta), 0]]"),
                 CALL, 1, "(1,2) d f1/d s: differs by sign"},
         Program{"PythonPrints", "a.py",
                 PYTHON("print('nan'); return [[-l*sin(theta), -1], [l*cos(theta), 0]]"), CALL, 0,
                 "all 4 agree"},
         Program{"PythonBefore", "a.py",
                 "from math import *\nclass C:\n  def __init__(self, l): self.l = l\n"
                 "def f(c, J, t):\n  J += [-c.l*sin(t), -1, c.l*cos(t), 0]\n",
                 FRAME "  before J = []; c = C(l)\n  before f(c, J, theta)\n  result J\n"
                       "  entry result[2*i + j]",
                 0, "all 4 agree"},
         Program{"PythonFlat", "a.py", PYTHON("return [1, 2, 3, 4]"), CALL, 2,
                 "say, for instance, 'entry result[i*2 + j]'"},
         Program{"PythonRaises", "a.py", PYTHON("return math.sqrt(-5 - l)"), CALL, 1,
                 "printed     it ended with ValueError: "},
         Program{"PythonExits", "a.py", PYTHON("raise SystemExit(0)"), CALL, 1, "SystemExit: 0"},
         Program{"PythonHangs", "a.py", PYTHON("while True: pass"), CALL, 1,
                 "did not end within 1 s"},
         Program{"PythonText", "a.py", PYTHON("return [['a', 1], [2, 3]]"), CALL, 1,
                 "ended with TypeError: the result has text in place of numbers"},
         Program{"PythonNumbersAsText", "a.py",
                 PYTHON("return [[str(-l*sin(theta)), -1], [l*cos(theta), 0]]"), CALL, 1,
                 "ended with TypeError: the result has text in place of numbers"},
         Program{"PythonNoNumber", "a.py", PYTHON("return [[math.nan, 1], [2, 3]]"), CALL, 1,
                 "printed     it is not a number (NaN)"},
         Program{"PythonWrongSize", "a.py", PYTHON("return [[1, 2]]"), CALL, 2,
                 "the result is 1 by 2, not 2 by 2"},
         Program{"PythonSyntax", "a.py", "def f(l:\n", CALL, 2, "ended with SyntaxError"},
         Program{"Octave", "f.m",
                 "function J = f(l, theta)\nJ = [-l*sin(theta), -1; l*cos(theta), 0];\nend\n", CALL,
                 0, "all 4 agree"},
         Program{"PythonRowsAreOne", "a.py",
                 PYTHON("J = [[0]*2]*2; J[0][0] = -l*sin(theta); J[0][1] = -1; J[1][0] = "
                        "l*cos(theta); J[1][1] = 0; return J"),
                 CALL, 1, "2 of 4 agree"},
         Program{
             "PythonListOfTheFirstCall", "a.py",
             "from math import *\ndef f(l, t, c=[]):\n    c.append(cos(t)); return [[-l*sin(t), "
             "-1], [l*c[0], 0]]\n",
             CALL, 1, "3 of 4 agree"},
         Program{"PythonComplex", "a.py",
                 PYTHON("return [[-l*sin(theta), -1], [l*cos(theta), 0j]]"), CALL, 1,
                 "printed     it is a complex number, 0j"},
         Program{"OctaveEnd", "f.m",
                 "function J = f(l, theta)\nJ = zeros(2); J(end, 1) = -l*sin(theta); J(1, 2) = -1; "
                 "J(1, 1) = l*cos(theta);\nend\n",
                 CALL, 1, "2 of 4 agree"},
         Program{"OctaveDeal", "f.m",
                 "function J = f(l, theta)\nJ = zeros(2); [J(1, 1), J(2, 1)] = deal(l*cos(theta), "
                 "-l*sin(theta)); J(1, 2) = -1;\nend\n",
                 CALL, 1, "it is exchanged with (2,1)"},
         Program{
             "OctaveLogical", "f.m",
             "function J = f(l, theta)\nJ = [-l*sin(theta), -1; l*cos(theta), 0]; J(J < 0) = 0;\n"
             "end\n",
             CALL, 1, "1 of 4 agree"},
         Program{"OctaveComplex", "f.m",
                 "function J = f(l, theta)\nJ = [-l*sin(theta), -1; l*cos(theta), "
                 "sqrt(-theta^2)];\nend\n",
                 CALL, 1, "printed     it is a complex number, 0"},
         Program{"OctaveGlobal", "f.m",
                 "function J = f(l, theta)\nglobal c; if isempty(c), c = cos(theta); end\nJ = "
                 "[-l*sin(theta), -1; l*c, 0];\nend\n",
                 CALL, 1, "3 of 4 agree"},
         Program{"OctaveError", "f.m", "function J = f(l, theta)\nerror('no way');\nend\n", CALL, 1,
                 "ended with no way"},
         Program{"OctaveExits", "f.m", "function J = f(l, theta)\nexit(0);\nend\n", CALL, 1,
                 "ended with status 0\n"},
         Program{"OctaveHangs", "f.m", "function J = f(l, theta)\nwhile true\nend\nend\n", CALL, 1,
                 "did not end within 2 s"},
         Program{"OctaveCell", "f.m", "function J = f(l, theta)\nJ = {1, 2; 3, 4};\nend\n", CALL, 1,
                 "printed     it ended with "},
         Program{"OctaveText", "f.m", "function J = f(l, theta)\nJ = ['ab'; 'cd'];\nend\n", CALL, 1,
                 "ended with a result that is not a matrix of numbers"},
         Program{"OctaveThirdDimension", "f.m",
                 "function J = f(l, theta)\nJ = [-l*sin(theta), -1; l*cos(theta), 0];\n"
                 "J(:, :, 2) = 1;\nend\n",
                 CALL, 2, "the result is 2 by 2 by 2, not 2 by 2"},
         Program{"OctaveWrongSize", "f.m", "function J = f(l, theta)\nJ = [1 2 3];\nend\n", CALL, 2,
                 "the result is 1 by 3, not 2 by 2"},
         Program{"OctaveWrong", "f.m",
                 "function J = f(l, theta)\nJ = [-l*sin(theta), -1; l*cos(theta), 0]';\nend\n",
                 CALL, 1, "the matrix is transposed"},
         Program{"OctaveFailsAtSome", "f.m",
                 "function J = f(l, theta)\nif l > 1, error('too long'); end\nJ = [-l*sin(theta), "
                 "-1; l*cos(theta), 0];\nend\n",
                 CALL, 1, "note        it fails at 35 of 40 points; it agrees at the others"},
         Program{"OctaveSingle", "f.m",
                 "function J = f(l, theta)\nJ = single([-l*sin(theta), -1; l*cos(theta), 0]);\n"
                 "end\n",
                 CALL, 0, "in single precision"},
         Program{"CNumber", "a.c",
                 "#include <math.h>\ndouble f(double l, double t) { return -l*sin(t); }",
                 "-l*sin(theta)\n  result f(l, theta)", 0, "agrees, computed at 40"},
         Program{"CNumberForAList", "a.c",
                 "#include <math.h>\ndouble f(double l, double t) { return -l*sin(t); }",
                 "-l*sin(theta), -l*sin(theta)\n  result f(l, theta)", 2,
                 "say, for instance, 'entry result[i*1 + j]'"},
         Program{
             "CSingle", "a.c",
             "#include <math.h>\nvoid f(float l, float t, float J[2][2]) { J[0][0] = -l*sinf(t); "
             "J[0][1] = -1; J[1][0] = l*cosf(t); J[1][1] = 0; }",
             FRAME "  before float J[2][2]; f(l, theta, J)\n  result J", 0, "in single precision"},
         Program{"CSingleWrong", "a.c",
                 "#include <math.h>\nfloat f(float l, float t) { return -l*sinf(t)*1.001f; }",
                 "-l*sin(theta)\n  result f(l, theta)", 1, "differs"},
         Program{"CComplex", "a.c",
                 "#include <complex.h>\ndouble _Complex f(double l) { return csqrt(-l*l); }",
                 "l\n  result f(l)", 1, "printed     it is a complex number, 0+"},
         Program{"PythonFailsAtSome", "a.py",
                 PYTHON("return [[-l*sin(theta), -1], [l*cos(theta), 0*math.sqrt(1 - l)]]"), CALL,
                 1, "note        it fails at 35 of 40 points; it agrees at the others"},
         Program{"PythonOwnNameError", "a.py", PYTHON("return sinus(theta)"), CALL, 1,
                 "printed     it ended with NameError: name 'sinus' is not defined"},
         Program{"PythonNoSuchName", "a.py", PYTHON("return 0"), FRAME "  result g(l)", 2,
                 "a.py cannot be audited: it has no 'g'"},
         Program{"PythonNothingOfIt", "a.py", PYTHON("return 0"), FRAME "  result abs(l)", 2,
                 "a.py cannot be audited: the rows use nothing of it"}},
        4))),
    [](const testing::TestParamInfo<Program>& at) { return std::string(at.param.name); });

INSTANTIATE_TEST_SUITE_P(
    JavaScript, RunLanguage,
    testing::ValuesIn(installed(share_of<Program>(
        {Program{"Script", "a.js", JAVASCRIPT(FULL_RIGHT), CALL, 0, "all 4 agree"},
         Program{"CommonJs", "a.js",
                 "'use strict';\n" JAVASCRIPT(FULL_RIGHT) "module.exports = { jacobian: f };\n",
                 FRAME "  result jacobian(l, theta)", 0, "all 4 agree"},
         Program{"CommonJsFunction", "lever.cjs",
                 "const { sin, cos } = require('node:util') && Math;\nmodule.exports = (l, theta) "
                 "=> { " FULL_RIGHT " };\n",
                 FRAME "  result lever(l, theta)", 0, "all 4 agree"},
         Program{"EsModule", "a.mjs",
                 "const { sin, cos } = Math;\nexport function f(l, theta) { " FULL_RIGHT " }\n",
                 CALL, 0, "all 4 agree"},
         Program{
             "EsModuleByItsText", "a.js",
             "import { format } from 'node:util';\n" JAVASCRIPT(FULL_RIGHT) "export default f;\n",
             FRAME "  result a(l, theta)", 0, "all 4 agree"},
         Program{"NotExported", "a.mjs", JAVASCRIPT(FULL_RIGHT) "export const g = 1;\n", CALL, 0,
                 "all 4 agree"},
         Program{"TypedArrays", "a.js",
                 JAVASCRIPT("return [[-l*sin(theta), -1], [l*cos(theta), 0]]"
                            ".map(row => Float64Array.from(row));"),
                 CALL, 0, "all 4 agree"},
         Program{"SingleArray", "a.js",
                 JAVASCRIPT("return Float32Array.of(-l*sin(theta), -1, l*cos(theta), 0);"),
                 FRAME "  result f(l, theta)\n  entry result[2*i + j]", 0, "in single precision"},
         Program{"Wrong", "a.js", JAVASCRIPT("return [[l*sin(theta), -1], [l*cos(theta), 0]];"),
                 CALL, 1, "the sign is wrong"},
         Program{"Flat", "a.js", JAVASCRIPT("return [1, 2, 3, 4];"), CALL, 2,
                 "say, for instance, 'entry result[i*2 + j]'"},
         Program{"WrongSize", "a.js", JAVASCRIPT("return [[1, 2]];"), CALL, 2,
                 "the result is 1 by 2, not 2 by 2"},
         Program{"Undefined", "a.js", JAVASCRIPT("return [[-l*sin(theta), -1], [l, undefined]];"),
                 CALL, 1, "(2,2) d f2/d s: fails"},
         Program{"Text", "a.js", JAVASCRIPT("return [['1', 2], [3, 4]];"), CALL, 1,
                 "the result has text in place of numbers"},
         Program{"Throws", "a.js",
                 JAVASCRIPT("if (l > 1) throw new RangeError('long'); " FULL_RIGHT), CALL, 1,
                 "note        it fails at 35 of 40 points; it agrees at the others"},
         Program{"Exits", "a.js", JAVASCRIPT("process.exit(0);"), CALL, 1, "ended with status 0\n"},
         Program{"Kept", "a.js",
                 "let last = 0;\n" JAVASCRIPT("const c = last; last = cos(theta); "
                                              "return [[-l*sin(theta), -1], [l*c, 0]];"),
                 CALL, 1, "the same call gives another value later"},
         Program{"Syntax", "a.js", "function f(l {\n", CALL, 2, "it ended with SyntaxError"},
         Program{"NoSuchFunction", "a.js", JAVASCRIPT(FULL_RIGHT), FRAME "  result g(l)", 2,
                 "a.js cannot be audited: g is not defined"},
         Program{"OwnMissingFunction", "a.js", JAVASCRIPT("return g(l);"), CALL, 1,
                 "printed     it ended with ReferenceError: g is not defined"}},
        4))),
    [](const testing::TestParamInfo<Program>& at) { return std::string(at.param.name); });

}  // namespace
}  // namespace assur::test::run_languages_test
