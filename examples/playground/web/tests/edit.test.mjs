// SPDX-License-Identifier: MIT

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { isProved, lengthOf, openForEachTest, playground } from './page.mjs';

openForEachTest();

test('the first plan is there and proved', async (context) => {
  const state = await playground.state();
  assert.ok(isProved(state));
  const { optimum } = state.replies[0]?.reply?.result ?? {};
  assert.ok(optimum && optimum.ratio >= 1 - 1e-9 && optimum.ratio < 1.01);
  context.diagnostic(`first plan ${state.firstPlan?.toFixed(0)} ms after the start of navigation`);
  await playground.screenshot('first');
});

test('a polygon across the path makes the path longer', async () => {
  const old = lengthOf(await playground.state());
  await playground.page.getByTestId('tool-polygon').click();
  const state = await playground.afterPlan(async () => {
    for (const corner of /** @type {import('./page.mjs').Point[]} */ ([
      [4, 5],
      [7, 4],
      [7.5, 2.5],
      [5, 2.5],
    ]))
      await playground.click(corner);
    await playground.page.getByRole('button', { name: 'Close polygon' }).click();
  });
  assert.ok(isProved(state));
  assert.ok(lengthOf(state) > old + 0.01, `${lengthOf(state)} is longer than ${old}`);
  await playground.screenshot('polygon');
  const undone = await playground.afterPlan(() => playground.page.getByTestId('undo').click());
  assert.equal(lengthOf(undone), old);
  const redone = await playground.afterPlan(() => playground.page.getByTestId('redo').click());
  assert.equal(lengthOf(redone), lengthOf(state));
});

test('a disc is drawn, moved and made larger', async () => {
  await playground.page.getByTestId('tool-disc').click();
  await playground.afterPlan(() => playground.drag([3, 12], [4, 12]));
  await playground.page.getByTestId('tool-select').click();
  await playground.afterPlan(() => playground.drag([3, 12.3], [4, 13.3]));
  const state = await playground.afterPlan(() => playground.drag([5, 13], [5.5, 13]));
  const { world } = state.scene;
  const disc = world.kind === 'workspace' ? world.obstacles.at(-1) : undefined;
  assert.ok(disc && 'radius' in disc);
  assert.ok(
    Math.abs(disc.radius - 1.5) < 0.1 && Math.hypot(disc.center[0] - 4, disc.center[1] - 13) < 0.1,
    JSON.stringify(disc),
  );
});

test('the path follows the goal while it is dragged', async (context) => {
  const { page } = playground;
  const old = await playground.state();
  const { x, y } = await playground.at(old.scene.goal);
  await page.mouse.move(x, y);
  await page.mouse.down();
  const ends = [];
  const frames = await page.evaluateHandle(() => {
    /** @type {number[]} */
    const times = [];
    const note = (/** @type {number} */ time) => {
      times.push(time);
      if (times.length < 600) requestAnimationFrame(note);
    };
    requestAnimationFrame(note);
    return times;
  });
  for (let i = 1; i <= 60; ++i) {
    await page.mouse.move(x - i * 2, y + i * 1.2);
    await page.waitForTimeout(15);
    const { replies } = await playground.state();
    ends.push(replies[0]?.reply?.curve?.x.at(-1));
  }
  const times = await frames.jsonValue();
  await page.mouse.up();
  assert.ok(new Set(ends).size > 10, 'the path has had many ends');
  const state = await playground.settled();
  assert.ok(isProved(state));
  assert.notDeepEqual(state.scene.goal, old.scene.goal);
  assert.notEqual(lengthOf(state), lengthOf(old));
  const steps = times
    .slice(1)
    .map((time, i) => time - (times[i] ?? 0))
    .sort((a, b) => a - b);
  const mean = steps.reduce((a, b) => a + b, 0) / steps.length;
  const { plans } = state;
  context.diagnostic(
    `frames while dragging: mean ${mean.toFixed(1)} ms, median ${steps[steps.length >> 1]?.toFixed(1)} ms, 95 % ${steps[Math.floor(steps.length * 0.95)]?.toFixed(1)} ms; ${plans - old.plans} plans`,
  );
});

test('the radius changes by its slider, down to a point', async () => {
  const slider = playground.page.getByTestId('radius');
  const wide = await playground.afterPlan(() => slider.fill('0.45'));
  assert.ok(isProved(wide));
  assert.ok((wide.replies[0]?.reply?.result.certificate?.lower ?? 0) >= 0.44);
  const narrow = await playground.afterPlan(() => slider.fill('0'));
  assert.ok(isProved(narrow));
  assert.ok(lengthOf(narrow) < lengthOf(wide));
});

test('keys alone move the goal, an obstacle and a vertex', async () => {
  const { page } = playground;
  const { scene } = await playground.state();
  for (let i = 0; i < 40; ++i) {
    await page.keyboard.press('Tab');
    if (await page.evaluate(() => document.activeElement?.id === 'map')) break;
  }
  assert.equal(await page.evaluate(() => document.activeElement?.id), 'map');
  const moved = await playground.afterPlan(async () => {
    await page.keyboard.press('g');
    await page.keyboard.press('Shift+ArrowDown');
    await page.keyboard.press('ArrowLeft');
  });
  assert.ok(moved.scene.goal[1] < scene.goal[1] - 0.5 && moved.scene.goal[0] < scene.goal[0]);
  assert.ok(isProved(moved));
  const undone = await playground.afterPlan(() => page.keyboard.press('Control+z'));
  assert.deepEqual(
    undone.scene.goal,
    scene.goal,
    'keys that follow each other are one step of the history',
  );
  await page.keyboard.press('n');
  await page.keyboard.press('n');
  const vertex = await playground.afterPlan(async () => {
    await page.keyboard.press('Enter');
    await page.keyboard.press('ArrowUp');
  });
  assert.notDeepEqual(vertex.scene.world, scene.world);
  await playground.screenshot('keyboard');
  await page.keyboard.press('?');
  assert.ok(await page.getByTestId('help-dialog').isVisible());
  await playground.screenshot('help');
});

test('keys alone draw a polygon', async () => {
  const { page } = playground;
  await page.getByTestId('map').focus();
  const state = await playground.afterPlan(async () => {
    await page.keyboard.press('o');
    for (const key of ['Enter', 'Shift+ArrowRight', 'Enter', 'Shift+ArrowUp', 'Enter', 'c'])
      await page.keyboard.press(key);
  });
  const { world } = state.scene;
  const last = world.kind === 'workspace' ? world.obstacles.at(-1) : undefined;
  assert.ok(last && 'polygon' in last && last.polygon.length === 3);
});

test('cells are painted and erased', async () => {
  const { page } = playground;
  const empty = await playground.afterPlan(() =>
    page.getByTestId('preset').selectOption('empty cells'),
  );
  assert.ok(isProved(empty));
  await page.getByTestId('tool-paint').click();
  const painted = await playground.afterPlan(() => playground.drag([7.5, 1], [7.5, 9]));
  assert.ok(isProved(painted));
  assert.ok(lengthOf(painted) > lengthOf(empty));
  await playground.screenshot('cells');
  await page.getByTestId('tool-erase').click();
  const erased = await playground.afterPlan(() => playground.drag([7.5, 3], [7.5, 8]));
  assert.ok(lengthOf(erased) < lengthOf(painted));
});
