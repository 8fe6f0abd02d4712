"""Law: a page follows the assembly that it shows, whatever values change; it plays to the ends of a
branch and turns round, or goes over the fold; an output can be dragged along its path; the picture
can be moved and enlarged; and link angles and transmission angles are those of the solution."""

import csv
import io
import json
import math

from opened_page import (expect, expect_near, keep_picture, main, obstacle, opened, run,
                         set_parameter)

FOOT = "[...page.branch.outputs.at(page.place) ?? []].slice(0, 2)"

# Plays a branch for some frames of a display with 60 of them in a second; returns the branches that
# were shown, how many frames show none, and the farthest that a point moved in a frame, as a part of
# the mechanism's size.
PLAYED = """((number, frames, goesOn) => {
  const { film } = page;
  let state = { number, place: film.branch(number).placeNear(0), forwards: true };
  const shown = new Set();
  let [absent, farthest, before] = [0, 0, null];
  for (let frame = 0; frame < frames; ++frame) {
    state = advanced(film, state, (film.count - 1) / sweepSeconds / 60, goesOn);
    const points = film.branch(state.number).points.at(state.place);
    shown.add(state.number);
    absent += points === null;
    points?.forEach((one, place) => {
      farthest = before === null ? 0 : Math.max(farthest, Math.abs(one - before[place]) / film.size);
    });
    before = points;
  }
  return [[...shown].sort((one, other) => one - other), absent, farthest];
})"""


def check_following(chromium, assur, scene, folder):
    """Jansen's leg near phi = 0.5236, on branch 2 of the scene."""
    opened(chromium, assur, scene, folder)
    place = "page.choose(2); page.seek(page.film.placeOf(0.5235987755982988))"
    chromium.value(place)
    expect_near(chromium.value(FOOT), [-30.806, -91.823], 1e-3, "the foot as the scene has it")
    set_parameter(chromium, "a", 37.6)
    table, _ = run(assur, "solve", str(scene), "--format", "csv", "--set", "a=37.6")
    feet = [[float(row["foot.x"]), float(row["foot.y"])] for row in csv.DictReader(io.StringIO(table))
            if row["step"] == "30" and not row["event"]]
    nearest = min(feet, key=lambda foot: math.dist(foot, [-30.806, -91.823]))
    expect_near(chromium.value(FOOT), nearest, 1e-9, "the foot after a small step")
    set_parameter(chromium, "a", 34)
    expect_near(chromium.value(FOOT), [-23.645, -93.543], 1e-3, "the foot after nine steps")
    set_parameter(chromium, "a", 38)
    for step in range(1, 10):
        set_parameter(chromium, "a", 38 - 4 * step / 9)
    expect_near(chromium.value(FOOT), [-23.645, -93.543], 1e-3, "the foot after nine steps")
    set_parameter(chromium, "a", 38)
    expect_near(chromium.value(FOOT), [-30.806, -91.823], 1e-3, "the foot when all is as before")
    expect(chromium.value("page.chosen") == 2, "the branch when all is as before")
    chromium.value("document.getElementById('follow').checked = false")
    set_parameter(chromium, "a", 37.6)
    expect_near(chromium.value(FOOT), [-83.2, 60.7], 0.1, "the foot of the branch with the same number")


def check_end_of_assembly(chromium, assur, scene, folder):
    """Where no branch is left at the present place, the page says so."""
    opened(chromium, assur, scene, folder)
    chromium.value("page.seek(page.film.placeOf(Math.PI))")
    number = chromium.value("page.chosen")
    set_parameter(chromium, "coupler", 15)
    absent = chromium.value("page.film.branches.every((one) => one.points.at(page.place) === null)")
    expect(absent, "there is no assembly at this place")
    expect("ends here" in obstacle(chromium), f"the page says {obstacle(chromium)!r}")
    expect(chromium.value("page.chosen") == number, "the number of the branch is kept")
    set_parameter(chromium, "coupler", 100)
    expect(obstacle(chromium) == "", "the message goes away")


