// lcpush and the other libraries' solvers on the same problems, in one process:
//
//     peers [--sizes K:G,K:G,...] [--seeds N] [--only SOLVER] [--law rigid|pad]
//           [--no-peers] [--peer-seconds S] [--peer FILE.so]
//
// Two round fingers of K points, a line pusher, G facets (n unknowns, seeded variations), under
// `rigid` and in the first round of `pad`. The other libraries and lcpush's dense basis get the
// same n x n problem: the free unknowns are pivoted out (lcp/pivots/reduce.hpp) and rows and
// columns scaled. The structured basis gets the factored problem that it stands for. Every answer
// is brought back to that one and judged by lcp/residual.hpp. Times are processor times; set-up and
// final check included. Other libraries are plug-ins (peers/peer.h). `warm` starts from the basis
// of the same push 1 % slower, `warm, held` only looks at it.
#include <dlfcn.h>
#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>

#include "bench/peers/peer.h"
#include "bench/stopwatch.hpp"
#include "bench/wide_grasp.hpp"
#include "lcpush/desktop/owned.hpp"
#include "lcpush/lcp/pivots/held_basis.hpp"
#include "lcpush/lcp/pivots/reduce.hpp"
#include "lcpush/lcpush.hpp"

namespace {

using namespace lcpush;
using Flags = std::vector<unsigned char>;

constexpr double right = 1e-6; // the residual of an answer that counts as right

std::map<std::string, std::string> arguments = {{"--sizes", "1:4,2:8,6:8,20:8,20:16,50:8"},
                                                {"--seeds", "8"},
                                                {"--only", ""},
                                                {"--law", ""},
                                                {"--peer-seconds", "45"},
                                                {"--peer", ""},
                                                {"--no-peers", "no"}};

/// One problem in all its forms, with the memory to solve it.
struct Instance {
  test::OwnedScene<double> owned;
  Scene<double> scene;
  test::OwnedWorkspace<double> memory;
  Assembly<double> assembly;
  StructuredLemke<double> structured;
  std::vector<double> z; ///< the last answer, of all unknowns
  std::vector<double> matrix;
  std::unique_ptr<desktop::Owned<Reduction<double>>> reduction;

  explicit Instance(const test::OwnedScene<double>& given)
      : owned(given), scene(owned.view()), memory(size_of(scene), scene.actuators.size),
        assembly(memory.work.assembly),
        structured(memory.work.lemke_scalars, memory.work.lemke_integers) {
    assembly.assemble(scene);
    push_by(1);
    const Index n = problem().size;
    z.resize(static_cast<std::size_t>(n));
    matrix.resize(static_cast<std::size_t>(n * n));
    fill_matrix(problem(), MatrixMap<double>(matrix.data(), n, n));
    Flags is_free(z.size(), 0);
    for (Index i = problem().free_begin; i < n; ++i) is_free[static_cast<std::size_t>(i)] = 1;
    reduction = std::make_unique<desktop::Owned<Reduction<double>>>(reduction_scalars(n),
                                                                    reduction_integers(n));
    const Status status =
        reduction->init(n, matrix.data(), problem().q, is_free.data(), SingularBlock::exchange);
    if (status != Status::solved || reduced().free_begin < reduced().size)
      throw std::runtime_error("a problem whose free unknowns do not go");
  }
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;

