/* lever_arm: the reference point that was measured is not the middle of the axle.
   Inverse: nothing to undo; it moves the measured point and not the robot. */
static inline ww_pose lever_arm_observed(const double* p, ww_pose axle) {
  const double c = cos(axle.theta);
  const double s = sin(axle.theta);
  axle.x += c * p[0] - s * p[1];
  axle.y += s * p[0] + c * p[1];
  return axle;
}
