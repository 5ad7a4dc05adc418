// Places on the globe as places on a floor.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace wheelwright::import {

struct LocalMetres {
  std::vector<double> east;  // of the first fix; not-a-number where there is none
  std::vector<double> north;
  std::size_t without_fix = 0;  // rows in which both are 0, as a receiver says that has no fix
};

// Of longitudes and latitudes in degrees, as many of each, on the ellipsoid of WGS 84. Within 10 km of the
// first fix that is as exact as the receiver.
LocalMetres local_metres(std::span<const double> longitude_deg, std::span<const double> latitude_deg);

}  // namespace wheelwright::import
