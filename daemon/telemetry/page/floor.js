// The floor: what /scene holds, and the robot where it is by the pose that it steers by. What stays, the ground with route and
// ways, is drawn when it changes, and copied under the robot.
class Floor {
  constructor(canvas) {
    this.canvas = canvas;
    this.ground = document.createElement('canvas');
    this.clear();
  }

  clear() {
    this.entities = new Map();
    this.pose = null;
    this.bounds = null;
    this.redrawGround();
  }

  redrawGround() { this.groundIsOld = true; }

  setVisited(count) {
    if (count !== this.visited) this.redrawGround();
    this.visited = count;
  }

  takeScene(update) {
    if (update.deletions.length || update.entities.some(entity => !isEllipse(entity.id) && entity.id !== 'robot')) {
      this.redrawGround();
    }
    for (const deletion of update.deletions) {
      if (deletion.type === 1) this.entities.clear();
      else this.entities.delete(deletion.id);
    }
    if (update.deletions.length) this.bounds = null;
    for (const entity of update.entities) this.entities.set(entity.id, entity);
    for (const [id, entity] of this.entities) {
      if (!isEllipse(id)) for (const line of entity.lines) line.points.forEach(point => this.include(point));
      if (id === 'checkpoints') entity.spheres.forEach(sphere => this.include(sphere.pose.position));
    }
  }

  takePose(pose) {
    const { x, y } = pose.position;
    const { z, w } = pose.orientation;
    this.pose = { x, y, theta: 2 * Math.atan2(z, w) };
    this.include(this.pose);
  }

  // In steps, so that a robot on its way out does not change the scale with each message.
  include({ x, y }) {
    const b = this.bounds || (this.bounds = { left: x, right: x, bottom: y, top: y });
    if (x >= b.left && x <= b.right && y >= b.bottom && y <= b.top) return;
    b.left = Math.min(b.left, Math.floor(x / boundsStep_m) * boundsStep_m);
    b.right = Math.max(b.right, Math.ceil(x / boundsStep_m) * boundsStep_m);
    b.bottom = Math.min(b.bottom, Math.floor(y / boundsStep_m) * boundsStep_m);
    b.top = Math.max(b.top, Math.ceil(y / boundsStep_m) * boundsStep_m);
    this.redrawGround();
  }

  // The names of the ways that there are.
  ways() {
    return wayLooks.filter(look => [...this.entities.keys()].some(id => id.startsWith(look.id + '/')));
  }

  draw() {
    const { context, width, height } = prepared(this.canvas);
    const b = this.bounds || { left: -.5, right: .5, bottom: -.5, top: .5 };
    const room = .3;  // the robot's body, and some
    const scale = Math.min(width / Math.max(b.right - b.left + 2 * room, 1),
                           height / Math.max(b.top - b.bottom + 2 * room, 1));
    const x = value => width / 2 + scale * (value - (b.left + b.right) / 2);
    const y = value => height / 2 - scale * (value - (b.bottom + b.top) / 2);
    this.drawGround(width, height, scale, x, y);
    context.drawImage(this.ground, 0, 0, width, height);
    this.drawRobot(context, scale, x, y);
    this.drawEllipse(context, 'predicted_covariance', ink.accent, x, y);
    this.drawEllipse(context, 'covariance', ink.filter, x, y);
  }

  drawEllipse(context, id, stroke, x, y) {
    for (const line of this.lines(id)) {
      strip(context, line.points, x, y);
      context.fillStyle = ink.tint;
      context.strokeStyle = stroke;
      context.lineWidth = 1.2;
      context.fill();
      context.stroke();
    }
  }

  lines(id) { return this.entities.get(id)?.lines ?? []; }

  drawGround(width, height, scale, x, y) {
    const { canvas, ground } = this;
    if (!this.groundIsOld && ground.width === canvas.width && ground.height === canvas.height) return;
    this.groundIsOld = false;
    ground.width = canvas.width;
    ground.height = canvas.height;
    const context = ground.getContext('2d');
    const ratio = canvas.width / width;
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.font = '11px system-ui, sans-serif';
    context.lineJoin = 'round';
    this.drawGrid(context, width, height, scale, x, y);
    for (const line of this.lines('route')) {
      strip(context, line.points, x, y);
      context.strokeStyle = ink.quiet;
      context.lineWidth = 1;
      context.setLineDash([2, 4]);
      context.stroke();
      context.setLineDash([]);
    }
    for (const look of wayLooks) {
      context.strokeStyle = ink[look.ink];
      context.lineWidth = look.width;
      context.setLineDash(look.dash || []);
      for (const [id, entity] of this.entities) {
        if (!id.startsWith(look.id + '/')) continue;
        for (const line of entity.lines) { strip(context, line.points, x, y); context.stroke(); }
      }
      context.setLineDash([]);
    }
    this.drawCheckpoints(context, scale, x, y);
  }

