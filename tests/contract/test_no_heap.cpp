// The core allocates nothing: every call to the heap in this program is counted.
#include <doctest/doctest.h>

#include <cstddef>
#include <cstdlib>
#include <limits>
#include <new>

#include "lcpush/lcp/pivots/reduce.hpp"
#include "lcpush/mechanics/paper/full_form.hpp"
#include "lcpush/mechanics/solve/predicted_modes.hpp"
#include "support/dense_lcp.hpp"
#include "support/scenes.hpp"
#include "support/seeds.hpp"
#include "support/solved_push.hpp"
#include "support/sweep_runs.hpp"

namespace {
volatile long heap_calls = 0;
} // namespace

// operator new ends in malloc, and so does Eigen. glibc lets a program bring its own; the address
// sanitizer has hooks; elsewhere operator new alone is counted.
#ifdef LCPUSH_TEST_SANITIZED
extern "C" int __sanitizer_install_malloc_and_free_hooks(void (*on_malloc)(const volatile void*,
                                                                           std::size_t),
                                                         void (*on_free)(const volatile void*));
namespace {
void count_allocation(const volatile void*, std::size_t) { heap_calls = heap_calls + 1; }
void ignore_release(const volatile void*) {}
[[maybe_unused]] const int hooks =
    __sanitizer_install_malloc_and_free_hooks(count_allocation, ignore_release);
} // namespace
#elif defined(__GLIBC__)
extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
void* malloc(std::size_t size) {
  heap_calls = heap_calls + 1;
  return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) {
  heap_calls = heap_calls + 1;
  return __libc_calloc(count, size);
}
void* realloc(void* old, std::size_t size) {
  heap_calls = heap_calls + 1;
  return __libc_realloc(old, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  heap_calls = heap_calls + 1;
  return __libc_memalign(alignment, size);
}
int posix_memalign(void** result, std::size_t alignment, std::size_t size) {
  heap_calls = heap_calls + 1;
  *result = __libc_memalign(alignment, size);
  return *result == nullptr ? 12 : 0; // ENOMEM
}
}
#else
void* operator new(std::size_t size) {
  heap_calls = heap_calls + 1;
  void* const memory = std::malloc(size);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
#endif

using namespace lcpush;
using namespace lcpush::test;

namespace {

template <class Action> long heap_calls_of(Action action) {
  const long before = heap_calls;
  action();
  return heap_calls - before;
}

template <class S> DenseLcp<S> positive_definite(Index n) {
  Random random(3);
  const MatrixX<double> A = random_matrix(random, n, n);
  const MatrixX<double> M = A * A.transpose() + 0.1 * MatrixX<double>::Identity(n, n);
  return {M.cast<S>(), random_vector(random, n).cast<S>()};
}

} // namespace

TEST_CASE("the counter sees what allocates: new, and a matrix of run-time size") {
  int* volatile number = nullptr;
  CHECK(heap_calls_of([&] { number = new int(3); }) > 0);
  delete number;
#if defined(__GLIBC__) || defined(LCPUSH_TEST_SANITIZED)
  volatile double sum = 0;
  CHECK(heap_calls_of([&] { sum = MatrixX<double>::Random(20, 20).eval().sum(); }) > 0);
#endif
}

TEST_CASE("a dense solve allocates nothing, cold or warm") {
  for (const Index n : {1, 5, 40}) {
    const DenseLcp<double> lcp = positive_definite<double>(n);
    LemkeRun<double> run(n);
    std::vector<unsigned char> active(static_cast<std::size_t>(n), 0);
    Status cold = Status::running, warm = Status::running;
    CHECK(heap_calls_of([&] {
            cold = run.lemke.init(lcp.view());
            cold = run.lemke.solve();
            for (Index i = 0; i < n; ++i)
              active[static_cast<std::size_t>(i)] = run.lemke.is_basic(i) ? 1 : 0;
            warm = run.lemke.init(lcp.view(), {}, active.data());
            warm = run.lemke.solve();
          }) == 0);
    CHECK(cold == Status::solved);
    CHECK(warm == Status::solved);
  }
}

TEST_CASE("block sweeps allocate nothing, with and without proximal Newton") {
  for (const bool accelerate : {false, true}) {
    OwnedScene<double> owned = random_grasp<double>(3);
    owned.base.pressure = Pressure::rigid;
    const SolvedPush<double> push(owned);
    const Problem<double> problem = push.assembly.problem();
    BlockRun<double> run(problem);
    SweepOptions<double> options;
    options.tolerance = 1e-3;
    options.accelerate = accelerate;
    Status status = Status::running;
    CHECK(heap_calls_of([&] { status = run.solve(problem, options); }) == 0);
    CHECK(status == Status::solved);
    CHECK(run.sweeps.sweeps() > 10); // Newton takes over after ten
  }
}

TEST_CASE("a reduction allocates nothing") {
  const Index n = 6;
  const DenseLcp<double> lcp = positive_definite<double>(n);
  std::vector<double> scalars(static_cast<std::size_t>(reduction_scalars(n)));
  std::vector<int> integers(static_cast<std::size_t>(reduction_integers(n)));
  const unsigned char is_free[] = {0, 1, 0, 1, 0, 0};
  Status status = Status::running;
  CHECK(heap_calls_of([&] {
          Reduction<double> reduction({scalars.data(), reduction_scalars(n)},
                                      {integers.data(), reduction_integers(n)});
          status = reduction.init(n, lcp.M.data(), lcp.q.data(), is_free, SingularBlock::exchange);
        }) == 0);
  CHECK(status == Status::solved);
}

TEST_CASE("a whole push allocates nothing: workspace, assembly, rounds, answer, check") {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    OwnedScene<double> owned = random_grasp<double>(seed);
    owned.base.pressure = seed % 2 == 0 ? Pressure::rigid : Pressure::pad;
    const Scene<double> scene = owned.view();
    std::vector<unsigned char> bytes(static_cast<std::size_t>(push_bytes<double>(size_of(scene))));
    Status status = Status::running;
    CHECK(heap_calls_of([&] {
            Workspace<double> work = make_workspace<double>(
                {bytes.data(), static_cast<Index>(bytes.size())}, size_of(scene));
            Assembly<double> assembly(work.assembly);
            assembly.assemble(scene);
            Lemke<double> lemke(work.lemke_scalars, work.lemke_integers);
            PressureRun run;
            status = solve_pressure(assembly, LemkeRounds{lemke}, work.pressure,
                                    PressureOptions<double>{}, run);
            read_answer(assembly, work.pressure.z.data, work.answer, 1.0);
            (void)check(scene, assembly.layout().scales, work.answer, 1.0);
          }) == 0);
    CHECK(status == Status::solved);
  }
}

