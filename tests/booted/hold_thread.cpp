// hold_thread PID NAME SECONDS: holds one thread of a process still for so long, as if it hung. Prints since
// when, in seconds of the epoch.
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <thread>

#include "tests/loopback/bench/held_thread.hpp"

int main(int argc, char** argv) {
  if (argc != 4) {
    std::cerr << "hold_thread: PID NAME SECONDS\n";
    return 2;
  }
  const wheelwright::bench::HeldThread held(std::atoi(argv[1]), argv[2]);
  if (!held) {
    std::cerr << "hold_thread: no such thread, or it may not be held\n";
    return 1;
  }
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  std::cout << std::fixed << std::chrono::duration<double>(now).count() << std::endl;
  std::this_thread::sleep_for(std::chrono::seconds(std::atoi(argv[3])));
  return 0;
}
