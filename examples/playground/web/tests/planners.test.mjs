// SPDX-License-Identifier: MIT

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { isProved, lengthOf, openForEachTest, playground, reads } from './page.mjs';

openForEachTest();

test('planners stand side by side', async () => {
  const { page } = playground;
  await playground.afterPlan(() => page.getByTestId('add-planner').click());
  await playground.afterPlan(() => page.getByTestId('search').nth(1).selectOption('tangent_graph'));
  const state = await playground.afterPlan(() =>
    page.getByTestId('smoother').nth(1).selectOption('none'),
  );
  assert.equal(await page.getByTestId('row').count(), 2);
  assert.ok(isProved(state));
  const ratio = state.replies[1]?.reply?.result.optimum?.ratio ?? 0;
  assert.ok(Math.abs(ratio - 1) < 1e-6, `tangent_graph finds the optimum, ratio ${ratio}`);
  await playground.screenshot('compare');
});

test('all searches are added at once', async () => {
  const { page } = playground;
  const state = await playground.afterPlan(() => page.getByTestId('add-all').click());
  assert.ok(state.replies.length > 10);
  for (const { reply, error } of state.replies) assert.ok(reply, error);
  await playground.screenshot('compare-all');
});

test('an option changes the plan, and a wrong one is explained', async () => {
  const { page } = playground;
  await playground.afterPlan(() => page.getByTestId('search').first().selectOption('rrt_star'));
  await page.getByText('Options of rrt_star').click();
  const iterations = page.getByLabel('max iterations');
  const set = async (/** @type {string} */ value) => {
    await iterations.fill(value);
    await iterations.press('Enter');
  };
  const state = await playground.afterPlan(() => set('700'));
  const options = /** @type {{ search: { max_iterations: number } }} */ (
    state.replies[0]?.reply?.result.options
  );
  assert.equal(options.search.max_iterations, 700);
  await playground.screenshot('options');
  const wrong = await playground.afterPlan(() => set('many'));
  assert.match(wrong.replies[0]?.error ?? '', /max_iterations/);
  await reads(page, 'status', /max_iterations/);
});

test('smoothers follow one another', async () => {
  const { page } = playground;
  await page.getByRole('button', { name: 'Add a smoother after it' }).click();
  await playground.afterPlan(() => page.getByTestId('smoother').first().selectOption('shortcut'));
  const state = await playground.afterPlan(() =>
    page.getByTestId('smoother-stage').selectOption('bezier'),
  );
  assert.equal(state.replies[0]?.reply?.result.smoother, 'shortcut+bezier');
});

test('a smoother that gives no curve leaves the route', async () => {
  const { page } = playground;
  await page.getByText('Options of clothoid').click();
  const state = await playground.afterPlan(async () => {
    await page.getByLabel('min turning radius').fill('6');
    await page.getByLabel('min turning radius').press('Enter');
  });
  assert.ok(isProved(state) && state.replies[0]?.reply?.result.fell_back);
  await reads(page, 'status', /^clothoid gave no curve.*so the plan keeps the route\. Proved/);
});

test('a curve that nobody checked is red, with the point where it is not safe', async () => {
  const { page } = playground;
  await playground.afterPlan(() => page.getByTestId('search').first().selectOption('astar'));
  const state = await playground.afterPlan(() => page.getByLabel('unchecked spline').check());
  const certificate = state.replies[0]?.reply?.unchecked?.certificate;
  assert.equal(certificate?.status, 'violated');
  assert.ok((certificate?.upper ?? 1) < state.scene.radius);
  assert.ok(isProved(state), 'the plan itself is proved');
  await reads(
    page,
    'status',
    /The unchecked spline is not safe: at \(.*\) its clearance is 0\.\d+ m\./,
  );
  await playground.screenshot('unchecked');
  await playground.afterPlan(() => page.getByLabel('unchecked spline').uncheck());
  await reads(page, 'status', /^(?!.*unchecked)/s);
});

