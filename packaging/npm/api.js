// Turns films of the library into solutions and sweeps, by the names of outputs, links and joints.

let library = null;
let answer = null;

/** The data with which pages draw and move a mechanism. */
export async function film(scene, values = {}, seen = undefined) {
  const text = typeof scene === "string" ? scene : JSON.stringify(scene);
  const settings = Object.entries(values).map(([name, value]) => `${name}=${value}`);
  library ??= WebAssembly.compile(moduleOf(packedModule));
  let told;
  try {
    answer ??= await startedLibrary(await library);
    told = answer(seen === undefined ? { text, settings } : { text, settings, seen });
  } catch (error) {
    answer = null;  // a module that stopped in the middle cannot go on
    throw new Error(`the solver stopped: ${error.message}`);
  }
  if (told.film === undefined) {
    throw new Error(told.obstacle);
  }
  return told.film;
}

/** Columns of rows that hold `width` numbers for each of some names, `size` numbers from `first` on. */
function columnsOf(rows, steps, names, width, parts, extra = 0) {
  const all = width * names.length + extra;
  const columns = {};
  names.forEach((name, place) => {
    columns[name] = {};
    for (const [part, first, size] of parts) {
      const numbers = new Float64Array(steps * size);
      for (let step = 0; step < steps; ++step) {
        for (let number = 0; number < size; ++number) {
          numbers[step * size + number] = rows[step * all + place * width + first + number];
        }
      }
      columns[name][part] = numbers;
    }
  });
  return columns;
}

const OUTPUT = [["position", 0, 2], ["velocity", 2, 2], ["acceleration", 4, 2]];
const LINK = [["theta", 0, 1], ["omega", 1, 1], ["alpha", 2, 1]];

/** The rows of a branch by names. */
function namedRows(made, branch) {
  const names = made.efforts.concat(made.forces.map(({ joint, link }) => `${joint}.${link}`));
  const forces = { efforts: {}, forces: {} };
  const width = made.efforts.length + 2 * made.forces.length;
  names.forEach((name, place) => {
    const isEffort = place < made.efforts.length;
    const size = isEffort ? 1 : 2;
    const first = isEffort ? place : 2 * place - made.efforts.length;
    const numbers = new Float64Array(made.count * size);
    for (let step = 0; step < made.count; ++step) {
      for (let number = 0; number < size; ++number) {
        numbers[step * size + number] = branch.forces[step * width + first + number];
      }
    }
    forces[isEffort ? "efforts" : "forces"][name] = numbers;
  });
  const transmissions = columnsOf(branch.transmissions, made.count, made.transmissions, 1, [["angle", 0, 1]]);
  return {
    outputs: columnsOf(branch.outputs, made.count, made.outputs, 6, OUTPUT),
    links: columnsOf(branch.angles, made.count, made.links, 3, LINK),
    transmissionAngles: Object.fromEntries(
      Object.entries(transmissions).map(([name, { angle }]) => [name, angle])),
    ...forces,
  };
}

/** The numbers of one step: arrays of one number become that number. */
function atOneStep(part) {
  if (part instanceof Float64Array) {
    return part.length === 1 ? part[0] : Array.from(part);
  }
  return Object.fromEntries(Object.entries(part).map(([name, inner]) => [name, atOneStep(inner)]));
}

/** The configurations of a scene: of more than 24 the first ones, and the nearest. */
export async function solve(scene, values = {}) {
  const { sweep: _, ...still } = typeof scene === "string" ? JSON.parse(scene) : scene;
  let made;
  try {
    made = await film(still, values);
  } catch (error) {
    const [, reason] = /there is nothing to draw: no-assembly: (.*)/s.exec(error.message) ?? [];
    if (reason === undefined) {
      throw error;
    }
    return { status: "no-assembly", reason, configurations: [], leftOut: 0, nearest: null };
  }
  const configurations = made.branches.map(
    (branch) => ({ number: branch.number, ...atOneStep(namedRows(made, branch)) }));
  return { status: "ok", reason: "", configurations, leftOut: made.left_out, nearest: made.nearest };
}

/** The branches of a scene's sweep, step by step. */
export async function sweep(scene, values = {}) {
  const made = await film(scene, values);
  if (made.parameter === "") {
    throw new Error("scene: it has no sweep; add one, such as " +
      "\"sweep\": {\"parameter\": \"phi\", \"from\": 0, \"to\": \"2*pi\", \"count\": 361}");
  }
  const steps = Float64Array.from({ length: made.count }, (_, step) =>
    (made.count === 1 ? made.from : made.from + (made.to - made.from) * (step / (made.count - 1))));
  return {
    parameter: made.parameter,
    values: steps,
    branches: made.branches.map((branch) => ({ number: branch.number, ...namedRows(made, branch) })),
    leftOut: made.left_out,
    events: made.events,
    nearest: made.nearest,
  };
}
