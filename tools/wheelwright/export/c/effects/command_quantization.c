/* command_quantization: commands act in steps.
   Inverse: the command in the middle of the step that comes nearest; only the steps themselves are reached.
 */
static inline double command_quantization_step(const double* p, double u) {
  return copysign(p[0] * floor(fabs(u) / p[0] + 1.0 - p[1] + 1e-9), u);
}

static inline void command_quantization_wheels(const double* p, int variant, const ww_around* around,
                                               ww_pair* command) {
  (void)variant;
  (void)around;
  if (p[0] <= 0.0) return;
  command->left = command_quantization_step(p, command->left);
  command->right = command_quantization_step(p, command->right);
}

static inline int command_quantization_undo(const double* p, double* u) {
  const double steps = floor(fabs(*u) / p[0] + 0.5);
  const int reached = fabs(steps * p[0] - fabs(*u)) < 1e-6 * p[0];
  *u = steps > 0.0 ? copysign(p[0] * (steps - 0.5 + p[1]), *u) : 0.0;
  return reached;
}

static inline int command_quantization_undo_wheels(const double* p, int variant, const ww_around* around,
                                                   ww_pair* command) {
  int left, right;
  (void)variant;
  (void)around;
  if (p[0] <= 0.0) return 1;
  left = command_quantization_undo(p, &command->left);
  right = command_quantization_undo(p, &command->right);
  return left && right;
}
