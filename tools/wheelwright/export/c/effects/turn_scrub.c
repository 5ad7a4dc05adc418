/* turn_scrub: turn rate is lost as turning gets harder (nonlinear in turn rate).
   Inverse: up to the turn rate from which on more of it is lost than gained; what creeping tyres take is that of a
   steady turn. */
typedef struct {
  double taken; /* turn rate, by creeping tyres */
} turn_scrub_state;

static inline void turn_scrub_reset(turn_scrub_state* s, const double* p, int variant) {
  (void)p;
  (void)variant;
  s->taken = 0.0;
}

static inline double turn_scrub_dragged(double size, const double* p) {
  return size / fmax(0.5, 1.0 + size * (p[0] + p[1] * size));
}

/* Variants: a part is taken away; drag works against the wheels; creep. */
static inline void turn_scrub_body(turn_scrub_state* s, const double* p, int variant, const ww_around* around,
                                   ww_twist* twist) {
  if (variant == 2) {
    const double share = around->period_s / (around->period_s + p[2]);
    const double kept = (1.0 - share) * s->taken;
    s->taken = kept + share * p[0] * tanh((twist->w - kept) / (p[1] + share * p[0]));
    twist->w -= s->taken;
  } else {
    const double bent = variant == 1 ? copysign(turn_scrub_dragged(fabs(twist->w), p), twist->w)
                                     : ww_bent(ww_bend_of(p[0], p[1], 0.5), twist->w);
    twist->w = copysign(fmax(0.0, fabs(bent) - p[2]), bent);
  }
}

/* The turn rate that is left of `size` without what the tyres take anew in a period; `with` is how much that is at
   most, and the rate that it needs. */
static inline double turn_scrub_left(double size, const double* with) {
  return size - with[0] * tanh(size / with[1]);
}

/* Where drag grows with the square, the turn rate has its largest at 1 / sqrt(square). */
static inline int turn_scrub_undo_body(const turn_scrub_state* s, const double* p, int variant,
                                       const ww_around* around, ww_twist* twist) {
  (void)s;
  if (twist->w == 0.0) return 1;
  if (variant == 2) {
    const double whole = p[0] * around->period_s / (around->period_s + p[2]);
    const double with[2] = {whole, p[1] + whole};
    const double size = ww_reach(turn_scrub_left, with, fabs(twist->w), fabs(twist->w) + whole);
    twist->w += copysign(p[0] * tanh(size / with[1]), twist->w);
    return 1;
  }
  twist->w += copysign(p[2], twist->w);
  if (variant == 1) {
    const double size =
        ww_reach(turn_scrub_dragged, p, fabs(twist->w), p[1] > 0.0 ? 1.0 / sqrt(p[1]) : 1000.0);
    if (size < 0.0) return 0;
    twist->w = copysign(size, twist->w);
    return 1;
  }
  return ww_unbend(ww_bend_of(p[0], p[1], 0.5), &twist->w);
}
