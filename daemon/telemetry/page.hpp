// The page of the live view: HTML with its style and its script, made at build time of the files in page/.
#pragma once

#include <string_view>

namespace wheelwright::daemon::telemetry {

std::string_view page();

}  // namespace wheelwright::daemon::telemetry
