/* dead_zone: commands below a threshold move nothing.
   Inverse: lifts each command over the threshold. */
static inline double dead_zone_passed(const double* p, double u) {
  const double above = fmax(0.0, fabs(u) - p[0]);
  return copysign(fmin(fabs(u), above / p[1]), u);
}

static inline void dead_zone_wheels(const double* p, int variant, const ww_around* around, ww_pair* command) {
  (void)variant;
  (void)around;
  command->left = dead_zone_passed(p, command->left);
  command->right = dead_zone_passed(p, command->right);
}

static inline double dead_zone_lifted(const double* p, double u) {
  return u == 0.0 ? 0.0 : copysign(fmax(fabs(u), p[0] + p[1] * fabs(u)), u);
}

static inline int dead_zone_undo_wheels(const double* p, int variant, const ww_around* around,
                                        ww_pair* command) {
  (void)variant;
  (void)around;
  command->left = dead_zone_lifted(p, command->left);
  command->right = dead_zone_lifted(p, command->right);
  return 1;
}
