// What the files of an export share: the full form with its memory, and names for its numbers.
#pragma once

#include "lcpush/desktop/export.hpp"
#include "lcpush/desktop/matrix_market.hpp"
#include "lcpush/desktop/push.hpp"
#include "lcpush/mechanics/paper/full_form.hpp"

namespace lcpush::desktop {

inline HostMatrix zero_matrix(Index rows, Index cols) {
  return {rows, cols, std::vector<double>(static_cast<std::size_t>(rows * cols))};
}

inline MatrixMap<double> map_of(HostMatrix& matrix) {
  return {matrix.values.data(), matrix.rows, matrix.cols};
}

/// An expression's values; zeros without a sign, so that none is written to a file.
template <class Expression> HostMatrix host_matrix(const Expression& values) {
  HostMatrix matrix = zero_matrix(values.rows(), values.cols());
  map_of(matrix) = values;
  for (double& x : matrix.values) x += 0.0;
  return matrix;
}

/// The full form of an assembly, which must outlive it.
class OwnedFullForm {
public:
  explicit OwnedFullForm(const Assembly<double>& assembly)
      : assembly_(assembly), patches_(static_cast<std::size_t>(assembly.scene().bodies.size)),
        first_(patches_.size()),
        weights_(static_cast<std::size_t>(most_references * assembly.scene().points.size)),
        form_({span_of(patches_), span_of(first_), span_of(weights_)}) {
    (void)form_.describe(assembly); // the memory is large enough
  }
  OwnedFullForm(const OwnedFullForm&) = delete;
  OwnedFullForm& operator=(const OwnedFullForm&) = delete;

  const FullForm<double>& form() const { return form_; }
  const Assembly<double>& assembly() const { return assembly_; }
  /// Unknowns that stand in a complementary pair; all others are free, their rows equalities.
  Index complementary() const { return assembly_.layout().size - assembly_.layout().actuators; }

private:
  const Assembly<double>& assembly_;
  std::vector<PatchReferences<double>> patches_;
  std::vector<Index> first_;
  std::vector<double> weights_;
  FullForm<double> form_;
};

/// The files of an export.
struct Folder {
  std::vector<ExportFile> files;

  void text(const std::string& name, std::string text) { files.push_back({name, std::move(text)}); }
  void matrix(const std::string& name, const HostMatrix& matrix, const std::string& comment) {
    text(name + ".mtx", write_matrix_market(matrix, MatrixMarketFormat::coordinate, comment));
  }
  void vector(const std::string& name, const HostMatrix& vector, const std::string& comment) {
    text(name + ".mtx", write_matrix_market(vector, MatrixMarketFormat::array, comment));
  }
};

/// The paper's optimisation problem in the full form's unknowns x = [lambda, beta.., xi point by
/// point ; s ; a ; r] (see mechanics/paper/full_form.hpp), n of them, the first c complementary:
///
///   minimise x' H x / 2 + f' x   subject to   A x <= b,  Aeq x = beq,  lb <= x <= ub.
///
/// The objective is the sum of z_i w_i over the complementary pairs, so it is >= 0 wherever the
/// constraints hold and 0 exactly at the solutions; it is not convex. With M and q of the full
/// form:
///
///   A = -M(1..c, :), b = q(1..c), Aeq = M(c+1..n, :), beq = -q(c+1..n),
///   H = C + C', f = [q(1..c) ; 0],   C = [M(1..c, :) ; 0].
///
/// `answer` x is [object's acceleration, 6 ; closing of each actuator ; for each contact
/// normal_force, friction_force (3), torsion, acceleration (3)] in SI units and scene axes.
void add_program(const OwnedFullForm& full, const std::string& units, Folder& folder);

/// The local problem of the Frictional Contact Library (FCLIB), in SI units, components n, t, o
/// contact by contact (k of them, e actuators):
///
///   u = W r + V l + q,   V' r + R l + s = 0,   K* contains u + mu |u_t| n  _|_  r in K,
///
/// K the *round* cone |r_t| <= mu r_n. r are the contact forces, u the accelerations of the object
/// relative to the bodies, l = - the closings of the actuators. W (3k x 3k, symmetric, 1/kg) is the
/// Delassus operator, V (3k x e) the hand Jacobian, R minus the actuators' inertia, s minus their
/// forces, q (m/s^2) the acceleration under the weight alone, less the prescribed motion.
void add_fclib(const SceneFile& file, Export& result, Folder& folder);

/// names.json: what every column and row of the exported matrices is.
std::string export_names(const Push& push, const OwnedFullForm& full);

/// solve_push.py and solve_push.m, which solve the program; the same for every scene. They are
/// embedded by src/cmake/embed_text.cmake. Both are local solvers of a problem with false minima,
/// so they start from several feasible points and call nothing solved but an objective of zero.
std::string python_script();
std::string octave_script();
/// What main.c does with its tables; embedded as well.
std::string control_loop();

} // namespace lcpush::desktop
