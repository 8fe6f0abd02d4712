// Turns a film, and the place in it, into the panels beside the stage and below it.

/** The buttons of branches, the marks of the time line, and what there is to be shown. */
function showFilm(page) {
  const { film } = page;
  page.element("branches").replaceChildren(...film.branches.map((branch) => {
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = branch.number;
    button.title = branch.circuit > 0 ? `circuit ${branch.circuit}` : "";
    button.style.borderBottomColor = `var(--c${branch.colour})`;
    button.addEventListener("click", () => page.choose(branch.number));
    return button;
  }));
  if (film.left_out > 0) {
    page.element("branches").append(`and ${film.left_out} more`);
  }
  page.element("drawn_one").textContent = film.nearest && page.scene?.isDrawn
    ? `${film.nearest} is the drawn one` : "";
  const along = (place) => `${100 * place / (film.count - 1)}%`;
  page.element("marks").replaceChildren(...film.events.map((event) => {
    const mark = document.createElement("span");
    mark.className = event.event;
    mark.style.left = along(film.placeOf(event.parameter));
    mark.title = `${event.event} ${event.branches.join(" ")} at ${film.parameter} = ` +
      shortNumber(event.parameter);
    return mark;
  }));
  page.element("place").max = film.count - 1;
  page.hide(".spreads", !film.hasSpreads);
  page.hide(".rates", !film.hasRates);
  page.hide(".forces", !film.hasForces);
  page.hide(".moving, #time", film.count === 1);
  page.hide("#plots", film.count === 1 || film.quantities.length === 0);
}

/** The circuit of the chosen branch: the branches that it reaches over folds, crossings and the ends
 * of the sweep. Where some branches are left out, those that are shown. */
function toldCircuit({ branches }, { number, circuit }) {
  if (circuit === 0) {
    return "";
  }
  const others = branches.filter((one) => one.circuit === circuit && one.number !== number);
  return `circuit ${circuit}: branch ${number} ` + (others.length === 0 ? "alone"
    : `with ${others.map((one) => one.number).join(", ")}`);
}

/** The quantities that can be plotted. The choice stays as long as it can. */
function showQuantities(page) {
  const select = page.element("quantity");
  const before = select.value;
  const labels = page.film.quantities.map(({ label }) => label);
  if (labels.join() !== [...select.options].map(({ value }) => value).join()) {
    select.replaceChildren(...labels.map((label) => new Option(label, label)));
    select.value = labels.includes(before) ? before : labels[0];
  }
}

/** Where the chosen branch exists, on the time line. */
function showStretches(page) {
  const { film, branch } = page;
  const line = page.element("stretches");
  const known = `${branch.number} ${branch.stretches}`;
  if (film.count === 1 || line.dataset.known === known) {
    return;
  }
  line.dataset.known = known;
  line.replaceChildren(...branch.stretches.map(([first, last]) => {
    const part = document.createElement("span");
    part.style.left = `${100 * first / (film.count - 1)}%`;
    part.style.width = `${100 * (last - first) / (film.count - 1)}%`;
    part.style.background = `var(--c${branch.colour})`;
    return part;
  }));
}

/** The fields of the chosen point. */
function showEditing(page) {
  const { editing } = page;
  page.element("edit").setAttribute("aria-pressed", editing.isOn);
  page.element("undo").disabled = editing.undone.length === 0;
  page.hide("#chosen_point", !editing.isOn || editing.selected === null);
  if (!editing.isOn || editing.selected === null) {
    return;
  }
  const select = page.element("point");
  const names = [...editing.places.keys()];
  if (names.join() !== [...select.options].map(({ value }) => value).join()) {
    select.replaceChildren(...names.map((name) => new Option(name, name)));
  }
  select.value = editing.selected;
  ["point_x", "point_y"].forEach((name, axis) => {
    const field = page.element(name);
    field.disabled = page.scene.handle(editing.selected, axis).kind === "formula";
    if (document.activeElement !== field) {
      field.value = Number(editing.places.get(editing.selected)[axis].toPrecision(12));
    }
  });
}
