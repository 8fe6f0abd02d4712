"""Law: in a browser, the page of a scene has the outputs of `assur solve` on every branch at every
step; its keys and buttons do what they say; its sliders solve as `assur solve --set` does; the page
says what cannot be assembled and draws mechanisms of any size; and the console has no error."""

import csv
import io
import json

from opened_page import OUTPUTS, SOLVED, expect, main, obstacle, opened, run, set_parameter

READ = """(() => {
  const page = window.page;
  const key = (name, shift) =>
    document.dispatchEvent(new KeyboardEvent("keydown", {key: name, shiftKey: Boolean(shift)}));
  const answer = {told: [], keys: []};
  page.play(false);
  for (const branch of page.film.branches) {
    page.choose(branch.number);
    for (let step = 0; step < page.film.count; step += 7) {
      page.seek(step);
      const cells = [...document.querySelectorAll("#readout tr")].map(
        (row) => [...row.cells].map((cell) => cell.textContent));
      answer.told.push([branch.number, step, page.film.parameterAt(step), cells.slice(1)]);
    }
  }
  const note = () => answer.keys.push([page.place, page.chosen, page.isPlaying, page.options.all]);
  key("Home"); note();
  key("ArrowRight"); note();
  key("ArrowRight", true); note();
  key("ArrowLeft"); note();
  key("End"); note();
  key("2"); note();
  key("a"); note();
  key(" "); note();
  key(" "); key("a"); key("1");
  return answer;
})()"""

SPREADS = """page.film.branches.map((branch) => [branch.number,
  Array.from(branch.spreads.numbers, (one) => (Number.isNaN(one) ? null : one))])"""

FRAMES = """new Promise((resolve) => {
  page.play(true);
  const begin = performance.now();
  let frames = 0;
  const next = () => {
    ++frames;
    const seconds = (performance.now() - begin) / 1000;
    if (seconds < 2) { requestAnimationFrame(next); } else {
      page.play(false); resolve([frames / seconds, page.place]); }
  };
  requestAnimationFrame(next);
})"""

def rows_of(assur, scene, *options):
    table, _ = run(assur, "solve", str(scene), "--format", "csv", *options)
    return {(row["branch"], int(row["step"])): row for row in csv.DictReader(io.StringIO(table))
            if not row["event"]}


def check(chromium, assur, scene, folder, output, parameter):
    opened(chromium, assur, scene, folder)
    answer = chromium.value(READ)
    rows = rows_of(assur, scene)
    compared = 0
    for branch, step, value, cells in answer["told"]:
        row = rows.get((str(branch), step))
        told = next(line for line in cells if line[0] == output)
        if row is None:
            expect(told[1] == "–", f"{scene.stem}: branch {branch} is not at step {step}")
            continue
        expect(abs(float(row[parameter]) - value) < 1e-12, "the parameter")
        for cell, column in zip(told[1:3], ("x", "y")):
            solved = float(row[f"{output}.{column}"])
            expect(abs(float(cell) - solved) <= 6e-6 * max(abs(solved), 1), f"{cell} is {solved}")
            compared += 1
    expect(compared > 100, f"{scene.stem}: {compared} numbers are compared")
    last = max(step for _, step in rows)
    expect(answer["keys"] == [[0, answer["keys"][0][1], False, True],
                              [1, answer["keys"][0][1], False, True],
                              [11, answer["keys"][0][1], False, True],
                              [10, answer["keys"][0][1], False, True],
                              [last, answer["keys"][0][1], False, True],
                              [last, 2, False, True], [last, 2, False, False],
                              [last, 2, True, False]], f"{scene.stem}: keys {answer['keys']}")
    print(f"{scene.stem}: {compared} numbers of the page are those of assur solve")