test('a plan that takes too long is cancelled', async () => {
  const { page } = playground;
  await page.getByText('Limits of the drive').click();
  await playground.afterPlan(async () => {
    await page.getByTestId('time-limit').fill('600');
    await page.getByTestId('time-limit').press('Enter');
  });
  await playground.afterPlan(() => page.getByTestId('search').first().selectOption('rrt_star'));
  await page.getByText('Options of rrt_star').click();
  const iterations = page.getByLabel('max iterations');
  await iterations.fill('2000000000');
  await iterations.press('Enter');
  await page.getByTestId('cancel').click({ timeout: 10000 });
  await page.waitForFunction(() =>
    document.querySelector('#status')?.textContent?.includes('cancelled'),
  );
  const state = await playground.afterPlan(async () => {
    await iterations.fill('500');
    await iterations.press('Enter');
  });
  assert.ok(isProved(state));
});

test('the search is played, stepped and scrubbed', async () => {
  const { page } = playground;
  await page.getByTestId('tab-search').click();
  const { events } = await playground.state();
  assert.ok(events > 100, `${events} events`);
  await page.getByTestId('rewind').click();
  assert.equal((await playground.state()).shownEvents, 0);
  await page.getByTestId('step').click();
  await page.getByTestId('step').click();
  assert.equal((await playground.state()).shownEvents, 2);
  await page.getByTestId('step-back').click();
  assert.equal((await playground.state()).shownEvents, 1);
  await page.getByTestId('scrub').fill(String(Math.floor(events / 2)));
  await page.waitForTimeout(100);
  await playground.screenshot('search');
  await page.getByTestId('play').click();
  await page.waitForTimeout(500);
  await page.getByTestId('play').click();
  const { shownEvents } = await playground.state();
  assert.ok(shownEvents > events / 2 && shownEvents <= events, `${shownEvents} of ${events}`);
});

for (const search of ['rrt_star', 'tangent_graph', 'rrt_connect']) {
  test(`shows the events of ${search}`, async () => {
    await playground.page.getByTestId('tab-search').click();
    const state = await playground.afterPlan(() =>
      playground.page.getByTestId('search').first().selectOption(search),
    );
    await playground.page.getByTestId('show-search').check();
    await playground.page.waitForTimeout(100);
    if (search !== 'tangent_graph') assert.ok(state.events > 0);
    await playground.screenshot(`events-${search}`);
  });
}

for (const search of ['jps', 'any_angle', 'rea_star', 'sb_rea_star']) {
  test(`shows the events of ${search} on cells`, async () => {
    const { page } = playground;
    await playground.afterPlan(() =>
      page.getByTestId('preset').selectOption('Improved REA*, map A'),
    );
    await page.getByTestId('tab-search').click();
    const state = await playground.afterPlan(() =>
      page.getByTestId('search').first().selectOption(search),
    );
    await page.getByTestId('show-search').check();
    await page.waitForTimeout(100);
    assert.ok(state.events > 0 && state.replies[0]?.reply);
    await playground.screenshot(`events-${search}`);
  });
}

test('the plots show the robot along the path', async () => {
  const { page } = playground;
  await page.getByTestId('tab-profile').click();
  await page.getByTestId('along').fill('9.5');
  await reads(page, 'readout', /At 9\.50 m: curvature .* clearance .* m\/s/);
  await playground.screenshot('profile');
  await page.getByTestId('drive').click();
  await page.waitForTimeout(700);
  await reads(page, 'readout', /^(?!.*At 9\.50 m)/s);
});

test('a car parks, with headings that can be dragged', async () => {
  const { page } = playground;
  const parked = await playground.afterPlan(() =>
    page.getByTestId('preset').selectOption('parking'),
  );
  assert.ok(isProved(parked));
  assert.ok(parked.replies[0]?.reply?.curve?.gear?.includes(-1), 'it drives in reverse');
  await playground.screenshot('parking');
  const heading = page.getByTestId('startHeading');
  const turned = await playground.afterPlan(async () => {
    await heading.fill('45');
    await heading.press('Enter');
  });
  assert.ok(Math.abs(turned.scene.startHeading - Math.PI / 4) < 1e-9);
  assert.notEqual(lengthOf(turned), lengthOf(parked));
  const smoothers = await page
    .getByTestId('smoother')
    .first()
    .locator('option')
    .evaluateAll((options) =>
      options.map((option) => /** @type {HTMLOptionElement} */ (option).value),
    );
  assert.ok(
    smoothers.includes('none') &&
      smoothers.includes('vehicle_shortcut') &&
      !smoothers.includes('bezier'),
  );
});
