// Block Gauss-Seidel measured: `sweeps [GRASPS]` (default 1000).
// First ways to speed up the plain sweeps, on seeded random grasps under `rigid`: how many reach a
// scaled residual of 1e-6 within 5,000 sweeps. Then the cost of a sweep a point, from 10 points to
// 10,000.
#include <Eigen/Dense>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <vector>

#include "bench/stopwatch.hpp"
#include "lcpush/lcpush.hpp"
#include "lcpush/mechanics/model/patch.hpp"
#include "support/grasp_families.hpp"
#include "support/owned_sweeps.hpp"

namespace {

using namespace lcpush;
using Forces = Eigen::VectorXd;

constexpr Index most_sweeps = 5000;
constexpr double wanted = 1e-6;

/// One plain sweep from the forces z; z receives what it leads to. The residual if it was checked.
class PlainSweep {
public:
  explicit PlainSweep(const Assembly<double>& assembly, const AssemblySize& size)
      : problem_(assembly.problem()), owned_(size) {
    options_.accelerate = false;
    options_.check_every = 1;
    options_.tolerance = wanted;
    (void)owned_.sweeps.init(problem_, options_);
  }
  Forces start() const { return Eigen::Map<const Forces>(owned_.sweeps.z(), problem_.free_begin); }
  /// False once the residual is reached.
  bool step(const Forces& from, Forces& to) {
    Forces all = Forces::Zero(problem_.size);
    all.head(problem_.free_begin) = from;
    if (owned_.sweeps.init(problem_, options_, all.data()) != Status::running) return false;
    const Status status = owned_.sweeps.sweep();
    to = start();
    for (const ConeGroup<double>& cone : problem_.factored->cones)
      if (cone.generators > 0) to[cone.slip()] = 0; // a multiplier, no force
    return status == Status::running;
  }

private:
  Problem<double> problem_;
  SweepOptions<double> options_;
  test::OwnedSweeps<double> owned_;
};

/// Non-negative, within the sums and the cones: what a sweep may start from.
void make_admissible(const Problem<double>& problem, Forces& z) {
  z = z.cwiseMax(0);
  for (const SumGroup<double>& sum : problem.factored->sums) {
    double total = 0;
    for (Index k = sum.first; k < sum.first + sum.count; ++k)
      total += problem.factored->coupling[k] * z[problem.factored->coupled_variable[k]];
    for (Index k = sum.first; total > 0 && k < sum.first + sum.count; ++k)
      z[problem.factored->coupled_variable[k]] *= sum.target / total;
  }
}

/// Returns the sweeps used, most_sweeps if they did not suffice.
using Method = std::function<Index(Assembly<double>&, const AssemblySize&)>;

Index plain(Assembly<double>& assembly, const AssemblySize& size) {
  PlainSweep sweep(assembly, size);
  Forces z = sweep.start(), next;
  Index k = 0;
  while (k < most_sweeps && sweep.step(z, next)) {
    z = next;
    ++k;
  }
  return k;
}

/// Non-smooth nonlinear conjugate gradients over the sweeps. [Silcowitz, Niebe, Erleben 2010]
Index conjugate(Assembly<double>& assembly, const AssemblySize& size) {
  PlainSweep sweep(assembly, size);
  const Problem<double> problem = assembly.problem();
  Forces z = sweep.start(), next, direction = Forces::Zero(z.size());
  double before = 0;
  Index k = 0;
  for (; k < most_sweeps && sweep.step(z, next); ++k) {
    const Forces move = next - z;
    const double now = move.squaredNorm(), beta = before > 0 ? now / before : 2;
    if (beta > 1) {
      direction = move; // restart
    } else {
      next += beta * direction;
      direction = beta * direction + move;
      make_admissible(problem, next);
    }
    before = now;
    z = next;
  }
  return k;
}

/// Anderson's extrapolation over the last few sweeps, undone where a move grows.
Index anderson(Assembly<double>& assembly, const AssemblySize& size) {
  constexpr std::size_t memory = 5;
  PlainSweep sweep(assembly, size);
  const Problem<double> problem = assembly.problem();
  Forces z = sweep.start(), next, last_z, last_move;
  std::vector<Forces> dz, dmove;
  Index k = 0;
  for (; k < most_sweeps && sweep.step(z, next); ++k) {
    const Forces move = next - z;
    if (last_move.size() > 0 && move.norm() > 2 * last_move.norm()) {
      dz.clear();
      dmove.clear();
    } else if (last_move.size() > 0) {
      dz.push_back(z - last_z);
      dmove.push_back(move - last_move);
      if (dz.size() > memory) {
        dz.erase(dz.begin());
        dmove.erase(dmove.begin());
      }
    }
    last_z = z;
    last_move = move;
    if (!dz.empty()) {
      const auto count = static_cast<Index>(dz.size());
      Eigen::MatrixXd X(z.size(), count), F(z.size(), count);
      for (Index j = 0; j < count; ++j) {
        X.col(j) = dz[static_cast<std::size_t>(j)];
        F.col(j) = dmove[static_cast<std::size_t>(j)];
      }
      const Eigen::VectorXd gamma = F.colPivHouseholderQr().solve(move);
      next -= (X + F) * gamma;
      make_admissible(problem, next);
    }
    z = next;
  }
  return k;
}

Index newton(Assembly<double>& assembly, const AssemblySize& size) {
  test::OwnedSweeps<double> owned(size);
  SweepOptions<double> options;
  options.tolerance = wanted;
  options.max_sweeps = most_sweeps;
  if (owned.sweeps.init(assembly.problem(), options) == Status::running) (void)owned.sweeps.solve();
  return owned.sweeps.status() == Status::solved ? owned.sweeps.sweeps() : most_sweeps;
}

void compare(const char* name, const Method& method, unsigned grasps) {
  std::vector<Index> sweeps;
  const double begin = bench::cpu_ms();
  for (unsigned seed = 0; seed < grasps; ++seed) {
    test::OwnedScene<double> owned = test::random_grasp<double>(seed);
    owned.base.pressure = Pressure::rigid;
    const Scene<double> scene = owned.view();
    test::OwnedWorkspace<double> memory(size_of(scene));
    Assembly<double> assembly(memory.work.assembly);
    assembly.assemble(scene);
    sweeps.push_back(method(assembly, size_of(scene)));
  }
  const double seconds = 1e-3 * (bench::cpu_ms() - begin);
  const auto solved =
      std::count_if(sweeps.begin(), sweeps.end(), [](Index k) { return k < most_sweeps; });
  std::sort(sweeps.begin(), sweeps.end());
  std::printf("%-24s %4td of %4u   median %4td sweeps, 90 %% within %4td   %.1f s\n", name,
              static_cast<Index>(solved), grasps, sweeps[grasps / 2], sweeps[grasps * 9 / 10],
              seconds);
}

/// Two discs of many points and an edge: what a sweep and what a pass of Newton cost.
void cost_of_a_sweep(Index points) {
  test::OwnedScene<double> owned = test::random_grasp<double>(3);
  owned.bodies.clear();
  owned.points.clear();
  owned.actuators.clear();
  owned.drives.clear();
  owned.base.facets = 8;
  owned.base.pressure = Pressure::rigid;
  for (const double side : {1.0, -1.0}) {
    std::vector<Vector3<double>> disc(static_cast<std::size_t>(points / 2 - 1));
    sample_disc<double>({0, 0, 0.01 * side}, Vector3<double>::UnitX(), Vector3<double>::UnitY(),
                        0.01, {disc.data(), static_cast<Index>(disc.size())});
    owned.add_body(Role::finger, {0, 0, -side}, 0.5, disc);
    owned.drive_last_body(20);
  }
  owned.add_body(Role::pusher, {1, 0, 0}, 0.3, {{-0.05, -0.01, 0}, {-0.05, 0.02, 0}});
  owned.bodies.back().acceleration[0] = 0.1;
  const Scene<double> scene = owned.view();
  const AssemblySize size = size_of(scene);
  std::vector<unsigned char> bytes(static_cast<std::size_t>(sweep_bytes<double>(size)));
  const Workspace<double> work =
      make_sweep_workspace<double>({bytes.data(), static_cast<Index>(bytes.size())}, size);
  Assembly<double> assembly(work.assembly);
  assembly.assemble(scene);
  BlockGaussSeidel<double> sweeps(work.sweep_scalars, work.sweep_integers);
  SweepOptions<double> options;
  options.check_every = 1 << 20;
  options.tolerance = 0;
  for (const bool accelerate : {false, true}) {
    options.accelerate = accelerate;
    options.max_sweeps = 60;
    const Index repeats = std::max<Index>(1, 20000 / points);
    Index passes = 0;
    const double begin = bench::cpu_ms();
    for (Index k = 0; k < repeats; ++k) {
      (void)sweeps.init(assembly.problem(), options);
      (void)sweeps.solve();
      passes += sweeps.sweeps();
    }
    const double ns = 1e6 * (bench::cpu_ms() - begin);
    std::printf("%s%6.0f ns a point and %s", accelerate ? "   " : "",
                ns / static_cast<double>(points * passes),
                accelerate ? "pass with Newton\n" : "sweep");
  }
}

} // namespace

int main(int count, char** words) {
  const auto grasps = static_cast<unsigned>(count > 1 ? std::atoi(words[1]) : 1000);
  std::printf("Scaled residual 1e-6 within 5,000 sweeps, rigid, random grasps 0 to %u:\n", grasps);
  compare("plain blocks", plain, grasps);
  compare("conjugate gradients", conjugate, grasps);
  compare("Anderson, depth 5", anderson, grasps);
  compare("Newton on what is shared", newton, grasps);
  std::printf("\nCost of a sweep, 8 facets:\n");
  for (const Index points : {10, 100, 1000, 10000}) {
    std::printf("%6td points ", points);
    cost_of_a_sweep(points);
  }
}
