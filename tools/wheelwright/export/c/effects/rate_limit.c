/* rate_limit: change of wheel speed is limited.
   Inverse: nothing to undo at a steady speed; not for speeds whose drag takes the whole limit. */
typedef struct {
  ww_pair now;
} rate_limit_state;

static inline void rate_limit_reset(rate_limit_state* s, const double* p, int variant) {
  (void)p;
  (void)variant;
  s->now.left = s->now.right = 0.0;
}

static inline double rate_limit_followed(const double* p, double now, double to, double period_s) {
  const double upwards = fmax(0.0, p[0] - p[1] * now);
  const double downwards = fmax(0.0, p[0] + p[1] * now);
  return now + ww_clamp(to - now, -period_s * downwards, period_s * upwards);
}

static inline void rate_limit_wheels(rate_limit_state* s, const double* p, int variant,
                                     const ww_around* around, ww_pair* speed) {
  (void)variant;
  s->now.left = rate_limit_followed(p, s->now.left, speed->left, around->period_s);
  s->now.right = rate_limit_followed(p, s->now.right, speed->right, around->period_s);
  *speed = s->now;
}

static inline int rate_limit_undo_wheels(const rate_limit_state* s, const double* p, int variant,
                                         const ww_around* around, ww_pair* speed) {
  (void)s;
  (void)variant;
  (void)around;
  return p[1] * fmax(fabs(speed->left), fabs(speed->right)) < p[0];
}
