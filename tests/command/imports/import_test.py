"""Law: an imported scene has the drawn configuration of its file, and the motion that the other
program gives it.

What is imported is solved and swept; places, angles, laws of drives and efforts are compared with
formulas of this file. What a scene does not say is told in one line each, with the exit status of
what is missing; a file that cannot be read gets one line, status 2, and no scene.
"""

import json
import math
import pathlib
import subprocess
import sys
import tempfile

from foreign_files import bar, force, joint, link, linkage, payload, pin

failures = 0
checks = 0


def expect(holds, message):
    global failures, checks
    checks += 1
    if not holds:
        failures += 1
        print("FAILED:", message)


def expect_near(one, other, message, error=1e-9):
    scale = max(1, *(abs(value) for value in other))
    gap = max(abs(a - b) for a, b in zip(one, other, strict=True))
    expect(gap <= error * scale, f"{message}: {one} in place of {other}")


class Importer:
    def __init__(self, command, directory):
        self.command, self.directory = command, pathlib.Path(directory)
        self.scene = self.directory / "scene.json"

    def run(self, text, *options, as_argument=False):
        """The status, the lines on standard error, and the scene if one was written."""
        self.scene.unlink(missing_ok=True)
        source = self.directory / "source.txt"
        source.write_bytes(text if isinstance(text, bytes) else text.encode())
        run = subprocess.run(
            [self.command, "import", text if as_argument else str(source), "--output",
             str(self.scene), *options], capture_output=True, text=True, timeout=60)
        expect(run.stdout == "", "nothing on standard output")
        lines = [line.replace(f"{source}: ", "") for line in run.stderr.splitlines()]
        scene = json.loads(self.scene.read_text()) if self.scene.exists() else None
        return run.returncode, lines, scene

    def scene_of(self, name, text, *options, status=0, told=()):
        """Imports, and checks the remarks and that the scene has its drawn configuration."""
        found, lines, scene = self.run(text, *options)
        expect(found == status, f"{name}: status {found}: {lines}")
        for words in told:
            expect(sum(words in line for line in lines) == 1, f"{name}: '{words}' in {lines}")
        expect(all(line.startswith("note: ") for line in lines), f"{name}: {lines}")
        answer = self.solve("--format", "json")
        drawn = answer["drawn"]
        expect(drawn["configuration"] is not None and drawn["distance"] < 1e-6,
               f"{name}: drawn {drawn}")
        pose = answer["configurations"][drawn["configuration"] - 1]
        for point, output in pose["outputs"].items():
            expect_near(output["position"], scene["points"][point], f"{name}: {point} as drawn")
        return scene, pose

    def solve(self, *options):
        run = subprocess.run([self.command, "solve", str(self.scene), *options],
                             capture_output=True, text=True, timeout=60)
        expect(run.returncode == 0, run.stderr)
        if "json" in options:
            return json.loads(run.stdout)
        rows = [line.split(",") for line in run.stdout.splitlines()]
        return [dict(zip(rows[0], map(number_of, row))) for row in rows[1:]]

    def sweep(self):
        """The rows of the drawn branch over the scene's sweep."""
        sweep = json.loads(self.scene.read_text())["sweep"]
        # Rows of events have no step.
        rows = [row for row in self.solve("--format", "csv", "--nearest")
                if row["step"] is not None]
        expect(len(rows) == sweep["count"], f"{len(rows)} of {sweep['count']} rows")
        expect(any(abs(row["t"]) < 1e-12 for row in rows), "the drawing is a step")
        return rows


def number_of(cell):
    try:
        return float(cell)
    except ValueError:
        return None


def to_and_fro(way, limit):
    rest = abs(way) % (2 * limit)
    return min(rest, 2 * limit - rest)


def turned(angle, other):
    """The difference of two angles, in (-pi, pi]."""
    return math.remainder(angle - other, 2 * math.pi)


