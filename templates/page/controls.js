// Turns buttons, fields, keys and dropped files into actions of the page.

/** Lets a page do what its buttons, fields, keys and pointers say. */
function listenFor(page) {
  const on = (name, event, act) => page.element(name).addEventListener(event, act);
  on("play", "click", () => page.play(!page.isPlaying));
  on("place", "input", (event) => page.seek(Number(event.target.value)));
  on("plot", "pointerdown", (event) => page.seek(page.plot.placeAt(event.offsetX)));
  for (const name of ["all", "ways", "names", "velocity", "acceleration", "force", "spread", "drawn",
    "quantity", "end"]) {
    on(name, "change", () => page.show());
  }
  on("reset", "click", () => page.reset());
  on("larger", "click", () => page.enlarge(1.25));
  on("smaller", "click", () => page.enlarge(0.8));
  on("fit", "click", () => page.fit());
  on("edit", "click", () => (page.editing.isOn ? page.leave() : page.edit()));
  on("undo", "click", () => page.editing.undo());
  on("point", "change", (event) => {
    page.editing.selected = event.target.value;
    page.show();
  });
  ["point_x", "point_y"].forEach((name, axis) =>
    on(name, "change", (event) => page.editing.set(axis, event.target.valueAsNumber)));
  on("copy_scene", "click", () => page.copy());
  on("save_scene", "click", () =>
    saveFile(fileName(page.film.title, "json"), page.scene.written(), "application/json"));
  on("save_csv", "click", () =>
    saveFile(fileName(`${page.film.title} branch ${page.chosen}`, "csv"),
      csvOfBranch(page.film, page.branch), "text/csv"));
  listenToDrops((text) => page.offer(text));
  new Hand(page.element("stage"), page.stage.view, {
    grip: (place, reach, isHovering) => page.grip(place, reach, isHovering),
    changed: () => page.show(),
  });
  new ResizeObserver(() => page.show()).observe(document.querySelector("main"));
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
    knownColours.clear();
    page.show();
  });
  document.addEventListener("keydown", (event) => actOnKey(page, event));
}

/** Does what a key says, unless it belongs to the field that has the focus. */
function actOnKey(page, event) {
  const isUndo = event.key === "z" && (event.ctrlKey || event.metaKey);
  const isPress = event.key === " " && event.target.closest?.("button");
  if (isPress || event.target.closest?.("select, input:not([type=checkbox]):not(#place), textarea") ||
      (!isUndo && (event.ctrlKey || event.altKey || event.metaKey))) {
    return;
  }
  const far = event.shiftKey ? 10 : 1;
  const step = Math.round(page.place);
  const digit = Number(event.key);
  const nudge = (right, up) =>
    page.editing.nudge(far * right, far * up, grainAt(page.stage.view.now.zoom));
  const actions = isUndo ? { z: () => page.editing.undo() } : {
    " ": () => page.play(!page.isPlaying),
    ArrowLeft: () => page.seek(step - far),
    ArrowRight: () => page.seek(step + far),
    Home: () => page.seek(0),
    End: () => page.seek(page.film.count - 1),
    a: () => page.element("all").click(),
    c: () => page.copy(),
    e: () => page.edit(),
    ...(page.editing.isOn ? {
      ArrowLeft: () => nudge(-1, 0),
      ArrowRight: () => nudge(1, 0),
      ArrowUp: () => nudge(0, 1),
      ArrowDown: () => nudge(0, -1),
      Escape: () => page.leave(),
    } : {}),
  };
  const action = actions[event.key] ||
    (page.film.branch(digit) ? () => page.choose(digit) : null);
  if (action) {
    event.preventDefault();
    action();
  }
}
