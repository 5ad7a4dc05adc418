/* wheel_eccentricity: speed ripples once per wheel turn.
   Inverse: not undone; the ripple is faster than a command that passes the lag, and averages out. */
static inline double wheel_eccentricity_ripple(double sine, double cosine, double angle) {
  return 1.0 + sine * sin(angle) + cosine * cos(angle);
}

static inline void wheel_eccentricity_wheels(const double* p, int variant, const ww_around* around,
                                             ww_pair* speed) {
  const double per_metre = 2.0 * ww_pi / p[4];
  const double left = per_metre * (around->distance.left + 0.5 * speed->left * around->period_s);
  const double right = per_metre * (around->distance.right + 0.5 * speed->right * around->period_s);
  (void)variant;
  speed->left *= wheel_eccentricity_ripple(p[0], p[1], left);
  speed->right *= wheel_eccentricity_ripple(p[2], p[3], right);
}