def test_linkage_turns(importer):
    four_bar = lambda rpm: linkage(
        [pin(0, 0, 0, f'anchor="true" input="true" rpm="{rpm}"'), pin(1, 20, 30),
         pin(2, 110, 50, 'draw="true"'), pin(3, 120, -20, 'anchor="true"')],
        [bar(0, [0, 1], 'name="crank"'), bar(1, [1, 2], 'name="rod"'), bar(2, [2, 3])])
    for rpm in (30, -7.5):
        scene, pose = importer.scene_of(f"four-bar at {rpm}", four_bar(rpm))
        omega = -rpm * 2 * math.pi / 60
        expect_near([pose["links"]["crank"]["velocity"][2]], [omega], "positive is clockwise")
        rows = importer.sweep()
        expect_near([rows[-1]["t"] - rows[0]["t"]], [60 / abs(rpm)], "one period")
        for row in rows:
            expect(abs(turned(row["crank.theta"], math.atan2(30, 20) + omega * row["t"])) < 1e-9,
                   f"the crank at {row['t']}")
    expect(scene["unit"] == "1/96 in" and set(scene["links"]) == {"ground", "crank", "rod", "L2"},
           "names and unit")


def test_linkage_oscillates(importer):
    for rpm, limit, start in ((10, 50, 0), (-10, 50, 20), (15, 90, 60)):
        text = linkage(
            [pin(0, 0, 0, f'anchor="true" input="true" rpm="{rpm}" limitangle="{limit}" '
                 f'startoffset="{start}"'),
             pin(1, 20, 30), pin(2, 110, 50), pin(3, 120, -20, 'anchor="true"'),
             pin(4, 0, -50, 'anchor="true" input="true" rpm="1"'), pin(5, 10, -50)],
            [bar(0, [0, 1], 'name="crank"'), bar(1, [1, 2]), bar(2, [2, 3]), bar(3, [4, 5])])
        importer.scene_of("an oscillating input", text)
        for row in importer.sweep():
            way = to_and_fro(abs(rpm) * 6 * row["t"] + start, limit) - start
            angle = math.atan2(30, 20) - math.copysign(math.radians(way), rpm * way) * (way != 0)
            expect(abs(turned(row["crank.theta"], angle)) < 1e-9, f"oscillates at {row['t']}")


def test_linkage_actuators(importer):
    for cpm, start in ((15, 0), (-12, 0), (15, 8), (-6, 20)):
        text = linkage(
            [pin(0, 0, 0, 'anchor="true"'), pin(1, 60, 40, 'draw="true"'),
             pin(2, 80, -30, 'anchor="true"'), pin(3, 100, 10, 'draw="true"')],
            [bar(0, [0, 1, 3], 'name="boom"'),
             bar(1, [2, 1], f'actuator="true" throw="25" cpm="{cpm}" startoffset="{start}"')])
        importer.scene_of(f"an actuator of {cpm}", text)
        drawn = math.hypot(20, 70)
        for row in importer.sweep():
            way = to_and_fro(25 * abs(cpm) / 30 * row["t"] + start, 25) - to_and_fro(start, 25)
            length = math.hypot(row["C1.x"] - 80, row["C1.y"] + 30)
            expect_near([length], [drawn + math.copysign(way, cpm * way) * (way != 0)],
                        f"the stroke of {cpm} at {row['t']}")


def test_linkage_gears(importer):
    wheels = [pin(0, 0, 0, 'anchor="true" input="true" rpm="10"'), pin(1, 100, 0, 'anchor="true"'),
              pin(2, 200, 10, 'anchor="true"'), pin(3, 10, 10)]
    gear = 'gear="true"'
    text = linkage(wheels, [bar(0, [0, 3], gear), bar(1, [1], gear), bar(2, [2], gear)],
                   [("chain", (2, 5), (1, 4)), ("gears", (0, 2), (1, 3))])
    scene, pose = importer.scene_of("gears in a row", text)
    one = -10 * 2 * math.pi / 60
    speeds = [pose["links"][name]["velocity"][2] for name in ("L0", "L1", "L2")]
    expect_near(speeds, [one, -one * 2 / 3, -one * 2 / 3 * 4 / 5], "the speeds of wheels")
    # A sun that the ground holds, and a planet on an arm: twice as fast as the arm.
    text = linkage(
        [pin(0, 0, 0, 'anchor="true" input="true" rpm="10"'), pin(1, 60, 0), pin(2, 70, 5)],
        [bar(0, [0], gear + ' fastenconnector="0"'), bar(1, [0, 1], 'name="arm"'),
         bar(2, [1, 2], gear + ' name="planet"')], [("gears", (0, 30), (2, 30))])
    scene, pose = importer.scene_of("a planet", text)
    expect_near([pose["links"][name]["velocity"][2] for name in ("arm", "planet")], [one, 2 * one],
                "the speeds of arm and planet")
    # Wheels that no link and not the ground carries.
    text = linkage(
        [pin(0, 0, 0, 'anchor="true" input="true" rpm="10"'), pin(1, 60, 0), pin(2, 0, 80),
         pin(3, 70, 5)], [bar(0, [0], gear), bar(1, [1, 3], gear)], [("gears", (0, 3), (1, 2))])
    status, lines, _ = importer.run(text)
    expect(status == 1 and any("they are no two gears" in line for line in lines),
           f"gears that nothing carries: {status}, {lines}")


