#include "tools/wheelwright/prediction/score_json.hpp"

namespace wheelwright::tools {

using nlohmann::ordered_json;

namespace {

ordered_json to_json(const AtHorizon& figure) {
  return {{"horizon_s", figure.horizon_s}, {"value", figure.value}};
}

}  // namespace

ordered_json score_to_json(const Score& score) {
  ordered_json json = ordered_json::object();
  if (score.wheel_speed_rms_m_s) json["wheel_speed_rms_m_s"] = *score.wheel_speed_rms_m_s;
  if (score.distance_rms_m) json["distance_rms_m"] = *score.distance_rms_m;
  if (score.position_rms_m) json["position_rms_m"] = to_json(*score.position_rms_m);
  if (score.heading_rms_rad) json["heading_rms_rad"] = to_json(*score.heading_rms_rad);
  return json;
}

}  // namespace wheelwright::tools
