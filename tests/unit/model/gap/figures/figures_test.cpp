#include "model/gap/figures/figures.hpp"

#include "tests/support/catch.hpp"

using namespace wheelwright;
using namespace wheelwright::gap;

TEST_CASE("A floor that lies above what is left is bounded by it, figure by figure") {
  Score floor;
  floor.wheel_speed_rms_m_s = 0.010;
  floor.distance_rms_m = 0.004;
  floor.position_rms_m = AtHorizon{10.0, 0.020};
  floor.heading_rms_rad = AtHorizon{10.0, 0.111};
  Score after = floor;
  after.distance_rms_m = 0.003;
  after.position_rms_m = AtHorizon{10.0, 0.050};
  after.heading_rms_rad = AtHorizon{10.0, 0.013};
  const Score bounded = bounded_floor(floor, after);
  CHECK(*bounded.wheel_speed_rms_m_s == 0.010);
  CHECK(*bounded.distance_rms_m == 0.003);
  CHECK(bounded.position_rms_m->value == 0.020);
  CHECK(bounded.heading_rms_rad->value == 0.013);
  CHECK(bounded.heading_rms_rad->horizon_s == 10.0);
}

TEST_CASE("A floor without a figure beside it stays as it is") {
  Score floor;
  floor.distance_rms_m = 0.004;
  const Score bounded = bounded_floor(floor, Score{});
  CHECK(*bounded.distance_rms_m == 0.004);
  CHECK_FALSE(bounded.heading_rms_rad);
}

TEST_CASE("What nobody sees is negligible, however much of it is gone after") {
  Score before;
  before.distance_rms_m = 0.0025;
  Score after;
  after.distance_rms_m = 0.0005;
  CHECK(all_figures_negligible({before, after, {}}));
  before.distance_rms_m = 0.0035;
  CHECK_FALSE(all_figures_negligible({before, after, {}}));
  CHECK_FALSE(all_figures_negligible({}));
}

TEST_CASE("Free runs go further astray where every figure above its noise rises") {
  const auto astray = [](double distance_after, double position_after) {
    Score floor;
    floor.distance_rms_m = 0.004;
    floor.position_rms_m = AtHorizon{10.0, 0.020};
    Score before = floor;
    before.distance_rms_m = 0.010;
    Score after = floor;
    after.distance_rms_m = distance_after;
    after.position_rms_m = AtHorizon{10.0, position_after};
    return goes_further_astray({before, after, floor});
  };
  CHECK(astray(0.011, 0.040));
  CHECK(astray(0.011, 0.019));        // the position falls, but within its noise
  CHECK_FALSE(astray(0.011, 0.010));  // it falls by far more than the distance rises
  CHECK_FALSE(astray(0.009, 0.040));
  CHECK_FALSE(goes_further_astray({}));
}
