// Turns the parameters of a scene into sliders and fields, by which the reader changes them.

/** A slider and a field for each parameter with a value of its own, or as drawn, but the swept one. */
class Sliders {
  /** `film` tells the parameters' values; `changed` is called after each change of the scene. */
  constructor(place, scene, film, changed) {
    [this.scene, this.changed] = [scene, changed];
    const helpers = scene.helpers ?? [];
    const shown = film.parameters.filter(({ name, own }) => name !== film.parameter &&
      !helpers.includes(name) && (own || scene.isAsDrawn(name)));
    this.made = new Map(shown.map(({ name, value }) => [name, value]));
    this.rows = shown.map((parameter) => this.row(parameter));
    const longest = Math.max(...shown.map(({ name }) => name.length));
    place.style.setProperty("--longest", `${Math.min(longest, 10) + 1}ch`);
    place.replaceChildren(...this.rows.map(({ line }) => line));
    this.read(film);
  }

  /** The range of a slider to either side: half of the value, or for 0 a tenth of the largest. */
  reach(value) {
    const largest = Math.max(...[...this.made.values()].map(Math.abs));
    return Math.abs(value) / 2 || largest / 10 || 1;
  }

  row({ name, value }) {
    const line = document.createElement("div");
    const label = document.createElement("label");
    const slider = document.createElement("input");
    const field = document.createElement("input");
    const note = document.createElement("small");
    slider.id = `slider ${name}`;
    label.htmlFor = slider.id;
    label.textContent = name;
    label.title = name;
    note.textContent = "as drawn";
    Object.assign(slider, { type: "range", title: "double click: the value it had, or as drawn" });
    Object.assign(field, { type: "number", step: "any" });
    field.setAttribute("aria-label", `${name}, as a number`);
    slider.addEventListener("input", () => this.set(name, Number(slider.valueAsNumber.toPrecision(6))));
    field.addEventListener("change", () => this.set(name, field.valueAsNumber));
    line.addEventListener("dblclick", (event) => event.target !== field && this.set(name, null));
    line.append(label, slider, field, note);
    const row = { name, line, slider, field, note };
    this.spread(row, value);
    this.write(row, value);
    return row;
  }

  spread({ slider }, value) {
    const reach = this.reach(value);
    Object.assign(slider, { min: value - reach, max: value + reach, step: reach / 100 });
  }

  /** A value as drawn is not one that somebody has written, so it is shown to seven digits. */
  write({ name, slider, field }, value) {
    slider.value = value;
    field.value = Number(value.toPrecision(this.scene.isAsDrawn(name) ? 7 : 12));
  }

  /** Shows the values of a film: those that are as drawn follow the drawing. */
  read(film) {
    for (const { name, value } of film.parameters.filter((one) => this.made.has(one.name))) {
      const row = this.rows.find((one) => one.name === name);
      if (this.scene.isAsDrawn(name) && value !== this.made.get(name)) {
        this.made.set(name, value);
        this.spread(row, value);
      }
      this.show(row);
    }
  }

  show(row) {
    const { name } = row;
    this.write(row, this.scene.changed.get(name) ?? this.made.get(name));
    row.line.classList.toggle("changed", this.scene.changed.has(name));
    row.note.classList.toggle("none", !this.scene.isAsDrawn(name));
  }

  /** Sets a parameter; null gives it the value back that it had. If `value` is not a number, the
   * field returns to the value before. */
  set(name, value) {
    const { changed } = this.scene;
    const before = changed.get(name);
    const now = value === null || Number.isFinite(value) ? value : before ?? null;
    now === null || now === this.made.get(name) ? changed.delete(name) : changed.set(name, now);
    this.show(this.rows.find((one) => one.name === name));
    if (changed.get(name) !== before) {
      this.changed();
    }
  }

  setDisabled(isDisabled) {
    this.rows.forEach(({ slider, field }) => {
      slider.disabled = field.disabled = isDisabled;
    });
  }
}
