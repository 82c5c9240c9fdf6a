// SPDX-License-Identifier: MIT

import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import { after, afterEach, before, beforeEach } from 'node:test';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';

/** @typedef {import('../src/protocol.ts').Point} Point */
/** @typedef {ReturnType<import('../src/test_interface.ts').TestInterface['state']>} State */

const here = dirname(fileURLToPath(import.meta.url));

/** The data of the library's own tests. */
export const testData = resolve(here, '../../../../tests/data');

/** The built page. */
export const pageUrl = pathToFileURL(
  resolve(process.env.TUTAVIA_PLAYGROUND_DIR ?? join(here, '../dist'), 'index.html'),
).href;

export function launch() {
  return chromium.launch({
    executablePath: process.env.TUTAVIA_CHROMIUM ?? '/usr/bin/chromium',
    args: ['--no-sandbox'],
  });
}

/**
 * Waits until the text of an element matches: a slow machine draws its next frame late.
 * @param {import('playwright-core').Page} page
 * @param {string} testId
 * @param {RegExp} pattern
 */
export async function reads(page, testId, pattern) {
  const element = page.getByTestId(testId);
  const until = Date.now() + 15000;
  for (;;) {
    const text = (await element.count()) > 0 ? await element.first().innerText() : '';
    if (pattern.test(text)) return;
    if (Date.now() > until) assert.match(text, pattern);
    await page.waitForTimeout(50);
  }
}

/** The page in a browser, with what tests do again and again. */
export class Playground {
  /** @type {string[]} */
  errors = [];

  /** @param {import('playwright-core').Page} page */
  constructor(page) {
    this.page = page;
    page.on('console', (message) => {
      if (message.type() === 'error' || message.type() === 'warning')
        this.errors.push(message.text());
    });
    page.on('pageerror', (error) => this.errors.push(error.message));
  }

  /**
   * @param {import('playwright-core').Browser} browser
   * @param {import('playwright-core').BrowserContextOptions} options
   */
  static async open(browser, options = {}, url = pageUrl) {
    return Playground.openIn(
      await browser.newContext({
        viewport: { width: 1360, height: 860 },
        acceptDownloads: true,
        ...options,
      }),
      url,
    );
  }

  /** @param {import('playwright-core').BrowserContext} context */
  static async openIn(context, url = pageUrl) {
    const playground = new Playground(await context.newPage());
    await playground.page.goto(url);
    await playground.page.evaluate(() => window.tutaviaPlayground.ready);
    await playground.settled();
    return playground;
  }

  /** @returns {Promise<State>} */
  state() {
    return this.page.evaluate(() => window.tutaviaPlayground.state());
  }

  /** Waits until all planners have their full plans. */
  async settled() {
    await this.page.waitForFunction(
      () => {
        const { replies, inGesture } = window.tutaviaPlayground.state();
        return !inGesture && replies.length > 0 && replies.every(({ complete }) => complete);
      },
      undefined,
      { timeout: 30000 },
    );
    return this.state();
  }

  /**
   * Waits until what the action has changed is planned.
   * @param {() => Promise<unknown>} action
   */
  async afterPlan(action) {
    const { version } = await this.state();
    await action();
    await this.page.waitForFunction(
      (before) => window.tutaviaPlayground.state().version > before,
      version,
      { timeout: 30000 },
    );
    return this.settled();
  }

  /**
   * Where a point of the world is in the window.
   * @param {Point} point
   */
  async at(point) {
    const [x, y] = await this.page.evaluate(
      (p) => window.tutaviaPlayground.view.toScreen(p),
      point,
    );
    const box = await this.page.getByTestId('map').boundingBox();
    if (!box) throw new Error('the map is not visible');
    return { x: box.x + x, y: box.y + y };
  }

  /** @param {Point} point */
  async click(point) {
    const { x, y } = await this.at(point);
    await this.page.mouse.click(x, y);
  }

  /**
   * @param {Point} from
   * @param {Point} to
   */
  async drag(from, to, steps = 12) {
    const a = await this.at(from);
    const b = await this.at(to);
    await this.page.mouse.move(a.x, a.y);
    await this.page.mouse.down();
    for (let i = 1; i <= steps; ++i) {
      await this.page.mouse.move(a.x + ((b.x - a.x) * i) / steps, a.y + ((b.y - a.y) * i) / steps);
      await this.page.waitForTimeout(16);
    }
    await this.page.mouse.up();
  }

  /** @param {{ name: string; content: string | Uint8Array }[]} files */
  async openFiles(files) {
    await this.page.getByTestId('file').setInputFiles(
      files.map(({ name, content }) => ({
        name,
        mimeType: 'application/octet-stream',
        buffer: Buffer.from(content),
      })),
    );
  }

  /** @param {string} name */
  async screenshot(name) {
    const folder = process.env.TUTAVIA_PLAYGROUND_SCREENSHOTS;
    if (!folder) return;
    mkdirSync(folder, { recursive: true });
    await this.page.screenshot({ path: join(folder, `${name}.png`) });
  }

  async close() {
    await this.page.context().close();
  }
}

/**
 * The page of the current test, after `openForEachTest`: an import sees every new value.
 * @type {Playground}
 */
export let playground;

/** Opens the page before each test of a file; after it the page must have logged no error. */
export function openForEachTest() {
  /** @type {import('playwright-core').Browser} */
  let browser;
  before(async () => {
    browser = await launch();
  });
  after(() => browser.close());
  beforeEach(async () => {
    playground = await Playground.open(browser);
  });
  afterEach(async () => {
    const { errors } = playground;
    await playground.close();
    assert.deepEqual(errors, [], 'no errors on the console');
  });
}

/**
 * Whether the certificate of every plan is a proof.
 * @param {State} state
 */
export function isProved({ replies }) {
  return replies.every(({ reply }) => reply?.result.certificate?.status === 'proved');
}

/** @param {State} state */
export function lengthOf(state) {
  return state.replies[0]?.reply?.result.metrics?.length ?? Number.NaN;
}
