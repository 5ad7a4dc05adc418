/* yaw_bias: the robot turns when it should not, at a constant rate while driving.
   Inverse: steers against it; not for speeds below 20 mm/s, where the bias fades. */

/* Variants: driving, moving. */
static inline void yaw_bias_body(const double* p, int variant, const ww_around* around, ww_twist* twist) {
  const double speed =
      variant == 1 ? fmax(fabs(around->next_speed.left), fabs(around->next_speed.right)) : fabs(twist->v);
  twist->w += p[0] * fmin(1.0, speed / 0.01);
}

static inline int yaw_bias_undo_body(const double* p, int variant, const ww_around* around, ww_twist* twist) {
  ww_twist before = *twist;
  ww_pair wheels;
  if (twist->v == 0.0 && (variant == 0 || twist->w == 0.0)) return 1;
  before.w -= p[0];
  wheels = ww_wheels_of(before, around->wheel_base_m);
  if (variant == 1 ? fmax(fabs(wheels.left), fabs(wheels.right)) < 0.02 : fabs(twist->v) < 0.02) return 0;
  *twist = before;
  return 1;
}
