// Law: the package, installed from its tarball, tells what the command tells: configurations, branches,
// events and errors.
// node package_test.mjs FOLDER ASSUR SOURCE
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

const [folder, assur, source] = process.argv.slice(2);
const project = join(folder, "project");
rmSync(project, { recursive: true, force: true });
const modules = join(project, "node_modules");
mkdirSync(modules, { recursive: true });
const tarball = readdirSync(folder).find((name) => name.endsWith(".tgz"));
execFileSync("tar", ["xzf", join(folder, tarball), "-C", modules]);
execFileSync("mv", [join(modules, "package"), join(modules, "assur")]);
const packed = JSON.parse(readFileSync(join(modules, "assur/package.json"), "utf8"));
assert.equal(`assur-${packed.version}.tgz`, tarball);
const { solve, sweep, film } = await import(pathToFileURL(join(modules, "assur/index.js")));

const command = (...words) => spawnSync(assur, words, { encoding: "utf8" });
let largest = 0;
const near = (told, expected, what) => {
  const away = Math.abs(told - expected) / Math.max(1, Math.abs(expected));
  largest = Math.max(largest, away);
  assert.ok(away < 1e-9, `${what}: ${told}, not ${expected}`);
};

for (const name of ["four_bar_coupler_curve", "watt_six_bar", "jansen_leg", "rack_press", "excavator_arm"]) {
  const file = join(source, "examples", `${name}.json`);
  const text = readFileSync(file, "utf8");
  const expected = JSON.parse(command("solve", file, "--format", "json").stdout);
  for (const scene of [text, JSON.parse(text)]) {
    const { status, configurations } = await solve(scene);
    assert.equal(status, "ok");
    assert.equal(configurations.length, expected.configurations.length, name);
    configurations.forEach((one, place) => {
      const other = expected.configurations[place];
      assert.equal(one.number, place + 1);
      for (const [output, state] of Object.entries(other.outputs ?? {})) {
        for (const part of ["position", "velocity", "acceleration"].filter((key) => state[key])) {
          state[part].forEach((number, at) => near(one.outputs[output][part][at], number, `${name} ${output}`));
        }
      }
      for (const [link, state] of Object.entries(other.links)) {
        if (link in one.links) {
          near(Math.cos(one.links[link].theta - state.theta), 1, `${name} ${link}`);
        }
      }
    });
  }
}

// Branches are those of the command's table; its steps are among those of the package.
const file = join(source, "examples/four_bar_coupler_curve.json");
const scene = JSON.parse(readFileSync(file, "utf8"));
const swept = await sweep(scene, { crank: "76/2" });
assert.equal(swept.parameter, "phi");
const [head, ...rows] = command("solve", file, "--set", "crank=38", "--format", "csv").stdout.trim().split("\n");
const column = (name) => head.split(",").indexOf(name);
let compared = 0;
for (const row of rows.map((line) => line.split(","))) {
  const value = Number(row[column("phi")]);
  const step = swept.values.findIndex((one) => Math.abs(one - value) < 1e-12);
  assert.ok(step >= 0, `phi = ${value}`);
  const branch = swept.branches.find(({ number }) => number === Number(row[column("branch")]));
  near(branch.outputs.P.position[2 * step], Number(row[column("P.x")]), "P.x");
  near(branch.outputs.P.velocity[2 * step + 1], Number(row[column("P.vy")]), "P.vy");
  near(branch.links.rocker.omega[step], Number(row[column("rocker.omega")]), "rocker.omega");
  compared += 1;
}
assert.ok(compared > 300);

// A crank that cannot turn: two folds, and nothing beyond.
const stopped = await sweep(scene, { crank: 150 });
assert.ok(stopped.events.some(({ event }) => event === "fold"));
assert.equal((await solve(scene, { coupler: 20 })).status, "no-assembly");

