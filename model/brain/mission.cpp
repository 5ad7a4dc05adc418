#include "model/brain/mission.hpp"

namespace wheelwright {

std::string_view name_of(PoseSource source) {
  switch (source) {
    case PoseSource::fir:
      return "fir";
    case PoseSource::arma:
      return "arma";
    case PoseSource::hybrid:
      return "hybrid";
    case PoseSource::odometry:
      return "odometry";
  }
  return "unknown";
}

}  // namespace wheelwright