def test_linkage_slides(importer):
    slot = [("slidelimit", 3), ("slidelimit", 4)]
    text = linkage(
        [pin(0, 0, 0, 'anchor="true" input="true" rpm="20"'), pin(1, 30, 10),
         pin(2, 130, 20, 'slider="true" draw="true"', slot), pin(3, 60, 20, 'anchor="true"'),
         pin(4, 200, 20, 'anchor="true"')], [bar(0, [0, 1]), bar(1, [1, 2], 'name="rod"')])
    scene, _ = importer.scene_of("a slot in the ground", text)
    expect(scene["joints"]["C2_slot"]["limits"] == [0, 140], "the slot ends where it is drawn to")
    for row in importer.sweep():
        expect_near([row["C2.y"]], [20], "the pin is on the line")
    for radius, centre in ((100, (0, 1)), (-90, (0, -1))):
        text = linkage(
            [pin(0, -150, 0, 'anchor="true" input="true" rpm="20"'), pin(1, -140, 10),
             pin(2, 0, 0, f'slider="true" draw="true" slideradius="{radius}"', slot),
             pin(3, -80, 0, 'anchor="true"'), pin(4, 80, 0, 'anchor="true"')],
            [bar(0, [0, 1]), bar(1, [1, 2])])
        importer.scene_of("a slot along an arc", text, told=["its slot is an arc"])
        height = math.sqrt(radius**2 - 80**2)
        for row in importer.sweep():
            expect_near([math.hypot(row["C2.x"], row["C2.y"] - centre[1] * height)], [height],
                        "the pin is on the arc through where it is drawn")
    # Two pins of a plate in one slot are a slide: it does not turn.
    text = linkage(
        [pin(0, 0, 0, 'anchor="true" input="true" rpm="20"'), pin(1, 20, 10), pin(2, 110, 30),
         pin(5, 100, 20, 'slider="true"', slot), pin(6, 130, 20, 'slider="true"', slot),
         pin(3, 20, 20, 'anchor="true"'), pin(4, 200, 20, 'anchor="true"')],
        [bar(0, [0, 1]), bar(1, [1, 2]), bar(2, [2, 5, 6], 'name="plate"')])
    importer.scene_of("a slide of two pins", text)
    angles = [row["plate.theta"] for row in importer.sweep()]
    expect(max(angles) - min(angles) < 1e-9, "the plate does not turn")


def test_linkage_fastened(importer):
    text = linkage(
        [pin(0, 0, 0, 'anchor="true" input="true" rpm="20"'), pin(1, 30, 10), pin(2, 120, 40),
         pin(3, 125, -50, 'anchor="true"'), pin(4, 60, 60, 'draw="true"'),
         pin(5, 70, 90, 'draw="true" fastenlink="1"'), pin(6, 80, 95, 'draw="true"'),
         pin(7, 5, 40, 'draw="true" fastenconnector="1"')],
        [bar(0, [0, 1]), bar(1, [1, 2], 'name="rod"', fastened=[6]), bar(2, [2, 3]),
         bar(3, [2, 4], 'fastenlink="1"')])
    _, lines, scene = importer.run(text)
    expect(set(scene["links"]) == {"ground", "L0", "rod", "L2"}, f"one body: {scene['links']}")
    expect(set(scene["links"]["rod"]) >= {"C1", "C2", "C4", "C5", "C6"}, "all that is fastened")
    expect(any("several links hold" in line for line in lines), "which of several links is told")
    for row in importer.sweep():
        expect_near([math.hypot(row["C4.x"] - row["C5.x"], row["C4.y"] - row["C5.y"])],
                    [math.hypot(10, 30)], "what is fastened keeps its distance")
    # A link with two anchors, and one that is fastened to an anchor, are the ground.
    text = linkage(
        [pin(0, 0, 0, 'anchor="true" input="true" rpm="20"'), pin(1, 30, 10), pin(2, 120, 40),
         pin(3, 130, -20), pin(4, 100, -60, 'anchor="true"'), pin(5, 160, -60, 'anchor="true"')],
        [bar(0, [0, 1]), bar(1, [1, 2]), bar(2, [2, 3]), bar(3, [3, 4, 5])])
    scene, _ = importer.scene_of("a frame", text)
    expect(set(scene["links"]) == {"ground", "L0", "L1", "L2"} and
           "C3" in scene["links"]["ground"], "the frame is the ground")


