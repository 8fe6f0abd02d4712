"""Law: on a page the points of a drawing can be moved by mouse, finger, keys and fields, and moved
back; what the page then shows is what `assur solve` finds for the scene that the page saves; lengths
with a value stay; scenes can be saved, copied and dropped; and scenes without parameters or a sweep
can be played with."""

import csv
import io
import json
import math

from opened_page import (OUTPUTS, SOLVED, expect, expect_near, keep_picture, main, obstacle, opened,
                         run, set_parameter)
from page_editing_scenes import DRAWN, SHORT


def written(folder, name, scene):
    file = folder / f"{name}.json"
    file.write_text(scene if isinstance(scene, str) else json.dumps(scene))
    return file


def expect_solved(chromium, assur, folder, what):
    """The page shows what the scene that it saves has for its solution."""
    file = written(folder, "saved", chromium.value("page.scene.written()"))
    table, told = run(assur, "solve", str(file), "--format", "csv")
    expect(told == "" or "error" not in told, f"{what}: {told}")
    rows = {(row["branch"], int(row["step"])): row for row in csv.DictReader(io.StringIO(table))
            if not row["event"]}
    names = chromium.value("page.film.outputs")
    compared, worst = 0, 0
    for number, numbers in chromium.value(OUTPUTS):
        for (branch, step), row in rows.items():
            if branch != str(number):
                continue
            for place, name in enumerate(names):
                for column, axis in enumerate("xy"):
                    shown = numbers[6 * (step * len(names) + place) + column]
                    solved = float(row[f"{name}.{axis}"])
                    worst = max(worst, math.inf if shown is None else abs(shown - solved))
                    compared += 1
    expect(compared > 500 and worst < 1e-9, f"{what}: {compared} numbers are compared, to {worst}")
    return json.loads(file.read_text())


def place_of(chromium, point):
    """Where the square of a drawn point is in the window."""
    return chromium.value(f"""(() => {{
      const box = page.stage.canvas.getBoundingClientRect();
      const [u, v] = page.stage.view.at(...page.editing.places.get("{point}"));
      return [box.left + u, box.top + v];
    }})()""")


def point_at(chromium, point):
    return chromium.value(f"page.editing.places.get('{point}')")


def dragged(chromium, point, right, down, **told):
    begin = place_of(chromium, point)
    chromium.mouse(begin, [begin[0] + right / 2, begin[1] + down / 3],
                   [begin[0] + right, begin[1] + down], **told)
    chromium.value(SOLVED)


def undone(chromium, count=1):
    for _ in range(count):
        chromium.key("z", ctrlKey=True)
        chromium.value(SOLVED)