  drawGrid(context, width, height, scale, x, y) {
    const step = roundUp(60 / scale);
    context.strokeStyle = ink.line;
    context.lineWidth = 1;
    context.beginPath();
    const first = (at, origin) => Math.ceil((at - origin) / (step * scale));
    for (let i = first(0, x(0)); x(i * step) < width; ++i) {
      context.moveTo(Math.round(x(i * step)) + .5, 0);
      context.lineTo(Math.round(x(i * step)) + .5, height);
    }
    for (let i = first(0, y(0)); y(0) + i * step * scale < height; ++i) {
      const at = Math.round(y(0) + i * step * scale) + .5;
      context.moveTo(0, at);
      context.lineTo(width, at);
    }
    context.stroke();
    const bar = step * scale;
    context.fillStyle = ink.card;
    context.fillRect(8, height - 27, bar + 8, 21);
    context.strokeStyle = ink.text;
    context.beginPath();
    context.moveTo(12.5, height - 14);
    context.lineTo(12.5, height - 9.5);
    context.lineTo(12.5 + bar, height - 9.5);
    context.lineTo(12.5 + bar, height - 14);
    context.stroke();
    context.fillStyle = ink.quiet;
    context.textAlign = 'center';
    context.textBaseline = 'bottom';
    context.fillText(`${+step.toFixed(3)} m`, 12.5 + bar / 2, height - 12);
  }

  drawCheckpoints(context, scale, x, y) {
    const visited = this.visited || 0;
    (this.entities.get('checkpoints')?.spheres ?? []).forEach((sphere, i) => {
      const { x: px, y: py } = sphere.pose.position;
      context.beginPath();
      context.arc(x(px), y(py), Math.max(4.5, scale * sphere.size.x / 2), 0, 2 * Math.PI);
      context.fillStyle = i < visited ? ink.accent : ink.card;
      context.strokeStyle = i < visited ? ink.accent : ink.quiet;
      context.lineWidth = 1.5;
      context.fill();
      context.stroke();
    });
  }

  drawRobot(context, scale, x, y) {
    if (!this.pose) return;
    const body = this.entities.get('robot')?.cylinders[0];
    const radius = Math.max(6, scale * (body ? body.size.x : .34) / 2);
    const cx = x(this.pose.x);
    const cy = y(this.pose.y);
    context.beginPath();
    context.arc(cx, cy, radius, 0, 2 * Math.PI);
    context.fillStyle = ink.tint;
    context.strokeStyle = ink.accent;
    context.lineWidth = 2;
    context.fill();
    context.moveTo(cx, cy);
    context.lineTo(cx + radius * Math.cos(this.pose.theta), cy - radius * Math.sin(this.pose.theta));
    context.stroke();
  }
}

const boundsStep_m = 0.1;

// A path through points of the floor; what would not move by half a pixel is left out.
function strip(context, points, x, y) {
  context.beginPath();
  let last = null;
  points.forEach((point, i) => {
    const here = { x: x(point.x), y: y(point.y) };
    if (last && i < points.length - 1 && Math.abs(here.x - last.x) < 0.5 && Math.abs(here.y - last.y) < 0.5) return;
    (last ? context.lineTo : context.moveTo).call(context, here.x, here.y);
    last = here;
  });
}

// The 95 % ellipse of a pose: it comes and goes with the robot, and is no part of the floor.
function isEllipse(id) {
  return id === 'covariance' || id === 'predicted_covariance';
}

const wayLooks = [
  { id: 'odometry', label: 'odometry', ink: 'quiet', width: 2 },
  { id: 'filtered', label: 'filtered, with 95 % ellipse', ink: 'filter', width: 2, dash: [6, 2] },
  { id: 'truth', label: 'truth', ink: 'alarm', width: 1.5, dash: [5, 3] },
  { id: 'predicted', label: 'model, with 95 % ellipse', ink: 'accent', width: 3 },
];
