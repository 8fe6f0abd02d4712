#!/usr/bin/env python3
"""Law: a slip planted in a program of any of 14 sorts is found by running it, and no right program is called wrong.

Each program is written with symbolic or with fixed lengths, in Python, JavaScript, C++, C or Octave. What a slip
changes is decided here, by values at configurations that are found without the audit.
"""
import ast
import copy
import math
import os
import random
import shutil
import subprocess
import sys
import tempfile

SEED = 57
ASSUR = sys.argv[1]
PART, PARTS = (int(each) for each in (sys.argv[2] if len(sys.argv) > 2 else "0/1").split("/"))  # of the sorts
WHOLE = os.environ.get("ASSUR_WHOLE_CAMPAIGN") == "1"

SLIDER = ("x", "th ph", "ph x", "th", "loop f1 f2 = polar({r}, th) + polar({l}, ph) - point(x, 0)")
FOUR_BAR = ("", "t2 t3 t4", "t3 t4", "t2",
            "loop f1 f2 = polar({a}, t2) + polar({b}, t3) - polar({c}, t4) - point({d}, 0)")
INVERTED = ("s", "th ps", "s ps", "th", "loop f1 f2 = point({h}, 0) + polar({r}, th) - polar(s, ps)")
FIVE_BAR = ("", "q1 q2 u v", "u v", "q1 q2",
            "loop f1 f2 = polar({a}, q1) + polar({b}, u) - polar({e}, q2) - polar({c}, v) - point({d}, 0)")
LENGTHS = {"r": 1.5, "l": 3.25, "a": 1.25, "b": 2.75, "c": 2.5, "d": 3.0, "e": 1.75, "h": 2.25}


class Sort:
    """A sort of program: what it computes of which mechanism, from what, and how."""

    def __init__(self, name, mechanism, of, takes, lines, gives, where="", symbolic_only=False):
        self.name, self.mechanism, self.of, self.takes = name, mechanism, of, takes
        self.lines = [(target, ast.parse(value, mode="eval").body) for target, value in lines]
        self.gives = [ast.parse(value, mode="eval").body for value in gives]
        self.where, self.symbolic_only = where, symbolic_only
        self.is_matrix = " by " in of

    def lengths(self):
        return [name for name in LENGTHS if "{" + name + "}" in self.mechanism[4] + self.of]


