// One test's bench: a folder, a simulated robot, and a daemon with its live view on a free port.
import { spawn, spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync, readFileSync, existsSync } from 'node:fs';
import { createServer } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const bin = process.env.WHEELWRIGHT_BIN;
const source = process.env.WHEELWRIGHT_SOURCE;

export const sleep = ms => new Promise(resolve => setTimeout(resolve, ms));

export async function eventually(what, condition, patience_ms = 10000) {
  const deadline = Date.now() + patience_ms;
  for (;;) {
    const value = await condition();
    if (value) return value;
    if (Date.now() > deadline) throw new Error(`not in time: ${what}`);
    await sleep(20);
  }
}

async function freePort() {
  const server = createServer();
  await new Promise(resolve => server.listen(0, '127.0.0.1', resolve));
  const { port } = server.address();
  await new Promise(resolve => server.close(resolve));
  return port;
}

// A robot does not wait for the host's processor: where the system lets it, its stand-in goes first.
const likeHardware = spawnSync('chrt', ['-f', '60', 'true']).status === 0 ? ['chrt', '-f', '60'] : [];

// A wheel follows within 0.13 s with gain 1.
const own = '[0.0, 0.1, 0.2, 0.3, 0.2, 0.1, 0.1]';
const other = '[0, 0, 0, 0, 0, 0, 0]';
const model = `wheelwright_model: 1
wheel_base_m: 0.235
period_s: 0.018
encoder_scale:
  metres_per_tick_left: 0.000444565
  metres_per_tick_right: 0.000444565
  ticks_per_turn: 1660
  relative_standard_error: 0.002
core:
  type: fir
  left: {from_left: ${own}, from_right: ${other}}
  right: {from_left: ${other}, from_right: ${own}}
`;

export class Bench {
  static async create({ route = '[[0.8, 0], [0.8, 0.5], [0, 0]]', token = '', robot = 'perfect', arm = 'at_start' } = {}) {
    const bench = new Bench();
    bench.folder = mkdtempSync(join(tmpdir(), 'wheelwright_live_view_'));
    bench.port = await freePort();
    bench.url = `http://127.0.0.1:${bench.port}/${token ? `?token=${token}` : ''}`;
    const at = name => join(bench.folder, name);
    writeFileSync(at('model.yaml'), model);
    writeFileSync(at('daemon.yaml'), `robot: {name: test robot}
link: {device: ${at('robot')}}
calibration: {when: never, model_file: ${at('model.yaml')}}
run:
  arm: ${arm}
  route: {name: triangle, speed: 0.2, checkpoints: ${route}}
  log_folder: ${at('runs')}
real_time: {policy: prefer, lock_memory: false}
live_view: {port: ${bench.port}, token: "${token}", truth: ${at('truth.csv')}}
`);
    const robotConfig = join(source, `config/robots/${robot}.yaml`);
    bench.robot = bench.start([...likeHardware, join(bin, 'roomba-sim'), '--config', robotConfig, '--link', at('robot'),
                               '--truth', at('truth.csv')]);
    await eventually('the robot is there', () => existsSync(at('robot')));
    return bench;
  }

  start([program, ...options]) {
    const child = spawn(program, options);
    child.said = '';
    child.stdout.on('data', text => { child.said += text; });
    child.stderr.on('data', text => { child.said += text; });
    child.ended = new Promise(resolve => child.on('exit', (code, signal) => resolve(code ?? signal)));
    return child;
  }

  async startDaemon() {
    this.daemon = this.start([join(bin, 'wheelwrightd'), '--config', join(this.folder, 'daemon.yaml')]);
    await eventually('the daemon has a live view', () => this.daemon.said.includes(' live view: '));
  }

  // Of both wheels truly, without sign, in m/s, at the end of what the robot has recorded.
  async trueSpeedAtEnd() {
    this.robot.kill('SIGTERM');
    await this.robot.ended;
    const lines = readFileSync(join(this.folder, 'truth.csv'), 'utf8').trim().split('\n');
    const columns = lines.find(line => line.startsWith('t,')).split(',');
    const last = lines.at(-1).split(',').map(Number);
    return ['speed_left', 'speed_right'].map(name => Math.abs(last[columns.indexOf(name)]));
  }

  async end() {
    for (const child of [this.daemon, this.robot]) {
      if (!child || child.exitCode !== null || child.signalCode !== null) continue;
      child.kill('SIGTERM');
      await Promise.race([child.ended, sleep(3000).then(() => child.kill('SIGKILL'))]);
    }
    rmSync(this.folder, { recursive: true, force: true });
  }
}

// Runs a test on a bench of its own.
export async function onBench(options, body) {
  const bench = await Bench.create(options);
  try {
    return await body(bench);
  } finally {
    await bench.end();
  }
}
