// Turns values that the reader sets for parameters into films of the mechanism at these values.

/** A slider and a field for each parameter of the scene. Values that were set while the solver was
 * busy are solved only if they are the last ones. */
class Sliders {
  /** `show` takes a film. `tell` takes the reason why there is none, or an empty text, and whether
   * any film was solved so far. The page's own values are solved first: if that fails, the browser
   * cannot solve at all. */
  constructor(place, scene, show, tell) {
    [this.show, this.tell] = [show, tell];
    this.scene = scene;
    this.works = false;
    this.made = new Map(scene.parameters.map(({ name, value }) => [name, value]));
    this.changed = new Map();
    this.rows = scene.parameters.map((parameter) => this.row(parameter));
    const longest = Math.max(...scene.parameters.map(({ name }) => name.length));
    place.style.setProperty("--longest", `${Math.min(longest, 10) + 1}ch`);
    place.append(...this.rows.map(({ line }) => line));
    this.busy = false;
    this.waiting = false;
    this.solve();
  }

  /** The range of a slider to either side: half of the value, or for 0 a tenth of the largest. */
  reach(value) {
    const largest = Math.max(...[...this.made.values()].map(Math.abs));
    return Math.abs(value) / 2 || largest / 10 || 1;
  }

  row({ name, value }) {
    const reach = this.reach(value);
    const line = document.createElement("div");
    const label = document.createElement("label");
    const slider = document.createElement("input");
    const field = document.createElement("input");
    slider.id = `slider ${name}`;
    label.htmlFor = slider.id;
    label.textContent = name;
    label.title = name;
    Object.assign(slider, { type: "range", min: value - reach, max: value + reach, step: reach / 100 });
    Object.assign(field, { type: "number", step: "any" });
    field.setAttribute("aria-label", `${name}, as a number`);
    slider.addEventListener("input", () => this.set(name, Number(slider.valueAsNumber.toPrecision(6))));
    field.addEventListener("change", () => this.set(name, field.valueAsNumber));
    line.append(label, slider, field);
    const row = { name, line, slider, field };
    this.write(row, value);
    return row;
  }

  write({ slider, field }, value) {
    slider.value = value;
    field.value = Number(value.toPrecision(12));
  }

  /** Sets a parameter. If `value` is not a number, the field returns to the value before. */
  set(name, value) {
    const before = this.changed.get(name) ?? this.made.get(name);
    const now = Number.isFinite(value) ? value : before;
    now === this.made.get(name) ? this.changed.delete(name) : this.changed.set(name, now);
    const row = this.rows.find((one) => one.name === name);
    this.write(row, now);
    row.line.classList.toggle("changed", this.changed.has(name));
    if (now !== before) {
      this.solve();
    }
  }

  reset() {
    for (const [name, value] of this.made) {
      this.set(name, value);
    }
  }

  async solve() {
    this.waiting = this.busy;
    if (this.busy) {
      return;
    }
    this.busy = true;
    try {
      this.solver ??= new Solver(this.scene);
      this.show(new Film(await this.solver.solve(Object.fromEntries(this.changed))));
      this.works = true;
      this.tell("", true);
    } catch (error) {
      this.tell(error.message, this.works);
      this.rows.forEach(({ slider, field }) => {
        slider.disabled = field.disabled = !this.works;
      });
    }
    this.busy = false;
    if (this.waiting) {
      this.solve();
    }
  }
}
