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

static inline void acceleration_slip_hold(double most, double own, double across, double wanted, double* harder,
                                          double* other) {
  if (fabs(*harder) <= most) return;
  *harder = copysign(most, *harder);
  *other = ww_clamp((wanted - across * *harder) / own, -most, most);
}

/* Each tyre pushes up to its grip, and the robot's mass lies between the two. */
static inline void acceleration_slip_tied(acceleration_slip_state* s, const double* p, double period_s,
                                          ww_pair* speed) {
  const double most = 0.5 / fmax(p[0], 1e-3);
  const double own = 1.0 + p[1], across = 1.0 - p[1];
  const double scale = 1.0 / (own * own - across * across);
  const double left = (speed->left - s->speed[0]) / period_s;
  const double right = (speed->right - s->speed[1]) / period_s;
  double push_left = scale * (own * left - across * right);
  double push_right = scale * (own * right - across * left);
  if (fabs(push_left) > fabs(push_right))
    acceleration_slip_hold(most, own, across, right, &push_left, &push_right);
  else
    acceleration_slip_hold(most, own, across, left, &push_right, &push_left);
  s->speed[0] += (own * push_left + across * push_right) * period_s;
  s->speed[1] += (own * push_right + across * push_left) * period_s;
  speed->left = s->speed[0];
  speed->right = s->speed[1];
}

/* Variants: relative, absolute, sliding, tied. */
static inline void acceleration_slip_wheels(acceleration_slip_state* s, const double* p, int variant,
                                            const ww_around* around, ww_pair* speed) {
  if (variant == 3) {
    acceleration_slip_tied(s, p, around->period_s, speed);
    return;
  }
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
