// SPDX-License-Identifier: MIT

import assert from 'node:assert/strict';
import { mkdir, readFile, writeFile } from 'node:fs/promises';
import { dirname } from 'node:path';
import { after, before, test } from 'node:test';
import { isProved, launch, lengthOf, Playground, reads } from './page.mjs';

/** @type {import('playwright-core').Browser} */
let browser;

before(async () => {
  browser = await launch();
});
after(() => browser.close());

/**
 * @param {Playground} playground
 * @param {string} testId
 */
async function downloaded({ page }, testId) {
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.getByTestId(testId).click(),
  ]);
  return { name: download.suggestedFilename(), content: await readFile(await download.path()) };
}

/** @param {Playground} playground */
async function closed(playground) {
  await playground.close();
  assert.deepEqual(playground.errors, [], 'no errors on the console');
}

test('a scene is shared by its address', async () => {
  const playground = await Playground.open(browser);
  const { page } = playground;
  await playground.afterPlan(() => page.getByTestId('radius').fill('0.4'));
  await playground.afterPlan(() =>
    page.getByTestId('smoother').first().selectOption('taut_string'),
  );
  const state = await playground.afterPlan(() => playground.drag([14.5, 14.5], [13.5, 13]));
  await page.getByTestId('share').click();
  const url = await page.getByTestId('link').inputValue();
  assert.match(url, /#s=[\w-]+$/);
  const again = await Playground.open(browser, {}, url);
  const restored = await again.state();
  assert.deepEqual(restored.scene, state.scene);
  assert.equal(lengthOf(restored), lengthOf(state));
  await closed(again);
  const broken = await Playground.open(browser, {}, url.slice(0, -30));
  await reads(broken.page, 'notice', /damaged/);
  await closed(broken);
  await closed(playground);
});

test('cells are shared by the address, too', async () => {
  const playground = await Playground.open(browser);
  const state = await playground.afterPlan(() =>
    playground.page.getByTestId('preset').selectOption('Improved REA*, map B'),
  );
  await playground.page.getByTestId('share').click();
  const again = await Playground.open(
    browser,
    {},
    await playground.page.getByTestId('link').inputValue(),
  );
  assert.deepEqual((await again.state()).scene, state.scene);
  await closed(again);
  await closed(playground);
});

test('scene, results and pictures are saved', async () => {
  const playground = await Playground.open(browser);
  const { page } = playground;
  await playground.afterPlan(() => page.getByTestId('add-planner').click());
  const state = await playground.afterPlan(() =>
    page.getByTestId('smoother').nth(1).selectOption('taut_string'),
  );
  const results = await downloaded(playground, 'export-json');
  const scene = await downloaded(playground, 'export-scene');
  const file = JSON.parse(results.content.toString());
  assert.equal(file.tutavia, 1);
  assert.equal(file.results.length, 2);
  assert.equal(file.results[0].certificate.status, 'proved');
  assert.deepEqual(
    file.results.map((/** @type {unknown} */ result) => result),
    state.replies.map(({ reply }) => reply?.result),
  );
  const reopened = await playground.afterPlan(() =>
    playground.openFiles([{ name: scene.name, content: scene.content }]),
  );
  assert.deepEqual(reopened.scene.world, state.scene.world);
  const { TUTAVIA_PLAYGROUND_EXPORT: path } = process.env;
  if (path) {
    await mkdir(dirname(path), { recursive: true });
    await writeFile(path, results.content);
    await writeFile(path.replace(/(\.json)?$/, '.scene.json'), scene.content);
  }
  const svg = await downloaded(playground, 'export-svg');
  assert.match(svg.content.toString(), /^\s*(<\?xml.*\?>\s*)?<svg/);
  const png = await downloaded(playground, 'export-png');
  assert.equal(png.content.subarray(1, 4).toString(), 'PNG');
  await closed(playground);
});

test('cells are saved and opened again', async () => {
  const playground = await Playground.open(browser);
  const state = await playground.afterPlan(() =>
    playground.page.getByTestId('preset').selectOption('JPS_Theta*'),
  );
  const scene = await downloaded(playground, 'export-scene');
  const reopened = await playground.afterPlan(() =>
    playground.openFiles([{ name: scene.name, content: scene.content }]),
  );
  assert.deepEqual(reopened.scene, state.scene);
  await closed(playground);
});

test('the tour has five steps', async () => {
  const playground = await Playground.open(browser);
  const { page } = playground;
  await page.getByTestId('tour').click();
  for (let step = 1; step <= 5; ++step) {
    await reads(page, 'tour-box', new RegExp(`${step} of 5`));
    if (step === 2 || step === 5) await playground.screenshot(`tour-${step}`);
    await page.getByTestId('tour-next').click();
  }
  await page.getByTestId('tour-box').waitFor({ state: 'detached' });
  await closed(playground);
});

test('the status is announced in words', async () => {
  const playground = await Playground.open(browser);
  const { page } = playground;
  await reads(page, 'announcer', /^Proved: the clearance of the whole curve is at least 0\.300 m/);
  // Inside of a wall.
  await playground.afterPlan(() => playground.drag([14.5, 14.5], [9, 3]));
  await reads(page, 'announcer', /^No plan by auto with clothoid/);
  await playground.screenshot('failure');
  await closed(playground);
});

test('the page is dark where the system is, and the button changes it', async () => {
  const playground = await Playground.open(browser, { colorScheme: 'dark' });
  const theme = () => playground.page.evaluate(() => document.documentElement.dataset['theme']);
  assert.equal(await theme(), 'dark');
  await playground.page.getByTestId('tab-search').click();
  await playground.page.getByTestId('show-search').check();
  await playground.page.waitForTimeout(100);
  await playground.screenshot('dark');
  await playground.page.getByTestId('theme').click();
  await playground.page.waitForTimeout(100);
  assert.equal(await theme(), 'light');
  await closed(playground);
});

test('nothing is wider than a phone', async () => {
  const playground = await Playground.open(browser, {
    viewport: { width: 360, height: 740 },
    hasTouch: true,
    isMobile: true,
    deviceScaleFactor: 2,
  });
  const { page } = playground;
  const overflow = () =>
    page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
  await playground.screenshot('phone');
  for (const tab of ['tab-profile', 'tab-search', 'tab-comparison']) {
    await page.getByTestId(tab).tap();
    assert.ok((await overflow()) <= 0, tab);
    await playground.screenshot(`phone-${tab}`);
  }
  await page.getByTestId('share').tap();
  assert.ok((await overflow()) <= 0, 'with the address');
  await page.evaluate(() => document.querySelector('#panel')?.scrollIntoView());
  await playground.screenshot('phone-panel');
  await page.getByTestId('panel-button').tap();
  assert.ok(!(await page.getByTestId('radius').isVisible()), 'the panel is closed');
  await closed(playground);
});

test('two fingers zoom the map, one drags the goal', async () => {
  const playground = await Playground.open(browser, {
    viewport: { width: 390, height: 800 },
    hasTouch: true,
    isMobile: true,
  });
  const { page } = playground;
  const scale = async () => {
    const [a, b] = [await playground.at([0, 0]), await playground.at([10, 0])];
    return (b.x - a.x) / 10;
  };
  const old = await scale();
  const client = await page.context().newCDPSession(page);
  const touch = (
    /** @type {'touchStart' | 'touchMove' | 'touchEnd'} */ type,
    /** @type {{ x: number; y: number }[]} */ touchPoints,
  ) => client.send('Input.dispatchTouchEvent', { type, touchPoints });
  const box = await page.getByTestId('map').boundingBox();
  assert.ok(box);
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await touch('touchStart', [
    { x: x - 30, y },
    { x: x + 30, y },
  ]);
  for (let i = 1; i <= 6; ++i)
    await touch('touchMove', [
      { x: x - 30 - 8 * i, y },
      { x: x + 30 + 8 * i, y },
    ]);
  await touch('touchEnd', []);
  assert.ok((await scale()) > 1.5 * old);
  await page.getByTestId('fit').tap();
  const { scene } = await playground.state();
  const goal = await playground.at(scene.goal);
  const state = await playground.afterPlan(async () => {
    await touch('touchStart', [goal]);
    for (let i = 1; i <= 6; ++i)
      await touch('touchMove', [{ x: goal.x - 4 * i, y: goal.y + 3 * i }]);
    await touch('touchEnd', []);
  });
  assert.notDeepEqual(state.scene.goal, scene.goal);
  assert.ok(isProved(state));
  await closed(playground);
});

test('controls have names', async () => {
  const playground = await Playground.open(browser);
  const nameless = await playground.page.evaluate(() =>
    [...document.querySelectorAll('button, select, input, canvas')]
      .filter((control) => {
        const element = /** @type {HTMLInputElement} */ (control);
        const labels = [...(element.labels ?? [])]
          .map((label) => label.textContent?.trim())
          .join('');
        return !labels && !element.getAttribute('aria-label') && !element.textContent?.trim();
      })
      .map((control) => control.outerHTML.slice(0, 120)),
  );
  assert.deepEqual(nameless, []);
  await closed(playground);
});