def test_linkage_tells(importer):
    text = linkage(
        [pin(0, 0, 0, 'anchor="true" input="true" rpm="20" alwaysmanual="true" color="5"'),
         pin(1, 20, 30, 'name="same" locked="true" newkey="1"'), pin(2, 110, 50, 'name="same"'),
         pin(3, 120, -20, 'anchor="true" name="a.b"'), pin(4, 5, 5, 'layer="1"'),
         pin(5, 6, 6, 'layer="1"'), pin(6, 200, 70)],
        [bar(0, [0, 1], 'name="Jaw"'), bar(1, [1, 2], 'name="Jaw"'), bar(2, [2, 3], 'solid="true"'),
         bar(3, [4, 5], 'layer="1"'), bar(4, [4, 5], 'layer="1" measurementelement="true"'),
         bar(5, [2, 6])],
        program='units="Inches" scalefactor="2" zoom="1"', more="<background>xyz</background>")
    scene, _ = importer.scene_of("what is told", text, told=[
        "the scale 2 of the drawing", "the drawing layer are left out: 2 connectors, 1 link",
        "measurement are left out: 1 link", "attribute 'connector.newkey' is not known",
        "picture in the background", "moved by hand only; set the parameter C0_hand",
        "the link 'L5' is left out", "the name 'a.b' of the point 'C3' cannot be used",
        "the point 'C1', called 'same'", "the link 'L1', called 'Jaw'", "1/96 inch",
        "how the drawing looks is left out: colours, fillings, locks, the view"])
    expect(set(scene["links"]) == {"ground", "Jaw_L0", "Jaw_L1", "L2"}, "equal names get numbers")
    expect(set(scene["points"]) == {"C0", "same_C1", "same_C2", "C3"}, "so do those of points")
    expect(scene["parameters"]["C0_hand"] == 0 and scene["sweep"]["parameter"] == "C0_hand",
           "moved by hand")
    still = [pin(0, 0, 0, 'anchor="true" input="true"'), pin(1, 20, 30)]
    for name, text, words in [
        ("no input", linkage([pin(0, 0, 0, 'anchor="true"'), pin(1, 1, 1), pin(2, 2, 0,
                             'anchor="true"')], [bar(0, [0, 1]), bar(1, [1, 2])]),
         "nothing drives the mechanism"),
        ("a slot without ends", linkage(still + [pin(2, 5, 5, 'slider="true"')],
                                        [bar(0, [0, 1, 2])]), "no two ends"),
        ("ends of no link", linkage(
            still + [pin(2, 5, 5, 'slider="true"', [("slidelimit", 1), ("slidelimit", 3)]),
                     pin(3, 9, 9, 'anchor="true"')], [bar(0, [0, 1]), bar(1, [2, 1])]),
         "no link has both ends"),
        ("a fastening to nothing", linkage(still, [bar(0, [0, 1], 'fastenlink="9"')]),
         "fastened to the link 9"),
        ("an unknown element", linkage(still, [bar(0, [0, 1])], more="<cam/>"), "'cam'"),
        ("a missing connector", linkage(still, [bar(0, [0, 1, 8])]), "no connector 8"),
    ]:
        status, lines, scene = importer.run(text)
        expect(status == 1 and scene is not None and sum(words in line for line in lines) == 1,
               f"{name}: {status}, {lines}")


CRANK = [joint(6, "A", 0, 0), joint(0, "B", 3, 4), joint(0, "C", 12, 6), joint(4, "D", 14, 0)]
BARS = [link("AB", "AB", "Jaw"), link("BC", "BC", "Jaw"), link("CD", "CD")]


