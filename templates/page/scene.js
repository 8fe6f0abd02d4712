// Turns the text of a scene file, and what the reader changes in it, into questions for the solver
// and into a new scene file.

/** The value of a setting or a coordinate: a number where the text is one. */
function numberOrFormula(text) {
  const isNumber = typeof text === "number" || (text.trim() !== "" && Number.isFinite(Number(text)));
  return isNumber ? Number(text) : text;
}

/** JSON as people write it: what fits into a line is one line. */
function prettyJson(value, indent = "", before = 0) {
  const inLine = (one) => {
    if (one === null || typeof one !== "object") {
      return JSON.stringify(one);
    }
    return Array.isArray(one) ? `[${one.map(inLine).join(", ")}]`
      : `{${Object.entries(one).map(([key, part]) => `${JSON.stringify(key)}: ${inLine(part)}`).join(", ")}}`;
  };
  const line = inLine(value);
  const isScene = indent === "";
  if (value === null || typeof value !== "object" || (!isScene && before + line.length <= 100)) {
    return line;
  }
  const inner = `${indent}  `;
  const parts = Array.isArray(value)
    ? value.map((part) => inner + prettyJson(part, inner, inner.length))
    : Object.entries(value).map(([key, part]) => {
      const start = `${inner}${JSON.stringify(key)}: `;
      return start + prettyJson(part, inner, start.length);
    });
  const [open, close] = Array.isArray(value) ? "[]" : "{}";
  return `${open}\n${parts.join(",\n")}\n${indent}${close}`;
}

/** A scene and the reader's changes. `json` is null where the file is not plain JSON; such a scene
 * has sliders, but its drawing cannot be edited. */
class Scene {
  constructor({ text, settings }) {
    [this.text, this.settings] = [text, settings];
    this.changed = new Map();  // the values that the reader has set, by the names of parameters
    this.isEdited = false;
    this.isSolved = false;
    this.turns = true;     // whether a scene without a sweep may get one
    this.helpers = null;   // the parameters that it gets with it
    try {
      this.json = JSON.parse(text);
      if (settings.length > 0) {
        this.json = this.withValues(settings.map((setting) => {
          const equals = setting.indexOf("=");
          return [setting.slice(0, equals), numberOrFormula(setting.slice(equals + 1))];
        }));
      }
    } catch {
      this.json = null;
    }
    this.original = JSON.stringify(this.json);
  }

  get isDrawn() {
    return Object.values(this.json?.links ?? {}).some(Array.isArray);
  }

  /** Whether a parameter is the angle of a driver. */
  isAngle(name) {
    const isTurned = ([joint, { position }]) => position === name &&
      (this.json.joints?.[joint]?.type ?? "revolute") === "revolute";
    return this.helpers?.[0] === name || Object.entries(this.json?.drivers ?? {}).some(isTurned);
  }

  /** A copy of the scene with values in place of those of parameters. */
  withValues(values) {
    const json = structuredClone(this.json);
    for (const [name, value] of values) {
      const parameter = json.parameters?.[name];
      if (parameter === null || typeof parameter !== "object") {
        json.parameters[name] = value;
        continue;
      }
      parameter.value = value;
      if (typeof parameter.drawn === "string") {
        delete parameter.drawn;
      }
    }
    return json;
  }

  /** Whether a parameter has the value that the drawing gives it. */
  isAsDrawn(name) {
    const parameter = this.json?.parameters?.[name];
    return parameter !== null && typeof parameter === "object" && "drawn" in parameter &&
      !("value" in parameter) && !this.changed.has(name);
  }

  /** What the solver is asked, without a sweep where only the drawn pose is wanted. */
  question(wantsSweep) {
    const settings = [...this.changed].map(([name, value]) => `${name}=${value}`);
    if (this.json === null) {
      return { text: this.text, settings: [...this.settings, ...settings] };
    }
    let json = this.json;
    if (!wantsSweep) {
      json = { ...json };
      delete json.sweep;
    } else if (!json.sweep && this.turns) {
      json = this.turning() ?? json;
    }
    const isOwn = json === this.json && !this.isEdited;
    return isOwn ? { text: this.text, settings: [...this.settings, ...settings] }
      : { text: JSON.stringify(json), settings };
  }

