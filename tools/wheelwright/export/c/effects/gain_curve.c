/* gain_curve: gain bends with command size.
   Inverse: up to where the curve is level. */
static inline ww_bend gain_curve_bend(const double* p) {
  return ww_bend_of(p[0], p[1] / 0.3, 0.35);
}

static inline void gain_curve_wheels(const double* p, int variant, const ww_around* around, ww_pair* speed) {
  const ww_bend bend = gain_curve_bend(p);
  (void)variant;
  (void)around;
  speed->left = ww_bent(bend, speed->left);
  speed->right = ww_bent(bend, speed->right);
}

static inline int gain_curve_undo_wheels(const double* p, int variant, const ww_around* around,
                                         ww_pair* speed) {
  const ww_bend bend = gain_curve_bend(p);
  const int left = ww_unbend(bend, &speed->left);
  const int right = ww_unbend(bend, &speed->right);
  (void)variant;
  (void)around;
  return left && right;
}