def check_ends(chromium, assur, scene, folder):
    """Branch 3 of Jansen's leg exists on less than half of the sweep."""
    opened(chromium, assur, scene, folder)
    shown, absent, farthest = chromium.value(f"{PLAYED}(3, 1440, false)")
    expect(shown == [3] and absent == 0, f"turning round shows {shown}, {absent} frames with nothing")
    expect(farthest < 0.1, f"turning round moves by {farthest}")
    partners = set(chromium.value("""page.film.events.filter(({event, branches}) =>
        event === "fold" && branches.includes(3)).flatMap(({branches}) => branches)"""))
    shown, absent, farthest = chromium.value(f"{PLAYED}(3, 1440, true)")
    expect(absent == 0 and len(partners) > 1 and partners <= set(shown),
           f"going on shows {shown} with the partners {partners}, {absent} frames with nothing")
    expect(farthest < 0.25, f"going on moves by {farthest} of the size")
    stretches = chromium.value("""[page.choose(3), [...document.querySelectorAll("#stretches span")]
        .map((one) => parseFloat(one.style.width))][1]""")
    expect(len(stretches) > 0 and sum(stretches) < 60, f"the time line shows {stretches} percent")


def place_of_output(chromium, output):
    """Where an output is in the window."""
    return chromium.value(f"""(() => {{
      const box = page.stage.canvas.getBoundingClientRect();
      const [x, y] = page.branch.outputs.at(page.place).slice({6 * output}, {6 * output} + 2);
      const [u, v] = page.stage.view.at(x, y);
      return [box.left + u, box.top + v];
    }})()""")


def check_dragged_output(chromium, assur, scene, folder):
    """A foot that is pulled along its path stays on it and moves on evenly, over the sweep's ends."""
    opened(chromium, assur, scene, folder)
    chromium.value("page.choose(2); page.seek(page.film.placeOf(30 * Math.PI / 180))")
    told = chromium.value("""(() => {
      const outputs = page.branch.outputs;
      let place = page.place;
      const places = [];
      for (let step = 0; step < 25; ++step) {
        const ahead = (place - 5 + 2 * (page.film.count - 1)) % (page.film.count - 1);
        const pulled = outputs.at(ahead).slice(0, 2).map((one) => one + 0.3);
        place = placeOnPath(page.film, page.branch, 0, pulled, place);
        places.push(place);
      }
      return places;
    })()""")
    steps = [(before - after) % 360 for before, after in zip([30, *told], told)]
    expect(all(0 < step < 12 for step in steps), f"the place moves by {steps}")
    expect(any(place > 300 for place in told), f"the drag goes over the end of the sweep: {told}")

    start = place_of_output(chromium, 0)
    chromium.value("page.seek(page.place - 20)")
    goal = place_of_output(chromium, 0)
    chromium.value("page.seek(page.place + 20)")
    way = [[start[axis] + part / 8 * (goal[axis] - start[axis]) for axis in (0, 1)]
           for part in range(9)]
    before = chromium.value("page.place")
    chromium.mouse(*way)
    expect(abs(chromium.value("page.place") - before + 20) < 1, "the foot follows the mouse")
    expect(chromium.value("page.stage.view.own") is None, "the picture stands still")


def check_view(chromium, assur, scene, folder):
    opened(chromium, assur, scene, folder)
    box = chromium.value("(({left, top}) => [left, top])(page.stage.canvas.getBoundingClientRect())")
    spot = [box[0] + 60, box[1] + 80]
    under = "page.stage.view.under([60, 80])"
    zoom = "page.stage.view.now.zoom"
    fitted, before = chromium.value(zoom), chromium.value(under)
    chromium.wheel(spot, -300)
    expect(chromium.value(zoom) > 1.4 * fitted, "the wheel enlarges")
    expect_near(chromium.value(under), before, 1e-9, "the place under the pointer stays there")
    chromium.mouse(spot, [spot[0] + 25, spot[1] + 10], [spot[0] + 40, spot[1] + 30])
    expect_near(chromium.value("page.stage.view.under([100, 110])"), before, 1e-9, "the picture moves")
    chromium.value("""page.stage.canvas.dispatchEvent(new MouseEvent("dblclick"))""")
    expect(chromium.value(zoom) == fitted, "a double click shows all")
    for name, larger in (("larger", True), ("smaller", False), ("fit", False)):
        last = chromium.value(zoom)
        chromium.value(f"document.getElementById('{name}').click()")
        expect((chromium.value(zoom) > last) == larger, f"{name}: {last}, {chromium.value(zoom)}")
    expect(chromium.value(zoom) == fitted, "Fit shows all")
    middle = [box[0] + 300, box[1] + 60]
    def fingers(far):
        return [[middle[0] - far, middle[1]], [middle[0] + far, middle[1]]]
    before = chromium.value("page.stage.view.under([300, 60])")
    chromium.touch(fingers(30), fingers(45), fingers(60))
    expect_near([chromium.value(zoom) / fitted], [2], 1e-6, "fingers that part double the picture")
    expect_near(chromium.value("page.stage.view.under([300, 60])"), before, 1e-6, "its middle stays")


