/* direction_gain: forward and reverse gains differ.
   Inverse: exact. */

/* Variants: one change for both wheels, each_wheel. */
static inline void direction_gain_wheels(const double* p, int variant, const ww_around* around,
                                         ww_pair* command) {
  (void)around;
  if (command->left < 0.0) command->left *= 1.0 + p[0];
  if (command->right < 0.0) command->right *= 1.0 + p[variant];
}

static inline int direction_gain_undo_wheels(const double* p, int variant, const ww_around* around,
                                             ww_pair* command) {
  (void)around;
  if (command->left < 0.0) command->left /= 1.0 + p[0];
  if (command->right < 0.0) command->right /= 1.0 + p[variant];
  return 1;
}
