// What the files of an export share: the full form with its memory, and names for its numbers.
#pragma once

#include "lcpush/desktop/export.hpp"
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

/// The program of a full form.
PaperProgram paper_program(const OwnedFullForm& full);

/// names.json: what every column and row of the exported matrices is.
std::string export_names(const Push& push, const OwnedFullForm& full);

/// solve_push.py and solve_push.m, which solve the program; the same for every scene. They are
/// embedded by src/cmake/embed_text.cmake. Both are local solvers of a problem with false minima,
/// so they start from several feasible points and call nothing solved but an objective of zero.
std::string python_script();
std::string octave_script();

} // namespace lcpush::desktop