SLIDER_RATE = ("dp", "-r*w*cos(th)/(l*cos(ph))")
FOUR_BAR_RATES = [("w3", "a*w*sin(t4 - t2)/(b*sin(t3 - t4))"), ("w4", "a*w*sin(t2 - t3)/(c*sin(t4 - t3))")]
SORTS = [
    Sort("slider position", SLIDER, "of x, sin(ph)", "th", [("s", "-r*sin(th)/l"), ("k", "sqrt(1 - s*s)")],
         ["r*cos(th) + l*k", "s"], "cos(ph)"),
    Sort("slider velocity", SLIDER, "of rate(x), rate(ph)", "th ph rate_th:w", [SLIDER_RATE],
         ["-r*w*sin(th) - l*dp*sin(ph)", "dp"]),
    Sort("slider acceleration", SLIDER, "of rate2(x), rate2(ph)", "th ph rate_th:w rate2_th:g",
         [SLIDER_RATE, ("ddp", "(r*w*w*sin(th) - r*g*cos(th) + l*dp*dp*sin(ph))/(l*cos(ph))")],
         ["-r*g*sin(th) - r*w*w*cos(th) - l*ddp*sin(ph) - l*dp*dp*cos(ph)", "ddp"]),
    Sort("slider Jacobian", SLIDER, "of f1 f2 by ph x", "ph", [], ["-l*sin(ph)", "-1.0", "l*cos(ph)", "0.0"]),
    Sort("slider sensitivity", SLIDER, "of D(x, {l}), D(x, {r})", "th ph",
         [("by_l", "-sin(ph)/(l*cos(ph))"), ("by_r", "-sin(th)/(l*cos(ph))")],
         ["cos(ph) - l*sin(ph)*by_l", "cos(th) - l*sin(ph)*by_r"], symbolic_only=True),
    Sort("slider coefficients", SLIDER, "of D(x, th), D(D(x, th), th)", "th ph",
         [("k", "-r*cos(th)/(l*cos(ph))"), ("m", "(r*sin(th) + l*k*k*sin(ph))/(l*cos(ph))")],
         ["-r*sin(th) - l*k*sin(ph)", "-r*cos(th) - l*m*sin(ph) - l*k*k*cos(ph)"]),
    Sort("four-bar position", FOUR_BAR, "of cos(t3), sin(t3), sin(t4)", "t2",
         [("p", "d - a*cos(t2)"), ("q", "-a*sin(t2)"), ("n", "p*p + q*q"),
          ("z", "atan2(q, p) + acos((n + b*b - c*c)/(2*b*sqrt(n)))")],
         ["cos(z)", "sin(z)", "(b*sin(z) - q)/c"], "sin(t4 - t3)"),
    Sort("four-bar velocity", FOUR_BAR, "of rate(t3), rate(t4)", "t2 t3 t4 rate_t2:w", FOUR_BAR_RATES, ["w3", "w4"]),
    Sort("four-bar acceleration", FOUR_BAR, "of rate2(t3), rate2(t4)", "t2 t3 t4 rate_t2:w rate2_t2:g",
         FOUR_BAR_RATES,
         ["(c*w4*w4 - a*g*sin(t2 - t4) - a*w*w*cos(t2 - t4) - b*w3*w3*cos(t3 - t4))/(b*sin(t3 - t4))",
          "(a*g*sin(t2 - t3) + a*w*w*cos(t2 - t3) + b*w3*w3 - c*w4*w4*cos(t4 - t3))/(c*sin(t4 - t3))"]),
    Sort("four-bar Jacobian", FOUR_BAR, "of f1 f2 by t3 t4", "t3 t4", [],
         ["-b*sin(t3)", "c*sin(t4)", "b*cos(t3)", "-c*cos(t4)"]),
    Sort("coupler point", FOUR_BAR, "of rate({a}*cos(t2) + {e}*cos(t3)), rate({a}*sin(t2) + {e}*sin(t3))",
         "t2 t3 t4 rate_t2:w", FOUR_BAR_RATES[:1],
         ["-a*w*sin(t2) - e*w3*sin(t3)", "a*w*cos(t2) + e*w3*cos(t3)"]),
    Sort("swinging block position", INVERTED, "of s, cos(ps)", "th",
         [("p", "h + r*cos(th)"), ("q", "r*sin(th)"), ("k", "sqrt(p*p + q*q)")], ["k", "p/k"], "s"),
    Sort("swinging block velocity", INVERTED, "of rate(s), rate(ps)", "th ps s rate_th:w", [],
         ["-r*w*sin(th - ps)", "r*w*cos(th - ps)/s"]),
    Sort("five-bar map", FIVE_BAR, "of D(u, q1), D(v, q1), D(u, q2)", "q1 q2 u v", [],
         ["-a*sin(q1 - v)/(b*sin(u - v))", "a*sin(q1 - u)/(c*sin(v - u))", "e*sin(q2 - v)/(b*sin(u - v))"]),
]
LANGUAGES = {"python": "py", "javascript": "js", "c++": "cpp", "c": "c", "octave": "m"}
TOOLS = {"javascript": "node", "octave": "octave-cli"}


def circle_pair(p, q, b, c):
    """The directions (of b, of c) with b e^(iu) - c e^(iv) = (p, q), in both assemblies."""
    n = p * p + q * q
    cosine = (n + b * b - c * c) / (2 * b * math.sqrt(n))
    for side in (1, -1) if abs(cosine) < 0.999 else ():
        u = math.atan2(q, p) + side * math.acos(cosine)
        yield u, math.atan2(b * math.sin(u) - q, b * math.cos(u) - p)


