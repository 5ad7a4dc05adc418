// Does an encoder slowly lose or gain against the model? A generalised likelihood-ratio test.
//
// Over every window of the last 16 s the travel that the encoder shows beyond the model's is set against its
// standard deviation: reading noise at both ends, random walk, and the uncertainty of the model's gain times
// the distance. The largest ratio is the test statistic; the window that gives it says since when. The gain
// itself is learnt from travel that has left all windows, so that a drift does not teach the test to accept
// it.
//
// A drift goes on, while a wheel that a model with effects has wrong for a moment (play, a caster that turns
// over) makes one large step. So the step of the offset within 0.25 s counts for two of its standard
// deviations at most, and no single moment is called a drift.
//
// What it cannot show: a drift within the first metres, before the gain is known better than the drift is
// large; and which of both is right, encoder or model. Where both wheels leave the model alike, it is the
// model.
#pragma once

#include <array>
#include <cstddef>

namespace wheelwright {

class ScaleDriftDetector {
 public:
  ScaleDriftDetector(double period_s, double gain_standard_error);

  // Takes a tick on which the reading was accepted. `doubt_m` is by how much the model's travel may be
  // another (model_doubt.hpp), `offset_m` the travel beyond the model's so far.
  void take(double predicted_m, double doubt_m, double offset_m, double process_variance_m2,
            double reading_sd_m);
  // The readings of this tick say nothing; windows do not reach across it.
  void interrupt();

  // Learnt correction of the model's travel, as a fraction of it, and its standard error.
  double gain_error() const { return gain_error_; }
  double gain_standard_error() const;

  // How much more the encoder drifts about the model than the noise figures say, as a factor of standard
  // deviations: a model that bends the truth (a robot whose commands act in steps) must not give alarms.
  double roughness() const;
  // Gain and roughness are known well enough to test by.
  bool ready() const { return learnt_ >= min_learnt; }

  // Largest ratio of all windows, signed as the offset, and the offset collected over that window.
  double statistic() const { return statistic_; }
  double collected_m() const { return collected_m_; }
  // The same with steps of any size, for a wheel that follows another one which drifts.
  double whole_statistic() const { return whole_statistic_; }

 private:
  struct Mark {
    double model_m = 0.0;
    double distance_m = 0.0;
    double doubt_m = 0.0;
    double offset_m = 0.0;
    double variance_m2 = 0.0;  // of the random walk since construction
    double reading_m2 = 0.0;   // of the reading itself
  };
  static constexpr std::size_t marks = 64;
  static constexpr int min_learnt = 32;

  void look_back();
  void learn(const Mark& older, const Mark& newer);
  void learn_roughness();
  static double doubt_variance_m2(const Mark& then, const Mark& now);
  double step_variance_m2(const Mark& then, const Mark& now) const;
  // Beyond the model with its learnt gain.
  double collected_m(const Mark& then, const Mark& now) const;

  int ticks_per_mark_;
  int ticks_ = 0;
  Mark now_;
  std::array<Mark, marks> past_{};  // ring
  std::size_t newest_ = 0;
  std::size_t count_ = 0;
  double gain_error_ = 0.0;
  double gain_variance_;
  double roughness2_ = 1.0;
  int learnt_ = 0;
  double statistic_ = 0.0;
  double whole_statistic_ = 0.0;
  double collected_m_ = 0.0;
};

}  // namespace wheelwright
