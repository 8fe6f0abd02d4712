// A program that uses every function and type of the package, for a compiler in its strict mode; each
// line after @ts-expect-error must not compile.
import { solve, sweep, film } from "assur";
import type { Branch, Configuration, Event, Film, Scene, SeenPose, Shape, Solution, Sweep, Values } from "assur";

const scene: Scene = {
  points: { A: [0, 0], B: [0, 0.04], C: [0.08, 0.1], D: [0.08, 0], P: [0.16, 0.16] },
  links: { ground: ["A", "D"], crank: ["A", "B"], coupler: ["B", "C", "P"], rocker: ["D", "C"] },
  parameters: { phi: { drawn: "A" } },
  drivers: { A: { position: "phi", velocity: 10 } },
  outputs: ["P"],
  sweep: { parameter: "phi", from: "phi", to: "phi + 2*pi", count: 25 },
};
const values: Values = { phi: "90*deg" };

const solution: Solution = await solve(scene, values);
const places: number[] = solution.configurations.map((one: Configuration) => one.outputs["P"].position[0]);
const nearest: number = solution.nearest ?? 0;
const reason: string = solution.status === "ok" ? solution.configurations[0].number.toFixed() : solution.reason;

const swept: Sweep = await sweep(JSON.stringify(scene));
const branch: Branch = swept.branches[0];
const along: Float64Array = branch.outputs["P"].velocity;
const angle: number = branch.transmissionAngles["C"][0] + branch.links["coupler"].theta[0];
const events: string[] = swept.events.map((one: Event) => one.event);

const seen: SeenPose = { part: 0, points: [] };
const made: Film = await film(scene);
const again: Film = await film(scene, {}, { ...seen, points: Array.from(made.branches[0].points.slice(0, 2 * made.points)) });
const shape: Shape = again.shapes[0];

// @ts-expect-error a status is one of two words
const status: "solved" = solution.status;
// @ts-expect-error values are numbers or expressions
const wrong = solve(scene, { phi: true });
// @ts-expect-error a scene is needed
const without = sweep();
// @ts-expect-error there may be no nearest configuration
const certain: number = swept.nearest;
// @ts-expect-error a branch has arrays, a configuration has numbers
const one: number = branch.efforts["A"];
wrong.catch(() => {});
without.catch(() => {});
console.log([places.length, nearest, reason, along.length === 2 * swept.values.length, Number.isFinite(angle),
  events.length, shape.points.length > 0, status, certain, one].length, places.length, nearest);