def configurations(sort, fixed, engine):
    """Values of all names at configurations of the mechanism that the sort's condition allows."""
    while True:
        at = {name: LENGTHS[name] if fixed else engine.uniform(0.8, 3) for name in LENGTHS}
        at |= {name: engine.uniform(-3, 3) for name in ("th", "t2", "q1", "q2", "w", "g")}
        if sort.mechanism is SLIDER:
            sine = -at["r"] * math.sin(at["th"]) / at["l"]
            found = [{"ph": one, "x": at["r"] * math.cos(at["th"]) + at["l"] * math.cos(one)}
                     for one in ((math.asin(sine), math.pi - math.asin(sine)) if abs(sine) < 0.999 else ())]
        elif sort.mechanism is FOUR_BAR:
            p, q = at["d"] - at["a"] * math.cos(at["t2"]), -at["a"] * math.sin(at["t2"])
            found = [{"t3": u, "t4": v} for u, v in circle_pair(p, q, at["b"], at["c"])]
        elif sort.mechanism is INVERTED:
            p, q = at["h"] + at["r"] * math.cos(at["th"]), at["r"] * math.sin(at["th"])
            found = [{"s": sign * math.hypot(p, q), "ps": math.atan2(sign * q, sign * p)} for sign in (1, -1)]
        else:
            p = at["d"] + at["e"] * math.cos(at["q2"]) - at["a"] * math.cos(at["q1"])
            q = at["e"] * math.sin(at["q2"]) - at["a"] * math.sin(at["q1"])
            found = [{"u": u, "v": v} for u, v in circle_pair(p, q, at["b"], at["c"])]
        for unknowns in found:
            whole = at | unknowns
            if not sort.where or eval(sort.where, vars(math) | whole) > 0:
                yield whole


def values(lines, gives, at):
    names = vars(math) | at
    try:
        for target, value in lines:
            names[target] = eval(compile(ast.Expression(value), "", "eval"), names)
        return [eval(compile(ast.Expression(value), "", "eval"), names) for value in gives]
    except (ValueError, ZeroDivisionError, OverflowError):
        return None


def nodes_of(program, kind, wanted=lambda node: True):
    lines, gives = program
    return [node for value in [value for _, value in lines] + gives for node in ast.walk(value)
            if isinstance(node, kind) and wanted(node)]


def become(node, other):
    """Turns a node into another one in place."""
    node.__class__ = other.__class__
    node.__dict__ = dict(other.__dict__)


def is_sum(node):
    return isinstance(node.op, (ast.Add, ast.Sub))


def plant_sign(program, sort, engine):
    choice = engine.choice(nodes_of(
        program, (ast.BinOp, ast.UnaryOp), lambda node: isinstance(node, ast.UnaryOp) or is_sum(node)))
    if isinstance(choice, ast.UnaryOp):
        become(choice, choice.operand)
    else:
        choice.op = ast.Sub() if isinstance(choice.op, ast.Add) else ast.Add()


def plant_name(program, sort, engine):
    angles, lengths = sort.mechanism[1].split(), sort.lengths()
    taken = [name.split(":")[-1] for name in sort.takes.split()]
    kinds = [[name for name in angles if name in taken], lengths]
    choice = engine.choice(nodes_of(program, ast.Name, lambda node: any(
        node.id in kind and len(kind) > 1 for kind in kinds)))
    kind = next(kind for kind in kinds if choice.id in kind)
    choice.id = engine.choice([name for name in kind if name != choice.id])


def plant_function(program, sort, engine):
    choice = engine.choice(nodes_of(program, ast.Call, lambda node: node.func.id in ("sin", "cos")))
    choice.func.id = "cos" if choice.func.id == "sin" else "sin"


def plant_factor(program, sort, engine):
    choice = engine.choice(nodes_of(program, ast.BinOp, lambda node: isinstance(node.op, ast.Mult)))
    become(choice, engine.choice([choice.left, choice.right]))


