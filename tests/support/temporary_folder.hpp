// A folder of this process's own, since tests run side by side, each in a process. Gone when the process
// ends.
#pragma once

#include <filesystem>

namespace wheelwright::test {

const std::filesystem::path& temporary_folder();

}  // namespace wheelwright::test
