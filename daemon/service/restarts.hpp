// What a service remembers from one process to the next.
//
// In its runtime folder: how often in a row it ended out of order. From it comes the back-off (systemd 252
// has none that grows). A reboot forgets it.
//
// In its state folder, which survives a reboot and a power cut: a note that the robot was armed. A process
// that finds the note does not arm the robot by itself, since nobody knows who stands in its way by now. The
// note is on the disk before the robot is armed, and goes away when a drive ends in order. An upgrade of the
// package writes the same note (systemd/debian/postinst).
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

namespace wheelwright::daemon {

struct ServiceFolders {
  std::filesystem::path runtime;  // RuntimeDirectory= of the unit; empty: none
  std::filesystem::path state;    // StateDirectory=; empty: none
};

class Restarts {
 public:
  // By hand, without folders, nothing is remembered. Counts this process as one that ends out of order, until
  // ended_in_order() or lasted() says otherwise.
  explicit Restarts(const std::optional<ServiceFolders>& folders);

  // How long to wait before anything is tried: nothing at first, then 1 s, then twice as long each time, up
  // to a minute.
  std::chrono::seconds back_off() const;
  // Why this process may not arm the robot by itself: the note that it found, in one line.
  const std::optional<std::string>& hold() const { return hold_; }

  // Keeps the note. Returns why it could not, in one line; then the robot is not to be armed.
  std::optional<std::string> armed();
  // The process has run so long that its end, whenever it comes, does not count with the failures before.
  void lasted();
  // The robot stands, and no drive was interrupted: forgets the failures and the note.
  void ended_in_order();
  // The process ended as it was asked to, but in the middle of a drive: forgets the failures alone.
  void ended_in_drive();

 private:
  bool as_service_ = false;
  std::filesystem::path attempts_file_;
  std::filesystem::path hold_file_;
  int attempts_before_ = 0;
  std::optional<std::string> hold_;
  bool lasted_ = false;
};

}  // namespace wheelwright::daemon
