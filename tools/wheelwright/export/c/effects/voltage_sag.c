/* voltage_sag: gain follows the battery voltage.
   Inverse: by the voltage that was measured last. */
static inline double voltage_sag_gain(const double* p, const ww_around* around) {
  return around->battery_v > 0.0 ? pow(around->battery_v / 14.4, p[0]) : 1.0;
}

static inline void voltage_sag_wheels(const double* p, int variant, const ww_around* around,
                                      ww_pair* command) {
  const double gain = voltage_sag_gain(p, around);
  (void)variant;
  command->left *= gain;
  command->right *= gain;
}

static inline int voltage_sag_undo_wheels(const double* p, int variant, const ww_around* around,
                                          ww_pair* command) {
  const double gain = voltage_sag_gain(p, around);
  (void)variant;
  command->left /= gain;
  command->right /= gain;
  return 1;
}