def test_pmks(importer):
    for flags, rpm, omega in ((1, 20, -1), (0, 20, 1), (1, 7, -1)):
        scene, pose = importer.scene_of("a link of PMKS+", payload(
            CRANK, BARS, flags=flags, rpm=rpm), told=["the link 'BC', called 'Jaw'"])
        expect_near([pose["links"]["Jaw_AB"]["velocity"][2]], [omega * rpm * 2 * math.pi / 60],
                    "the sense of the file's speed")
    own = [joint(6, "A", 0, 0, speed=-12.5)] + CRANK[1:]
    for text in (payload(own, BARS), payload(own, BARS, digest=True),
                 "https://app.pmksplus.com/?" + payload(own, BARS) + "\n"):
        scene, pose = importer.scene_of("a joint's own speed", text)
        expect_near([pose["links"]["Jaw_AB"]["velocity"][2]], [-12.5 * 2 * math.pi / 60], "speed")
    status, _, scene = importer.run("https://app.pmksplus.com/?" + payload(own, BARS),
                                    as_argument=True)
    expect(status == 0 and scene["links"]["ground"] == ["A", "D"], "the link as an argument")
    exact = payload(CRANK, BARS, tail="PJB~0~3.00012345,LAB,KJB~d,CGAB")
    scene, _ = importer.scene_of("exact numbers", exact, told=["how the drawing looks"])
    expect(scene["points"]["B"] == [3.00012345, 4], f"exact: {scene['points']['B']}")
    traced = [joint(6, "A", 0, 0), joint(16, "B", 3, 4)]
    frame = [joint(0, "E", 20, 0), joint(4, "F", 20, 5), joint(4, "G", 25, 0)]
    scene, _ = importer.scene_of("a frame", payload(
        CRANK[:3] + [joint(0, "D", 14, 0)] + frame,
        BARS[:2] + [link("CE", "CE"), link("EFG", "EFG")]))
    expect(set(scene["links"]["ground"]) == {"A", "E", "F", "G"}, "two ground pins")
    for tail, words in (("G1~abc", "gears"), ("Xabc", "'Xabc'")):
        status, lines, scene = importer.run(payload(CRANK, BARS, tail=tail))
        expect(status == 1 and any(words in line for line in lines), f"{tail}: {lines}")
    expect(traced[1].startswith("G"), "a traced pin has its flag")


def test_pmks_slides(importer):
    start = [joint(6, "A", 0, 0), joint(0, "B", 3, 4)]
    bars = [link("AB", "AB"), link("BC", "BC", "rod")]
    older = payload(start + [joint(16, "C", 12, 1), joint(5, "S", 12, 1, 0.3)],
                    bars + [link("CS", "CS", head="YP")])
    newer = payload(start + [joint(1 + 4 + 16, "C", 12, 1, 0.3)], bars)
    rows = []
    for text in (older, newer):
        importer.scene_of("a slider", text)
        rows.append([(row["C.x"], row["C.y"]) for row in importer.sweep()])
    for one, other in zip(*rows):
        expect_near(one, other, "a slider in either form")
        expect_near([math.cos(0.3) * (one[1] - 1)], [math.sin(0.3) * (one[0] - 12)], "its line")
    # A slide in a link: a crank's pin in a slotted lever.
    scene, _ = importer.scene_of("a slot in a link", payload(
        [joint(6, "A", 0, 0), joint(1, "B", 3, 4, slot=("CD", "C", "D")), joint(4, "C", 0, -9),
         joint(16, "D", 3.6, 6.6)], [link("AB", "AB"), link("CD", "CD")]))
    for row in importer.sweep():
        crank = (5 * math.cos(row["AB.theta"]), 5 * math.sin(row["AB.theta"]))
        across = crank[0] * math.sin(row["CD.theta"]) - (crank[1] + 9) * math.cos(row["CD.theta"])
        expect(abs(across - row_offset()) < 1e-9, f"the pin is in the slot: {across}")
    # What is welded does not turn in its slot.
    importer.scene_of("a welded slide", payload(
        start + [joint(0, "C", 12, 1), joint(1 + 4 + 8, "E", 12, 3)],
        bars + [link("CE", "CE", "piston")]))
    angles = [row["piston.theta"] for row in importer.sweep()]
    expect(max(angles) - min(angles) < 1e-9, "a welded slide does not turn")
    # A driven slide has its speed in lengths per second, clockwise counting as backward.
    driven = [joint(4, "A", 0, 0), joint(0, "B", 3, 4), joint(1 + 2 + 4, "C", 9, 1)]
    for flags, slide, own, speed in ((0, 2.5, None, 2.5), (1, 2.5, None, -2.5), (1, 2.5, 4, 4)):
        joints = driven[:2] + [joint(7, "C", 9, 1, speed=own)] if own else driven
        _, pose = importer.scene_of("a driven slide",
                                    payload(joints, bars, flags=flags, slide=slide))
        expect_near([pose["joints"]["C_slot"]["velocity"]], [speed], "the slide's speed")
    status, lines, _ = importer.run(payload(driven, bars))
    expect(status == 1 and any("no speed for a driven slide" in line for line in lines), "no speed")
    status, lines, _ = importer.run(payload(
        start + [joint(1, "C", 12, 1, slot=("BC", "B", "C"))], bars))
    expect(status == 1 and any("slides in its own link" in line for line in lines), "its own link")


