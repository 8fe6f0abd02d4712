"""Law: in windows from 320 to 1600 pixels wide, light and dark, nothing of a page is clipped or runs
out of the window, and short words stay in one line."""

import json

from opened_page import SOLVED, expect, keep_picture, main, opened
from page_editing_scenes import DRAWN

# What is wider than the window, clipped at the side of its box, or broken though it is one word.
FAULTS = """(() => {
  const faults = [];
  const { scrollWidth, clientWidth } = document.documentElement;
  if (scrollWidth > clientWidth) { faults.push(`the page is ${scrollWidth} wide`); }
  const isShown = (one) => one.offsetParent !== null;
  for (const one of [...document.querySelectorAll("button, input, select, canvas, label")]
      .filter(isShown)) {
    const box = one.getBoundingClientRect();
    const around = one.closest("fieldset, section").getBoundingClientRect();
    if (box.left < around.left - 0.5 || box.right > around.right + 0.5) {
      faults.push(`${one.id || one.textContent.slice(0, 20)} is clipped`);
    }
  }
  for (const one of [...document.querySelectorAll("#sliders div")].filter(isShown)) {
    const boxes = [...one.querySelectorAll("label, input")].map((part) => part.getBoundingClientRect());
    if (boxes.some((box, place) => place > 0 && box.left < boxes[place - 1].right - 0.5)) {
      faults.push(`${one.textContent}: label, slider and field overlap`);
    }
  }
  for (const one of [...document.querySelectorAll("button, .heads th, .heads td")].filter(isShown)) {
    const range = document.createRange();
    range.selectNodeContents(one);
    const lines = new Set([...range.getClientRects()].map(({ top }) => Math.round(top)));
    if (lines.size > 1) { faults.push(`${one.textContent} is in ${lines.size} lines`); }
  }
  return faults;
})()"""


# How many drawn points are on the stage.
SQUARES_INSIDE = """[...page.editing.places.values()].filter((place) => {
  const [x, y] = page.stage.view.at(...place);
  const { clientWidth, clientHeight } = page.stage.canvas;
  return x > 0 && y > 0 && x < clientWidth && y < clientHeight;
}).length"""


def checks(chromium, assur, examples, folder):
    drawn = folder / "drawn.json"
    drawn.write_text(json.dumps(DRAWN))
    scenes = [examples / "jansen_leg.json", examples / "excavator_arm.json",
              examples / "watt_six_bar.json", drawn]
    for scene in scenes:
        opened(chromium, assur, scene, folder)
        for is_edited in (False, scene == drawn):
            if is_edited:
                chromium.key("e")
                chromium.value(SOLVED)
            for width in (320, 375, 480, 768, 820, 821, 1024, 1200, 1280, 1600):
                for dark in (False, True):
                    chromium.window(width, 800, dark)
                    chromium.value("new Promise((done) => requestAnimationFrame(() => "
                                   "setTimeout(done, 30)))")
                    name = f"{scene.stem}_{width}_{'dark' if dark else 'light'}"
                    name += "_edited" if is_edited else ""
                    faults = chromium.value(FAULTS)
                    expect(not faults, f"{name}: {faults}")
                    if is_edited:
                        inside = chromium.value(SQUARES_INSIDE)
                        expect(inside == len(DRAWN["points"]), f"{name}: {inside} squares are seen")
                    colours = chromium.value("[colour('paper'), colour('ink')]")
                    expect(len(set(colours)) == 2, f"{name}: ink and paper are {colours}")
                    if width in (320, 768, 1200, 1600):
                        keep_picture(chromium, name)


main(checks)
