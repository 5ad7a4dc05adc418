/* distance_scale: both wheels roll more or less than counted, or the reference is out of scale.
   Inverse: exact. */

/* Variants: (no name), turns_as_counted. */
static inline ww_pair distance_scale_rolling(const double* p, int variant) {
  ww_pair gain;
  gain.left = gain.right = variant == 1 ? 1.0 : 1.0 + p[0];
  return gain;
}

static inline void distance_scale_wheels(const double* p, int variant, const ww_around* around,
                                         ww_pair* speed) {
  const double more = p[0] * 0.5 * (speed->left + speed->right);
  (void)around;
  speed->left += variant == 1 ? more : p[0] * speed->left;
  speed->right += variant == 1 ? more : p[0] * speed->right;
}

static inline int distance_scale_undo_wheels(const double* p, int variant, const ww_around* around,
                                             ww_pair* speed) {
  const double share = p[0] / (1.0 + p[0]);
  const double less = share * 0.5 * (speed->left + speed->right);
  (void)around;
  speed->left -= variant == 1 ? less : share * speed->left;
  speed->right -= variant == 1 ? less : share * speed->right;
  return 1;
}
