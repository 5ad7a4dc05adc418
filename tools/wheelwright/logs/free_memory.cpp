#include "tools/wheelwright/logs/free_memory.hpp"

#include <filesystem>
#include <fstream>

#include "config/load/text_format.hpp"
#include "tools/wheelwright/import/conversion/repair_checks.hpp"

namespace wheelwright::tools {
namespace {

constexpr std::uint64_t times_its_text = 8;

std::string in_gigabytes(std::uint64_t bytes) {
  return config::fixed_number(static_cast<double>(bytes) / 1e9, 1) + " GB";
}

}  // namespace

std::optional<std::uint64_t> free_memory_bytes() {
  std::ifstream memory("/proc/meminfo");
  constexpr std::uint64_t bytes_per_kib = 1024;
  for (std::string key, unit; memory >> key; std::getline(memory, unit)) {
    std::uint64_t kib = 0;
    if (!(memory >> kib)) return std::nullopt;
    if (key == "MemAvailable:") return bytes_per_kib * kib;
  }
  return std::nullopt;
}

std::optional<std::string> find_missing_memory(std::uint64_t logs_bytes, std::uint64_t free_bytes) {
  const std::uint64_t needed = times_its_text * logs_bytes;
  if (needed <= free_bytes) return std::nullopt;
  return "logs of " + in_gigabytes(logs_bytes) + " take about " + in_gigabytes(needed) + " of memory, and " +
         in_gigabytes(free_bytes) + " are free; give fewer or shorter runs";
}

std::optional<std::string> find_missing_memory(const std::vector<std::string>& paths) {
  const auto free_bytes = free_memory_bytes();
  if (!free_bytes) return std::nullopt;
  std::uint64_t logs_bytes = 0;
  for (const std::string& path : paths) {
    std::error_code error;
    const auto size = std::filesystem::file_size(path, error);
    if (!error && import::is_drive_log(path)) logs_bytes += size;
  }
  if (auto missing = find_missing_memory(logs_bytes, *free_bytes)) return paths.front() + ": " + *missing;
  return std::nullopt;
}

}  // namespace wheelwright::tools
