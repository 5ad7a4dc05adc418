/* gain_drift: gain drifts with time (warming up).
   Inverse: by the gain of this moment, as the simulated run has it. */
typedef struct {
  ww_pair warmth;
} gain_drift_state;

static inline void gain_drift_reset(gain_drift_state* s, const double* p, int variant) {
  (void)p;
  (void)variant;
  s->warmth.left = s->warmth.right = 0.0;
}

/* Variants: by time, by use. */
static inline ww_pair gain_drift_gain(const gain_drift_state* s, const double* p, int variant,
                                      const ww_around* around) {
  const double gone = -expm1(-around->time_s / p[1]);
  ww_pair gain;
  gain.left = 1.0 + p[0] * (variant == 1 ? s->warmth.left : gone);
  gain.right = 1.0 + p[0] * (variant == 1 ? s->warmth.right : gone);
  return gain;
}

static inline void gain_drift_wheels(gain_drift_state* s, const double* p, int variant,
                                     const ww_around* around, ww_pair* command) {
  const ww_pair gain = gain_drift_gain(s, p, variant, around);
  const double share = around->period_s / (around->period_s + p[1]);
  command->left *= gain.left;
  command->right *= gain.right;
  s->warmth.left += share * (fabs(around->command.left) / 0.2 - s->warmth.left);
  s->warmth.right += share * (fabs(around->command.right) / 0.2 - s->warmth.right);
}

static inline int gain_drift_undo_wheels(const gain_drift_state* s, const double* p, int variant,
                                         const ww_around* around, ww_pair* command) {
  const ww_pair gain = gain_drift_gain(s, p, variant, around);
  if (gain.left <= 0.0 || gain.right <= 0.0) return 0;
  command->left /= gain.left;
  command->right /= gain.right;
  return 1;
}
