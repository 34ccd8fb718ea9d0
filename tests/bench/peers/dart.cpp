// DART's Lemke (Debian: libdart-dev).
#include "bench/peers/peer.hpp"

#ifdef LCPUSH_HAS_DART
#include <Eigen/Dense>
#include <dart/lcpsolver/Lemke.hpp>
#endif

namespace lcpush::bench {

#ifdef LCPUSH_HAS_DART
namespace {
class Dart : public Peer {
public:
  const char* name() const override { return "DART"; }
  void load(int n, const double* M, const double* q) override {
    M_ = Eigen::Map<const Eigen::MatrixXd>(M, n, n);
    q_ = Eigen::Map<const Eigen::VectorXd>(q, n);
  }
  bool solve(double* z) override {
    z_.setZero(q_.size());
    const int error = dart::lcpsolver::Lemke(M_, q_, &z_);
    for (Eigen::Index i = 0; i < q_.size(); ++i) z[i] = i < z_.size() ? z_[i] : 0;
    return error == 0;
  }

private:
  Eigen::MatrixXd M_;
  Eigen::VectorXd q_, z_;
};
} // namespace

std::unique_ptr<Peer> dart_lemke() { return std::make_unique<Dart>(); }
#else
std::unique_ptr<Peer> dart_lemke() { return nullptr; }
#endif

} // namespace lcpush::bench