def row_offset():
    """How far the crank's pin is drawn beside the line from C to D, which is its slot: not at all,
    but for the rounding of thousandths."""
    length = math.hypot(3.6, 15.6)
    return 3 * 15.6 / length - 13 * 3.6 / length


def test_pmks_forces(importer):
    """The effort of a turning bar holds its weight and a force; one unit of length after another."""
    joints = [joint(6, "A", 0, 0), joint(0, "B", 3, 4)]
    for unit, weight, length in (("2", 9.81, "m"), ("1", 9.81e-3, "cm"), ("0", 9.81 / 9.80665, "in")):
        for flags, local in ((128, False), (128, True), (128 + 256, False)):
            text = payload(joints, [link("AB", "AB", mass=7, inertia=0.5, center=(1.5, 2))],
                           [force(2 + local, "F1", "AB", (3, 4), (3, 5), 6)], flags=flags, unit=unit)
            scene, pose = importer.scene_of("a weight", text)
            fall = 0 if flags & 256 else 7 * weight
            expect(scene["unit"] == length, "the unit")
            expect_near([pose["drivers"]["A"]["effort"]], [1.5 * fall - 3 * 6], f"effort in {unit}")
            rows = importer.sweep()
            for row in rows[::40]:
                turn = row["AB.theta"] - math.atan2(4, 3)
                x = 2.5 * math.cos(row["AB.theta"])
                arm = 5 * math.cos(row["AB.theta"]) if not local else 3
                expect_near([row["A.effort"]], [x * fall - arm * 6], f"effort at turn {turn}")
    # The block of a slider counts at its pin: its own speed needs a force. Energy tells the effort.
    text = payload(
        [joint(6, "A", 0, 0), joint(0, "B", 3, 4), joint(16, "C", 12, 0), joint(5, "S", 12, 0)],
        [link("AB", "AB"), link("BC", "BC", mass=2, inertia=3, center=(6, 3)),
         link("CS", "CS", mass=5, head="YP")], flags=128 + 256, unit="2")
    importer.scene_of("a block", text)
    rows = importer.sweep()
    omega = 10 * 2 * math.pi / 60

    def energy(row):
        """Of the rod about its centre, of inertia 3, and of the block."""
        # The centre in the rod's frame, from the drawing.
        angle = math.atan2(-4, 9)
        local = (3 * math.cos(angle) - 1 * math.sin(angle), -3 * math.sin(angle) - 1 * math.cos(angle))
        theta = row["BC.theta"]
        arm = (math.cos(theta) * local[0] - math.sin(theta) * local[1],
               math.sin(theta) * local[0] + math.cos(theta) * local[1])
        speed = (row["BC.vx"] - row["BC.omega"] * arm[1], row["BC.vy"] + row["BC.omega"] * arm[0])
        return (speed[0] ** 2 + speed[1] ** 2) + 1.5 * row["BC.omega"] ** 2 + 2.5 * row["C.vx"] ** 2

    step = rows[1]["t"] - rows[0]["t"]
    for one, two, row, four, five in zip(rows, rows[1:], rows[2:], rows[3:], rows[4:]):
        rate = (energy(one) - 8 * energy(two) + 8 * energy(four) - energy(five)) / (12 * step)
        expect_near([row["A.effort"] * omega], [rate], "the power is the rate of energy", 1e-4)