  /** The scene with a whole turn of its first driver for a sweep; null if that is no revolute joint. */
  turning() {
    const driver = Object.keys(this.json.drivers ?? {})[0];
    const type = this.json.joints?.[driver]?.type ?? "revolute";
    if (driver === undefined || type !== "revolute") {
      return null;
    }
    const json = structuredClone(this.json);
    const free = (name) => (name in (json.parameters ?? {}) ? free(`${name}_`) : name);
    const [turn, begin] = [free("turn"), free("as_drawn")];
    json.parameters = { ...json.parameters, [turn]: 0 };
    const { position } = json.drivers[driver];
    if (position === undefined) {
      json.parameters[begin] = { drawn: driver };
    }
    json.drivers[driver].position = `(${position ?? begin}) + ${turn}`;
    json.sweep = { parameter: turn, from: 0, to: "2*pi", count: 181 };
    this.helpers = [turn, begin];
    return json;
  }

  /** The scene file as it stands. */
  written() {
    return this.json === null ? this.text : `${prettyJson(this.withValues(this.changed))}\n`;
  }

  /** How a coordinate of a drawn point can be changed: as a number, through a parameter, or not. */
  handle(point, axis) {
    const given = numberOrFormula(this.json.points[point][axis]);
    if (typeof given === "number") {
      return { kind: "number" };
    }
    const parameter = this.json.parameters?.[given.trim()];
    const value = parameter !== null && typeof parameter === "object" ? parameter.value : parameter;
    const isValue = value !== undefined && typeof numberOrFormula(value) === "number";
    return isValue ? { kind: "parameter", name: given.trim() } : { kind: "formula" };
  }

  /** Moves a drawn point, as far as its coordinates are not formulas. */
  movePoint(point, place) {
    place.forEach((value, axis) => {
      const handle = this.handle(point, axis);
      if (handle.kind === "number") {
        this.json.points[point][axis] = value;
        this.isEdited = true;
      } else if (handle.kind === "parameter") {
        this.changed.set(handle.name, value);
      }
    });
  }

  /** The distances of a drawn point from the others of its links, by the places of points. */
  lengthsAt(point, places) {
    const lengths = new Map();
    for (const list of Object.values(this.json.links ?? {})) {
      if (!Array.isArray(list) || !list.includes(point)) {
        continue;
      }
      for (const other of list.filter((one) => one !== point && places.has(one))) {
        const names = [point, other];
        const [here, there] = names.map((name) => places.get(name));
        const fixed = this.fixedLength(names);
        lengths.set(`${point}${other}`, {
          name: `${point}${other}`,
          length: fixed ?? Math.hypot(there[0] - here[0], there[1] - here[1]),
          isFixed: fixed !== null,
        });
      }
    }
    return [...lengths.values()];
  }

  /** The value of the parameter that sets the distance of two points, whatever the drawing says. */
  fixedLength(names) {
    const isPair = (pair) => Array.isArray(pair) && pair.length === 2 &&
      names.every((name) => pair.includes(name));
    for (const [name, parameter] of Object.entries(this.json.parameters ?? {})) {
      const drawn = parameter?.drawn;
      if (isPair(drawn) || (Array.isArray(drawn) && drawn.some(isPair))) {
        const value = this.changed.get(name) ?? parameter.value;
        return value === undefined || typeof numberOrFormula(value) !== "number" ? null : Number(value);
      }
    }
    return null;
  }

  /** What `restore` takes to undo later changes. */
  remembered() {
    return { json: JSON.stringify(this.json), changed: [...this.changed], isEdited: this.isEdited };
  }

  restore({ json, changed, isEdited }) {
    this.json = JSON.parse(json);
    this.changed = new Map(changed);
    this.isEdited = isEdited;
  }

  /** Takes all changes back. */
  reset() {
    this.restore({ json: this.original, changed: [], isEdited: false });
  }
}
