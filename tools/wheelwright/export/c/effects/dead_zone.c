/* dead_zone: commands below a threshold move nothing.
   Inverse: lifts each command over the threshold; not for speeds that a sharp threshold leaves out. */
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

/* Where commands come through again all at once, speeds between none and those cannot be held: a command
   aimed between them is at the mercy of the last digit of the threshold. The nearer of the two is sent. */
static inline int dead_zone_undo(const double* p, double* u) {
  const double steepest = 0.1, margin = 1.02;
  const double whole_from = p[0] / fmax(1.0 - p[1], 1e-9);
  const double size = fabs(*u);
  if (size == 0.0) return 1;
  if (p[1] < steepest && size < margin * whole_from) {
    *u = size < 0.5 * whole_from ? 0.0 : copysign(margin * whole_from, *u);
    return size >= whole_from;
  }
  *u = copysign(fmax(size, p[0] + p[1] * size), *u);
  return 1;
}

static inline int dead_zone_undo_wheels(const double* p, int variant, const ww_around* around,
                                        ww_pair* command) {
  int left, right;
  (void)variant;
  (void)around;
  left = dead_zone_undo(p, &command->left);
  right = dead_zone_undo(p, &command->right);
  return left && right;
}