def check_spreads(chromium, rows):
    """The square roots of the variances are the foot's `rss`, where that is known."""
    known = 0
    for branch, numbers in chromium.value(SPREADS):
        for step in range(len(numbers) // 3):
            row = rows.get((str(branch), step), {"foot.rss_x": "", "foot.rss_y": ""})
            for column, place in (("foot.rss_x", 0), ("foot.rss_y", 2)):
                told, shown = row[column], numbers[3 * step + place]
                expect((told == "") == (shown is None), f"branch {branch}, step {step}: {column}")
                if told and shown is not None:
                    expect(abs(shown**0.5 - float(told)) <= 1e-6 * float(told), f"{shown} is {told}^2")
                    known += 1
    expect(known > 1000, f"{known} deviations are compared")


def check_sliders(chromium, assur, scene, folder):
    """The foot of Jansen's leg, on all its branches, as sliders and fields move it."""
    opened(chromium, assur, scene, folder)
    worst = 0
    for name, part, value in (("b", "slider", 43), ("m", "field", 14.123456789), ("b", "field", 40.5)):
        set_parameter(chromium, name, value, part)
        values = chromium.value("Object.fromEntries(page.scene.changed)")
        rows = rows_of(assur, scene, *(word for one, number in values.items()
                                       for word in ("--set", f"{one}={number!r}")))
        check_spreads(chromium, rows)
        found = 0
        for branch, numbers in chromium.value(OUTPUTS):
            for step in range(len(numbers) // 6):
                row = rows.pop((str(branch), step), None)
                expect((row is None) == (numbers[6 * step] is None), f"branch {branch}, step {step}")
                for place, column in enumerate(("x", "y", "vx", "vy", "ax", "ay") if row else ()):
                    solved, shown = float(row[f"foot.{column}"]), numbers[6 * step + place]
                    if place < 2:
                        worst = max(worst, abs(shown - solved) / max(abs(solved), 1))
                    else:
                        expect(abs(shown - solved) <= 1e-6 * max(abs(solved), 1), f"{shown} is {solved}")
                    found += 1
        expect(found > 1000 and not rows, f"{values}: {found} numbers are compared, {len(rows)} left")
    expect(worst < 1e-12, f"the foot is where it is solved, within {worst}")
    print(f"{scene.stem}: with sliders the foot is where assur solve --set has it, within {worst:.1e}")
    rate, place = chromium.value(FRAMES)
    expect(place > 0, "the leg walks")
    print(f"{scene.stem}: {rate:.0f} frames per second")
    milliseconds = chromium.value("""(async () => {
      const times = [];
      for (let step = 0; step < 20; ++step) {
        const begin = performance.now();
        page.scene.changed.set("b", 41 + step / 20);
        await page.asker.solver.solve(page.question().asked);
        times.push(performance.now() - begin);
      }
      return times.sort((one, other) => one - other)[10];
    })()""")
    print(f"{scene.stem}: {milliseconds:.0f} ms for a step of a slider, in the middle of 20")

    before = chromium.value(OUTPUTS)
    for name, value, told in (("b", 1, "form no triangle"), ("m", 200, "no-assembly")):
        chromium.value("page.reset()")
        chromium.value(SOLVED)
        set_parameter(chromium, name, value)
        expect(told in obstacle(chromium), f"{name} = {value}: {obstacle(chromium)}")
    expect(set_parameter(chromium, "m", "") == 200, "no number changes nothing")
    chromium.value("document.getElementById('reset').click()")
    chromium.value(SOLVED)
    expect(obstacle(chromium) == "", f"reset: {obstacle(chromium)}")
    expect(chromium.value("page.scene.changed.size") == 0, "reset")
    expect(chromium.value(OUTPUTS) != before, "reset")
    for key, moved in (("ArrowRight", False), ("2", False)):
        state = chromium.value("[page.place, page.chosen]")
        chromium.value(f"""page.sliders.rows[0].slider.dispatchEvent(
            new KeyboardEvent("keydown", {{key: "{key}", bubbles: true}}))""")
        expect((state != chromium.value("[page.place, page.chosen]")) == moved, f"{key} in a slider")


def check_without_solver(chromium, assur, scene, folder):
    """A browser that cannot solve shows the page's stored data, and says so."""
    page = folder / "old.html"
    run(assur, "draw", str(scene), "--output", str(page))
    page.write_text(page.read_text().replace("<script", "<script>Worker = undefined;</script><script", 1))
    chromium.open(page.as_uri())
    chromium.value(SOLVED)
    expect("cannot solve" in obstacle(chromium), obstacle(chromium))
    expect(chromium.value("page.sliders.rows.every(({slider, field}) => slider.disabled && field.disabled)"),
           "the sliders stand still")
    expect(chromium.value("page.film.branches.length > 0 && page.isPlaying"), "the page moves")


def check_sizes(chromium, assur, scene, folder):
    """A window with no room and a mechanism of nanometres in metres are drawn, paths included."""
    lengths = {"ground": 80, "crank": 40, "coupler": 100, "rocker": 100, "reach": 200}
    small = [word for name, length in lengths.items() for word in ("--set", f"{name}={length}e-10")]
    opened(chromium, assur, scene, folder, *small)
    paths = chromium.value("""(() => {
      page.play(false);
      const box = document.getElementById("ways");
      const drawn = () => (page.show(), page.stage.canvas.toDataURL());
      const before = drawn();
      box.checked = false;
      return before !== drawn();
    })()""")
    expect(paths, f"{scene.stem}: the paths of a small mechanism are drawn")
    chromium.open((folder / f"{scene.stem}.html").as_uri(), width=30, height=60)
    lengths = chromium.value("[999.9999999999999, 1000, 7].map(roundBelow)")
    expect(lengths == [500, 1000, 5], f"round lengths {lengths}")


def checks(chromium, assur, examples, folder):
    check(chromium, assur, examples / "jansen_leg.json", folder, "foot", "phi")
    check(chromium, assur, examples / "quintero_2011_rrp_rrr.json", folder, "E", "phi")
    check_sliders(chromium, assur, examples / "jansen_leg.json", folder)
    check_without_solver(chromium, assur, examples / "slider_crank.json", folder)
    check_sizes(chromium, assur, examples / "four_bar_coupler_curve.json", folder)


main(checks)
