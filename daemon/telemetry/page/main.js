const at = id => document.getElementById(id);

const phases = {
  idle: 'Standing, not armed', wait_until_still: 'Waiting until the robot stands still',
  encoder_check: 'Calibration: which counter is the left wheel\u2019s',
  await_encoder_order: 'Calibration: which counter is the left wheel\u2019s',
  encoder_turn: 'Calibration A: turning past the surroundings', await_encoder_scale: 'Calibration A: fitting the scale',
  left_on: 'Calibration B: left wheel on', left_off: 'Calibration B: left wheel off',
  right_on: 'Calibration B: right wheel on', right_off: 'Calibration B: right wheel off',
  await_response: 'Calibration B: fitting the response', random_drive: 'Calibration C: random drive',
  await_arma: 'Calibration C: fitting the model', route: 'Driving', commanded_drive: 'Driving given commands', finished: 'Finished', stopped: 'Stopped',
};
const wheelSeries = [{ ink: 'quiet', width: 1.5, dash: [2, 3], steps: true }, { ink: 'text', width: 1.2, clip: true },
                     { ink: 'accent', width: 2.2 }];
const bumperNames = ['left', 'front_left', 'center_left', 'center_right', 'front_right', 'right'];
const bumperLabels = ['L', 'FL', 'CL', 'CR', 'FR', 'R'];

const floor = new Floor(at('floor'));
const wheels = { left: new Samples(12), right: new Samples(12) };
const lateness = new Samples(60);
let state = null;
let sessionId = null;
let mayControl = false;
let connected = false;
let stopping = '';  // what became of the button: '', 'asked', 'taken', or why not
let faults = { left: 'none', right: 'none' };
let bumper = null;
let hasModel = false;

function clearAll() {
  floor.clear();
  wheels.left.clear();
  wheels.right.clear();
  lateness.clear();
  at('messages').replaceChildren();
  state = bumper = null;
  hasModel = false;
  faults = { left: 'none', right: 'none' };
  stopping = '';
}

const handlers = {
  '/pose': message => { floor.takePose(message.pose); schedule.changed('floor'); },
  '/scene': message => { floor.takeScene(message); schedule.changed('floor', 'legend'); },
  '/wheels': (message, t) => {
    for (const side of ['left', 'right']) {
      const wheel = message[side];
      wheels[side].add(t, [wheel.command_m_s, smoothed(side, t, wheel.measured_m_s), wheel.predicted_m_s]);
      faults[side] = wheel.fault;
      hasModel ||= wheel.predicted_m_s !== null;
    }
    schedule.changed('wheels', 'texts');
  },
  '/light_bumper': message => { bumper = message; schedule.changed('bumper'); },
  '/loop': (message, t) => { lateness.add(t, [message.lateness_us]); schedule.changed('lateness'); },
  '/state': message => {
    // Armed anew: what was stopped before is over.
    if (state && state.stop !== 'none' && message.stop === 'none') stopping = '';
    state = message;
    floor.setVisited(message.checkpoints_visited);
    schedule.changed('texts', 'floor');
  },
  '/log': message => addMessage(message),
};

// An encoder tick is coarse: the speed from one tick to the next is mostly noise.
const recent = { left: [], right: [] };
function smoothed(side, t, value) {
  const last = recent[side];
  while (last.length && (last[0].t < t - 0.1 || last[0].t > t)) last.shift();
  if (value !== null) last.push({ t, value });
  return last.length ? last.reduce((sum, one) => sum + one.value, 0) / last.length : null;
}

function addMessage({ timestamp, level, message }) {
  const row = document.createElement('li');
  const time = document.createElement('time');
  const text = document.createElement('span');
  time.textContent = new Date(1e3 * timestamp.sec + 1e-6 * timestamp.nsec).toLocaleTimeString([], { hour12: false });
  text.textContent = message;
  text.className = level >= 4 ? 'error' : level === 3 ? 'warning' : '';
  row.append(time, text);
  const list = at('messages');
  list.prepend(row);
  while (list.children.length > 200) list.lastChild.remove();
}

