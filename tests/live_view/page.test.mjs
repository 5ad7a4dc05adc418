// The page of the live view in a browser without a window.
import assert from 'node:assert/strict';
import { existsSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { chromium } from 'playwright-core';
import { eventually, onBench, sleep } from './bench.mjs';

const browserPath = ['/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome'].find(existsSync);
const options = { skip: browserPath ? false : 'no chromium (tools/install-dependencies browser)' };
const sizes = [['desktop', { width: 1280, height: 860 }], ['phone', { width: 390, height: 844 }]];

// The browser stands for another computer's: it takes no processor time that the pseudo-terminal between daemon and
// robot needs, whose bytes the kernel carries at ordinary priority.
let browser;
const folder = mkdtempSync(join(tmpdir(), 'wheelwright_browser_'));
before(async () => {
  const executablePath = join(folder, 'browser');
  writeFileSync(executablePath, `#!/bin/sh\nexec nice -n 19 ${browserPath} "$@"\n`, { mode: 0o755 });
  if (browserPath) browser = await chromium.launch({ executablePath, args: ['--no-sandbox'] });
});
after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true, force: true });
});

// A page that keeps count of what goes wrong in it, and of what it asks of the network.
async function open(bench, context = {}) {
  const page = await (await browser.newContext({ viewport: sizes[0][1], ...context })).newPage();
  page.wrong = [];
  page.on('pageerror', error => page.wrong.push(String(error)));
  page.on('request', request => {
    if (!request.url().startsWith(`http://127.0.0.1:${bench.port}/`) && !request.url().startsWith('data:')) {
      page.wrong.push(`asked for ${request.url()}`);
    }
  });
  await page.goto(bench.url);
  return page;
}

const textOf = (page, id) => page.locator(`#${id}`).textContent();
const phase = (page, wanted) => eventually(`the page says ${wanted}`, async () => wanted.test(await textOf(page, 'phase')), 15000)
  .catch(async error => { throw new Error(`${error.message}, but: ${await textOf(page, 'phase')}; ${await textOf(page, 'notice')}`); });

// How many different colours a canvas shows: an empty one has one.
const coloursOf = (page, id) => page.evaluate(name => {
  const canvas = document.getElementById(name);
  const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
  return new Set(new Uint32Array(data.buffer)).size;
}, id);

test('the page shows the run as it goes, in both sizes and themes, and asks nothing of the network', options, () => onBench({ arm: 'by_signal', route: '[[0.4, 0], [3, 0], [0, 0]]' }, async bench => {
  await bench.startDaemon();
  const pages = [];
  for (const [name, viewport] of sizes) {
    for (const colorScheme of ['light', 'dark']) pages.push([name, await open(bench, { viewport, colorScheme })]);
  }
  await phase(pages[0][1], /Standing, not armed/);
  bench.daemon.kill('SIGUSR1');
  for (const [name, page] of pages) {
    await phase(page, /Driving .triangle., [0-2] of 3 checkpoints/);
    for (const id of ['floor', 'wheel-left', 'wheel-right', 'lateness']) {
      await eventually(`${id} is drawn`, async () => await coloursOf(page, id) > 8);
    }
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), `${name} scrolls sideways`);
    await page.evaluate(() => scrollTo(0, document.body.scrollHeight));
    const button = await page.locator('#stop').boundingBox();
    assert.ok(button.y >= 0 && button.y + button.height <= page.viewportSize().height, `no stop button in sight, ${name}`);
    assert.ok(button.height >= 44 && button.width >= 44, 'the stop button is small for a finger');
    assert.match(await textOf(page, 'messages'), /route: driving/);
  }
  const [, page] = pages[0];
  await phase(page, /[1-3] of 3 checkpoints/);
  bench.daemon.kill('SIGTERM');
  await bench.daemon.ended;
  const ended = /The run has ended: stopped, ended by a signal/;
  await eventually('the page says how the run ended', async () => ended.test(await textOf(page, 'notice')))
    .catch(async error => { throw new Error(`${error.message}, but: ${await textOf(page, 'notice')}`); });
  for (const [, one] of pages) assert.deepEqual(one.wrong, []);
}));

