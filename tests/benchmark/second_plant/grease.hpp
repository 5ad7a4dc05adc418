#pragma once

#include <cmath>

namespace plants::second {

// Gear grease: viscous drag that falls as churning and copper losses warm the drive.
struct GreaseSpec {
  double cold_drag_n_s_m = 0.0;
  double thinning_1_k = 0.05;
  double warming_k_w = 0.0;  // steady temperature rise per watt
  double time_constant_s = 30.0;
};

class Grease {
 public:
  explicit Grease(const GreaseSpec& spec) : spec_(spec) {}

  double drag_n(double speed_m_s, double copper_loss_w, double step_s) {
    if (spec_.cold_drag_n_s_m == 0.0) return 0.0;
    const double drag = spec_.cold_drag_n_s_m * std::exp(-spec_.thinning_1_k * rise_k_) * speed_m_s;
    const double heat_w = drag * speed_m_s + copper_loss_w;
    rise_k_ += step_s * (heat_w * spec_.warming_k_w - rise_k_) / spec_.time_constant_s;
    return drag;
  }

 private:
  GreaseSpec spec_;
  double rise_k_ = 0.0;
};

}  // namespace plants::second
