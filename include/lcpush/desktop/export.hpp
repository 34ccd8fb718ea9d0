// lcpush export: a scene's problem in the forms that other solvers read, and scripts that solve it
// the paper's way. Texts only: who wants files writes them. docs/check/export.md lists all of them.
//
// All forms hold the literal laws [T.1] to [T.6] with the scene's full push, and no pressure law:
// `pad` and `rigid` scenes give the same files, an `even` scene gives the spread scene, in which
// each point of a driven patch is a body of its own.
#pragma once

#include <string>
#include <vector>

#include "lcpush/desktop/matrix_market.hpp"
#include "lcpush/desktop/scene_io.hpp"

namespace lcpush::desktop {

/// Bounds of this size and more mean "none": a Matrix Market file cannot hold an infinity.
constexpr double no_bound = 1e30;

/// The paper's optimisation problem in the full form's unknowns x = [lambda, beta.., xi point by
/// point ; s ; a ; r] (see mechanics/paper/full_form.hpp), n of them, the first c complementary:
///
///   minimise x' H x / 2 + f' x   subject to   A x <= b,  Aeq x = beq,  lb <= x <= ub.
///
/// The objective is the sum of z_i w_i over the complementary pairs, so it is >= 0 wherever the
/// constraints hold and 0 exactly at the solutions. Scaled units. With M and q of the full form:
///
///   A = -M(1..c, :), b = q(1..c), Aeq = M(c+1..n, :), beq = -q(c+1..n),
///   H = C + C', f = [q(1..c) ; 0],   C = [M(1..c, :) ; 0].
struct PaperProgram {
  Index complementary = 0; ///< c
  HostMatrix H;            ///< n x n, symmetric, zero diagonal: convex on the constraints at best
  HostMatrix f;            ///< n x 1
  HostMatrix A;            ///< c x n
  HostMatrix b;            ///< c x 1
  HostMatrix Aeq;          ///< n - c x n
  HostMatrix beq;          ///< n - c x 1
  HostMatrix lb, ub;       ///< n x 1
  /// Reads an answer off: answer x = [object's acceleration, 6 ; closing of each actuator ; for
  /// each contact normal_force, friction_force (3), torsion, acceleration (3)], SI units, scene
  /// axes.
  HostMatrix answer;
};

PaperProgram paper_program(const SceneFile& file);

/// The same physics as the local problem of the Frictional Contact Library (FCLIB), in SI units,
/// components n, t, o contact by contact (k of them, e actuators):
///
///   u = W r + V l + q,   V' r + R l + s = 0,   K* contains u + mu |u_t| n  _|_  r in K,
///
/// K the *round* cone |r_t| <= mu r_n. r are the contact forces, u the accelerations of the object
/// relative to the bodies, l = - the closings of the actuators.
struct FclibProblem {
  /// Empty, or why this scene has no such form (torsion, or a contact that pulls): then the rest is
  /// empty.
  std::string refusal;
  HostMatrix W;  ///< 3k x 3k, symmetric, 1/kg: the Delassus operator
  HostMatrix V;  ///< 3k x e: the hand Jacobian
  HostMatrix R;  ///< e x e: minus the actuators' inertia
  HostMatrix mu; ///< k x 1
  HostMatrix q;  ///< 3k x 1, m/s^2: acceleration under the weight alone, less the prescribed motion
  HostMatrix s;  ///< e x 1: minus the actuators' forces
};

FclibProblem fclib_problem(const SceneFile& file);

struct ExportFile {
  std::string name; ///< relative to the folder, '/' between parts
  std::string text;
};

struct Export {
  std::vector<ExportFile> files;
  Index unknowns = 0;        ///< of M.mtx
  std::string free;          ///< its free unknowns as `lcp --free` takes them: "65,66"; or empty
  std::string units;         ///< "scaled: force 20 N, .."
  std::string fclib_refusal; ///< FclibProblem::refusal
  /// Files that another scene's export has and this one has not: left in a folder they would lie.
  std::vector<std::string> absent;
};

/// Every file of `lcpush export`. Numbers read back as the same doubles. Cost: O(n^2) memory, n the
/// unknowns of the full form.
Export export_scene(const SceneFile& file);

} // namespace lcpush::desktop
