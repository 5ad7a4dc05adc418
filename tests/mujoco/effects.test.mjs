// Each effect that MuJoCo can express, put into the robot by a patch: its free run beside that of `wheelwright simulate`.
import assert from 'node:assert';
import { execFileSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { read_commands, simulate } from './simulator.mjs';

const wheelwright = `${process.env.WHEELWRIGHT_BIN}/wheelwright`;
const wheel_base_m = 0.235;
const wheel = ['--wheel-radius', '0.036', '--wheel-inertia', '0.00244'];

const effects = {
  linear_part: '',
  unequal_gains: '',
  transport_delay: 'delay: 0.054',
  coulomb_friction: 'speed_loss: 0.011, lag: 0.08',
  saturation: 'limit: 0.2, motor_lag: 0, knee: 0',
  effective_track: 'excess: 0.006',
  distance_scale: 'change: 0.02',
  wheel_scale_mismatch: 'mismatch: 0.02',
};
const variants = { saturation: 'command' };

// Of the gap, %. Where the goal is not met, the bound is what was reached: a model steps its friction once a period, which
// 18 ms make coarse, and larger wheels lift the robot off its gliders, so that it nods.
const goal = 1;
const reached = { linear_part: 1.5, coulomb_friction: 2.5, distance_scale: 3 };
const usual = { given: 'robot.xml', period_s: 0.018 };

// Each wheel with a dead time of 10 ms and a time constant of 80 ms.
function model_text(name, period_s) {
  const pole = Math.exp(-period_s / 0.08);
  const none = '0, '.repeat(Math.round(0.01 / period_s + 0.4));
  const own = (gain) => `[${none}${gain * (1 - pole)}]`;
  const other = `[${none}0]`;
  const [left_gain, right_gain] = name === 'unequal_gains' ? [0.95, 1.04] : [1, 1];
  const wheel_text = (left, right) =>
    `{from_left: ${left}, from_right: ${right}, from_own_past: [${pole}]}`;
  return (
    `wheelwright_model: 1\nwheel_base_m: ${wheel_base_m}\nperiod_s: ${period_s}\n` +
    `core: {type: arma, left: ${wheel_text(own(left_gain), other)}, right: ${wheel_text(other, own(right_gain))}}\n` +
    (effects[name]
      ? `effects:\n  - {name: ${name}, ${variants[name] ? `variant: ${variants[name]}, ` : ''}parameters: {${effects[name]}}}\n`
      : '')
  );
}

// A minute of speeds up to 0.3 m/s that hold for 0.3 to 1.5 s, with rests.
function commands_text(period_s) {
  let state = 7;
  const random = () => (state = (state * 48271) % 2147483647) / 2147483647;
  let text = `# wheelwright_drive_log: 1\n# wheel_base_m: ${wheel_base_m}\n# period_s: ${period_s}\nt,cmd_left,cmd_right\n`;
  for (let row = 0, until = 0, left = 0, right = 0; row * period_s < 60; ++row) {
    if (row >= until) {
      const rest = random() < 0.2;
      const [v, w] = [0.36 * random() - 0.12, 1.2 * random() - 0.6];
      left = rest ? 0 : v - (w * wheel_base_m) / 2;
      right = rest ? 0 : v + (w * wheel_base_m) / 2;
      until = row + Math.round((0.3 + 1.2 * random()) / period_s);
    }
    text += `${(row * period_s).toFixed(3)},${left.toFixed(4)},${right.toFixed(4)}\n`;
  }
  return text;
}

function by_wheelwright(name, period_s) {
  writeFileSync(`${name}.yaml`, model_text(name, period_s));
  execFileSync(wheelwright, ['simulate', `${name}.yaml`, 'commands.csv', '-o', `${name}.csv`]);
  const lines = readFileSync(`${name}.csv`, 'utf8').trim().split('\n').slice(1);
  return lines.map((line) => {
    const [, , , , , x_m, y_m, theta_rad] = line.split(',').map(Number);
    return { x_m, y_m, theta_rad };
  });
}

function by_mujoco(name, given) {
  const options = ['export', `${name}.yaml`, '--to', 'mujoco', '--patch', given, ...wheel];
  const robot = `${name}.${given}`;
  writeFileSync(robot, '');
  execFileSync(wheelwright, [...options, '-o', robot]);
  return simulate(readFileSync(robot, 'utf8'), read_commands('commands.csv'));
}

function apart(one, other) {
  const turned = (angle) => Math.atan2(Math.sin(angle), Math.cos(angle));
  const rms = (of) => Math.sqrt(one.reduce((sum, row, k) => sum + of(row, other[k]), 0) / one.length);
  return {
    position_m: rms((a, b) => (a.x_m - b.x_m) ** 2 + (a.y_m - b.y_m) ** 2),
    heading_rad: rms((a, b) => turned(a.theta_rad - b.theta_rad) ** 2),
  };
}

const shown = (figure) =>
  `${(1000 * figure.position_m).toFixed(2)} mm, ${(1000 * figure.heading_rad).toFixed(2)} mrad`;

const velocity = readFileSync('robot.xml', 'utf8');
writeFileSync(
  'general.xml',
  velocity.replace(/<velocity (.*) kv="0.5"\/>/g, '<general $1 gear="2" gainprm="0.25" biastype="affine" biasprm="0 0 -0.125"/>'),
);

async function compare(name, { given, period_s }) {
  writeFileSync('commands.csv', commands_text(period_s));
  const wanted = by_wheelwright(name, period_s);
  const gap = apart(await simulate(velocity, read_commands('commands.csv')), wanted);
  const left = apart(await by_mujoco(name, given), wanted);
  const share = (100 * left.position_m) / gap.position_m;
  console.log(
    `${name} in ${given}, period ${period_s} s: before ${shown(gap)}; after ${shown(left)}; ${share.toFixed(2)} % of the gap is left`,
  );
  return share;
}

for (const name of Object.keys(effects)) {
  test(`MuJoCo with ${name} moves as the model does`, async () => {
    assert.ok((await compare(name, usual)) <= (reached[name] ?? goal), 'more of the gap is left than was');
  });
}

test('A general actuator with a gear does as a velocity actuator', async () => {
  assert.ok((await compare('unequal_gains', { ...usual, given: 'general.xml' })) <= goal);
});

test('Friction is the same where the model has steps as short as those of MuJoCo', async () => {
  assert.ok((await compare('coulomb_friction', { ...usual, period_s: 0.002 })) <= goal);
});
