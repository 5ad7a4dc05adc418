/* asymmetric_response: speeding up and slowing down have different dynamics.
   Inverse: nothing to undo at a steady speed. */
typedef struct {
  ww_pair now, linear_before, load_before;
} asymmetric_response_state;

static inline void asymmetric_response_reset(asymmetric_response_state* s, const double* p, int variant) {
  (void)p;
  (void)variant;
  s->now.left = s->now.right = 0.0;
  s->linear_before = s->load_before = s->now;
}

static inline double asymmetric_response_slow_one_way(const double* p, double now, double wanted,
                                                      double period_s) {
  const int slowing = fabs(wanted) < fabs(now) || wanted * now < 0.0;
  const int slow = slowing == (p[0] > 0.0);
  const double lag_s = p[1] + (slow ? fabs(p[0]) : 0.0);
  return now + (wanted - now) * period_s / (period_s + lag_s);
}

static inline double asymmetric_response_coasting(const double* p, double now, double wanted,
                                                  double period_s) {
  const double driven = now + (wanted - now) * period_s / (period_s + p[1]);
  const double rolling = now * p[0] / (p[0] + period_s);
  const int waits = wanted * now < 0.0 && fabs(now) > p[3];
  const int brakes = !waits && wanted * now < p[2] * now * now;
  return !brakes && driven * now < rolling * now ? rolling : driven;
}

/* Share of a period for which what goes from one value to another is above zero, if it began there. */
static inline double asymmetric_response_share_above_zero(double from, double to) {
  if (from <= 0.0) return 0.0;
  return to >= 0.0 ? 1.0 : from / (from - to);
}

/* Share of a period for which what falls from one value to another is below zero. */
static inline double asymmetric_response_share_below_zero(double from, double to) {
  if (from <= 0.0) return 1.0;
  return to >= 0.0 ? 0.0 : to / (to - from);
}

/* Without current, what loads take from a wheel is not given back by its motor. */
static inline double asymmetric_response_motor(const double* p, double* now, double* linear_before,
                                               double* load_before, double linear, double load_now,
                                               double period_s) {
  const double share = -expm1(-period_s / p[1]);
  const double drive = *linear_before + (linear - *linear_before) / share;
  const double kept_load = (1.0 - share) * load_now;
  const double load = *load_before + (load_now - *load_before) / share;
  const double speed = *now - load_now;
  const double driven = *now + share * (drive - *now);
  const double rolling = speed * p[0] / (p[0] + period_s) + kept_load + (share - period_s / p[1]) * load;
  const double unbraked = driven * speed < rolling * speed ? rolling : driven;
  const double sign = copysign(1.0, speed);
  double braked_share = asymmetric_response_share_above_zero(sign * (p[2] * speed - drive),
                                                             sign * (p[2] * (driven - load_now) - drive));
  if (sign * drive < 0.0)
    braked_share *=
        asymmetric_response_share_below_zero(fabs(speed) - p[3], sign * (rolling - load_now) - p[3]);
  *linear_before = linear;
  *load_before = load_now;
  *now = braked_share * driven + (1.0 - braked_share) * unbraked;
  return *now;
}

/* Variants: command, speed, command_coasting, speed_coasting, motor_coasting. */
static inline void asymmetric_response_wheels(asymmetric_response_state* s, const double* p, int variant,
                                              const ww_around* around, ww_pair* speed) {
  double (*next)(const double*, double, double, double) =
      variant < 2 ? asymmetric_response_slow_one_way : asymmetric_response_coasting;
  if (variant == 4) {
    speed->left = asymmetric_response_motor(p, &s->now.left, &s->linear_before.left, &s->load_before.left,
                                            speed->left, around->load.left, around->period_s);
    speed->right = asymmetric_response_motor(p, &s->now.right, &s->linear_before.right, &s->load_before.right,
                                             speed->right, around->load.right, around->period_s);
    return;
  }
  s->now.left = next(p, s->now.left, speed->left, around->period_s);
  s->now.right = next(p, s->now.right, speed->right, around->period_s);
  *speed = s->now;
}
