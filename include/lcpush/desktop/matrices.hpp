// The paper's matrices of a scene with names for rows and columns, for reading and for programs.
#pragma once

#include <string>
#include <vector>

#include "lcpush/desktop/matrix_market.hpp"
#include "lcpush/desktop/scene_check.hpp"
#include "lcpush/desktop/scene_io.hpp"
#include "lcpush/mechanics/paper/patch_rigidity.hpp"

namespace lcpush::desktop {

struct NamedMatrix {
  std::vector<std::string> rows, columns;
  HostMatrix values;
};

/// The friction generators of each point of one body.
struct BodyGenerators {
  std::string body;
  NamedMatrix D; ///< rows t, o and, at a soft point, torsion (m); a column a generator
};

/// A pusher's block of J, and the twist that multiplies it.
struct PusherJacobian {
  std::string body;
  NamedMatrix J;     ///< components of its points x 6
  NamedMatrix twist; ///< 6 x 1, as the file prescribes it for the pusher itself
};

/// [T.6] One body's references and weights, and what check_rigidity says of them.
struct PatchRigidity {
  std::string body;
  std::vector<std::string> points, references;
  std::vector<std::vector<double>> weights; ///< per point, per reference
  RigidityCheck<double> check;
  bool checked = false; ///< false beyond largest_checked_patch: the rank is not known
};

constexpr Index largest_checked_patch = 256; // points; the work grows with their cube

/// SI units, scene axes, wrenches and twists at the object's centre of mass; the meaning of each
/// matrix is in mechanics/paper/paper_matrices.hpp. The scene as the file has it: `even` pressure
/// splits bodies and actuators only when it is solved.
struct PaperMatrices {
  NamedMatrix M;     ///< 6 x 6
  NamedMatrix w;     ///< 6 x 1
  NamedMatrix G;     ///< 6 x components, "left.1 n", "left.1 t", "left.1 o", "left.1 torsion"
  NamedMatrix G_bar; ///< 6 x forces, "left.1 n", "left.1 d0", "left.1 d1", ..
  NamedMatrix J;     ///< components x force-controlled actuators
  NamedMatrix J_prescribed; ///< components x actuators whose acceleration is prescribed
  NamedMatrix s_prescribed; ///< their accelerations
  std::vector<PusherJacobian> J_pusher;
  NamedMatrix v; ///< components x 1, the right-hand side of [P.10]: r = G' a - J s - v
  std::vector<BodyGenerators> D;
  std::vector<PatchRigidity> rigidity;
};

PaperMatrices paper_matrices(const SceneFile& file);

/// `matrices`: tables of at most 100 columns as long as names are short; G and G-bar transposed.
std::string matrices_text(const SceneFile& file, const PaperMatrices& matrices);
/// `matrices --json`: M, w, G, G_bar, J, J_prescribed, s_prescribed and v with rows, columns and
/// values (row by row); J_pusher, D and rigidity.
std::string matrices_json(const PaperMatrices& matrices,
                          const std::vector<SceneDoubt>& warnings = {});

} // namespace lcpush::desktop
