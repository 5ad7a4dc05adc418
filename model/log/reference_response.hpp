// A reference that does not show the robot at once: a tracker that smooths its poses, by a moving average, a
// low-pass, a Kalman filter, or afterwards in both directions; a heading that comes later than the place.
//
// Found beside the counts, which no tracker smooths (response_windows.hpp): a delay alone against four forms
// of smoothing with a delay and a width, by the sums of squared errors of all windows. The response is then
// the form that suits best, or, where none suits, taken as it comes: by least squares with a penalty on
// second differences, whose weight half of the windows choose for the other half.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "model/log/delay_kernel.hpp"
#include "model/log/drive_log.hpp"

namespace wheelwright {

// Over all runs of one tracker. Nothing where the reference shows the robot at once or after one delay, the
// same of place and heading: that is no matter of its own, since the fit of a model finds one delay. Nothing
// either where there are no counts, or too few windows.
std::optional<ReferenceResponse> find_reference_response(std::span<const DriveLog* const> runs);

// "the reference does not show the robot at once: x and y with a rise time of 0.33 s (10 to 90 %), 0.15 s
// late; its heading ..."
std::string in_words(const ReferenceResponse& response);

}  // namespace wheelwright
