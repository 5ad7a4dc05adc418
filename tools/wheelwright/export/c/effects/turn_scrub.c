/* turn_scrub: turn rate is lost as turning gets harder (nonlinear in turn rate).
   Inverse: up to the turn rate from which on more of it is lost than gained. */
static inline double turn_scrub_dragged(double size, const double* p) {
  return size / fmax(0.5, 1.0 + size * (p[0] + p[1] * size));
}

/* Variants: a part is taken away; drag works against the wheels. */
static inline void turn_scrub_body(const double* p, int variant, const ww_around* around, ww_twist* twist) {
  const double bent = variant == 1 ? copysign(turn_scrub_dragged(fabs(twist->w), p), twist->w)
                                   : ww_bent(ww_bend_of(p[0], p[1], 0.5), twist->w);
  (void)around;
  twist->w = copysign(fmax(0.0, fabs(bent) - p[2]), bent);
}

/* Where drag grows with the square, the turn rate has its largest at 1 / sqrt(square). */
static inline int turn_scrub_undo_body(const double* p, int variant, const ww_around* around,
                                       ww_twist* twist) {
  (void)around;
  if (twist->w == 0.0) return 1;
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
