/* wheel_scale_mismatch: left and right wheels roll different distances for the same ticks or command.
   Inverse: exact. */

/* Variants: half by each wheel, the left wheel alone, the right wheel alone. */
static inline ww_pair wheel_scale_mismatch_rolling(const double* p, int variant) {
  const double of_left = variant == 0 ? 0.5 : variant == 1 ? 1.0 : 0.0;
  ww_pair gain;
  gain.left = 1.0 - of_left * p[0];
  gain.right = 1.0 + (1.0 - of_left) * p[0];
  return gain;
}

static inline void wheel_scale_mismatch_wheels(const double* p, int variant, const ww_around* around,
                                               ww_pair* speed) {
  const ww_pair gain = wheel_scale_mismatch_rolling(p, variant);
  (void)around;
  speed->left *= gain.left;
  speed->right *= gain.right;
}

static inline int wheel_scale_mismatch_undo_wheels(const double* p, int variant, const ww_around* around,
                                                   ww_pair* speed) {
  const ww_pair gain = wheel_scale_mismatch_rolling(p, variant);
  (void)around;
  speed->left /= gain.left;
  speed->right /= gain.right;
  return 1;
}