def test_pyslvs(importer):
    text = """# the crank
M[J[R, color[blue], P[0, 0], L[ground, a]], J[R, P[3, 4.], L[a, b]],
  J[RP, A[20], color[(1, 2, 3)], P[12, 1], L[ground, b]], J[R, P[5, 9], L[b]],]
#[ more #] end"""
    scene, pose = importer.scene_of("an expression", text, told=["P0, the first pin", "colours"])
    expect(scene["outputs"] == ["P2", "P3"], f"what is traced: {scene['outputs']}")
    slope = math.tan(math.radians(20))
    for row in importer.sweep():
        expect_near([row["P2.y"] - 1], [slope * (row["P2.x"] - 12)], "the slot is straight")
        expect(abs(turned(row["a.theta"], math.atan2(4, 3) + row["t"])) < 1e-9, "one radian a second")
    scene, pose = importer.scene_of("a driven slider", text, "--driver", "P2")
    expect_near([pose["joints"]["P2_slot"]["velocity"]], [1], "one length a second")
    text = ("M[J[R, P[0, 0], L[ground, a]], J[R, P[3, 4], L[a, b]], J[R, P[12, 1], L[b, c]], "
            "J[P, A[-10], P[13, 2], L[ground, c]]]")
    importer.scene_of("a slide", text)
    angles = [row["c.theta"] for row in importer.sweep()]
    expect(max(angles) - min(angles) < 1e-9, "the slide does not turn")
    text = ("M[J[R, P[0, 0], L[ground, a, c]], J[R, P[3, 4], L[a, b]], J[R, P[9, 5], L[b, d]], "
            "J[R, P[5, -3], L[c, d]]]")
    scene, pose = importer.scene_of("two cranks", text, "--driver", "P0")
    expect(len(scene["drivers"]) == 2, "all links at the pin are driven")
    text = "M[J[R, P[0, 0], L[ground, a]], J[RP, A[0], P[3, 4], L[g, a]], J[RP, A[90], P[4, 4], L[g, ground]]]"
    status, _, scene = importer.run(text)
    expect(scene["links"]["g"] == ["g_slot"], "a link of slots alone has a point")
    status, lines, scene = importer.run("M[]")
    expect(status == 1 and scene["links"] == {"ground": []}, "no joints")


