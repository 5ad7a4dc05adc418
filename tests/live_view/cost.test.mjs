// What the page costs: the processor time of a browser that shows a drive, beside one that shows an empty page. Software drawing.
import assert from 'node:assert/strict';
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { execFileSync } from 'node:child_process';
import { test } from 'node:test';
import { chromium } from 'playwright-core';
import { eventually, onBench, sleep } from './bench.mjs';

const browserPath = ['/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome'].find(existsSync);
const options = { skip: browserPath ? false : 'no chromium (tools/install-dependencies browser)' };
const ticksPerSecond = Number(execFileSync('getconf', ['CLK_TCK']));
const seconds = Number(process.env.WHEELWRIGHT_COST_SECONDS ?? 15);
const largestShareOfCore = 0.3;  // 0.2 on an idle machine; one that is busy does the same work in more time

// Of a process and all that come from it, in seconds.
function processorTime(root) {
  const processes = new Map();
  for (const name of readdirSync('/proc').filter(entry => /^\d+$/.test(entry))) {
    try {
      const fields = readFileSync(`/proc/${name}/stat`, 'utf8').replace(/^.*\) /s, '').split(' ');
      processes.set(Number(name), { parent: Number(fields[1]), ticks: Number(fields[11]) + Number(fields[12]) });
    } catch { /* it has ended */ }
  }
  const belongs = pid => pid === root || (processes.has(pid) && belongs(processes.get(pid).parent));
  let ticks = 0;
  for (const [pid, one] of processes) if (belongs(pid)) ticks += one.ticks;
  return ticks / ticksPerSecond;
}

async function shareOfCore(pid) {
  const before = processorTime(pid);
  const begin = performance.now();
  await sleep(1000 * seconds);
  return (processorTime(pid) - before) / (1e-3 * (performance.now() - begin));
}

test('the page takes less than a third of a core while the robot drives', options, () => onBench({ route: '[[1, 0], [1, 1], [0, 1], [0, 0], [1, 0], [1, 1], [0, 1], [0, 0], [1, 0], [1, 1], [0, 1], [0, 0]]' }, async bench => {
  const server = await chromium.launchServer({ executablePath: browserPath, args: ['--no-sandbox', '--disable-gpu'] });
  try {
    const pid = server.process().pid;
    const browser = await chromium.connect(server.wsEndpoint());
    const page = await (await browser.newContext({ viewport: { width: 1280, height: 860 } })).newPage();
    await page.goto('about:blank');
    await sleep(2000);
    const empty = await shareOfCore(pid);
    await bench.startDaemon();
    await page.goto(bench.url);
    await eventually('the robot drives', async () => /Driving/.test(await page.locator('#phase').textContent()), 15000);
    const shown = await shareOfCore(pid);
    assert.match(await page.locator('#phase').textContent(), /Driving/);
    console.log(`share of a core: empty page ${empty.toFixed(3)}, live page ${shown.toFixed(3)}`);
    assert.ok(shown - empty < largestShareOfCore, `the page takes ${(shown - empty).toFixed(3)} of a core`);
    await browser.close();
  } finally {
    await server.close();
  }
}));
