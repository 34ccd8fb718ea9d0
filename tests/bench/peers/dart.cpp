// DART's Lemke (Debian: libdart-dev).
#include <Eigen/Dense>
#include <dart/lcpsolver/Lemke.hpp>

#include "bench/peers/peer.h"

int lcpush_peer(int task, int n, const double* M, const double* q, double* z) {
  static Eigen::MatrixXd matrix;
  static Eigen::VectorXd constants, answer;
  if (task == lcpush_peer_load) {
    matrix = Eigen::Map<const Eigen::MatrixXd>(M, n, n);
    constants = Eigen::Map<const Eigen::VectorXd>(q, n);
    return 1;
  }
  answer.setZero(n);
  const int error = dart::lcpsolver::Lemke(matrix, constants, &answer);
  for (Eigen::Index i = 0; i < n; ++i) z[i] = i < answer.size() ? answer[i] : 0;
  return error == 0 ? 1 : 0;
}
