/* turn_speed_loss: forward speed is lost while turning, in proportion to the size of the turn rate.
   Inverse: as long as turning does not take all of the speed. */

/* Variants: relative, absolute. */
static inline void turn_speed_loss_body(const double* p, int variant, const ww_around* around,
                                        ww_twist* twist) {
  const double lost = p[0] * fmax(0.0, fabs(twist->w) - p[1] * fabs(twist->v));
  (void)around;
  if (variant == 1) {
    twist->v = copysign(fmax(0.0, fabs(twist->v) - 0.2 * lost), twist->v);
  } else {
    twist->v *= 1.0 - fmin(lost, 1.0);
  }
}

static inline int turn_speed_loss_undo_body(const double* p, int variant, const ww_around* around,
                                            ww_twist* twist) {
  const double size = fabs(twist->v);
  const double turn = fabs(twist->w);
  double before;
  (void)around;
  if (size == 0.0) return variant == 0 || p[0] >= 0.0 || turn == 0.0;
  if (turn <= p[1] * size) return 1; /* where the curve is not sharp enough, nothing is lost */
  if (variant == 1) {
    before = (size + 0.2 * p[0] * turn) / (1.0 + 0.2 * p[0] * p[1]);
  } else {
    const double share = 1.0 - p[0] * turn;
    const double root = share * share + 4.0 * p[0] * p[1] * size;
    if (root < 0.0 || share + sqrt(root) <= 0.0) return 0;
    before = 2.0 * size / (share + sqrt(root));
    if (p[0] * (turn - p[1] * before) >= 1.0) return 0;
  }
  if (before < 0.0 || turn < p[1] * before) return 0;
  twist->v = copysign(before, twist->v);
  return 1;
}