def check_angles(chromium, assur, scene, folder):
    """Angles of links, their rates and transmission angles, in the table and in Save CSV."""
    opened(chromium, assur, scene, folder)
    csv_text = chromium.value("csvOfBranch(page.film, page.branch)")
    own = {int(row["step"]): row for row in csv.DictReader(io.StringIO(csv_text))}
    table, _ = run(assur, "solve", str(scene), "--format", "csv")
    number = str(chromium.value("page.chosen"))
    solved = {int(row["step"]): row for row in csv.DictReader(io.StringIO(table))
              if row["branch"] == number and not row["event"]}
    expect(own.keys() == solved.keys() and len(own) > 300, f"{len(own)} steps of {len(solved)}")
    compared, largest_turn, before = 0, 0, None
    for step, row in own.items():
        for column, value in row.items():
            if column not in solved[step] or not solved[step][column]:
                continue
            told, expected = float(value), float(solved[step][column])
            if column.endswith(".theta"):
                told = math.remainder(told - expected, math.tau) + expected
            expect(abs(told - expected) <= 1e-9 * max(1, abs(expected)), f"{column}, step {step}")
            compared += 1
        # The pins of the rocker's dyad are B, C and D: the cosine law in the triangle B C D.
        lengths = {"BC": 90, "CD": 75}
        base = math.hypot(100 - 35 * math.cos(float(row["phi"])), 35 * math.sin(float(row["phi"])))
        cosine = (lengths["BC"]**2 + lengths["CD"]**2 - base**2) / (2 * lengths["BC"] * lengths["CD"])
        expect(abs(float(row["C.transmission"]) - math.acos(cosine)) < 1e-9, f"at C, step {step}")
        angles = [float(row[f"{link}.theta"]) for link in ("crank", "rocker", "upper")]
        largest_turn = max([largest_turn, *(abs(one - other) for one, other in
                                            zip(angles, before or angles))])
        before = angles
    expect(compared > 5000, f"{compared} numbers are compared")
    expect(largest_turn < 0.2, f"angles jump by {largest_turn}")
    chromium.value("page.seek(100)")
    rows = chromium.value("""[...document.querySelectorAll("#readout tr")].map((row) =>
        [...row.cells].map((cell) => cell.textContent))""")
    expect(chromium.value("document.getElementById('parameter').textContent") ==
           "phi = 1.7453 (100.0°)", "the swept angle is told in degrees, too")
    crank = next(row for row in rows if row[0] == "crank")
    expect_near([float(one) for one in crank[1:]], [100, 5 * 180 / math.pi, 0], 6e-3, "the crank in °")
    labels = chromium.value("page.film.quantities.map(({label}) => label)")
    for label in ("rocker: angle [deg]", "rocker: turning [deg/s]", "C: transmission angle [deg]"):
        expect(label in labels, f"{label} can be plotted")
    chromium.value("""(() => { const select = document.getElementById("quantity");
        select.value = "rocker: angle [deg]"; select.dispatchEvent(new Event("change")); })()""")
    curve = chromium.value("""page.plot.curves(page.film.quantities.find(({label}) =>
        label === "rocker: angle [deg]")).get(page.chosen)""")
    away = max(abs(one - math.degrees(float(row["rocker.theta"]))) for one, row in
               zip(curve, own.values()))
    expect(away < 1e-9, "the plot has the angles in degrees")
    keep_picture(chromium, "angles")


def check_opening(chromium, assur, scene, folder):
    opened(chromium, assur, scene, folder, "--configuration", "3")
    expect(chromium.value("page.chosen") == 3, "--configuration is the branch that is shown")
    scene_text = json.loads(scene.read_text())
    scene_text["reference"] = {"rocker": -1.6, "outer": -0.2}
    referred = folder / "referred.json"
    referred.write_text(json.dumps(scene_text))
    opened(chromium, assur, referred, folder)
    table, _ = run(assur, "solve", str(referred), "--format", "csv", "--nearest")
    nearest = next(csv.DictReader(io.StringIO(table)))
    chromium.value("page.seek(0)")
    told = chromium.value("[...page.branch.outputs.at(0)].slice(0, 2)")
    expect_near(told, [float(nearest["F.x"]), float(nearest["F.y"])], 1e-9,
                "the branch nearest to the reference is shown")


