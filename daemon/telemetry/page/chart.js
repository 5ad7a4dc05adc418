// Colours come from the style sheet, so that pictures follow the theme.
const ink = {};
function readInk() {
  const style = getComputedStyle(document.documentElement);
  for (const name of ['text', 'quiet', 'line', 'card', 'accent', 'tint', 'alarm', 'filter']) {
    ink[name] = style.getPropertyValue('--' + name).trim();
  }
}

// A canvas at the resolution of the screen; returns its context in CSS pixels, and its size.
function prepared(canvas) {
  const { width, height } = canvas.getBoundingClientRect();
  const ratio = window.devicePixelRatio || 1;
  if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
  }
  const context = canvas.getContext('2d');
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, width, height);
  context.font = '11px system-ui, sans-serif';
  context.lineJoin = 'round';
  return { context, width, height };
}

// The round number at or above a positive one: 1, 2 or 5 times a power of ten.
function roundUp(value) {
  const power = Math.pow(10, Math.floor(Math.log10(value)));
  return [1, 2, 5, 10].find(factor => factor * power >= value * 0.999999) * power;
}

// Samples of the last seconds: rows of a time in s and one value per series, null where there is none.
class Samples {
  constructor(span_s) { this.span_s = span_s; this.rows = []; }
  add(t, values) {
    const last = this.rows.at(-1);
    if (last && (t < last.t || t > last.t + 60)) this.rows = [];  // another run, or a clock that was set
    this.rows.push({ t, values });
    let old = 0;
    while (this.rows[old].t < t - this.span_s - 1) ++old;
    if (old > 200) this.rows.splice(0, old);
  }
  clear() { this.rows = []; }
  get latest() { return this.rows.length ? this.rows.at(-1).t : 0; }
  since(t) { return this.rows.filter(row => row.t >= t); }
}

const margin = { left: 58, right: 10, top: 8, bottom: 18 };

function drawTimeAxis(context, width, height, span_s) {
  context.fillStyle = ink.quiet;
  context.textBaseline = 'alphabetic';
  const step = roundUp(span_s / 5);
  for (let ago = 0; ago <= span_s; ago += step) {
    const x = width - margin.right - (ago / span_s) * (width - margin.left - margin.right);
    context.textAlign = ago === 0 ? 'right' : 'center';
    context.fillText(ago === 0 ? 'now' : `\u2212${ago} s`, ago === 0 ? width - margin.right + 4 : x, height - 4);
  }
}

function drawLevel(context, width, y, label) {
  context.strokeStyle = ink.line;
  context.lineWidth = 1;
  context.beginPath();
  context.moveTo(margin.left, Math.round(y) + .5);
  context.lineTo(width - margin.right, Math.round(y) + .5);
  context.stroke();
  context.fillStyle = ink.quiet;
  context.textAlign = 'right';
  context.textBaseline = 'middle';
  context.fillText(label, margin.left - 6, y);
}

// Speeds over time. `series` says for each value of a row how it is drawn: {ink, width, dash, steps, clip}. What is
// clipped may leave the picture: a jump of a counter is not to make everything else small.
function drawSpeeds(canvas, samples, series) {
  const { context, width, height } = prepared(canvas);
  const end = samples.latest;
  const rows = samples.since(end - samples.span_s);
  let largest = 0.05;
  let smallest = 0;
  for (const row of rows) {
    row.values.forEach((value, index) => {
      if (value === null || series[index].clip) return;
      largest = Math.max(largest, 1.25 * value);
      smallest = Math.min(smallest, 1.25 * value);
    });
  }
  const step = roundUp((largest - smallest) / 4);
  const top = Math.ceil(largest / step - 1e-6) * step;
  const bottom = Math.floor(smallest / step + 1e-6) * step;
  const y = value => margin.top + (top - value) / (top - bottom) * (height - margin.top - margin.bottom);
  const x = t => width - margin.right - (end - t) / samples.span_s * (width - margin.left - margin.right);
  const decimals = step < 0.1 ? 2 : 1;
  for (let i = Math.round(bottom / step); i <= Math.round(top / step); ++i) {
    const text = (i * step).toFixed(decimals).replace('-', '\u2212');
    drawLevel(context, width, y(i * step), i === Math.round(top / step) ? text + ' m/s' : text);
  }
  drawTimeAxis(context, width, height, samples.span_s);
  context.save();
  context.beginPath();
  context.rect(margin.left, margin.top - 2, width - margin.left - margin.right, height - margin.top - margin.bottom + 4);
  context.clip();
  series.forEach((look, index) => {
    context.strokeStyle = ink[look.ink];
    context.lineWidth = look.width;
    context.setLineDash(look.dash || []);
    context.beginPath();
    let before = null;
    for (const row of rows) {
      const value = row.values[index];
      if (value === null) { before = null; continue; }
      if (before === null) context.moveTo(x(row.t), y(value));
      else {
        if (look.steps) context.lineTo(x(row.t), y(before));
        context.lineTo(x(row.t), y(value));
      }
      before = value;
    }
    context.stroke();
  });
  context.restore();
}

// Lateness over time, on a logarithmic scale from 10 us to 100 ms; the period of the loop as a line.
function drawLateness(canvas, samples, period_s) {
  const { context, width, height } = prepared(canvas);
  const end = samples.latest;
  const y = us => {
    const share = (Math.log10(Math.min(Math.max(us, 10), 1e5)) - 1) / 4;
    return height - margin.bottom - share * (height - margin.top - margin.bottom);
  };
  for (const [us, label] of [[10, '10 \u00b5s'], [100, '100 \u00b5s'], [1e3, '1 ms'], [1e4, '10 ms'], [1e5, '']]) {
    drawLevel(context, width, y(us), label);
  }
  drawTimeAxis(context, width, height, samples.span_s);
  if (period_s) {
    const at = y(1e6 * period_s);
    context.strokeStyle = ink.alarm;
    context.setLineDash([3, 3]);
    context.beginPath();
    context.moveTo(margin.left, at);
    context.lineTo(width - margin.right, at);
    context.stroke();
    context.setLineDash([]);
    context.fillStyle = ink.quiet;
    context.textAlign = 'right';
    context.textBaseline = 'bottom';
    context.fillText(`one period, ${+(1e3 * period_s).toFixed(3)} ms`, width - margin.right, at - 1);
  }
  context.fillStyle = ink.accent;
  for (const row of samples.since(end - samples.span_s)) {
    const x = width - margin.right - (end - row.t) / samples.span_s * (width - margin.left - margin.right);
    context.fillRect(x - 1, y(row.values[0]) - 1, 2, 2);
  }
}