def check_editing(chromium, assur, folder):
    file = written(folder, "drawn", DRAWN)
    opened(chromium, assur, file, folder)
    number = chromium.value("page.chosen")
    expect(chromium.value("document.getElementById('drawn_one').textContent") ==
           f"{number} is the drawn one", "the page tells the drawn branch")
    chromium.value("document.getElementById('edit').click()")
    chromium.value(SOLVED)
    expect(chromium.value("page.editing.draft.count") == 1, "the drawn pose is shown")
    expect_near(chromium.value("[...page.editing.draft.branch(page.editing.draft.chosen).outputs.at(0)]"
                               ".slice(0, 2)"), [151.3, 162.3], 0.1, "P as drawn")
    keep_picture(chromium, "editing")

    zoom = chromium.value("page.stage.view.now.zoom")
    grain = chromium.value("grainAt(page.stage.view.now.zoom)")
    expect(0.1 / zoom < grain <= 1 / zoom, f"a step of {grain} is not longer than a pixel")
    dragged(chromium, "B", 24, -12)
    expect_near(point_at(chromium, "B"), [22.5 + 24 / zoom, 26.8 + 12 / zoom], grain, "B is dragged")
    scene = expect_solved(chromium, assur, folder, "B is dragged")
    expect(scene["points"]["B"] == point_at(chromium, "B"), "the scene has the new point")
    length = math.hypot(*point_at(chromium, "B"))
    told = chromium.value("page.film.parameters.find(({name}) => name === 'AB').value")
    expect(abs(told - length) < 1e-12, "the length AB follows its points")
    expect(scene["parameters"]["AB"] == DRAWN["parameters"]["AB"], "AB keeps its tolerance")

    dragged(chromium, "F", -20, 10)
    scene = expect_solved(chromium, assur, folder, "F is dragged")
    expect(scene["parameters"]["EF"] == DRAWN["parameters"]["EF"], "EF keeps its value and tolerance")
    labels = chromium.value("page.scene.lengthsAt('F', page.editing.places)")
    fixed = next(one for one in labels if one["name"] == "FE")
    expect(fixed["isFixed"] and fixed["length"] == 85, f"the label says {fixed}")
    pin = chromium.value("[...page.editing.draft.branch(page.editing.draft.chosen).outputs.at(0)]"
                         ".slice(6, 8)")
    expect(math.dist(pin, point_at(chromium, "F")) > 0.1, "the square leaves the pin")
    keep_picture(chromium, "fixed_length")

    dragged(chromium, "D", 15, -40)
    expect(chromium.value("page.scene.changed.get('AD')") == point_at(chromium, "D")[0],
           "a coordinate that is a parameter sets it")
    scene = expect_solved(chromium, assur, folder, "D is dragged")
    expect(scene["parameters"]["AD"] == point_at(chromium, "D")[0],
           "the scene has the parameter's value")
    expect(abs(point_at(chromium, "G")[0] - point_at(chromium, "D")[0] - 58.6) < 1e-9,
           "a formula follows its parameter")

    before = point_at(chromium, "C")
    dragged(chromium, "C", 30, 7, shift=True)
    after = point_at(chromium, "C")
    expect(after[0] > before[0] and after[1] == before[1], f"with shift, from {before} to {after}")
    before = point_at(chromium, "G")
    dragged(chromium, "G", 20, 20)
    after = point_at(chromium, "G")
    expect(after[0] == before[0] and after[1] < before[1], f"a formula stays: {before}, {after}")
    expect(chromium.value("document.getElementById('point_x').disabled"), "its field cannot be changed")

    undone(chromium, 5)
    expect(chromium.value("document.getElementById('undo').disabled"), "all is undone")
    scene = expect_solved(chromium, assur, folder, "all is undone")
    expect(scene == DRAWN, "the scene is as before")

    begin = place_of(chromium, "P")
    chromium.touch([begin], [[begin[0] - 10, begin[1]]], [[begin[0] - 30, begin[1] + 12]])
    chromium.value(SOLVED)
    expect_near(point_at(chromium, "P"), [151.3 - 30 / zoom, 162.3 - 12 / zoom], grain, "by finger")
    expect_solved(chromium, assur, folder, "P is dragged by a finger")
    before = point_at(chromium, "P")
    chromium.key("ArrowUp")
    chromium.key("ArrowRight", shiftKey=True)
    chromium.value(SOLVED)
    expect_near(point_at(chromium, "P"), [before[0] + 10 * grain, before[1] + grain], 1.01 * grain,
                "arrows move the chosen point")
    expect_solved(chromium, assur, folder, "P is moved by keys")
    chromium.value("""(() => { const field = document.getElementById("point_y");
        field.value = 170.25; field.dispatchEvent(new Event("change")); })()""")
    chromium.value(SOLVED)
    scene = expect_solved(chromium, assur, folder, "P is moved by a field")
    expect(scene["points"]["P"][1] == 170.25, "the field's number is the coordinate")
    chromium.key("Escape")
    expect(not chromium.value("page.editing.isOn"), "escape leaves the drawing")
    expect(chromium.value("page.scene.json.points.P[1]") == 170.25, "the change stays")


def check_obstacles(chromium, assur, folder):
    """A drawing that cannot be assembled is named, and can be undone."""
    opened(chromium, assur, written(folder, "drawn", DRAWN), folder)
    chromium.key("e")
    chromium.value(SOLVED)
    chromium.value("""(() => { page.editing.selected = "B"; page.editing.set(0, NaN);
        page.editing.set(0, 0); page.editing.set(1, 0); })()""")
    chromium.value(SOLVED)
    expect("coincide in the drawing" in obstacle(chromium), f"the page says {obstacle(chromium)!r}")
    undone(chromium, 2)
    expect(obstacle(chromium) == "", "undo mends it")
    expect_solved(chromium, assur, folder, "undone")


def check_values_as_drawn(chromium, assur, folder):
    opened(chromium, assur, written(folder, "drawn", DRAWN), folder)
    notes = """Object.fromEntries(page.sliders.rows.map(({name, note}) =>
        [name, !note.classList.contains("none")]))"""
    expect(chromium.value(notes) == {"AD": False, "AB": True, "EF": False},
           f"as drawn: {chromium.value(notes)}")
    set_parameter(chromium, "AB", 33)
    expect(not chromium.value(notes)["AB"], "a length with a value is not as drawn")
    scene = expect_solved(chromium, assur, folder, "AB has a value")
    expect(scene["parameters"]["AB"] == {"drawn": ["A", "B"], "tolerance": 0.02, "value": 33},
           f"the scene has {scene['parameters']['AB']}")
    chromium.value("""page.sliders.rows.find(({name}) => name === "AB").slider.dispatchEvent(
        new MouseEvent("dblclick", {bubbles: true}))""")
    chromium.value(SOLVED)
    expect(chromium.value(notes)["AB"], "a double click makes it as drawn again")
    expect(expect_solved(chromium, assur, folder, "AB is as drawn") == DRAWN, "the scene is as before")