def circuits_of(assur, scene):
    """The circuit of each branch, as the rows of the sweep tell."""
    table, _ = run(assur, "solve", str(scene), "--format", "csv")
    return {int(row["branch"]): int(row["circuit"])
            for row in csv.DictReader(io.StringIO(table)) if row["branch"]}


def check_circuits(chromium, assur, scene, folder):
    """The page names the circuit of each branch, and going on shows all of it and nothing else."""
    rocker = folder / "rocker.json"
    rocker.write_text(json.dumps({
        "points": {"A": [0, 0], "B": [3, 0], "C": [4.6, 1.6], "D": [4, 0]},
        "links": {"ground": ["A", "D"], "crank": ["A", "B"], "coupler": ["B", "C"],
                  "rocker": ["D", "C"]},
        "parameters": {"phi": {"drawn": "A"}, "AB": {"drawn": ["A", "B"], "value": 3},
                       "BC": {"drawn": ["B", "C"], "value": 2},
                       "CD": {"drawn": ["C", "D"], "value": 2.5}},
        "drivers": {"A": {"position": "phi"}}, "outputs": ["C"],
        "sweep": {"parameter": "phi", "from": 0, "to": "2*pi", "count": 181}}))
    for file in (scene, rocker):
        opened(chromium, assur, file, folder)
        circuits = circuits_of(assur, file)
        for number, circuit in circuits.items():
            own = {one for one, other in circuits.items() if other == circuit}
            others = ", ".join(str(one) for one in sorted(own - {number}))
            told = chromium.value(f"(page.choose({number}), document.getElementById('circuit').textContent)")
            expect(told == f"circuit {circuit}: branch {number} " +
                   (f"with {others}" if others else "alone"), f"{file.stem}: the page says {told!r}")
            shown, absent, _ = chromium.value(f"{PLAYED}({number}, 2880, true)")
            expect(set(shown) == own and absent == 0,
                   f"{file.stem}: going on from {number} shows {shown} of the circuit {own}")
        rows = chromium.value("csvOfBranch(page.film, page.branch)")
        expect({row["circuit"] for row in csv.DictReader(io.StringIO(rows))} == {str(circuit)},
               f"{file.stem}: the saved rows have the circuit")
    expect(set(circuits.values()) == {1} and len(circuits) == 4, f"a triple rocker has {circuits}")


def star(legs):
    """A crank that many dyads hold: 2^legs configurations."""
    turns = [math.tau * leg / legs for leg in range(legs)]
    points = {"O": [0, 0]}
    links = {"ground": ["O"], "crank": ["O"]}
    for leg, turn in enumerate(turns):
        c, s = math.cos(turn), math.sin(turn)
        points[f"P{leg}"], points[f"G{leg}"] = [c, s], [5 * c, 5 * s]
        points[f"Q{leg}"] = [3 * c - (2 + leg / 10) * s, 3 * s + (2 + leg / 10) * c]
        links["crank"].append(f"P{leg}")
        links["ground"].append(f"G{leg}")
        links[f"inner{leg}"] = [f"P{leg}", f"Q{leg}"]
        links[f"outer{leg}"] = [f"G{leg}", f"Q{leg}"]
    return {"points": points, "links": links, "parameters": {"phi": {"drawn": "O"}, "first":
            {"drawn": ["P0", "Q0"]}}, "drivers": {"O": {"position": "phi"}},
            "outputs": [f"Q{leg}" for leg in range(legs)],
            "sweep": {"parameter": "phi", "from": "phi - 0.1", "to": "phi + 0.1", "count": 5}}