const connection = new Connection(new Set(Object.keys(handlers)), {
  open(info) {
    if (info.sessionId !== sessionId) clearAll();
    at('messages').replaceChildren();  // they come again
    sessionId = info.sessionId;
    mayControl = info.mayControl;
    connected = true;
    at('robot').textContent = info.name;
    document.title = info.name + ' \u00b7 Wheelwright';
    schedule.changedAll();
  },
  message(topic, message, time_s) {
    handlers[topic]?.(message, time_s);
  },
  closed() {
    connected = false;
    schedule.changed('texts');
  },
});

async function stop() {
  if (at('stop').disabled) return;
  stopping = 'asked';
  showStop();
  const patience = setTimeout(() => {
    if (stopping !== 'asked') return;
    stopping = 'no answer yet';
    schedule.changed('texts');
  }, 1000);
  try {
    await connection.stop();
    stopping = 'taken';
  } catch (error) {
    stopping = error.message;
  }
  clearTimeout(patience);
  schedule.changed('texts');
}
// A finger counts when it comes down, not when it leaves.
at('stop').addEventListener('pointerdown', event => { if (event.button === 0) stop(); });
at('stop').addEventListener('click', event => { if (event.detail === 0) stop(); });  // keyboard

function showStop() {
  const button = at('stop');
  const stopped = state && state.stop !== 'none';
  const over = state && (state.result || state.activity === 'finished');
  button.disabled = !connected || !mayControl || !state || stopped || over || stopping === 'asked';
  button.textContent = !connected ? 'No connection' : !mayControl ? 'Watching only' : stopped ? 'Stopped'
    : over ? 'Finished' : stopping === 'asked' || stopping === 'taken' ? 'Stopping' : 'Stop';
}

// What stands in the banner, and how it looks: calm, mild or alarming.
function notice() {
  const undelivered = stopping && stopping !== 'asked' && stopping !== 'taken';
  if (connected && undelivered) {
    return [`The order to stop did not get through: ${stopping}. Use the robot\u2019s own button.`, 'alarming'];
  }
  if (state?.result === 'finished') return [state.outcome ? `The run has finished: ${state.outcome}.` : 'The run has finished.', 'calm'];
  if (state?.result) return [`The run has ended: ${state.result}.`, connected ? 'alarming' : 'mild'];
  if (!connected) return ['No connection to the daemon; what is shown is the last that came.', 'mild'];
  if (state && state.stop !== 'none') {
    return [`The wheels are stopped: ${state.stop === 'requested' ? 'on request' : state.stop}.`, 'alarming'];
  }
  const broken = ['left', 'right'].filter(side => faults[side] !== 'none').map(side => `${side} wheel: ${faults[side]}`);
  if (broken.length) return [`Fault, ${broken.join('; ')}.`, 'mild'];
  if (state?.recalibration_due) return ['The model does not fit any more: calibrate again.', 'mild'];
  if (state && !state.robot_answers) return ['The robot does not answer.', 'mild'];
  return null;
}

function setText(element, text) {
  if (element.textContent !== text) element.textContent = text;
}

