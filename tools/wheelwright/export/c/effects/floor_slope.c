/* floor_slope: speed depends on heading.
   Inverse: takes the slope's pull at the present heading off; not for turns, nor for speeds below 10 mm/s, where
   the pull fades. */
static inline double floor_slope_along(const double* p, const ww_around* around) {
  return p[0] * cos(around->pose.theta) + p[1] * sin(around->pose.theta);
}

static inline double floor_slope_share(double speed) {
  return fmin(1.0, fabs(speed) / 0.01);
}

/* Variants: floor, wheel, relative, creeping. */
static inline void floor_slope_wheels(const double* p, int variant, const ww_around* around, ww_pair* speed) {
  const double pull = floor_slope_along(p, around);
  speed->left += pull * (variant == 3 ? 1.0 : floor_slope_share(speed->left));
  speed->right += pull * (variant == 3 ? 1.0 : floor_slope_share(speed->right));
}

static inline void floor_slope_body(const double* p, int variant, const ww_around* around, ww_twist* twist) {
  const double pull = floor_slope_along(p, around);
  twist->v += variant == 2 ? pull / 0.2 * twist->v : pull * floor_slope_share(twist->v);
}

static inline int floor_slope_without(double pull, double* speed) {
  const double before = *speed - pull;
  if (*speed == 0.0 || before * *speed <= 0.0 || fabs(before) < 0.01) return *speed == 0.0;
  *speed = before;
  return 1;
}

static inline int floor_slope_undo_wheels(const double* p, int variant, const ww_around* around,
                                          ww_pair* speed) {
  const double pull = floor_slope_along(p, around);
  int left, right;
  if (variant == 3) {
    const int straight = speed->left == speed->right;
    speed->left -= pull;
    speed->right -= pull;
    return straight;
  }
  left = floor_slope_without(pull, &speed->left);
  right = floor_slope_without(pull, &speed->right);
  return left && right && speed->left == speed->right;
}

static inline int floor_slope_undo_body(const double* p, int variant, const ww_around* around,
                                        ww_twist* twist) {
  const double pull = floor_slope_along(p, around);
  if (variant != 2) return floor_slope_without(pull, &twist->v) && twist->w == 0.0;
  if (1.0 + pull / 0.2 <= 0.0) return 0;
  twist->v /= 1.0 + pull / 0.2;
  return twist->w == 0.0;
}
