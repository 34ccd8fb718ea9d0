// Bullet's Lemke (Debian: libbullet-dev, the build for double).
#define BT_USE_DOUBLE_PRECISION
#include <BulletDynamics/MLCPSolvers/btLemkeAlgorithm.h>

#include "bench/peers/peer.h"

int lcpush_peer(int task, int n, const double* M, const double* q, double* z) {
  static btMatrixXu matrix;
  static btVectorXu constants;
  if (task == lcpush_peer_load) {
    matrix.resize(n, n);
    constants.resize(n);
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) matrix.setElem(i, j, M[j * n + i]);
      constants[i] = q[i];
    }
    return 1;
  }
  btLemkeAlgorithm lemke(matrix, constants);
  // More pivots would only be spent where it cycles.
  const btVectorXu answer = lemke.solve(static_cast<unsigned>(100 + 4 * n));
  for (int i = 0; i < n; ++i) z[i] = i < answer.size() ? answer[i] : 0;
  return lemke.getInfo() == 0 ? 1 : 0;
}
