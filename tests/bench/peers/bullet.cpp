// Bullet's Lemke (Debian: libbullet-dev, the build for double).
#include "bench/peers/peer.hpp"

#ifdef LCPUSH_HAS_BULLET
#define BT_USE_DOUBLE_PRECISION
#include <BulletDynamics/MLCPSolvers/btLemkeAlgorithm.h>
#endif

namespace lcpush::bench {

#ifdef LCPUSH_HAS_BULLET
namespace {
class Bullet : public Peer {
public:
  const char* name() const override { return "Bullet"; }
  void load(int n, const double* M, const double* q) override {
    M_.resize(n, n);
    q_.resize(n);
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) M_.setElem(i, j, M[j * n + i]);
      q_[i] = q[i];
    }
  }
  bool solve(double* z) override {
    btLemkeAlgorithm lemke(M_, q_);
    // More would only be spent where it cycles.
    const btVectorXu answer = lemke.solve(static_cast<unsigned>(100 + 4 * q_.size()));
    for (int i = 0; i < q_.size(); ++i) z[i] = i < answer.size() ? answer[i] : 0;
    return lemke.getInfo() == 0;
  }

private:
  btMatrixXu M_;
  btVectorXu q_;
};
} // namespace

std::unique_ptr<Peer> bullet_lemke() { return std::make_unique<Bullet>(); }
#else
std::unique_ptr<Peer> bullet_lemke() { return nullptr; }
#endif

} // namespace lcpush::bench
