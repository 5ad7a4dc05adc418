// Who stops the wheels should the sensor loop be unable to: another process with the same port.
#pragma once

namespace wheelwright::roomba {

// Called by the constructor of the sensor loop, then on its thread only; nothing here blocks or allocates.
class PortGuard {
 public:
  virtual ~PortGuard() = default;
  // The port that commands go to from now on. The guard takes a duplicate of its own.
  virtual void port_opened(int descriptor) = 0;
  // The guard has to let go of its duplicate too: a device that is gone keeps its name for as long as it is
  // open somewhere, and a lock on it holds.
  virtual void port_closed() = 0;
  // The same for a port that was given up while the robot may drive: what the guard can still write to it,
  // it writes first, so that the wheels stand.
  virtual void port_dropped() = 0;
  // Once a tick. Its absence is what the guard acts on.
  virtual void beat() = 0;
  // Whether the guard has stopped the wheels since the last call, for want of beats.
  virtual bool has_acted() = 0;
};

}  // namespace wheelwright::roomba
