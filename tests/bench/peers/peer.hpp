// Another library's solver of linear complementarity problems, behind one interface. Each has a
// source file of its own, compiled with the library's flags and not with the benchmark's.
#pragma once

#include <memory>
#include <vector>

namespace lcpush::bench {

class Peer {
public:
  virtual ~Peer() = default;
  virtual const char* name() const = 0;
  /// Brings w = M z + q into the library's own types, untimed. M n x n, column-major.
  virtual void load(int n, const double* M, const double* q) = 0;
  /// Timed: z receives n numbers. Returns whether the library calls them a solution.
  virtual bool solve(double* z) = 0;
};

// Null where the library was not found.
std::unique_ptr<Peer> dart_lemke();
std::unique_ptr<Peer> siconos_lexicographic();
std::unique_ptr<Peer> siconos_pivot();
std::unique_ptr<Peer> bullet_lemke();

} // namespace lcpush::bench
