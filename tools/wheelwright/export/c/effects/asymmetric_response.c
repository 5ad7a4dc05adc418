/* asymmetric_response: speeding up and slowing down have different dynamics.
   Inverse: nothing to undo at a steady speed. */
typedef struct {
  ww_pair now;
} asymmetric_response_state;

static inline void asymmetric_response_reset(asymmetric_response_state* s, const double* p, int variant) {
  (void)p;
  (void)variant;
  s->now.left = s->now.right = 0.0;
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
  const int brakes = wanted * now < p[2] * now * now;
  return !brakes && fabs(driven) < fabs(rolling) ? rolling : driven;
}

/* Variants: command, speed, command_coasting, speed_coasting. */
static inline void asymmetric_response_wheels(asymmetric_response_state* s, const double* p, int variant,
                                              const ww_around* around, ww_pair* speed) {
  double (*next)(const double*, double, double, double) =
      variant < 2 ? asymmetric_response_slow_one_way : asymmetric_response_coasting;
  s->now.left = next(p, s->now.left, speed->left, around->period_s);
  s->now.right = next(p, s->now.right, speed->right, around->period_s);
  *speed = s->now;
}
