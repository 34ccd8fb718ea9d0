// A ray in words: who squeezes the object against whom, and what would free it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lcpush/desktop/scene_io.hpp"
#include "lcpush/mechanics/study/jam.hpp"

namespace lcpush::desktop {

struct JamBody {
  Index body;                      ///< of the scene file
  double normal;                   ///< its normal forces in the ray, the largest body's 1
  double power;                    ///< of its prescribed motion; > 0: it tightens; no rounding
  std::vector<std::string> points; ///< "wall.1": those that press
};

/// A change of the scene, and whether a solve has shown that it helps.
struct Remedy {
  std::string text;
  bool tried = false;
  bool works = false;
};

struct Jam {
  std::vector<JamBody> bodies;           ///< those that squeeze; empty: nothing is pressed
  std::vector<std::string> running_away; ///< bodies whose actuator closes without end
  bool uses_friction = false;
  bool no_answer = false;       ///< proved, for any loads and grip forces (theory 5.5)
  bool loads_actuators = false; ///< an actuator feels the squeeze
  std::vector<Remedy> remedies;
};

/// Does this changed scene have an answer?
using TryScene = std::function<bool(const SceneFile&)>;

/// Reads the ray v >= 0 of assembly.problem(), the scene of `file`. Each remedy's scene is tried by
/// `solves`, or none if that is empty. Cost: O(forces) and those solves.
Jam explain_jam(const SceneFile& file, const Assembly<double>& assembly, const double* v,
                const TryScene& solves = {});

/// The jam in full sentences, and the remedies that the last of them announces.
std::vector<std::string> jam_findings(const SceneFile& file, const Jam& jam);
std::vector<std::string> jam_remedies(const Jam& jam);
/// Both, a line each; a remedy's begins with a dash.
std::vector<std::string> jam_sentences(const SceneFile& file, const Jam& jam);

} // namespace lcpush::desktop
