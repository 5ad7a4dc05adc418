/* effective_track: the distance between wheels that turning shows is not the given one.
   Inverse: exact. */
static inline void effective_track_body(const double* p, int variant, const ww_around* around,
                                        ww_twist* twist) {
  (void)variant;
  twist->w *= around->wheel_base_m / (around->wheel_base_m + p[0]);
}

static inline int effective_track_undo_body(const double* p, int variant, const ww_around* around,
                                            ww_twist* twist) {
  (void)variant;
  twist->w *= (around->wheel_base_m + p[0]) / around->wheel_base_m;
  return 1;
}