  /// The push scaled by sigma, under `pad` with the first round's compliance around its preload.
  void push_by(double sigma) {
    assembly.push_by(sigma);
    if (scene.pressure != Pressure::pad) return;
    pad_preload(assembly, memory.work.pressure);
    set_compliance(assembly, memory.work.pressure, PressureOptions<double>{}.first_compliance);
  }
  Problem<double> problem() const { return assembly.problem(); }
  const Problem<double>& reduced() const { return reduction->problem(); }
  bool take(bool solved, const double* from) {
    if (solved) z.assign(from, from + problem().size);
    return solved;
  }
  bool take_reduced(bool solved, const double* from) {
    if (solved) reduction->recover(from, z.data());
    return solved;
  }
  bool is_right() const {
    const std::vector<double> unit(z.size(), 1.0);
    std::vector<double> w(z.size()), scratch(2 * z.size());
    const auto is_free = [&](Index i) { return i >= problem().free_begin; };
    return natural_residual(problem(), problem().q, z.data(), unit.data(), is_free, w.data(),
                            scratch.data())
               .residual <= right;
  }
  /// The basis of the same push 1 % slower.
  Flags neighbours_basis() {
    push_by(0.99);
    (void)structured.init(problem());
    Flags active(z.size(), 0);
    if (structured.solve() == Status::solved)
      for (std::size_t i = 0; i < active.size(); ++i)
        active[i] = structured.is_basic(static_cast<Index>(i)) ? 1 : 0;
    push_by(1);
    return active;
  }
};

/// Solves an instance as often as it is called; does it say that it has?
using Run = std::function<bool()>;

Run dense(Instance& in) {
  const Index n = in.reduced().size;
  auto lemke = std::make_shared<desktop::Owned<Lemke<double>>>(lemke_scalars(n), lemke_integers(n));
  return [&in, lemke] {
    (void)lemke->init(in.reduced());
    return in.take_reduced(lemke->solve() == Status::solved, lemke->z());
  };
}

Run structured(Instance& in) {
  return [&in] {
    (void)in.structured.init(in.problem());
    return in.take(in.structured.solve() == Status::solved, in.structured.z());
  };
}

Run warm(Instance& in) {
  return [&in, active = in.neighbours_basis()] {
    LemkeOptions<double> options;
    options.covers = 1;
    (void)in.structured.init(in.problem(), options, active.data());
    return in.take(in.structured.solve() == Status::solved, in.structured.z());
  };
}

Run held(Instance& in) {
  const Index n = in.problem().size, cones = in.problem().factored->cones.size;
  auto basis = std::make_shared<desktop::Owned<HeldBasis<double>>>(
      held_basis_scalars(n, cones, shared_actuators(*in.problem().factored)),
      held_basis_integers(n, cones));
  return [&in, basis, active = in.neighbours_basis()] {
    const Status status = basis->look(in.problem(), active.data());
    return in.take(status == Status::solved, basis->z());
  };
}

Run predicted(Instance& in) {
  return [&in] {
    using Pivots = StructuredLemke<double>;
    PredictedRounds<double, const Unwatched, Pivots> rounds{in.assembly,
                                                            LemkeRounds{in.structured}};
    PressureRun run;
    const PressureMemory<double>& pressure = in.memory.work.pressure;
    rounds.begin(in.problem(), false, pressure);
    Status status = Status::running;
    while (status == Status::running) status = rounds.step(pressure, run);
    return in.take(status == Status::solved, pressure.z.data);
  };
}

/// Nothing is printed as long as it lives: some libraries report their troubles line by line.
class Silence {
public:
  Silence() : out_(dup(1)), error_(dup(2)), nothing_(open("/dev/null", O_WRONLY)) {
    redirect(nothing_, nothing_);
  }
  ~Silence() {
    redirect(out_, error_);
    for (const int file : {out_, error_, nothing_}) close(file);
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

private:
  int out_, error_, nothing_;
  static void redirect(int out, int error) {
    std::fflush(nullptr);
    (void)dup2(out, 1);
    (void)dup2(error, 2);
  }
};

/// Another library, loaded as long as the process lives.
struct Peer {
  std::string name;
  int (*solve)(int, int, const double*, const double*, double*) = nullptr;
  double spent = 0; ///< ms, on this size

  explicit Peer(const std::string& file) : name(std::filesystem::path(file).stem().string()) {
    void* const library = dlopen(std::filesystem::absolute(file).c_str(), RTLD_NOW | RTLD_LOCAL);
    void* const symbol = library != nullptr ? dlsym(library, "lcpush_peer") : nullptr;
    if (symbol == nullptr) throw std::runtime_error(dlerror());
    solve = reinterpret_cast<decltype(solve)>(symbol);
    if (name.rfind("peer_", 0) == 0) name.erase(0, 5);
  }
  Run on(Instance& in) const {
    const Problem<double>& lcp = in.reduced();
    const int n = static_cast<int>(lcp.size);
    (void)solve(lcpush_peer_load, n, lcp.matrix, lcp.q, nullptr);
    return [this, &in, n, answer = std::vector<double>(static_cast<std::size_t>(n))]() mutable {
      const bool solved =
          solve(lcpush_peer_solve, n, in.reduced().matrix, in.reduced().q, answer.data()) != 0;
      return in.take_reduced(solved, answer.data());
    };
  }
};

/// What one solver did on the instances of a size: ms where it was right, else NaN.
struct Column {
  std::vector<double> ms;
  int wrong = 0;

