#include "daemon/telemetry/schemas.hpp"

#include <nlohmann/json.hpp>

#include <initializer_list>
#include <string>
#include <utility>

#include "daemon/recording/mcap/schemas.hpp"

namespace wheelwright::daemon::telemetry::schema {
namespace {

using Json = nlohmann::json;
using Fields = std::initializer_list<std::pair<const char*, Json>>;

Json of_type(const char* type) {
  return {{"type", type}};
}

Json object(const char* title, const Fields& fields) {
  Json properties = Json::object();
  for (const auto& [name, schema] : fields) properties[name] = schema;
  return {{"title", title}, {"type", "object"}, {"properties", std::move(properties)}};
}

Json list_of(Json item) {
  return {{"type", "array"}, {"items", std::move(item)}};
}

Json one_of(std::initializer_list<std::pair<int, const char*>> values) {
  Json choices = Json::array();
  for (const auto& [value, name] : values) choices.push_back({{"title", name}, {"const", value}});
  return {{"type", "integer"}, {"oneOf", std::move(choices)}};
}

const Json number = of_type("number");
const Json integer = of_type("integer");
const Json boolean = of_type("boolean");
const Json text = of_type("string");
const Json anything = list_of(of_type("object"));

Json time(const char* title = "time") {
  return object(title, {{"sec", {{"type", "integer"}, {"minimum", 0}}},
                        {"nsec", {{"type", "integer"}, {"minimum", 0}, {"maximum", 999999999}}}});
}

Json vector3(const char* title = "foxglove.Vector3") {
  return object(title, {{"x", number}, {"y", number}, {"z", number}});
}

Json quaternion() {
  return object("foxglove.Quaternion", {{"x", number}, {"y", number}, {"z", number}, {"w", number}});
}

Json pose() {
  return object("foxglove.Pose", {{"position", vector3()}, {"orientation", quaternion()}});
}

Json color() {
  return object("foxglove.Color", {{"r", number}, {"g", number}, {"b", number}, {"a", number}});
}

Json line() {
  const Json type = one_of({{0, "LINE_STRIP"}, {1, "LINE_LOOP"}, {2, "LINE_LIST"}});
  return object("foxglove.LinePrimitive", {{"type", type},
                                           {"pose", pose()},
                                           {"thickness", number},
                                           {"scale_invariant", boolean},
                                           {"points", list_of(vector3("foxglove.Point3"))},
                                           {"color", color()},
                                           {"colors", list_of(color())},
                                           {"indices", list_of(integer)}});
}

Json sphere() {
  return object("foxglove.SpherePrimitive", {{"pose", pose()}, {"size", vector3()}, {"color", color()}});
}

Json cylinder() {
  return object("foxglove.CylinderPrimitive", {{"pose", pose()},
                                               {"size", vector3()},
                                               {"bottom_scale", number},
                                               {"top_scale", number},
                                               {"color", color()}});
}

Json entity() {
  const Json pair = object("foxglove.KeyValuePair", {{"key", text}, {"value", text}});
  return object("foxglove.SceneEntity", {{"timestamp", time()},
                                         {"frame_id", text},
                                         {"id", text},
                                         {"lifetime", time("duration")},
                                         {"frame_locked", boolean},
                                         {"metadata", list_of(pair)},
                                         {"arrows", anything},
                                         {"cubes", anything},
                                         {"spheres", list_of(sphere())},
                                         {"cylinders", list_of(cylinder())},
                                         {"lines", list_of(line())},
                                         {"triangles", anything},
                                         {"texts", anything},
                                         {"models", anything}});
}

Json deletion() {
  return object("foxglove.SceneEntityDeletion",
                {{"timestamp", time()}, {"type", one_of({{0, "MATCHING_ID"}, {1, "ALL"}})}, {"id", text}});
}

}  // namespace

std::string_view pose_in_frame() {
  static const std::string schema = mcap::pose_in_frame_schema();
  return schema;
}

std::string_view frame_transform() {
  static const std::string schema = mcap::frame_transform_schema();
  return schema;
}

std::string_view scene_update() {
  static const std::string schema =
      object("foxglove.SceneUpdate", {{"deletions", list_of(deletion())}, {"entities", list_of(entity())}})
          .dump();
  return schema;
}

std::string_view log() {
  static const std::string schema = mcap::log_schema();
  return schema;
}

std::string_view wheels() {
  static const std::string schema = mcap::wheels_schema();
  return schema;
}

std::string_view light_bumper() {
  static const std::string schema = object("wheelwright.LightBumper", {{"timestamp", time()},
                                                                       {"left", integer},
                                                                       {"front_left", integer},
                                                                       {"center_left", integer},
                                                                       {"center_right", integer},
                                                                       {"front_right", integer},
                                                                       {"right", integer},
                                                                       {"bump_left", boolean},
                                                                       {"bump_right", boolean}})
                                        .dump();
  return schema;
}

std::string_view loop() {
  static const std::string schema =
      object("wheelwright.Loop", {{"timestamp", time()}, {"lateness_us", number}}).dump();
  return schema;
}

std::string_view state() {
  static const std::string schema = mcap::state_schema();
  return schema;
}

}  // namespace wheelwright::daemon::telemetry::schema
