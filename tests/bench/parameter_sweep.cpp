// What a sweep's warm starts save: the same points from nothing and from their neighbours' answers.
//
//     parameter_sweep SCENE.toml PATH FROM TO [POINTS]
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>

#include "lcpush/desktop/sweep.hpp"

int main(int count, char** words) {
  using namespace lcpush::desktop;
  if (count < 5) {
    std::fprintf(stderr, "Usage: parameter_sweep SCENE.toml PATH FROM TO [POINTS]\n");
    return 2;
  }
  try {
    const char* const law[] = {"rigid", "pad"};
    for (const char* pressure : law) {
      VariedScene scene = VariedScene::read(words[1]);
      scene.set_pressure(pressure);
      const Variation variation{scene.find(words[2]), std::atof(words[3]), std::atof(words[4])};
      double seconds[2];
      Sweep sweep;
      for (const bool warm : {false, true}) {
        ParameterSweepOptions options;
        options.steps = count > 5 ? std::atoi(words[5]) : 1000;
        options.warm = warm;
        options.both_ways = false;
        double best = 1e300;
        for (int repeat = 0; repeat < 5; ++repeat) {
          const std::clock_t begin = std::clock(); // of this process, whatever else runs
          sweep = sweep_parameter(scene, {variation}, options);
          best = std::min(best, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
        }
        seconds[warm ? 1 : 0] = best;
      }
      std::printf(
          "%-5s  %zu points: cold %.3f s, warm %.3f s, warm/cold %.3f; %td cold solves left\n",
          pressure, sweep.points.size(), seconds[0], seconds[1], seconds[1] / seconds[0],
          sweep.cold);
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
  return 0;
}