function showTexts() {
  showStop();
  document.body.classList.toggle('live', connected);
  document.body.classList.toggle('stale', !connected && sessionId !== null);
  setText(at('connection'), connected ? (mayControl ? 'Live' : 'Live, watching only')
    : sessionId === null ? 'Connecting' : 'Connecting again');
  const note = notice();
  at('notice').hidden = !note || sessionId === null;
  if (note) {
    setText(at('notice'), note[0]);
    at('notice').className = note[1];
  }
  if (!state) return;
  const phase = phases[state.activity] || state.activity;
  setText(at('phase'), state.activity === 'route'
    ? `${phase} \u2018${state.route}\u2019, ${state.checkpoints_visited} of ${state.checkpoints} checkpoints` : phase);
  const facts = [['Run', `${Math.floor(state.run_s / 60)}:${String(Math.floor(state.run_s % 60)).padStart(2, '0')} min`],
                 ['Steered by', state.pose_source === 'fir' || state.pose_source === 'arma'
                   ? `model (${state.pose_source})` : state.pose_source],
                 ['Battery', state.battery_v === undefined ? '\u2013' : `${state.battery_v.toFixed(1)} V`]];
  if (hasModel) facts.push(['Model', `version ${state.model_version}`]);
  if (floor.pose) {
    const { x, y, theta } = floor.pose;
    const text = value => value.toFixed(2).replace('-', '\u2212');
    facts.push(['Pose', `${text(x)} m, ${text(y)} m, ${(Math.atan2(Math.sin(theta), Math.cos(theta)) * 180 / Math.PI).toFixed(0).replace('-', '\u2212')}\u00b0`]);
  }
  facts.forEach(([name, value], i) => {
    const item = at('facts').children[i] ?? addFact();
    setText(item.children[0], name);
    setText(item.children[1], value);
  });
  while (at('facts').children.length > facts.length) at('facts').lastChild.remove();
}

function addFact() {
  const item = document.createElement('div');
  item.append(document.createElement('dt'), document.createElement('dd'));
  at('facts').append(item);
  return item;
}

function showBumper() {
  if (!bumper) return;
  bumperNames.forEach((name, i) => {
    const item = at('bars').children[i];
    const height = `${(100 * Math.min(1, bumper[name] / 4095)).toFixed(0)}%`;
    const bar = item.querySelector('i');
    if (bar.style.height !== height) bar.style.height = height;
    setText(item.querySelector('b'), String(bumper[name]));
  });
  setText(at('bump'), bumper.bump_left || bumper.bump_right
    ? `bump ${bumper.bump_left ? 'left ' : ''}${bumper.bump_right ? 'right' : ''}` : 'of 4095');
}

function microseconds(us) {
  return us < 1000 ? `${us.toFixed(0)} \u00b5s` : `${(us / 1000).toFixed(1)} ms`;
}

function showLateness() {
  const sorted = lateness.rows.map(row => row.values[0]).sort((a, b) => a - b);
  if (!sorted.length) return;
  const share = part => sorted[Math.min(sorted.length - 1, Math.floor(part * sorted.length))];
  at('lateness-facts').textContent =
    `half below ${microseconds(share(.5))}, 99 % below ${microseconds(share(.99))}, worst ${microseconds(sorted.at(-1))}`;
}

function showLegend() {
  const ways = floor.ways().reverse();
  const names = ways.map(look => look.id).join(' ');
  if (at('floor-legend').dataset.names === names) return;
  at('floor-legend').dataset.names = names;
  at('floor-legend').replaceChildren(...ways.map(
    look => Object.assign(document.createElement('span'), { className: look.id, textContent: look.label })));
}

// Often enough for the eye, and no more: most of the cost is the browser's, for each picture anew.
const schedule = new DrawSchedule({
  floor: { every_ms: 100, draw: () => floor.draw() },
  wheels: { every_ms: 200, draw: () => {
    drawSpeeds(at('wheel-left'), wheels.left, wheelSeries);
    drawSpeeds(at('wheel-right'), wheels.right, wheelSeries);
  } },
  texts: { every_ms: 300, draw: showTexts },
  bumper: { every_ms: 200, draw: showBumper },
  legend: { every_ms: 500, draw: showLegend },
  lateness: { every_ms: 500, draw: () => { showLateness(); drawLateness(at('lateness'), lateness, state?.period_s); } },
});

bumperLabels.forEach(label => {
  const item = document.createElement('div');
  item.innerHTML = `<div class="well"><i></i></div><span>${label} <b></b></span>`;
  at('bars').append(item);
});
readInk();
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => { readInk(); floor.redrawGround(); schedule.changedAll(); });
addEventListener('resize', () => schedule.changedAll());
schedule.changedAll();