def plant_term(program, sort, engine):
    choice = engine.choice(nodes_of(program, ast.BinOp, is_sum))
    become(choice, choice.left)


SLIPS = {"sign": plant_sign, "index": plant_name, "sine and cosine": plant_function, "missing factor": plant_factor,
         "lost term": plant_term}


def rewritten(program, engine):
    """The same program written otherwise: operands exchanged, parts with names of their own."""
    lines, gives = copy.deepcopy(program)
    for node in nodes_of((lines, gives), ast.BinOp, lambda node: isinstance(node.op, (ast.Add, ast.Mult))):
        if engine.random() < 0.5:
            node.left, node.right = node.right, node.left
    for place, value in enumerate(gives):
        if engine.random() < 0.5:
            lines.append((f"part_{place}", value))
            gives[place] = ast.Name(f"part_{place}", ast.Load())
    return lines, gives


def text_of(node, language):
    within = {"python": "", "javascript": "Math.", "c++": "std::", "c": "", "octave": ""}[language]
    if isinstance(node, ast.BinOp):
        sign = {ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.Div: "/"}[type(node.op)]
        return f"({text_of(node.left, language)} {sign} {text_of(node.right, language)})"
    if isinstance(node, ast.UnaryOp):
        return f"(-{text_of(node.operand, language)})"
    if isinstance(node, ast.Call):
        return within + node.func.id + "(" + ", ".join(text_of(each, language) for each in node.args) + ")"
    return node.id if isinstance(node, ast.Name) else str(float(node.value))


def written(sort, program, language, fixed):
    """The file of a program, and the rows of the audit that call it."""
    lines, gives = program
    lengths = sort.lengths()
    takes = [name.split(":") for name in sort.takes.split()]
    names = ([] if fixed else lengths) + [name[-1] for name in takes]
    call = "f(" + ", ".join(([] if fixed else lengths) + [name[0] for name in takes]) + ")"
    body = [(name, str(LENGTHS[name])) for name in (lengths if fixed else [])]
    body += [(target, text_of(value, language)) for target, value in lines]
    results = [text_of(value, language) for value in gives]
    rows = [results[:2], results[2:]] if sort.is_matrix else [[each] for each in results]
    comma = ", ".join
    if language == "octave":
        code = "function y = f(" + comma(names) + ")\n" + "".join(f"  {name} = {value};\n" for name, value in body)
        return code + "  y = [" + "; ".join(comma(row) for row in rows) + "];\nend\n", f"  result {call}\n"
    flat = "[" + comma("[" + comma(row) + "]" for row in rows) + "]" if sort.is_matrix else "[" + comma(results) + "]"
    if language == "python":
        code = "from math import *\ndef f(" + comma(names) + "):\n"
        code += "".join(f"    {name} = {value}\n" for name, value in body)
        return code + f"    return {flat}\n", f"  result {call}\n"
    if language == "javascript":
        code = "function f(" + comma(names) + ") {\n" + "".join(f"  const {name} = {value};\n" for name, value in body)
        return code + f"  return {flat};\n}}\n", f"  result {call}\n"
    code = "#include <array>\n#include <cmath>\n" if language == "c++" else "#include <math.h>\n"
    given = comma("double " + name for name in names)
    settings = "".join(f"  const double {name} = {value};\n" for name, value in body)
    columns = len(rows[0])
    entry = "  entry result[%d*i + j]\n" % columns
    if language == "c++":
        size = len(results)
        code += f"std::array<double, {size}> f({given}) {{\n{settings}  return {{{comma(results)}}};\n}}\n"
    else:
        code += f"double* f({given}) {{\n  static double y[{len(results)}];\n{settings}"
        code += "".join(f"  y[{place}] = {value};\n" for place, value in enumerate(results)) + "  return y;\n}\n"
    return code, f"  result {call}\n{entry}"


