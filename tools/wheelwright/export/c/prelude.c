typedef struct {
  double left, right;
} ww_pair;

typedef struct {
  double v, w; /* forward, m/s; counter-clockwise, rad/s */
} ww_twist;

typedef struct {
  double x, y, theta; /* m; rad, full turns are counted */
} ww_pose;

/* What an effect may know at the beginning of a period. */
typedef struct {
  double period_s, wheel_base_m, time_s;
  ww_pair command;    /* as sent, m/s */
  ww_pair speed;      /* of the wheels in the period before, m/s */
  ww_pair distance;   /* rolled since the start, m */
  ww_pair next_speed; /* of the wheels in this period, from the floor stage on */
  ww_pair load;       /* speed that loads took from the wheels in the period before, m/s */
  ww_pair rolling;    /* rolled on the floor per counted, of each wheel */
  ww_pose pose;       /* of the middle of the axle */
  double battery_v;   /* as measured last; 0 where it is not known */
} ww_around;

static const double ww_pi = 3.14159265358979323846;

static inline double ww_clamp(double value, double low, double high) {
  return value < low ? low : value > high ? high : value;
}

static inline ww_twist ww_twist_of(ww_pair speed, double wheel_base_m) {
  ww_twist twist;
  twist.v = 0.5 * (speed.left + speed.right);
  twist.w = (speed.right - speed.left) / wheel_base_m;
  return twist;
}

static inline ww_pair ww_wheels_of(ww_twist twist, double wheel_base_m) {
  const double half_difference = 0.5 * twist.w * wheel_base_m;
  ww_pair speed;
  speed.left = twist.v - half_difference;
  speed.right = twist.v + half_difference;
  return speed;
}

static inline ww_pair ww_scaled(ww_pair pair, ww_pair gain) {
  pair.left *= gain.left;
  pair.right *= gain.right;
  return pair;
}

/* How the body moves on wheels that turn at these counted speeds; and back. */
static inline ww_twist ww_floor_twist(const ww_around* around, ww_pair counted) {
  return ww_twist_of(ww_scaled(counted, around->rolling), around->wheel_base_m);
}

static inline ww_pair ww_counted_wheels(const ww_around* around, ww_twist twist) {
  ww_pair speed = ww_wheels_of(twist, around->wheel_base_m);
  speed.left /= around->rolling.left;
  speed.right /= around->rolling.right;
  return speed;
}

/* Along an arc: the chord points halfway through the turn. */
static inline ww_pose ww_moved(ww_pose pose, ww_twist twist, double period_s) {
  const double half = 0.5 * twist.w * period_s;
  const double ratio = fabs(half) < 1e-4 ? 1.0 - half * half / 6.0 : sin(half) / half;
  const double chord = twist.v * period_s * ratio;
  pose.x += chord * cos(pose.theta + half);
  pose.y += chord * sin(pose.theta + half);
  pose.theta += 2.0 * half;
  return pose;
}

/* Where `map`, which rises from 0 with its argument, reaches `value` within [0, high]; -1 where it does not.
 */
static inline double ww_reach(double (*map)(double, const double*), const double* with, double value,
                              double high) {
  double low = 0.0;
  int i;
  if (value < 0.0 || map(high, with) < value) return -1.0;
  for (i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    if (map(middle, with) < value) {
      low = middle;
    } else {
      high = middle;
    }
  }
  return high;
}

/* A map that bends the same way for both signs: size (1 - a size - b size^2), level from its top on. */
typedef struct {
  double a, b, top;
} ww_bend;

static inline ww_bend ww_bend_of(double a, double b, double least_top) {
  ww_bend bend;
  const double discriminant = a * a + 3.0 * b;
  const double inverse_of_top = discriminant < 0.0 ? 0.0 : a + sqrt(discriminant);
  bend.a = a;
  bend.b = b;
  bend.top = HUGE_VAL;
  if (inverse_of_top > 0.0) {
    const double less = fmin(1.0, 1.0 / (inverse_of_top * least_top));
    bend.a *= less;
    bend.b *= less * less;
    bend.top = 1.0 / (less * inverse_of_top);
  }
  return bend;
}

static inline double ww_bent(ww_bend bend, double value) {
  const double size = fmin(fabs(value), bend.top);
  return copysign(size * (1.0 - size * (bend.a + bend.b * size)), value);
}

static inline double ww_bent_by(double size, const double* with) {
  const ww_bend bend = {with[0], with[1], with[2]};
  return ww_bent(bend, size);
}

/* 0 where the value lies above the top. Beyond 1000 m/s or rad/s nothing is looked for. */
static inline int ww_unbend(ww_bend bend, double* value) {
  const double with[3] = {bend.a, bend.b, bend.top};
  const double size = ww_reach(ww_bent_by, with, fabs(*value), fmin(bend.top, 1000.0));
  if (size < 0.0) return 0;
  *value = copysign(size, *value);
  return 1;
}

/* Dry friction on a wheel whose drive is known only through a lag: what a motor without friction would do
   goes in, what friction leaves of it comes out. */
typedef struct {
  double breakaway, sliding, lag_s, sticking;
  double recovery_per_s; /* of a controller that makes up for friction; 0 without */
} ww_friction_levels;

typedef struct {
  double frictionless_before, taken, added, direction;
  int rests;
} ww_friction;

static inline ww_friction ww_friction_at_rest(void) {
  const ww_friction rest = {0.0, 0.0, 0.0, 1.0, 1};
  return rest;
}

/* `change` of the speed without friction since the step before. */
static inline double ww_friction_small_step(ww_friction* s, double frictionless, double change,
                                            ww_friction_levels levels, double step_s) {
  const double drive = frictionless + levels.lag_s / step_s * change + s->added;
  const double share = step_s / (step_s + levels.lag_s);
  double speed;
  if (s->rests) {
    if (fabs(drive) <= levels.breakaway) {
      s->added += step_s * levels.recovery_per_s * frictionless;
      return 0.0;
    }
    s->rests = 0;
    s->direction = copysign(1.0, drive);
    s->taken = frictionless - change;
  }
  s->taken += share * (levels.sliding * s->direction - s->added - s->taken);
  s->added += step_s * levels.recovery_per_s * s->taken;
  speed = frictionless - s->taken;
  if ((speed * s->direction <= 0.0 || fabs(speed) < levels.sticking) && fabs(drive) <= levels.breakaway) {
    s->rests = 1;
    return 0.0;
  }
  if (speed * s->direction < 0.0) s->direction = -s->direction;
  return speed;
}

/* The wheel's mean speed over the period, which is gone through in steps of about 20 ms. */
static inline double ww_friction_step(ww_friction* s, double frictionless, ww_friction_levels levels,
                                      double period_s) {
  const double steps = fmax(1.0, round(period_s / 0.02));
  const double change = (frictionless - s->frictionless_before) / steps;
  const double first = frictionless - 0.5 * (steps - 1.0) * change;
  double sum = 0.0, k;
  for (k = 0.0; k < steps; k += 1.0)
    sum += ww_friction_small_step(s, first + k * change, change, levels, period_s / steps);
  s->frictionless_before = frictionless;
  return sum / steps;
}

/* The speed without friction that leaves `*speed` in the end; 0 where a wheel at rest would not begin to move,
   or a moving one would stick. */
static inline int ww_friction_undo(ww_friction_levels levels, double* speed) {
  const double size = fabs(*speed);
  if (size == 0.0) return 1;
  if (levels.recovery_per_s > 0.0) return size >= levels.sticking;
  *speed += copysign(levels.sliding, *speed);
  return size + levels.sliding > levels.breakaway && size >= levels.sticking;
}
