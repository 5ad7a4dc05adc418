// What an analysis comes to: one word, and a sentence or two for a person.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/gap/gap_analysis.hpp"
#include "model/gap/gap_size.hpp"
#include "model/gap/random_moments.hpp"
#include "model/gap/regular_swing.hpp"

namespace wheelwright::gap {

// Of a run that was held out: what it travelled for each metre that the model predicts.
struct GainChange {
  std::string run;
  double gain = 1.0;
};

// Held-out runs may be another robot's, or the same one's on another day: a gain that changed between runs,
// whose cause no run shows. Empty where the model explains them about as well as those that it was fitted to.
std::vector<GainChange> changed_gains(const GapSearch& search, const GapProblem& train,
                                      const GapProblem& heldout);

// Whether a linear effect is more than a better linear model: a gap that was to be seen above the noise
// becomes smaller by it.
bool shows(const GapFigures& figures);

// Whether what was found shows where a person looks: some figure of the held-out free runs falls by it; or it
// is beyond doubt. Linear effects alone have to show, and so has what stands in for one that was left out
// (`linear_left_out`).
bool closes_the_gap(const GapAnalysis& analysis, bool linear_left_out);

// Whatever helps a little is not what is missing, where free runs stay far off all the same. What explains a
// lot may stand although more is missing, and so may a single effect to which no other comes near, unless
// free runs stay nowhere near the measured ones.
bool leaves_most_of_it(const GapAnalysis& analysis);

// Whether what is left, which hangs together, is more than what was found explains. Where a moment or a place
// decides, it may be: little is wrong, and much of the run with it.
bool is_the_smaller_part(const GapAnalysis& analysis);

// Whether free runs are further off with what was found than without it: it may follow what the noise that
// was assumed has left of something else.
bool drives_runs_apart(const GapAnalysis& analysis);

// Whether a decoy beside all that was found explains more than any of it does in its own place: then the
// names are shapes of something that the library does not hold.
bool is_less_than_a_decoy_adds(const GapAnalysis& analysis);

// What the model found leaves, in floors of the figures as they stand.
Excess what_is_left(const GapAnalysis& analysis);

// What may be missing where nothing was found.
struct Leftovers {
  Excess over_quick_noise;  // in floors of noise from reading to reading
  std::vector<GainChange> gain_changes;
  std::optional<RegularSwing> swing;
};

// Sets verdict and summary, and `where` for gains that changed or a swing, from all else that the analysis
// holds. Its floors are those of noise over seconds.
void reach_verdict(GapAnalysis& analysis, const SearchLimits& limits, const Leftovers& leftovers);

// Where nothing seems to be missing, what explains nothing was taken for noise. It is none where it comes at
// moments, or where it has the robot wander further within a second than robots do: then it is unnamed.
struct SupposedNoise {
  std::optional<RandomMoments> moments;
  Wandering wandering;  // over seconds
};
void doubt_the_noise(GapAnalysis& analysis, const SupposedNoise& noise);

}  // namespace wheelwright::gap
