/* stiction: a wheel at rest needs more to break away than to keep moving.
   Inverse: adds what friction costs a moving wheel; not for speeds at which a standing wheel would not break
   away, or a moving one would stick.
   Variants: free, controlled. */
typedef struct {
  ww_friction left, right;
} stiction_state;

static inline ww_friction_levels stiction_levels(const double* p, int variant) {
  ww_friction_levels levels;
  levels.breakaway = p[0] + p[1];
  levels.sliding = p[1];
  levels.lag_s = p[2];
  levels.sticking = p[3];
  levels.recovery_per_s = variant == 1 ? 1.0 / p[4] : 0.0;
  return levels;
}

static inline void stiction_reset(stiction_state* s, const double* p, int variant) {
  (void)p;
  (void)variant;
  s->left = s->right = ww_friction_at_rest();
}

static inline void stiction_wheels(stiction_state* s, const double* p, int variant, const ww_around* around,
                                   ww_pair* speed) {
  const ww_friction_levels levels = stiction_levels(p, variant);
  speed->left = ww_friction_step(&s->left, speed->left, levels, around->period_s);
  speed->right = ww_friction_step(&s->right, speed->right, levels, around->period_s);
}

static inline int stiction_undo_wheels(const stiction_state* s, const double* p, int variant,
                                       const ww_around* around, ww_pair* speed) {
  const ww_friction_levels levels = stiction_levels(p, variant);
  const int left = ww_friction_undo(levels, &speed->left);
  const int right = ww_friction_undo(levels, &speed->right);
  (void)s;
  (void)around;
  return left && right;
}