TEST_CASE_TEMPLATE("pivots on the structured basis allocate nothing", S, float, double) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    OwnedScene<S> owned = random_grasp<S>(seed);
    owned.base.pressure = seed % 2 == 0 ? Pressure::rigid : Pressure::pad;
    SolvedPush<S, StructuredLemke<S>> push(owned);
    Status status = Status::running;
    CHECK(heap_calls_of([&] { status = push.solve(); }) == 0);
    if (sizeof(S) == sizeof(double)) CHECK(status == Status::solved);
  }
}

TEST_CASE("a start from predicted modes allocates nothing") {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    OwnedScene<double> owned = random_grasp<double>(seed);
    owned.base.pressure = seed % 2 == 0 ? Pressure::rigid : Pressure::pad;
    using Pivots = StructuredLemke<double>;
    SolvedPush<double, Pivots> push(owned);
    Status status = Status::running;
    CHECK(heap_calls_of([&] {
            const LemkeRounds<double, const Unwatched, Pivots> pivots{push.lemke};
            const PredictedRounds<double, const Unwatched, Pivots> rounds{push.assembly, pivots};
            status = solve_pressure(push.assembly, rounds, push.memory.work.pressure, push.options,
                                    push.run);
          }) == 0);
    CHECK(status == Status::solved);
  }
}

TEST_CASE("the instant of breaking allocates nothing") {
  for (const Pressure pressure : {Pressure::pad, Pressure::rigid}) {
    OwnedScene<double> owned = straight_slide();
    owned.base.pressure = pressure;
    SolvedPush<double> push(owned);
    Breaking<double> breaking;
    Status status = Status::running;
    CHECK(heap_calls_of([&] {
            status = find_breaking(push.assembly, LemkeRounds{push.lemke}, push.memory.work,
                                   push.scene.bodies[2], push.options, breaking, push.run);
          }) == 0);
    CHECK(status == Status::solved);
  }
}

TEST_CASE("a full form and the check of its patches allocate nothing") {
  SolvedPush<double> push(random_grasp<double>(2));
  const Index bodies = push.scene.bodies.size, points = push.scene.points.size;
  std::vector<PatchReferences<double>> patches(static_cast<std::size_t>(bodies));
  std::vector<Index> first(patches.size());
  std::vector<double> weights(static_cast<std::size_t>(most_references * points));
  FullForm<double> form({{patches.data(), bodies},
                         {first.data(), bodies},
                         {weights.data(), most_references * points}});
  REQUIRE(form.describe(push.assembly) == Status::solved);
  const Index n = form.size();
  MatrixX<double> M(n, n);
  VectorX<double> q(n);
  std::vector<unsigned char> eliminated(static_cast<std::size_t>(n));
  std::vector<double> memory(static_cast<std::size_t>(rigidity_scalars(points)));
  bool holds = true;
  CHECK(heap_calls_of([&] {
          (void)form.describe(push.assembly);
          form.fill(MatrixMap<double>(M.data(), n, n), q.data(), eliminated.data());
          for (Index b = 0; b < bodies; ++b) {
            const Span<double> alpha = form.weights(b);
            holds = holds && check_rigidity<double>(patch_points(push.scene, push.scene.bodies[b]),
                                                    form.patch(b), {alpha.data, alpha.size},
                                                    {memory.data(), rigidity_scalars(points)})
                                 .holds();
          }
        }) == 0);
  CHECK(holds);
}