def test_broken(importer, examples):
    four_bar = linkage([pin(0, 0, 0, 'anchor="true"'), pin(1, 1, 1)], [bar(0, [0, 1])])
    whole = payload(CRANK, BARS)
    damaged = whole.replace("Jaw", "Jax")
    bomb = ('<?xml version="1.0"?><!DOCTYPE linkage2 [<!ENTITY a "aaaa"><!ENTITY b "&a;&a;">]>'
            + four_bar)
    long = "x" * 1000000
    for name, text, words in [
        ("nothing", "", "found nothing"), ("white space", " \n", "found nothing"),
        ("another text", "hello", "found 'hello'"), ("a scene", '{"links": {}}', "expected a file"),
        ("bytes", b"\xff\xfe\x00\x01", "NUL"), ("a NUL", four_bar.encode() + b"\0", "NUL"),
        ("truncated XML", four_bar[:-15], "no XML"), ("no XML", "<linkage2 <<", "no XML"),
        ("another root", "<other><linkage2/></other>", "expected the element <linkage2>"),
        ("entities", bomb, "document type"),
        ("deep", "<linkage2>" + "<a>" * 100000, "nested more than 32 deep"),
        ("deep in comments", "<linkage2>" + "<a><!-- </a> -->" * 100000, "nested more than"),
        ("a number", four_bar.replace('x="1"', 'x="one"'), "connector 1.x: expected a number"),
        ("not finite", four_bar.replace('x="1"', 'x="1e999"'), "expected a number"),
        ("no number", four_bar.replace('x="1"', 'z="1"'), "connector 1.x: the number is missing"),
        ("an identifier", four_bar.replace('id="1"', 'id="one"', 1), "expected a whole number"),
        ("no identifier", four_bar.replace('id="1"', "", 1), "no 'id'"),
        ("two connectors", four_bar.replace('id="1"', 'id="0"', 1), "has two of them"),
        ("too many links", linkage([pin(0, 0, 0)], [bar(k, [0]) for k in range(1001)]),
         "more than 1000 links"),
        ("a damaged link", whole[:-9] + whole[-8:], "damaged"),
        ("a digest", payload(CRANK, BARS, digest=True).replace("Jaw", "Jax"), "damaged"),
        ("half a link", whole[: len(whole) // 2], "damaged"),
        ("a digit", payload([joint(6, "A", 0, 0) + "!"], []), "base 64"),
        ("a field", payload(["6A,A,1"], []), "3 fields of 5"),
        ("two joints", payload([CRANK[0], CRANK[0]], []), "has two of them"),
        ("two links", payload(CRANK, [BARS[0], BARS[0]]), "has two of them"),
        ("no joint", payload(CRANK, [link("AX", "AX")]), "no joint 'X'"),
        ("no carrier", payload([joint(1, "A", 0, 0, slot=("Q", "A", "B"))], []), "no link 'Q'"),
        ("a kind of link", payload(CRANK, ["ZRAB,AB,0,0,0,0,c,A,B,,"]), "letters Y, A, M, G"),
        ("an exact number", payload(CRANK, BARS, tail="PJQ~0~1"), "belongs to nothing"),
        ("an exact nan", payload(CRANK, BARS, tail="PJA~0~nan"), "belongs to nothing"),
        ("a force", payload(CRANK, BARS, [force(2, "F", "Q", (0, 0), (1, 0), 1)]), "no link 'Q'"),
        ("an open bracket", "M[J[R, P[0, 0], L[a]]", "line 1, column 22: expected ']'"),
        ("a type", "M[\nJ[X, P[0, 0], L[a]]]", "line 2, column 3: expected the type"),
        ("a coordinate", "M[J[R, P[x, 0], L[a]]]", "expected a number, found 'x, 0"),
        ("no angle", "M[J[RP, P[0, 0], L[a, b]]]", "needs the angle"),
        ("a link", "M[J[R, P[0, 0], L[1]]]", "expected the name of a link"),
        ("behind the end", "M[] M[]", "expected the end"),
        ("too many joints", "M[" + "J[R,P[0,0],L[a]]," * 1001 + "]", "more than 1000 joints"),
    ]:
        status, lines, scene = importer.run(text)
        expect(status == 2 and len(lines) == 1 and lines[0].startswith("error: ") and
               words in lines[0] and scene is None and len(lines[0]) < 500,
               f"{name}: {status}, {[line[:300] for line in lines]}")
    expect(damaged != whole, "the names are in the payload")
    for name, text in [("connector", four_bar.replace('id="1"', f'id="1" name="{long}"', 1)),
                       ("PMKS+", payload([joint(6, "A", 0, 0, title=long)], []))]:
        status, lines, scene = importer.run(text)
        expect(status in (0, 1) and max(map(len, lines)) < 500 and
               max(map(len, scene["points"] or [""])) < 80, f"a long name of {name}")
    for options, words in ((["--driver", "P9"], "no point 'P9'"), (["--driver", "P1"], "no joint")):
        status, lines, _ = importer.run("M[J[R, P[0,0], L[ground, a]], J[R, P[1,0], L[a]]]", *options)
        expect(status == 2 and len(lines) == 1 and words in lines[0], f"{options}: {lines}")
    status, lines, _ = importer.run(four_bar, "--driver", "P0")
    expect(status == 2 and "only expressions of Pyslvs" in lines[0], f"a driver: {lines}")
    importer.scene.write_text("{}")
    run = subprocess.run([importer.command, "import", str(importer.directory / "source.txt"),
                          "--output", str(importer.scene)], capture_output=True, text=True)
    expect(run.returncode == 2 and importer.scene.read_text() == "{}", "a file is not replaced")
    # Every part of every example is refused in one line, or imported.
    for file in sorted(pathlib.Path(examples).iterdir()):
        text = file.read_bytes()
        for end in range(0, len(text), max(1, len(text) // 40)):
            status, lines, scene = importer.run(text[:end])
            expect(status in (0, 1) or (status == 2 and len(lines) == 1 and scene is None),
                   f"{file.name}, {end} bytes: {status}, {lines}")


def main(command, examples):
    with tempfile.TemporaryDirectory() as directory:
        importer = Importer(command, directory)
        for name, test in list(globals().items()):
            if name.startswith("test_"):
                test(importer, examples) if name == "test_broken" else test(importer)
        for file in sorted(pathlib.Path(examples).iterdir()):
            importer.scene_of(file.name, file.read_text())
    print(f"{checks} checks, {failures} failures")
    return 1 if failures or checks < 1000 else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