def check_files(chromium, assur, folder, watt):
    opened(chromium, assur, written(folder, "drawn", DRAWN), folder, "--set", "EF=84", "--set",
           "phi=60*deg")
    set_parameter(chromium, "AD", 103)
    chromium.value("""(() => { window.saved = []; URL.createObjectURL = (blob) => (saved.push(blob), "#");
        HTMLAnchorElement.prototype.click = function () { saved.push(this.download); };
        Object.defineProperty(navigator, "clipboard", {value: {writeText: async (text) =>
          { window.copied = text; }}, configurable: true});
        for (const name of ["save_scene", "save_csv", "copy_scene"]) {
          document.getElementById(name).click(); } })()""")
    text, name, table, table_name = chromium.value("""Promise.all(saved.map((one) =>
        (one instanceof Blob ? one.text() : one)))""")
    expect(name == "a_six_bar_as_it.json" and table_name.endswith(".csv"), f"{name}, {table_name}")
    expect(chromium.value("copied") == text, "the copy is what is saved")
    expect(max(map(len, text.splitlines())) <= 110 and len(text.splitlines()) < 40, "lines are short")
    scene = expect_solved(chromium, assur, folder, "saved")
    expect(json.loads(text) == scene, "saved")
    expect([scene["parameters"][name] for name in ("AD", "EF", "phi")] ==
           [103, {"drawn": ["E", "F"], "value": 84, "tolerance": 0.05}, {"value": "60*deg"}],
           f"the values in force are in the scene: {scene['parameters']}")
    solved, _ = run(assur, "solve", str(folder / "saved.json"), "--format", "csv")
    columns = csv.DictReader(io.StringIO(solved)).fieldnames
    shown = csv.DictReader(io.StringIO(table)).fieldnames
    expect([name for name in shown if not name.endswith(".transmission")] ==
           [name for name in columns if name in shown], f"the names of columns: {shown}")
    chromium.value("""(() => { Object.defineProperty(navigator, "clipboard", {value: undefined,
        configurable: true}); page.copy(); })()""")
    expect(chromium.value("(({value, classList}) => !classList.contains('none') && value)"
                          "(document.getElementById('text'))") == text, "a box has the text to copy")

    drop = """(() => { const held = new DataTransfer();
        held.items.add(new File([%s], "scene.json"));
        document.dispatchEvent(new DragEvent("drop", {dataTransfer: held, cancelable: true}));
        return new Promise((resolve) => setTimeout(resolve, 50)); })()"""
    for wrong, told in (("{", "scene"), ('{"links": 1}', "links")):
        chromium.value(drop % json.dumps(wrong))
        chromium.value(SOLVED)
        expect(told in obstacle(chromium) and "\n" not in obstacle(chromium), obstacle(chromium))
        expect(chromium.value("page.film.title") == DRAWN["name"], "the scene before stays")
    chromium.value(drop % json.dumps(watt.read_text()))
    chromium.value(SOLVED)
    expect(obstacle(chromium) == "", obstacle(chromium))
    expect(chromium.value("document.title").startswith("Watt's six-bar"), "the title is the scene's")
    expect(chromium.value("page.sliders.rows.map(({name}) => name)") ==
           ["AD", "AB", "BC", "CD", "EF", "FG"], "the sliders are the scene's")
    set_parameter(chromium, "CD", 77)
    expect_solved(chromium, assur, folder, "dropped")


def check_short(chromium, assur, folder):
    """A scene of five lines turns, and can be edited."""
    opened(chromium, assur, written(folder, "short", SHORT), folder)
    expect(chromium.value("[page.film.parameter, page.film.count]") == ["turn", 181], "it turns")
    expect(chromium.value("document.getElementById('parameters').classList.contains('none')"),
           "it has no sliders")
    turned = dict(SHORT, parameters={"begin": {"drawn": "A"}, "turn": 0},
                  drivers={"A": {"position": "begin + turn", "velocity": 10}},
                  sweep={"parameter": "turn", "from": 0, "to": "2*pi", "count": 181})
    table, _ = run(assur, "solve", str(written(folder, "turned", turned)), "--format", "csv")
    rows = [row for row in csv.DictReader(io.StringIO(table)) if row["branch"] == "1"]
    shown = dict(chromium.value(OUTPUTS))[1]
    away = max(abs(shown[6 * int(row["step"])] - float(row["P.x"])) for row in rows)
    expect(len(rows) == 181 and away < 1e-9, f"P is where it is solved, within {away}")
    chromium.key("e")
    chromium.value(SOLVED)
    dragged(chromium, "P", 30, 10)
    saved = json.loads(chromium.value("page.scene.written()"))
    expect(saved == dict(SHORT, points=dict(SHORT["points"], P=point_at(chromium, "P"))),
           f"the scene that is saved has no helpers: {saved}")
    chromium.key(" ")
    expect(chromium.value("page.isPlaying && !page.editing.isOn"), "playing leaves the drawing")


def checks(chromium, assur, examples, folder):
    check_editing(chromium, assur, folder)
    check_obstacles(chromium, assur, folder)
    check_values_as_drawn(chromium, assur, folder)
    check_files(chromium, assur, folder, examples / "watt_six_bar.json")
    check_short(chromium, assur, folder)


main(checks)
