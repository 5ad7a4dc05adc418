#include "model/gap/runs/short_name.hpp"

#include <algorithm>

namespace wheelwright::gap {

namespace {

std::string_view folder_of(std::string_view path) {
  return path.substr(0, path.rfind('/') + 1);
}

}  // namespace

std::vector<std::string> short_names(std::span<const std::string_view> names) {
  std::vector<std::string> result;
  if (names.empty()) return result;
  std::string_view shared = folder_of(names.front());
  if (names.size() == 1) shared = folder_of(shared.substr(0, shared.empty() ? 0 : shared.size() - 1));
  for (const std::string_view name : names) {
    const auto differs = std::ranges::mismatch(shared, name).in1;
    shared = shared.substr(0, static_cast<std::size_t>(differs - shared.begin()));
  }
  shared = folder_of(shared);
  for (const std::string_view name : names) result.emplace_back(name.substr(shared.size()));
  return result;
}

std::string short_name(std::size_t run, std::span<const GapRun> runs) {
  std::vector<std::string_view> names;
  for (const GapRun& one : runs) names.emplace_back(one.name);
  return short_names(names)[run];
}

}  // namespace wheelwright::gap
