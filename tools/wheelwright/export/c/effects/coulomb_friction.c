/* coulomb_friction: speed loss that opposes motion, constant in size.
   Inverse: adds what friction costs, where no controller does; not for a wheel slower than 2 mm/s.
   Variants: free, controlled. */
typedef struct {
  ww_friction left, right;
} coulomb_friction_state;

static inline ww_friction_levels coulomb_friction_levels(const double* p, int variant) {
  ww_friction_levels levels;
  levels.breakaway = levels.sliding = p[0];
  levels.lag_s = p[1];
  levels.sticking = 0.002;
  levels.recovery_per_s = variant == 1 ? 1.0 / p[2] : 0.0;
  return levels;
}

static inline void coulomb_friction_reset(coulomb_friction_state* s, const double* p, int variant) {
  (void)p;
  (void)variant;
  s->left = s->right = ww_friction_at_rest();
}

static inline void coulomb_friction_wheels(coulomb_friction_state* s, const double* p, int variant,
                                           const ww_around* around, ww_pair* speed) {
  const ww_friction_levels levels = coulomb_friction_levels(p, variant);
  speed->left = ww_friction_step(&s->left, speed->left, levels, around->period_s);
  speed->right = ww_friction_step(&s->right, speed->right, levels, around->period_s);
}

static inline int coulomb_friction_undo_wheels(const coulomb_friction_state* s, const double* p, int variant,
                                               const ww_around* around, ww_pair* speed) {
  const ww_friction_levels levels = coulomb_friction_levels(p, variant);
  const int left = ww_friction_undo(levels, &speed->left);
  const int right = ww_friction_undo(levels, &speed->right);
  (void)s;
  (void)around;
  return left && right;
}
