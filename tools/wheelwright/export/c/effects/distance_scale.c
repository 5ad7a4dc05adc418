/* distance_scale: both wheels roll more or less than counted.
   Inverse: exact. */
static inline ww_pair distance_scale_rolling(const double* p, int variant) {
  ww_pair gain;
  (void)variant;
  gain.left = gain.right = 1.0 + p[0];
  return gain;
}

static inline void distance_scale_wheels(const double* p, int variant, const ww_around* around,
                                         ww_pair* speed) {
  (void)variant;
  (void)around;
  speed->left *= 1.0 + p[0];
  speed->right *= 1.0 + p[0];
}

static inline int distance_scale_undo_wheels(const double* p, int variant, const ww_around* around,
                                             ww_pair* speed) {
  (void)variant;
  (void)around;
  speed->left /= 1.0 + p[0];
  speed->right /= 1.0 + p[0];
  return 1;
}
