/* caster_kick: a short yaw disturbance after the direction of travel flips.
   Inverse: nothing to undo at a steady speed; the kick itself is over before a command could act. */
typedef struct {
  double direction, kick, swung;
  ww_pair fork; /* cosine and sine of its angle from behind the pivot */
  ww_twist taken; /* by the friction of a stiff pivot */
} caster_kick_state;

static inline void caster_kick_reset(caster_kick_state* s, const double* p, int variant) {
  s->direction = 0.0;
  s->kick = 0.0;
  s->swung = 1.0;
  s->fork.left = variant == 3 || variant == 6 ? cos(p[3]) : 1.0;
  s->fork.right = variant == 3 || variant == 6 ? sin(p[3]) : 0.0;
  s->taken.v = 0.0;
  s->taken.w = 0.0;
}

static inline void caster_kick_swing(caster_kick_state* s, const double* p, int variant,
                                     const ww_around* around, ww_twist* twist) {
  const double moving = 0.005;
  const int alternates = variant == 1 || variant == 5;
  const int ploughs = variant >= 4;
  const double v = twist->v;
  double ahead, before;
  if (fabs(v) > moving) {
    const double direction = copysign(1.0, v);
    if (s->direction != 0.0 && direction != s->direction) {
      s->swung = ww_clamp(1.0 - s->swung, p[2], 1.0 - p[2]);
      s->kick = alternates ? direction * p[0] : p[0];
    }
    s->direction = direction;
  }
  ahead = (1.0 - s->swung) * exp(-fabs(v) * around->period_s / p[1]);
  before = s->swung;
  s->swung /= s->swung + ahead;
  twist->w += s->kick * (ploughs ? 4.0 * before * (1.0 - before) * tanh(fabs(v) / moving)
                                 : (s->swung - before) / (1.0 - p[2]) / around->period_s);
}

/* The direction `a`, given by its cosine and sine, turned by `b`, or back by it. */
static inline ww_pair caster_kick_turned(ww_pair a, ww_pair b) {
  ww_pair turned;
  turned.left = a.left * b.left - a.right * b.right;
  turned.right = a.right * b.left + a.left * b.right;
  return turned;
}

static inline ww_pair caster_kick_turned_back(ww_pair a, ww_pair b) {
  b.right = -b.right;
  return caster_kick_turned(a, b);
}

static inline ww_pair caster_kick_direction(double x, double y) {
  const double length = sqrt(x * x + y * y);
  ww_pair direction;
  direction.left = length > 0.0 ? x / length : 1.0;
  direction.right = length > 0.0 ? y / length : 0.0;
  return direction;
}

static inline double caster_kick_tangent_of_half(ww_pair direction) {
  const double largest = 1e16;
  const double other = 1.0 - direction.left;
  if (direction.left > 0.0) return direction.right / (1.0 + direction.left);
  return fabs(direction.right) * largest > other ? other / direction.right : copysign(largest, direction.right);
}

/* How fast the fork swivels, seen from the robot; `middle` is where it points in the middle of the period, and
   `ahead` is 1 for a fork that its pivot pushes ahead of itself. */
static inline double caster_kick_drag(caster_kick_state* s, double trail, double arm, double lean,
                                      ww_twist twist, double period_s, ww_pair* middle, double* ahead) {
  const double sideways = twist.w * arm;
  const double pivot = sqrt(twist.v * twist.v + sideways * sideways);
  const double half = 0.5 * twist.w * period_s;
  ww_pair turn, behind, off, end, leaning;
  double before, after, scale;
  turn.left = cos(half);
  turn.right = sin(half);
  behind = caster_kick_direction(twist.v, sideways);
  leaning.left = cos(lean * behind.left);
  leaning.right = sin(lean * behind.left);
  behind = caster_kick_turned(behind, leaning);
  off = caster_kick_turned_back(caster_kick_turned_back(s->fork, turn), behind);
  before = caster_kick_tangent_of_half(off);
  after = before * exp(-pivot * period_s / trail);
  scale = 1.0 / (1.0 + after * after);
  end.left = (1.0 - after * after) * scale;
  end.right = 2.0 * after * scale;
  *middle = caster_kick_turned(
      caster_kick_turned(caster_kick_direction(off.left + end.left, off.right + end.right), behind), turn);
  *ahead = fmax(0.0, -0.5 * (off.left + end.left));
  s->fork = caster_kick_turned_back(caster_kick_turned(end, behind), turn);
  return 2.0 * atan((after - before) / (1.0 + after * before)) / period_s - twist.w;
}

/* Friction of the pivot, which takes the less the more the robot turns with its fork. */
static inline void caster_kick_stiff(caster_kick_state* s, const double* p, const ww_around* around,
                                     ww_twist* twist) {
  const double share = around->period_s / (around->period_s + p[3]);
  const double push = share * p[0];
  const double arm = 4.0 * p[2] / (around->wheel_base_m * around->wheel_base_m);
  caster_kick_state trial = *s;
  ww_twist kept, whole, pushed;
  ww_pair middle, other;
  double free, sign, slower, part, ahead;
  kept.v = (1.0 - share) * s->taken.v;
  kept.w = (1.0 - share) * s->taken.w;
  pushed.v = twist->v + kept.v;
  pushed.w = twist->w + kept.w;
  free = caster_kick_drag(&trial, p[1], p[2], 0.0, pushed, around->period_s, &middle, &ahead);
  whole.v = push * middle.right;
  whole.w = -push * middle.left * arm;
  sign = copysign(1.0, free);
  pushed.v += sign * whole.v;
  pushed.w += sign * whole.w;
  trial = *s;
  slower = sign * (free - caster_kick_drag(&trial, p[1], p[2], 0.0, pushed, around->period_s, &other, &ahead));
  part = tanh(free / (p[4] + (slower > 0.0 ? slower : 0.0)));
  s->taken.v = kept.v + part * whole.v;
  s->taken.w = kept.w + part * whole.w;
  twist->v += s->taken.v;
  twist->w += s->taken.w;
  caster_kick_drag(s, p[1], p[2], 0.0, *twist, around->period_s, &middle, &ahead);
}

/* Variants: same, alternating, swivel, swing, ploughing_same, ploughing_alternating, ploughing. */
static inline void caster_kick_body(caster_kick_state* s, const double* p, int variant,
                                    const ww_around* around, ww_twist* twist) {
  const double moving = 0.005;
  ww_pair middle;
  double ahead;
  if (variant == 2) {
    caster_kick_stiff(s, p, around, twist);
  } else if (variant == 3) {
    const double swivel = caster_kick_drag(s, p[1], p[2], p[3], *twist, around->period_s, &middle, &ahead);
    twist->w += p[0] / ww_pi * swivel;
  } else if (variant == 6) {
    const double share = tanh(fabs(twist->v) / moving);
    caster_kick_drag(s, p[1], p[2], p[3], *twist, around->period_s, &middle, &ahead);
    twist->w += p[0] * middle.right * ahead * share;
  } else {
    caster_kick_swing(s, p, variant, around, twist);
  }
}
