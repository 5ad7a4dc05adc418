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

static inline void rate_limit_follow(const double* p, int variant, double* now, double* wanted,
                                     double period_s) {
  const double upwards = fmax(0.0, p[0] - p[1] * *now);
  const double downwards = fmax(0.0, p[0] + p[1] * *now);
  const double before = *now;
  const double most = period_s * (*wanted > before ? upwards : downwards);
  double change, ramping;
  *now += ww_clamp(*wanted - before, -most, most);
  change = *now - before;
  ramping = most > 0.0 ? fabs(change) / most : 0.0; /* share of the period */
  *wanted = variant == 2 ? *now - 0.5 * ramping * change : *now;
}

static inline void rate_limit_wheels(rate_limit_state* s, const double* p, int variant,
                                     const ww_around* around, ww_pair* speed) {
  rate_limit_follow(p, variant, &s->now.left, &speed->left, around->period_s);
  rate_limit_follow(p, variant, &s->now.right, &speed->right, around->period_s);
}

static inline int rate_limit_undo_wheels(const rate_limit_state* s, const double* p, int variant,
                                         const ww_around* around, ww_pair* speed) {
  (void)s;
  (void)variant;
  (void)around;
  return p[1] * fmax(fabs(speed->left), fabs(speed->right)) < p[0];
}
