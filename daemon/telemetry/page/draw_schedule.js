// Draws the parts of the page that changed, each at most so often, and nothing while nobody can see it: a browser that draws each
// message takes a processor core, which the machine may need for the robot.
class DrawSchedule {
  // `parts` holds by name {every_ms, draw}.
  constructor(parts) {
    this.parts = new Map(Object.entries(parts).map(([name, part]) => [name, { ...part, dirty: false, drawn_ms: -Infinity }]));
    this.planned = false;
    document.addEventListener('visibilitychange', () => this.plan());
  }

  changed(...names) {
    for (const name of names) this.parts.get(name).dirty = true;
    this.plan();
  }

  changedAll() { this.changed(...this.parts.keys()); }

  // One timer for all, until the first part that changed may be drawn.
  plan() {
    if (this.planned || document.hidden) return;
    const due = Math.min(...[...this.parts.values()].filter(part => part.dirty).map(part => part.drawn_ms + part.every_ms));
    if (due === Infinity) return;
    this.planned = true;
    const wait_ms = Math.min(Math.max(due - performance.now(), 0), shortest_ms);
    setTimeout(() => (this.due().length ? requestAnimationFrame(() => this.draw()) : this.draw()), wait_ms);
  }

  // What changed and was last drawn so long ago, as a share of its own time.
  due(share = 1) {
    const now = performance.now();
    return [...this.parts.values()].filter(part => part.dirty && now >= part.drawn_ms + share * part.every_ms - tolerance_ms);
  }

  // What is due soon is drawn with what is due: each picture costs the browser much, whatever is new in it.
  draw() {
    this.planned = false;
    for (const part of this.due().length ? this.due(0.75) : []) {
      part.dirty = false;
      part.drawn_ms = performance.now();
      part.draw();
    }
    this.plan();
  }
}

const shortest_ms = 1000 / 15;
const tolerance_ms = 4;
