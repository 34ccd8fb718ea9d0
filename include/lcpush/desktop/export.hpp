// lcpush export: a scene's problem in the forms that other solvers read, and scripts that solve it
// the paper's way. Texts only: who wants files writes them. docs/check/export.md lists all of them.
//
// All forms hold the literal laws [T.1] to [T.6] with the scene's full push, and no pressure law:
// `pad` and `rigid` scenes give the same files, an `even` scene gives the spread scene, in which
// each point of a driven patch is a body of its own.
#pragma once

#include <string>
#include <vector>

#include "lcpush/desktop/scene_io.hpp"

namespace lcpush::desktop {

/// Bounds of this size and more mean "none": a Matrix Market file cannot hold an infinity.
constexpr double no_bound = 1e30;

struct ExportFile {
  std::string name; ///< relative to the folder, '/' between parts
  std::string text;
};

struct Export {
  std::vector<ExportFile> files;
  Index unknowns = 0; ///< of M.mtx
  std::string free;   ///< its free unknowns as `lcp --free` takes them: "65,66"; or empty
  std::string units;  ///< "scaled: force 20 N, ..", in six digits; the files have all
  /// Why the scene has no FCLIB problem (torsion, or a contact that pulls); empty if it has one.
  std::string fclib_refusal;
  /// Files that another scene's export has and this one has not: left in a folder they would lie.
  std::vector<std::string> absent;
};

/// Every file of `lcpush export`. Numbers read back as the same doubles. Cost: O(n^2) memory, n the
/// unknowns of the full form.
Export export_scene(const SceneFile& file);

/// The scene for a device: main.c of the C interface, with the memory that it takes and a control
/// loop. Its last tick is the scene's push, in float.
std::string c_program(const SceneFile& file);

/// The scene for engines of rigid bodies: MuJoCo's XML (MJCF) and SDFormat 1.9; a sentence as
/// InputError on what they cannot say. Bodies slide, press and rub as the scene's; what stands for
/// contact points, and what engines add (soft contact, steps), docs/check/export.md tells.
std::string mjcf_text(const SceneFile& file);
std::string sdf_text(const SceneFile& file);

} // namespace lcpush::desktop
