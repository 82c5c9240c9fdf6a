// SPDX-License-Identifier: MIT
// Random scenes of polygons and discs, and of cells. A scene follows from its number alone.

/** Numbers from 0 to 1, by mulberry32 of Tommy Ettinger (public domain). */
function generator(seed) {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = state;
    t = Math.imul(t ^ (t >>> 15), t | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  };
}

/** Multiples of 1/64, which JSON and doubles hold exactly. */
const rounded = (value) => Math.round(64 * value) / 64;

function star(random, x, y, size) {
  const corners = 3 + Math.floor(6 * random());
  const polygon = [];
  for (let i = 0; i < corners; ++i) {
    const angle = ((i + 0.8 * random()) / corners) * 2 * Math.PI;
    const radius = size * (0.4 + 0.6 * random());
    polygon.push([
      rounded(x + radius * Math.cos(angle)),
      rounded(y + radius * Math.sin(angle)),
    ]);
  }
  return { polygon };
}

function workspace(random) {
  const obstacles = [];
  const count = 2 + Math.floor(9 * random());
  for (let i = 0; i < count; ++i) {
    const x = 2 + 16 * random();
    const y = 2 + 16 * random();
    const size = 0.5 + 2 * random();
    obstacles.push(
      random() < 0.3
        ? { center: [rounded(x), rounded(y)], radius: rounded(size) }
        : star(random, x, y, size),
    );
  }
  const end = () => [
    rounded(0.5 + 19 * random()),
    rounded(0.5 + 19 * random()),
  ];
  return {
    request: {
      do: "scene",
      workspace: {
        bounds: [0, 0, 20, 20],
        safety_radius: rounded(0.05 + 0.45 * random()),
        resolution: 0.25,
        obstacles,
      },
    },
    start: end(),
    goal: end(),
  };
}

function cells(random) {
  const width = 16 + Math.floor(32 * random());
  const height = 16 + Math.floor(32 * random());
  const density = 0.1 + 0.25 * random();
  const bytes = new Uint8Array(width * height).map(() =>
    random() < density ? 0 : 1,
  );
  const end = () => {
    for (;;) {
      const x = Math.floor(width * random());
      const y = Math.floor(height * random());
      if (bytes[y * width + x]) return [x + 0.5, y + 0.5];
    }
  };
  return {
    request: {
      do: "scene",
      cells: {
        width,
        height,
        resolution: 1,
        origin: [0, 0],
        safety_radius: random() < 0.5 ? 0 : rounded(0.1 + 0.35 * random()),
      },
    },
    bytes,
    start: end(),
    goal: end(),
  };
}

/** The scene of a number: its request, the cells' bytes, start, goal and headings. */
export function scene(number) {
  const random = generator(number);
  const made = number % 2 === 0 ? workspace(random) : cells(random);
  const heading = () => rounded(2 * Math.PI * random());
  return {
    bytes: new Uint8Array(),
    ...made,
    start_heading: heading(),
    goal_heading: heading(),
  };
}