test('the stop button stops the wheels, and the run ends by that name', options, () => onBench({ robot: 'default', route: '[[3, 0]]' }, async bench => {
  await bench.startDaemon();
  const page = await open(bench, { viewport: sizes[1][1], hasTouch: true });
  await phase(page, /Driving/);
  await sleep(800);
  await page.locator('#stop').tap();
  await eventually('the page says it', async () => /stopped: on request|ended: stopped, requested/.test(await textOf(page, 'notice')));
  assert.equal(await bench.daemon.ended, 1);
  assert.match(bench.daemon.said, /live view: 127\.0\.0\.1:\d+ asks for a stop/);
  assert.match(bench.daemon.said, /Result: stopped, requested/);
  for (const speed of await bench.trueSpeedAtEnd()) assert.ok(Math.abs(speed) < 1e-4, `a wheel turns at ${speed} m/s`);
  assert.deepEqual(page.wrong, []);
}));

test('the page comes back by itself when the daemon does, with the token in its address', options, () => onBench({ token: 'a-token-of-the-tests', route: '[[3, 0]]' }, async bench => {
  await bench.startDaemon();
  const page = await open(bench);
  await phase(page, /Driving/);
  bench.daemon.kill('SIGTERM');
  await bench.daemon.ended;
  await eventually('the page has noticed', async () => await textOf(page, 'connection') === 'Connecting again');
  assert.ok(await page.locator('#stop').isDisabled());
  await bench.startDaemon();
  await eventually('the page is live again', async () => await textOf(page, 'connection') === 'Live');
  await phase(page, /Driving/);
  assert.ok(await page.locator('#stop').isEnabled());
  assert.deepEqual(page.wrong, []);
  const refused = await fetch(`http://127.0.0.1:${bench.port}/`);
  assert.equal(refused.status, 401);
}));

test('nothing is drawn while the page is hidden, and the floor at most 15 times a second while it is not', options, () => onBench({ route: '[[3, 0]]' }, async bench => {
  await bench.startDaemon();
  const context = await browser.newContext({ viewport: sizes[0][1] });
  await context.addInitScript(() => {
    window.drawn = 0;
    window.isHidden = false;
    Object.defineProperty(Document.prototype, 'hidden', { get: () => window.isHidden });
    const { clearRect } = CanvasRenderingContext2D.prototype;
    CanvasRenderingContext2D.prototype.clearRect = function clear(...area) {
      if (this.canvas.id === 'floor') ++window.drawn;
      return clearRect.apply(this, area);
    };
  });
  const page = await context.newPage();
  await page.goto(bench.url);
  await phase(page, /Driving/);
  const drawnIn = async ms => {
    const before = await page.evaluate(() => [window.drawn, performance.now()]);
    await sleep(ms);
    const after = await page.evaluate(() => [window.drawn, performance.now()]);
    return [after[0] - before[0], 1e-3 * (after[1] - before[1])];
  };
  const [drawn, seconds] = await drawnIn(2000);
  assert.ok(drawn > 0 && drawn <= 15 * seconds + 1, `drawn ${drawn} times in ${seconds} s`);
  await page.evaluate(() => { window.isHidden = true; document.dispatchEvent(new Event('visibilitychange')); });
  await sleep(300);  // what was planned before
  assert.equal((await drawnIn(1500))[0], 0);
  await page.evaluate(() => { window.isHidden = false; document.dispatchEvent(new Event('visibilitychange')); });
  await eventually('it is drawn again', async () => (await drawnIn(100))[0] > 0);
}));

test('a run that has finished says so calmly, with what came of it', options, () => onBench({ route: '[[0.2, 0], [0, 0]]' }, async bench => {
  await bench.startDaemon();
  const page = await open(bench);
  await phase(page, /Driving/);
  await eventually('the page says how it came out', async () => /finished: 2 of 2 checkpoints visited, and the robot ended 0\.\d+ m \+- 0\.\d+ m \(95 %\) from its start by the filter/.test(await textOf(page, 'notice')), 30000);
  assert.equal(await page.locator('#notice').getAttribute('class'), 'calm');
  assert.deepEqual(page.wrong, []);
}));
