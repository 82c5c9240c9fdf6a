// SPDX-License-Identifier: MIT

import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { test } from 'node:test';
import { isProved, openForEachTest, playground, testData, reads } from './page.mjs';

openForEachTest();

const square = '[[4, 4], [6, 4], [6, 6], [4, 6]]';
const octile = [
  'type octile',
  'height 4',
  'width 6',
  'map',
  '......',
  '.@@@..',
  '.@....',
  '......',
  '',
].join('\n');

/** One small file of every kind that stands alone. */
const files = [
  {
    name: 'scene.json',
    content: `{"bounds": [0, 0, 10, 10], "safety_radius": 0.2, "start": [1, 5], "goals": [[9, 5]], "obstacles": [{"polygon": ${square}}]}`,
  },
  {
    name: 'walls.geojson',
    content: `{"type": "Polygon", "coordinates": [[[4, 4], [6, 4], [6, 6], [4, 6], [4, 4]]]}`,
  },
  {
    name: 'walls.wkt',
    content: 'POLYGON ((4 4, 6 4, 6 6, 4 6, 4 4))\nPOLYGON ((8 1, 9 1, 9 2, 8 1))\n',
  },
  { name: 'walls.csv', content: 'id,wkt\n1,"POLYGON ((4 4, 6 4, 6 6, 4 6, 4 4))"\n' },
  { name: 'rooms.map', content: octile },
];

for (const file of files) {
  test(`opens ${file.name}`, async () => {
    const state = await playground.afterPlan(() => playground.openFiles([file]));
    assert.equal(state.scene.world.kind, file.name.endsWith('.map') ? 'cells' : 'workspace');
    assert.ok(
      isProved(state),
      JSON.stringify(state.replies[0]?.error ?? state.replies[0]?.reply?.result.status),
    );
    if (state.scene.world.kind === 'workspace') assert.ok(state.scene.world.obstacles.length > 0);
    await playground.screenshot(`file-${file.name}`);
  });
}

test('opens a .map with its scenarios', async () => {
  const scen =
    'version 1\n0\trooms.map\t6\t4\t0\t0\t5\t3\t6.24264069\n1\trooms.map\t6\t4\t0\t3\t5\t0\t6.24264069\n';
  const last = await playground.afterPlan(() =>
    playground.openFiles([
      { name: 'rooms.map', content: octile },
      { name: 'rooms.map.scen', content: scen },
    ]),
  );
  assert.ok(isProved(last));
  const scenario = playground.page.getByTestId('scenario');
  assert.equal(await scenario.inputValue(), '2');
  const first = await playground.afterPlan(async () => {
    await scenario.fill('1');
    await scenario.press('Enter');
  });
  assert.notDeepEqual(first.scene.start, last.scene.start);
  assert.ok(isProved(first));
});

test('opens a ROS map from its YAML file and its image', async () => {
  const read = async (/** @type {string} */ name) => ({
    name,
    content: await readFile(join(testData, 'ros_map', name)),
  });
  const state = await playground.afterPlan(async () =>
    playground.openFiles([await read('rooms.yaml'), await read('rooms.pgm')]),
  );
  const { world } = state.scene;
  assert.ok(world.kind === 'cells');
  assert.deepEqual(world.origin, [-2.2, -1.4]);
  assert.ok(isProved(state));
  await playground.screenshot('file-ros');
});

test('opens a ROS map whose rows are turned', async () => {
  const yaml =
    'image: map.pgm\nresolution: 0.5\norigin: [3, -2, 0.7]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n';
  const pgm = `P2\n6 4\n255\n${['254 254 254 254 254 254', '254 0 0 0 254 254', '254 0 254 254 254 254', '254 254 254 254 254 254'].join('\n')}\n`;
  const state = await playground.afterPlan(() =>
    playground.openFiles([
      { name: 'map.yaml', content: yaml },
      { name: 'map.pgm', content: pgm },
    ]),
  );
  assert.ok(isProved(state));
  await playground.screenshot('file-ros-turned');
});

const broken = [
  {
    files: [{ name: 'broken.json', content: '{"bounds": [0, 0, 10, 10], "obstacles": [' }],
    message: /broken\.json/,
  },
  {
    files: [{ name: 'broken.wkt', content: 'POLYGON ((4 4, 6 4, 6 x, 4 6))' }],
    message: /broken\.wkt/,
  },
  {
    files: [{ name: 'broken.map', content: 'type octile\nheight 2\nwidth 3\nmap\n...\n..\n' }],
    message: /broken\.map/,
  },
  {
    files: [{ name: 'map.yaml', content: 'image: map.pgm\nresolution: [\n' }],
    message: /map\.yaml: line 3/,
  },
  {
    files: [{ name: 'map.yaml', content: 'image: map.pgm\nresolution: 0.1\norigin: [0, 0, 0]\n' }],
    message: /map\.pgm together/,
  },
  { files: [{ name: 'notes.txt', content: 'hello' }], message: /notes\.txt/ },
];

for (const { files: wrong, message } of broken) {
  test(`says what is wrong with ${wrong[0]?.name}: ${message}`, async () => {
    const { scene } = await playground.state();
    await playground.openFiles(wrong);
    await reads(playground.page, 'notice', message);
    assert.deepEqual((await playground.state()).scene, scene, 'the old map stays');
    if (wrong[0]?.name === 'broken.json') await playground.screenshot('file-broken');
  });
}

test('opens files that are dropped on it', async () => {
  const state = await playground.afterPlan(() =>
    playground.page.evaluate((text) => {
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File([text], 'dropped.wkt'));
      window.dispatchEvent(
        new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }),
      );
    }, 'POLYGON ((4 4, 6 4, 6 6, 4 6, 4 4))'),
  );
  assert.equal(state.scene.name, 'dropped');
  assert.ok(isProved(state));
});

test('every preset has a plan', async () => {
  const { page } = playground;
  const ids = await page
    .getByTestId('preset')
    .locator('option')
    .evaluateAll((options) =>
      options.map((option) => /** @type {HTMLOptionElement} */ (option).value),
    );
  for (const id of ids.filter((each) => each !== 'maze')) {
    const state = await playground.afterPlan(() => page.getByTestId('preset').selectOption(id));
    const { reply, error } = state.replies[0] ?? {};
    assert.equal(reply?.result.status, 'success', `${id}: ${error ?? reply?.result.detail}`);
    assert.ok(isProved(state), id);
    if (
      [
        'parking',
        'complex',
        'rrt_scene_2',
        'ros',
        'arena2.map',
        'den520d.map',
        '32room_000.map',
        'Improved REA*, map A',
        'JPS_Theta*',
      ].includes(id)
    )
      await playground.screenshot(`preset-${id.replace(/\W+/g, '_')}`);
  }
});
