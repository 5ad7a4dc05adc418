#include "daemon/service/printable_formatter.hpp"

#include <spdlog/pattern_formatter.h>

#include <string_view>

#include "config/load/printable_text.hpp"

namespace wheelwright::daemon {
namespace {

class PrintableFormatter final : public spdlog::formatter {
 public:
  explicit PrintableFormatter(std::unique_ptr<spdlog::formatter> pattern) : pattern_(std::move(pattern)) {}

  void format(const spdlog::details::log_msg& message, spdlog::memory_buf_t& to) override {
    const std::string text = config::printable({message.payload.data(), message.payload.size()});
    spdlog::details::log_msg shown = message;
    shown.payload = text;
    pattern_->format(shown, to);
    message.color_range_start = shown.color_range_start;  // where a sink begins and ends the colour
    message.color_range_end = shown.color_range_end;
  }

  std::unique_ptr<spdlog::formatter> clone() const override {
    return std::make_unique<PrintableFormatter>(pattern_->clone());
  }

 private:
  std::unique_ptr<spdlog::formatter> pattern_;
};

}  // namespace

std::unique_ptr<spdlog::formatter> make_printable_formatter(const std::string& pattern) {
  return std::make_unique<PrintableFormatter>(std::make_unique<spdlog::pattern_formatter>(pattern));
}

}  // namespace wheelwright::daemon
