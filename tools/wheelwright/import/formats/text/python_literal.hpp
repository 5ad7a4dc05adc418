// Lines that a Python program printed: a dict as JSON.
#pragma once

#include <string>
#include <string_view>

namespace wheelwright::import {

// "{'t': 0.5, 'ok': True, 'enc': (1, 2), 'v': np.float64(0.1)}" as
// {"t": 0.5, "ok": true, "enc": [1, 2], "v": 0.1}; nan, inf and None become null. What is no such text
// becomes no JSON.
std::string json_of_python(std::string_view text);

}  // namespace wheelwright::import
