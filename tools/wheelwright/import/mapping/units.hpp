// Units as logs name them, in SI.
#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace wheelwright::import {

// Of a gyro: the numbers of its registers.
inline constexpr std::string_view raw_unit = "LSB";

// Of the places of a reference: degrees of longitude (x) and latitude (y), and of an image.
inline constexpr std::string_view geographic_unit = "deg";
inline constexpr std::string_view pixel_unit = "px";

struct Unit {
  std::string_view name;
  double in_si;            // how many m, m/s, rad, rad/s, s or V one of it is
  bool of_wheel = false;   // an angle of the wheel: times the wheel radius it is a distance
  bool of_count = false;   // counts of the encoder: times the distance of one it is a distance
  bool is_stated = false;  // never inferred from motion alone: a wrong scale looks the same
  bool is_raw = false;     // of the registers of a servo; likewise

  bool is_found_by_motion() const { return !is_stated && !is_raw; }
};

// m/s mm/s cm/s km/h ft/s inch/s mph dm/s m/min, of a wheel rad/s deg/s rpm turn/s, counts/s, 0.229rpm
// (Dynamixel)
std::span<const Unit> speed_units();
std::span<const Unit> angular_units();   // rad/s deg/s rpm mrad/s
std::span<const Unit> distance_units();  // m mm cm km ft inch dm yd
std::span<const Unit> angle_units();     // rad deg turn mrad 0.1deg 0.01deg
std::span<const Unit> voltage_units();   // V mV

// The unit of that name, spelled in any of the usual ways ("m_s", "mps", "meters", "degrees").
std::optional<Unit> find_unit(std::span<const Unit> units, std::string_view name);

// How much one unit of that name is in SI; 1 where it is none of them.
double in_si(std::span<const Unit> units, std::string_view name);

// The name that files use for a spelling: "mps" is "m/s". Empty where it is no unit.
std::string_view unit_by_spelling(std::string_view spelling);

}  // namespace wheelwright::import