def check_many_branches(chromium, assur, folder):
    """Of 32 branches a page has 24, and always the one that it follows."""
    scene = folder / "star.json"
    scene.write_text(json.dumps(star(5)))
    for number in (2, 17, 31):
        opened(chromium, assur, scene, folder, "--configuration", str(number))
        expect(chromium.value("[page.chosen, page.film.branches.length]") == [number, 24],
               f"branch {number} of 32 is shown first")
        places = "[...page.branch.outputs.at(page.place)].filter((_, place) => place % 6 < 2)"
        before = chromium.value(places)
        for first in (2.85, 2.8, 2.75):
            set_parameter(chromium, "first", first)
        away = max(abs(one - other) for one, other in zip(chromium.value(places), before))
        expect(0 < away < 0.3, f"branch {number} is followed: its outputs move by {away}")


def check_forces(chromium, assur, folder):
    """Efforts and forces along the branch, beside the numbers of `assur solve`."""
    scene = folder / "forces.json"
    scene.write_text(json.dumps({
        "points": {"A": [0, 0], "B": [0.1, 0.2], "C": [0.5, 0.45], "D": [0.6, 0]},
        "links": {"ground": ["A", "D"], "crank": ["A", "B"], "coupler": ["B", "C"],
                  "rocker": ["D", "C"]},
        "parameters": {"phi": {"drawn": "A"}},
        "drivers": {"A": {"position": "phi", "velocity": 10}}, "outputs": ["C"],
        "masses": {"coupler": {"mass": 2.5, "at": [0.2, 0], "inertia": 0.01}},
        "gravity": [0, -9.81], "want": ["position", "velocity", "acceleration", "forces"],
        "sweep": {"parameter": "phi", "from": 0, "to": "2*pi", "count": 181}}))
    opened(chromium, assur, scene, folder)
    own = list(csv.DictReader(io.StringIO(chromium.value("csvOfBranch(page.film, page.branch)"))))
    table, _ = run(assur, "solve", str(scene), "--format", "csv", "--nearest")
    solved = {row["step"]: row for row in csv.DictReader(io.StringIO(table)) if not row["event"]}
    columns = ["A.effort", *(f"{pin}.{axis}" for pin in "ABCD" for axis in ("fx", "fy"))]
    largest = max(abs(float(row[column])) for row in solved.values() for column in columns)
    away = max(abs(float(row[column]) - float(solved[row["step"]][column]))
               for row in own for column in columns)
    expect(len(own) == 181 and away < 1e-9 * largest, f"forces are those of solve to {away}")
    labels = chromium.value("page.film.quantities.map(({label}) => label)")
    expect({"A: effort", "C: force"} <= set(labels), f"efforts and forces can be plotted: {labels}")
    chromium.value("page.seek(40)")
    rows = chromium.value("""[...document.querySelectorAll("#readout tr")].map((row) =>
        [...row.cells].map((cell) => cell.textContent))""")
    told = {row[0]: row[1:] for row in rows}
    expect_near([float(one) for one in told["A"] + told["C on rocker"]],
                [float(solved["40"][name]) for name in ("A.effort", "C.fx", "C.fy")],
                1e-5 * largest, "the table")
    arrows = chromium.value("""(() => {
      const arrows = [];
      const own = page.stage.arrows.arrow;
      page.stage.arrows.arrow = (from, to) => arrows.push([to[0] - from[0], from[1] - to[1]]);
      page.show();
      page.stage.arrows.arrow = own;
      page.show();
      return arrows;
    })()""")
    expect(len(arrows) == 4, f"there are {len(arrows)} arrows")
    for pin, arrow in zip("ABCD", arrows):
        force = [float(solved["40"][f"{pin}.{axis}"]) for axis in ("fx", "fy")]
        cosine = (arrow[0] * force[0] + arrow[1] * force[1]) / math.hypot(*arrow) / math.hypot(*force)
        expect(cosine > 1 - 1e-9, f"the arrow at {pin} points along its force")
    keep_picture(chromium, "forces")


def checks(chromium, assur, examples, folder):
    jansen = examples / "jansen_leg.json"
    check_following(chromium, assur, jansen, folder)
    check_end_of_assembly(chromium, assur, examples / "four_bar_coupler_curve.json", folder)
    check_ends(chromium, assur, jansen, folder)
    check_dragged_output(chromium, assur, jansen, folder)
    check_view(chromium, assur, jansen, folder)
    check_angles(chromium, assur, examples / "watt_six_bar.json", folder)
    check_many_branches(chromium, assur, folder)
    check_circuits(chromium, assur, jansen, folder)
    check_forces(chromium, assur, folder)
    check_opening(chromium, assur, examples / "watt_six_bar.json", folder)


main(checks)
