// Siconos' Lemke with the lexicographic rule, or with LCPUSH_SICONOS_PIVOT its pivoting solver
// (Debian: libsiconos-numerics-dev).
#include <numerics/LCP_Solvers.h>
#include <numerics/LinearComplementarityProblem.h>
#include <numerics/NumericsMatrix.h>
#include <numerics/SolverOptions.h>
#include <numerics/lcp_cst.h>

#include <algorithm>
#include <vector>

#include "bench/peers/peer.h"

namespace {

class Siconos {
public:
  Siconos() : options_(solver_options_create(solver)) {
    if (solver == SICONOS_LCP_PIVOT)
      options_->iparam[SICONOS_LCP_IPARAM_PIVOTING_METHOD_TYPE] = SICONOS_LCP_PIVOT_LEMKE;
  }
  ~Siconos() {
    if (matrix_ != nullptr) NM_clear(matrix_);
    solver_options_delete(options_);
  }
  Siconos(const Siconos&) = delete;
  Siconos& operator=(const Siconos&) = delete;

  void load(int n, const double* M, const double* q) {
    if (matrix_ != nullptr) NM_clear(matrix_);
    matrix_ = NM_create(NM_DENSE, n, n);
    std::copy(M, M + n * n, matrix_->matrix0);
    q_.assign(q, q + n);
    w_.resize(q_.size());
    problem_.size = n;
    problem_.M = matrix_;
    problem_.q = q_.data();
    options_->iparam[SICONOS_IPARAM_MAX_ITER] = 1000 + 50 * n;
  }
  bool solve(double* z) {
    int info = -1;
    std::fill_n(z, problem_.size, 0.0);
    std::fill(w_.begin(), w_.end(), 0.0);
    (solver == SICONOS_LCP_PIVOT ? lcp_pivot : lcp_lexicolemke)(&problem_, z, w_.data(), &info,
                                                                options_);
    return info == 0;
  }

private:
#ifdef LCPUSH_SICONOS_PIVOT
  static constexpr int solver = SICONOS_LCP_PIVOT;
#else
  static constexpr int solver = SICONOS_LCP_LEMKE;
#endif
  SolverOptions* options_;
  NumericsMatrix* matrix_ = nullptr;
  LinearComplementarityProblem problem_{};
  std::vector<double> q_, w_;
};

} // namespace

int lcpush_peer(int task, int n, const double* M, const double* q, double* z) {
  static Siconos siconos;
  if (task == lcpush_peer_load) siconos.load(n, M, q);
  return task == lcpush_peer_load || siconos.solve(z) ? 1 : 0;
}
