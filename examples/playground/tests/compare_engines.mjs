// SPDX-License-Identifier: MIT
// Plans random scenes in the page's engine and in that of this machine, and compares all numbers.
//
//   node compare_engines.mjs PROGRAM FOLDER [SCENES [FIRST]]
//
// PROGRAM is tutavia-playground-engine; FOLDER holds engine.js and engine.wasm. Every search is
// planned with smoother none, every smoother with four searches. Statuses, texts and counts have to
// be equal, and all other numbers to 1e-12, relative where they are above 1. Numbers that need no
// function of the mathematical library have to be equal to the last bit. Prints the largest
// differences, and the ratio of the times.

import { nativeEngine, wasmEngine } from "./engines.mjs";
import { scene } from "./random_scenes.mjs";

const [program, folder, scenes = "500", first = "0"] = process.argv.slice(2);
if (!folder) {
  console.error(
    "usage: node compare_engines.mjs PROGRAM FOLDER [SCENES [FIRST]]",
  );
  process.exit(2);
}

const tolerance = 1e-12;
const times = new Set(["us", "search_us", "smooth_us", "certify_us"]);
const counts = new Set([
  "expanded",
  "generated",
  "distinct",
  "seed",
  "turning_points",
  "piece",
  "gear",
  "pieces",
  "left_out",
  "obstacle",
  "kinds",
]);

/** Where the first difference is, or nothing. `record(difference, path)` gets those in tolerance. */
function difference(a, b, path, key, record) {
  if (times.has(key)) return null;
  if (typeof a === "number" && typeof b === "number") {
    if (a === b) return null;
    const size = Math.abs(a - b) / Math.max(1, Math.abs(a), Math.abs(b));
    if (counts.has(key) || !(size <= tolerance))
      return `${path}: ${a} and ${b}`;
    record(size, path);
    return null;
  }
  if (
    a === null ||
    b === null ||
    typeof a !== "object" ||
    typeof b !== "object"
  ) {
    return a === b
      ? null
      : `${path}: ${JSON.stringify(a)} and ${JSON.stringify(b)}`;
  }
  const isList = Array.isArray(a);
  if (isList !== Array.isArray(b))
    return `${path}: ${typeof a} and ${typeof b}`;
  const keys = Object.keys(a);
  const others = Object.keys(b);
  if (keys.length !== others.length)
    return `${path}: ${keys.length} and ${others.length} entries`;
  for (const name of keys) {
    if (!(name in b)) return `${path}.${name}: missing`;
    const inner = isList ? path : `${path}.${name}`;
    const found = difference(
      a[name],
      b[name],
      inner,
      isList ? key : name,
      record,
    );
    if (found) return found;
  }
  return null;
}

/** What is planned on a scene. */
function requests(
  catalogue,
  { request, start, goal, start_heading, goal_heading },
  number,
) {
  const kind = request.workspace ? "on_workspace" : "on_cells";
  const ends = {
    do: "plan",
    start,
    goal,
    seed: number,
    events: 20,
    samples: 40,
    max_expansions: 20000,
  };
  const vehicle = {
    start_heading,
    goal_heading,
    vehicle: { min_turning_radius: 1, reverse: number % 3 > 0 },
  };
  const list = [];
  for (const search of catalogue.searches.filter((one) => one[kind])) {
    const headings = search.for_vehicles ? vehicle : {};
    list.push({ ...ends, ...headings, search: search.name, smoother: "none" });
  }
  for (const smoother of catalogue.smoothers.filter((one) => one[kind])) {
    const searches = ["auto", "astar", "theta_star", "rrt_connect"];
    for (const search of smoother.for_vehicles ? [] : searches) {
      list.push({ ...ends, search, smoother: smoother.name });
    }
    if (smoother.for_vehicles) {
      list.push({
        ...ends,
        ...vehicle,
        search: "hybrid_astar",
        smoother: smoother.name,
      });
    }
  }
  return list;
}

const wasm = await wasmEngine(folder);
const native = nativeEngine(program);
const catalogue = (await wasm({ do: "catalogue" })).json;
const largest = new Map(); // by number, the largest difference and who made it
let plans = 0;
let successes = 0;
let differing = 0;
let wasmTime = 0;
let nativeTime = 0;
const last = Number(first) + Number(scenes);
for (let number = Number(first); number < last; ++number) {
  if (process.stderr.isTTY)
    process.stderr.write(`\rscene ${number} of ${last}`);
  const world = scene(number);
  const set = [
    await wasm(world.request, world.bytes),
    await native(world.request, world.bytes),
  ];
  if (JSON.stringify(set[0].json) !== JSON.stringify(set[1].json)) {
    throw new Error(
      `scene ${number}: ${JSON.stringify(set.map((one) => one.json))}`,
    );
  }
  for (const request of requests(catalogue, world, number)) {
    const [a, b] = [(await wasm(request)).json, (await native(request)).json];
    ++plans;
    if (a.result?.status === "success") ++successes;
    const time = ({ result }) =>
      result
        ? result.stats.search_us +
          result.stats.smooth_us +
          result.stats.certify_us
        : 0;
    wasmTime += time(a);
    nativeTime += time(b);
    const who = `${request.search}, ${request.smoother}`;
    const record = (size, path) => {
      if (!(size <= (largest.get(path)?.size ?? 0)))
        largest.set(path, { size, who, number });
    };
    const found = difference(a, b, "", "", record);
    if (!found) continue;
    if (++differing <= 20) console.log(`scene ${number}: ${who}: ${found}`);
  }
}
if (process.stderr.isTTY) process.stderr.write("\n");
native.close();
for (const [path, { size, who, number }] of [...largest].sort(
  (a, b) => b[1].size - a[1].size,
)) {
  console.log(`${size.toExponential(1)}  ${path}  (scene ${number}: ${who})`);
}
console.log(
  `${scenes} scenes from ${first} on, ${plans} plans, ${successes} of them found a path: ` +
    `${differing} differ; time in the page / on this machine ${(wasmTime / nativeTime).toFixed(2)}`,
);
process.exit(differing === 0 ? 0 : 1);
