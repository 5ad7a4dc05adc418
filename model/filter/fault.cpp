#include "model/filter/fault.hpp"

namespace wheelwright {

std::string_view name_of(FaultKind kind) {
  switch (kind) {
    case FaultKind::none:
      return "none";
    case FaultKind::misfit:
      return "misfit";
    case FaultKind::dropped:
      return "dropped counts";
    case FaultKind::frozen:
      return "frozen encoder";
    case FaultKind::spike:
      return "spike";
    case FaultKind::stuck_at:
      return "encoder stuck";
    case FaultKind::swapped:
      return "swapped encoders";
    case FaultKind::drifting:
      return "drifting encoder scale";
    case FaultKind::stalled:
      return "stalled wheel";
    case FaultKind::lifted:
      return "lifted wheel";
    case FaultKind::slipping:
      return "slipping or held robot";
  }
  return "unknown";
}

}  // namespace wheelwright
