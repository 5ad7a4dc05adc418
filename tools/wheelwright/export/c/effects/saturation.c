/* saturation: wheel speed is limited.
   Inverse: below the limit. */
typedef struct {
  ww_pair now;
} saturation_state;

static inline void saturation_reset(saturation_state* s, const double* p, int variant) {
  (void)p;
  (void)variant;
  s->now.left = s->now.right = 0.0;
}

static inline double saturation_below_limit(const double* p, double drive) {
  const double ratio = fabs(drive) / p[0];
  if (p[2] < 0.02) return ww_clamp(drive, -p[0], p[0]);
  if (ratio < exp(-16.0 * p[2])) return drive;
  return drive * pow(1.0 + pow(ratio, 1.0 / p[2]), -p[2]);
}

static inline void saturation_wheels(saturation_state* s, const double* p, int variant,
                                     const ww_around* around, ww_pair* speed) {
  const double share = around->period_s / (around->period_s + p[1]);
  (void)variant;
  s->now.left +=
      share * (saturation_below_limit(p, s->now.left + (speed->left - s->now.left) / share) - s->now.left);
  s->now.right += share * (saturation_below_limit(p, s->now.right + (speed->right - s->now.right) / share) -
                           s->now.right);
  *speed = s->now;
}

/* What has to be wanted for the drive that holds this speed. */
static inline int saturation_undo(const double* p, double share, double* speed) {
  const double ratio = fabs(*speed) / p[0];
  double drive;
  if (p[2] < 0.02) return ratio <= 1.0;
  if (ratio >= 1.0) return 0;
  if (ratio < exp(-16.0 * p[2])) return 1;
  drive = *speed * pow(1.0 - pow(ratio, 1.0 / p[2]), -p[2]);
  *speed += share * (drive - *speed);
  return 1;
}

static inline int saturation_undo_wheels(const saturation_state* s, const double* p, int variant,
                                         const ww_around* around, ww_pair* speed) {
  const double share = around->period_s / (around->period_s + p[1]);
  const int left = saturation_undo(p, share, &speed->left);
  const int right = saturation_undo(p, share, &speed->right);
  (void)s;
  (void)variant;
  return left && right;
}
