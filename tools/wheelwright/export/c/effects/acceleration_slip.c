/* acceleration_slip: distance is lost when speeding up or slowing down hard.
   Inverse: nothing to undo at a steady speed. */
typedef struct {
  double speed[2];
  int slides[2];
} acceleration_slip_state;

static inline void acceleration_slip_reset(acceleration_slip_state* s, const double* p, int variant) {
  (void)p;
  (void)variant;
  s->speed[0] = s->speed[1] = 0.0;
  s->slides[0] = s->slides[1] = 0;
}

static inline double acceleration_slip_rolled(const double* p, int variant, double speed, double change) {
  const double lost = p[0] * fmax(0.0, fabs(change) - p[1]);
  if (variant == 0) return speed * (1.0 - fmin(lost, 1.0));
  return copysign(fmax(0.0, fabs(speed) - lost * 0.2), speed);
}

static inline double acceleration_slip_dragged(acceleration_slip_state* s, int wheel, const double* p,
                                               double speed, double period_s) {
  const double wanted = (speed - s->speed[wheel]) / period_s;
  const double sliding = 1.0 / fmax(p[0], 1e-3);
  const double given = s->slides[wheel] ? sliding : fmax(p[1], sliding);
  s->slides[wheel] = fabs(wanted) > given;
  s->speed[wheel] = s->slides[wheel] ? s->speed[wheel] + copysign(sliding, wanted) * period_s : speed;
  return s->speed[wheel];
}

/* Variants: relative, absolute, sliding. */
static inline void acceleration_slip_wheels(acceleration_slip_state* s, const double* p, int variant,
                                            const ww_around* around, ww_pair* speed) {
  if (variant == 2) {
    speed->left = acceleration_slip_dragged(s, 0, p, speed->left, around->period_s);
    speed->right = acceleration_slip_dragged(s, 1, p, speed->right, around->period_s);
    return;
  }
  speed->left = acceleration_slip_rolled(p, variant, speed->left,
                                         (around->next_speed.left - around->speed.left) / around->period_s);
  speed->right = acceleration_slip_rolled(
      p, variant, speed->right, (around->next_speed.right - around->speed.right) / around->period_s);
}
