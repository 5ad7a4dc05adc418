#include "tools/wheelwright/doctor/interruption.hpp"

namespace wheelwright::tools::doctor {
namespace {

constexpr std::array signals{SIGINT, SIGTERM, SIGHUP};
volatile sig_atomic_t interrupted = 0;

void note_signal(int) {
  interrupted = 1;
}

}  // namespace

InterruptionWatch::InterruptionWatch() {
  interrupted = 0;
  struct sigaction action {};
  action.sa_handler = note_signal;
  for (std::size_t i = 0; i < signals.size(); ++i) ::sigaction(signals.at(i), &action, &before_.at(i));
}

InterruptionWatch::~InterruptionWatch() {
  for (std::size_t i = 0; i < signals.size(); ++i) ::sigaction(signals.at(i), &before_.at(i), nullptr);
}

void throw_if_interrupted() {
  if (interrupted != 0) throw Interrupted();
}

}  // namespace wheelwright::tools::doctor
