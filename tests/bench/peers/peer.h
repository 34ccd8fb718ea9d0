/* A solver of linear complementarity problems that lcpush is compared with: a shared library that
   exports this one function. Find z: w = M z + q, z >= 0, w >= 0, z'w = 0.

       peers --peer ./my_solver.so

   M is n x n, column-major; M and q stay where they are from a `load` to the next. Returns whether
   z is a solution, as the solver says; lcpush judges it. */
#ifndef LCPUSH_PEER_H
#define LCPUSH_PEER_H

#ifdef __cplusplus
extern "C" {
#endif

enum lcpush_peer_task {
  lcpush_peer_load, /* untimed: bring the problem into the solver's own types */
  lcpush_peer_solve /* timed: solve it from nothing into z */
};

int lcpush_peer(int task, int n, const double* M, const double* q, double* z);

#ifdef __cplusplus
}
#endif
#endif