def audited(sort, program, language, fixed, directory):
    """What the audit of a program says, and its exit status."""
    code, rows = written(sort, program, language, fixed)
    name = "f." + LANGUAGES[language]
    with open(os.path.join(directory, name), "w", encoding="utf-8") as file:
        file.write(code)
    numbers = {one: str(LENGTHS[one]).replace(".", "") + "/" + "1" + "0" * (len(str(LENGTHS[one]).split(".")[1]))
               if fixed else one for one in LENGTHS}
    lengths = ([] if fixed else sort.lengths()) + sort.mechanism[0].split()
    text = ("length " + " ".join(lengths) + "\n" if lengths else "") + "angle " + sort.mechanism[1] + "\nunknown "
    text += sort.mechanism[2] + "\nmoving " + sort.mechanism[3] + "\n" + sort.mechanism[4].format(**numbers) + "\n"
    text += f"printed run a {name} " + sort.of.format(**numbers) + "\n" + rows
    text += f"  where {sort.where}\n" if sort.where else ""
    with open(os.path.join(directory, "f.audit"), "w", encoding="utf-8") as file:
        file.write(text)
    run = subprocess.run([ASSUR, "audit", "f.audit", "--run"], cwd=directory, capture_output=True, text=True)
    return run.returncode, text + code + run.stdout + run.stderr


def is_changed(sort, program, wrong, fixed, engine):
    found = configurations(sort, fixed, engine)
    for _ in range(30):
        at = next(found)
        right, other = values(*program, at), values(*wrong, at)
        if other is None or any(abs(one - two) > 1e-6 * (1 + abs(one)) for one, two in zip(right, other)):
            return True
    return False


def main():
    languages = [each for each in LANGUAGES if shutil.which(TOOLS.get(each, "sh"))]
    left_out = sorted(set(LANGUAGES) - set(languages))
    counts = {"right": 0, "wrong": 0, "harmless": 0}
    faults = []
    with tempfile.TemporaryDirectory() as directory:
        def expect(status, sort, program, language, fixed, what):
            found, said = audited(sort, program, language, fixed, directory)
            counts["right" if status == 0 else "wrong"] += 1
            if found != status:
                faults.append(f"{sort.name}, {language}, {'fixed' if fixed else 'symbolic'}, {what}:\n{said}")

        for place, sort in list(enumerate(SORTS))[PART::PARTS]:
            engine = random.Random(f"{SEED} {sort.name}")
            program = (sort.lines, sort.gives)
            for fixed in (False, True)[: 1 if sort.symbolic_only else 2]:
                compiled = [each for each in languages if each in ("c++", "c", "octave")]
                interpreted = [each for each in languages if each in ("python", "javascript")]
                some = languages if WHOLE else [languages[(2 * place + fixed) % len(languages)]]
                for language in some:
                    expect(0, sort, program, language, fixed, "right")
                    for name, plant in SLIPS.items() if WHOLE else [engine.choice(list(SLIPS.items()))]:
                        wrong = copy.deepcopy(program)
                        try:
                            plant(wrong, sort, engine)
                        except IndexError:  # there is nothing of this kind
                            continue
                        if not is_changed(sort, program, wrong, fixed, engine):
                            counts["harmless"] += 1
                            continue
                        expect(1, sort, wrong, language, fixed, name)
                for _ in range(75 if WHOLE else 0):
                    language = engine.choice(interpreted if engine.random() < 0.9 else compiled or interpreted)
                    expect(0, sort, rewritten(program, engine), language, fixed, "rewritten")
    print(f"seed {SEED}: {len(SORTS[PART::PARTS])} sorts; right {counts['right']}, wrong {counts['wrong']}, "
          f"harmless slips {counts['harmless']}; misjudged {len(faults)}"
          + (f"; not installed: {', '.join(left_out)}" if left_out else ""))
    print("\n".join(faults[:5]))
    return 1 if faults else 0


sys.exit(main())