// Errors are the lines of the command.
const bad = join(project, "scene");
for (const change of [{ joints: undefined }, { drivers: { Z: { position: 1 } } }, { want: ["speed"] }]) {
  writeFileSync(bad, JSON.stringify({ ...scene, ...change }));
  const line = spawnSync(assur, ["solve", "scene"], { cwd: project, encoding: "utf8" }).stderr.trim();
  await assert.rejects(solve({ ...scene, ...change }), { message: line.replace(/^error: /, "") });
}
await assert.rejects(sweep({ ...scene, sweep: undefined }), /it has no sweep/);
await assert.rejects(solve(scene, { crank: "cranc" }));
assert.equal((await solve(scene)).configurations.length, 2);  // goes on after errors

// Five four-bars side by side have 32 configurations and branches: 24 are listed, the rest is counted.
const many = { points: {}, links: { ground: [] }, parameters: { phi: { drawn: "A0" } }, drivers: {}, outputs: [],
  sweep: { parameter: "phi", from: "phi - 0.1", to: "phi + 0.1", count: 3 } };
for (let place = 0; place < 5; ++place) {
  const x = 20 * place;
  const [A, B, C, D] = ["A", "B", "C", "D"].map((letter) => letter + place);
  Object.assign(many.points, { [A]: [x, 0], [B]: [x, 3], [C]: [x + 6, 6], [D]: [x + 7, 0] });
  many.links.ground.push(A, D);
  Object.assign(many.links, { [`crank${place}`]: [A, B], [`rod${place}`]: [B, C], [`rocker${place}`]: [D, C] });
  many.drivers[A] = { velocity: 1 };
  many.outputs.push(C);
}
many.drivers.A0.position = "phi";
writeFileSync(bad, JSON.stringify(many));
const all = JSON.parse(command("solve", bad, "--format", "json").stdout).configurations;
const listed = await solve(many);
assert.deepEqual([all.length, listed.configurations.length, listed.leftOut], [32, 24, 8]);
for (const { number, outputs } of listed.configurations) {
  near(outputs.C4.position[0], all[number - 1].outputs.C4.position[0], "C4.x");
}
assert.ok(listed.configurations.some(({ number }) => number === listed.nearest));
const branches = await sweep(many);
assert.deepEqual([branches.branches.length, branches.leftOut], [24, 8]);

// A press with forces: efforts and forces have their names.
const loaded = JSON.parse(readFileSync(join(source, "docs/tutorial/four_bar_loaded.json"), "utf8"));
const [drawn] = (await solve(loaded)).configurations.slice(1);
near(drawn.efforts.A, 0.0756, "the effort of the crank");

const made = await film(scene);
assert.ok(made.shapes.length > 3 && made.branches[0].points.length === made.count * made.points * 2);

// The types name what is there.
const types = readFileSync(join(modules, "assur/index.d.ts"), "utf8");
for (const name of ["solve", "sweep", "film"]) {
  assert.match(types, new RegExp(`export function ${name}\\(`));
}
const declared = (name) => [...types.split(`export interface ${name} {`)[1].split("\n}")[0]
  .matchAll(/^ {2}(\w+):/gm)].map((found) => found[1]).sort();
assert.deepEqual(declared("Configuration"), Object.keys(drawn).sort());
assert.deepEqual(declared("Solution"), Object.keys(await solve(scene)).sort());
assert.deepEqual(declared("Sweep"), Object.keys(swept).sort());
assert.deepEqual(declared("Branch"), Object.keys(swept.branches[0]).sort());
assert.ok(declared("Film").every((name) => name in made));

// The lines of the README run.
const lines = readFileSync(join(modules, "assur/README.md"), "utf8").match(/```js\n(.*?)```/s)[1];
writeFileSync(join(project, "readme.mjs"), `${lines}\nconsole.log(solution.configurations.length, swept.branches.length);\n`);
const said = execFileSync(process.execPath, [join(project, "readme.mjs")], { encoding: "utf8" });
assert.match(said, /^2 \d+\n$/);
console.log(`${compared} rows of a sweep; largest difference ${largest.toExponential(1)}`);
