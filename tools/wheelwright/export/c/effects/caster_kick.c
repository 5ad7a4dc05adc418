/* caster_kick: a short yaw disturbance after the direction of travel flips.
   Inverse: nothing to undo at a steady speed; the kick itself is over before a command could act. */
typedef struct {
  double direction, kick, swung, angle;
} caster_kick_state;

static inline void caster_kick_reset(caster_kick_state* s, const double* p, int variant) {
  s->direction = 0.0;
  s->kick = 0.0;
  s->swung = 1.0;
  s->angle = variant == 3 ? p[3] : 0.0;
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

/* How fast the fork swivels, seen from the robot; `middle` is its angle in the middle of the period. */
static inline double caster_kick_drag(caster_kick_state* s, double trail, double arm, double lean,
                                      ww_twist twist, double period_s, double* middle) {
  const double sideways = twist.w * arm;
  const double heading = atan2(sideways, twist.v);
  const double behind = heading + lean * cos(heading);
  double off, turned, swivel;
  off = remainder(s->angle - 0.5 * twist.w * period_s - behind, 2.0 * ww_pi);
  turned = 2.0 * atan(tan(0.5 * off) * exp(-hypot(twist.v, sideways) * period_s / trail)) - off;
  *middle = s->angle + 0.5 * turned;
  swivel = turned / period_s - twist.w;
  s->angle += turned - twist.w * period_s;
  return swivel;
}

/* Variants: same, alternating, swivel, swing, ploughing_same, ploughing_alternating. */
static inline void caster_kick_body(caster_kick_state* s, const double* p, int variant,
                                    const ww_around* around, ww_twist* twist) {
  double middle, swivel;
  if (variant != 2 && variant != 3) {
    caster_kick_swing(s, p, variant, around, twist);
    return;
  }
  swivel = caster_kick_drag(s, p[1], p[2], variant == 3 ? p[3] : 0.0, *twist, around->period_s, &middle);
  if (variant == 3) {
    twist->w += p[0] / ww_pi * swivel;
  } else {
    const double push = p[0] * tanh(swivel / 0.7);
    twist->v += push * sin(middle);
    twist->w -= push * cos(middle) * 4.0 * p[2] / (around->wheel_base_m * around->wheel_base_m);
  }
}
