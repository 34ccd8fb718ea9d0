// Siconos' Lemke with the lexicographic rule, and its pivoting solver (Debian:
// libsiconos-numerics-dev).
#include "bench/peers/peer.hpp"

#ifdef LCPUSH_HAS_SICONOS
#include <numerics/LCP_Solvers.h>
#include <numerics/LinearComplementarityProblem.h>
#include <numerics/NumericsMatrix.h>
#include <numerics/SolverOptions.h>
#include <numerics/lcp_cst.h>
#endif

namespace lcpush::bench {

#ifdef LCPUSH_HAS_SICONOS
namespace {
class Siconos : public Peer {
public:
  explicit Siconos(bool lexicographic)
      : lexicographic_(lexicographic),
        options_(solver_options_create(lexicographic ? SICONOS_LCP_LEMKE : SICONOS_LCP_PIVOT)) {
    if (!lexicographic)
      options_->iparam[SICONOS_LCP_IPARAM_PIVOTING_METHOD_TYPE] = SICONOS_LCP_PIVOT_LEMKE;
  }
  ~Siconos() override {
    if (matrix_ != nullptr) NM_clear(matrix_);
    solver_options_delete(options_);
  }
  Siconos(const Siconos&) = delete;
  Siconos& operator=(const Siconos&) = delete;

  const char* name() const override { return lexicographic_ ? "Siconos lexico" : "Siconos pivot"; }
  void load(int n, const double* M, const double* q) override {
    if (matrix_ != nullptr) NM_clear(matrix_);
    matrix_ = NM_create(NM_DENSE, n, n);
    for (int k = 0; k < n * n; ++k) matrix_->matrix0[k] = M[k];
    q_.assign(q, q + n);
    w_.resize(q_.size());
    problem_.size = n;
    problem_.M = matrix_;
    problem_.q = q_.data();
    options_->iparam[SICONOS_IPARAM_MAX_ITER] = 1000 + 50 * n;
  }
  bool solve(double* z) override {
    int info = -1;
    for (int i = 0; i < problem_.size; ++i) z[i] = w_[static_cast<std::size_t>(i)] = 0;
    (lexicographic_ ? lcp_lexicolemke : lcp_pivot)(&problem_, z, w_.data(), &info, options_);
    return info == 0;
  }

private:
  bool lexicographic_;
  SolverOptions* options_;
  NumericsMatrix* matrix_ = nullptr;
  LinearComplementarityProblem problem_{};
  std::vector<double> q_, w_;
};
} // namespace

std::unique_ptr<Peer> siconos_lexicographic() { return std::make_unique<Siconos>(true); }
std::unique_ptr<Peer> siconos_pivot() { return std::make_unique<Siconos>(false); }
#else
std::unique_ptr<Peer> siconos_lexicographic() { return nullptr; }
std::unique_ptr<Peer> siconos_pivot() { return nullptr; }
#endif

} // namespace lcpush::bench
