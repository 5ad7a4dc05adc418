/* backlash: motion is lost on reversal.
   Inverse: nothing to undo at a steady speed. */
typedef struct {
  double in_gap[2], speed[2];
} backlash_state;

static inline void backlash_reset(backlash_state* s, const double* p, int variant) {
  (void)variant;
  s->in_gap[0] = s->in_gap[1] = p[2] * p[0];
  s->speed[0] = s->speed[1] = 0.0;
}

static inline double backlash_passed(backlash_state* s, int wheel, const double* p, double motor,
                                     double period_s) {
  const double by_itself = s->speed[wheel] * exp(-p[1] * period_s);
  const double at = s->in_gap[wheel] + (motor - by_itself) * period_s;
  double travelled;
  s->in_gap[wheel] = ww_clamp(at, 0.0, p[0]);
  travelled = (at - s->in_gap[wheel]) + by_itself * period_s;
  s->speed[wheel] = at != s->in_gap[wheel] ? motor : by_itself;
  return travelled / period_s;
}

static inline void backlash_wheels(backlash_state* s, const double* p, int variant, const ww_around* around,
                                   ww_pair* speed) {
  (void)variant;
  speed->left = backlash_passed(s, 0, p, speed->left, around->period_s);
  speed->right = backlash_passed(s, 1, p, speed->right, around->period_s);
}
