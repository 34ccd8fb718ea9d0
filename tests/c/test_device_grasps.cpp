// What a microcontroller is given: random grasps of at most twelve points in float, through the C
// interface. docs/embed/tables.md quotes the figures.
#include "support/c_grasp_checks.hpp"

using namespace lcpush;
using namespace lcpush::test;

TEST_CASE("a thousand grasps in float on a device: at least 995 solved, none of them wrong") {
  for (const Pressure pressure : {Pressure::pad, Pressure::rigid, Pressure::even})
    for (const Index facets : {4, 8}) check_a_thousand(pressure, facets);
}

TEST_CASE("whatever a command's solve still takes, forces obey its grip and their cones") {
  for (const Pressure pressure : {Pressure::pad, Pressure::rigid, Pressure::even})
    check_commands_cut_off(pressure);
}

TEST_CASE("a tighter grip's push is told more nearly than by the answer before") {
  for (const Pressure pressure : {Pressure::pad, Pressure::rigid, Pressure::even})
    check_tighter_grips(pressure);
}

TEST_CASE("round friction that does not settle leaves the answer of eight facets, and says so") {
  for (const Pressure pressure : {Pressure::pad, Pressure::rigid}) check_unsettled(pressure);
}

TEST_CASE("float on a device has the push to a per cent unless it is slow beside grip over mass") {
  const double ratios[] = {1, 1e-1, 1e-2, 1e-3, 1e-4}, least[] = {98, 95, 88, 65, 15};
  for (int k = 0; k < 5; ++k) {
    const double within = within_a_per_cent(ratios[k]);
    MESSAGE("pushes of " << ratios[k] << " grip / mass: " << within << " of 100 within 1 %");
    CHECK(within >= least[k]);
  }
}

TEST_CASE("on a device, too, a grasp breaks or does not hold") {
  for (const Pressure pressure : {Pressure::pad, Pressure::rigid, Pressure::even})
    check_breaks(pressure);
}

TEST_CASE("a push fits into the bytes that the macros say, wherever they begin") {
  // What alignment takes depends on every length and on the block's address.
  std::vector<double> block(LCPUSH_BYTES(double, 9, 13, 10, 4, 5) / sizeof(double) + 3);
  Index refused = 0;
  const auto all_fit = [&](unsigned char* at, const lcpush_size& s) {
    const auto fits = [&](const void* push) { refused += push == nullptr ? 1 : 0; };
    const auto [b, p, g, a, d, pulls] = s;
    fits(lcpush_make(at, LCPUSH_BYTES(double, b, p, g, a, d), &s));
    fits(lcpushf_make(at, LCPUSH_BYTES(float, b, p, g, a, d), &s));
    fits(lcpush_make_for_sweeps(at, LCPUSH_SWEEP_BYTES(double, b, p, g, a, d), &s));
    fits(lcpushf_make_for_sweeps(at, LCPUSH_SWEEP_BYTES(float, b, p, g, a, d), &s));
    static_cast<void>(pulls);
  };
  for (std::size_t off : {0U, 8U})
    for (int bodies : {1, 2, 9})
      for (int points = 1; points <= 13; ++points)
        for (int facets : {4, 6, 10})
          for (int actuators = 0; actuators <= 4; ++actuators)
            for (int drives : {0, 1, 2, 5}) {
              unsigned char* const at = reinterpret_cast<unsigned char*>(block.data()) + off;
              all_fit(at, {bodies, points, facets, actuators, drives, 0});
            }
  CHECK(refused == 0);
}
