/* surface_patch: motion differs inside a region of the floor.
   Inverse: not undone; the patch ends before a command that is made for it has passed the lag. */
typedef struct {
  ww_pair gain;
  int began;
} surface_patch_state;

static inline void surface_patch_reset(surface_patch_state* s, const double* p, int variant) {
  (void)p;
  (void)variant;
  s->gain.left = s->gain.right = 0.0;
  s->began = 0;
}

static inline double surface_patch_share(double inside_m) {
  return fmin(1.0, fmax(0.0, 0.5 + inside_m / 0.02));
}

static inline double surface_patch_gain(const double* p, int round, double x, double y) {
  const double c = cos(p[5]);
  const double s = sin(p[5]);
  const double dx = x - p[1];
  const double dy = y - p[2];
  const double along = c * dx + s * dy;
  const double across = c * dy - s * dx;
  const double half_length = 0.5 * p[3];
  const double half_width = 0.5 * p[4];
  if (round) {
    const double a = along / half_length;
    const double b = across / half_width;
    const double slope = 2.0 * hypot(a / half_length, b / half_width);
    return 1.0 + p[0] * surface_patch_share((1.0 - a * a - b * b) / slope);
  }
  return 1.0 + p[0] * surface_patch_share(half_length - fabs(along)) *
                   surface_patch_share(half_width - fabs(across));
}

/* Variants: floor, wheel, floor_each, wheel_each, floor_round, wheel_round, floor_each_round,
   wheel_each_round. */
static inline void surface_patch_wheels(surface_patch_state* s, const double* p, int variant,
                                        const ww_around* around, ww_pair* speed) {
  const double half = variant / 2 % 2 == 1 ? 0.5 * around->wheel_base_m : 0.0;
  const double aside_x = -half * sin(around->pose.theta);
  const double aside_y = half * cos(around->pose.theta);
  const double left = surface_patch_gain(p, variant >= 4, around->pose.x + aside_x, around->pose.y + aside_y);
  const double right =
      surface_patch_gain(p, variant >= 4, around->pose.x - aside_x, around->pose.y - aside_y);
  const double lag_s = variant % 2 == 1 ? p[6] : 0.0;
  const double fresh = s->began && lag_s > 0.0 ? -expm1(-around->period_s / lag_s) : 1.0;
  s->gain.left += fresh * (left - s->gain.left);
  s->gain.right += fresh * (right - s->gain.right);
  s->began = 1;
  speed->left *= s->gain.left;
  speed->right *= s->gain.right;
}