  void time(Instance& in, const Run& run, double budget) {
    std::vector<double> times;
    bool solved = false;
    bench::sample([&] { solved = run(); }, budget, times);
    const bool is_right = solved && in.is_right();
    wrong += solved && !is_right ? 1 : 0;
    ms.push_back(is_right ? bench::median(times) : std::nan(""));
  }
  /// Of each other instance's time to ours, where both are right.
  std::vector<double> over(const Column& ours) const {
    std::vector<double> ratios;
    for (std::size_t k = 0; k < ms.size() && k < ours.ms.size(); ++k)
      ratios.push_back(ms[k] / ours.ms[k]);
    return numbers(ratios);
  }
  static std::vector<double> numbers(std::vector<double> all) {
    all.erase(std::remove_if(all.begin(), all.end(), [](double x) { return std::isnan(x); }),
              all.end());
    return all;
  }
};

void run_size(const std::string& law, Index points, Index facets, std::vector<Peer>& peers) {
  const std::pair<const char*, Run (*)(Instance&)> ours[] = {{"dense", dense},
                                                             {"structured", structured},
                                                             {"warm", warm},
                                                             {"warm, held", held},
                                                             {"predicted", predicted}};
  std::map<std::string, Column> columns;
  std::vector<std::string> order;
  for (const auto& [name, make] : ours)
    if (arguments["--only"].empty() || arguments["--only"] == name) order.push_back(name);
  for (Peer& peer : peers) {
    order.push_back(peer.name);
    peer.spent = 0;
  }
  const double limit = 1e3 * std::stod(arguments["--peer-seconds"]);
  for (int seed = 0; seed < std::stoi(arguments["--seeds"]); ++seed) {
    Instance in(bench::disc_grasp(points, facets, law == "pad" ? Pressure::pad : Pressure::rigid,
                                  static_cast<std::uint64_t>(seed)));
    for (const auto& [name, make] : ours)
      if (arguments["--only"].empty() || arguments["--only"] == name)
        columns[name].time(in, make(in), 30);
    for (Peer& peer : peers) {
      if (peer.spent > limit) continue;
      const double begin = bench::cpu_ms();
      const Silence silence;
      columns[peer.name].time(in, peer.on(in), 5);
      peer.spent += bench::cpu_ms() - begin;
    }
  }
  for (const std::string& name : order) {
    const Column& column = columns[name];
    const std::vector<double> ms = Column::numbers(column.ms);
    std::printf("%-6s %6td  %-14s %3zu/%-3zu %5d %10.4f", law.c_str(),
                (2 * points + 2) * (facets + 2), name.c_str(), ms.size(), column.ms.size(),
                column.wrong, bench::median(ms));
    for (const Peer& peer : peers)
      std::printf(" %9.1fx", bench::median(columns[peer.name].over(column)));
    std::printf("\n");
  }
  std::fflush(stdout);
}

void run_all() {
  std::vector<Peer> peers;
  std::stringstream files(arguments["--no-peers"] == "no" ? LCPUSH_PEERS ":" + arguments["--peer"]
                                                          : arguments["--peer"]);
  for (std::string file; std::getline(files, file, ':');)
    if (!file.empty()) peers.emplace_back(file);
  std::printf("%-6s %6s  %-14s %7s %5s %10s", "law", "n", "solver", "right", "wrong", "median ms");
  for (const Peer& peer : peers) std::printf(" %10.10s", peer.name.c_str());
  std::printf("\n");
  for (const std::string law : {"rigid", "pad"}) {
    if (!arguments["--law"].empty() && arguments["--law"] != law) continue;
    std::stringstream sizes(arguments["--sizes"]);
    for (std::string size; std::getline(sizes, size, ',');)
      run_size(law, std::stoi(size), std::stoi(size.substr(size.find(':') + 1)), peers);
  }
}

} // namespace

int main(int count, char** words) {
  // One core for all: Siconos' linear algebra would start threads of its own.
  if (std::getenv("OPENBLAS_NUM_THREADS") == nullptr) {
    setenv("OPENBLAS_NUM_THREADS", "1", 1);
    execv("/proc/self/exe", words);
  }
  try {
    for (int i = 1; i < count; ++i) {
      const auto option = arguments.find(words[i]);
      const bool has_value = option != arguments.end() && option->first != "--no-peers";
      if (option == arguments.end() || (has_value && i + 1 == count))
        throw std::runtime_error("what it takes stands at the top of tests/bench/peers.cpp");
      option->second = has_value ? words[++i] : "yes";
    }
    run_all();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "peers: %s\n", error.what());
    return 2;
  }
}
