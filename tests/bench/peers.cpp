// lcpush and the other libraries' solvers on the same problems, in one process:
//
//     peers [--quick] [--sizes K:G,K:G,...] [--seeds N] [--no-peers] [--only SOLVER]
//           [--law rigid|pad] [--peer-seconds S] [--peer FILE.so]...
//
// Two round fingers of K points, a line pusher, G facets (n unknowns, seeded variations), and the
// paper's three primitives; each under `rigid` and in the first round of `pad`. The other libraries
// and lcpush's dense basis get the same n x n problem: the free unknowns are pivoted out
// (lcp/pivots/reduce.hpp) and rows and columns scaled. The structured basis and the sweeps get the
// factored problem that it stands for. Every answer is brought back to that one and judged by
// lcp/residual.hpp. Times are processor times; set-up and the final check included. Other libraries
// are plug-ins (peers/peer.h). `warm` starts from the answer with the pusher 1 % slower, theirs and
// ours, and `warm, held` looks at its basis alone; ratios compare cold with cold and warm with
// warm.
#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <iostream>
#include <map>
#include <sstream>
#include <string>

#include "bench/bandwidth.hpp"
#include "bench/peers/plugin.hpp"
#include "bench/stopwatch.hpp"
#include "bench/wide_grasp.hpp"
#include "lcpush/desktop/owned.hpp"
#include "lcpush/lcp/pivots/held_basis.hpp"
#include "lcpush/lcp/pivots/reduce.hpp"
#include "lcpush/lcpush.hpp"

namespace {

using namespace lcpush;
using bench::Peer;

constexpr double right = 1e-6; // the residual of an answer that counts as right

struct Arguments {
  bool quick = false, peers = true;
  std::string only;         // one of lcpush's own solvers; empty: all
  std::string law;          // empty: both
  double peer_seconds = 45; // of each library on each size
  unsigned seeds = 8;
  std::vector<std::string> plugins; // further peers
  std::vector<std::pair<Index, Index>> sizes = {{1, 4},   {2, 8},  {6, 8},  {20, 8},
                                                {20, 16}, {50, 8}, {50, 16}};
  std::vector<std::pair<Index, Index>> wide = {{100, 8}, {200, 8}, {500, 8}};
};

/// One problem in all its forms, with the memory to solve it.
class Instance {
public:
  Instance(test::OwnedScene<double> scene, bool dense)
      : owned_(std::move(scene)), size_(size_of(owned_.view())),
        memory_(size_, owned_.view().actuators.size), assembly_(memory_.work.assembly),
        structured_(memory_.work.lemke_scalars, memory_.work.lemke_integers) {
    scene_ = owned_.view();
    assembly_.assemble(scene_);
    push_by(1);
    const Index n = problem().size;
    full_z.resize(static_cast<std::size_t>(n));
    if (dense) reduce(n);
    dense_memory_.resize(static_cast<std::size_t>(dense ? lemke_scalars(n) : 0));
    dense_integers_.resize(static_cast<std::size_t>(dense ? lemke_integers(n) : 0));
    sweep_memory_.resize(static_cast<std::size_t>(sweep_bytes<double>(size_)));
    sweeps_ = make_sweep_workspace<double>(
        {sweep_memory_.data(), static_cast<Index>(sweep_memory_.size())}, size_);
  }
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;

  /// The push scaled by sigma, under `pad` with the first round's compliance around its preload.
  void push_by(double sigma) {
    assembly_.push_by(sigma);
    if (scene_.pressure != Pressure::pad) return;
    pad_preload(assembly_, memory_.work.pressure);
    set_compliance(assembly_, memory_.work.pressure, PressureOptions<double>{}.first_compliance);
  }

  Problem<double> problem() const { return assembly_.problem(); }
  Assembly<double>& assembly() { return assembly_; }
  const Scene<double>& scene() const { return scene_; }
  StructuredLemke<double>& structured() { return structured_; }
  const PressureMemory<double>& pressure() const { return memory_.work.pressure; }
  Lemke<double> dense() {
    return {{dense_memory_.data(), static_cast<Index>(dense_memory_.size())},
            {dense_integers_.data(), static_cast<Index>(dense_integers_.size())}};
  }
  BlockGaussSeidel<double> sweeps() const {
    return {sweeps_.sweep_scalars, sweeps_.sweep_integers};
  }
  const Problem<double>& reduced() const { return reduction_->problem(); }
  /// The same with the pusher 1 % slower.
  const Problem<double>& neighbour() const { return neighbour_; }
  bool has_dense() const { return reduction_ != nullptr; }
  /// Complementary pairs: the size of the problem that the others get.
  Index pairs() const { return problem().free_begin; }

  std::vector<double> full_z;
  void take(const double* z) { full_z.assign(z, z + problem().size); }
  void take_reduced(const double* z) { reduction_->recover(z, full_z.data()); }
  double residual() const {
    const Index n = problem().size;
    const std::vector<double> unit(full_z.size(), 1.0);
    std::vector<double> w(full_z.size()), scratch(2 * full_z.size());
    const double worst =
        natural_residual(
            problem(), problem().q, full_z.data(), unit.data(),
            [&](Index i) { return i >= problem().free_begin && i < n; }, w.data(), scratch.data())
            .residual;
    return worst == worst ? worst : 1.0;
  }

private:
  test::OwnedScene<double> owned_;
  Scene<double> scene_;
  AssemblySize size_;
  test::OwnedWorkspace<double> memory_;
  Assembly<double> assembly_;
  StructuredLemke<double> structured_;
  std::vector<double> dense_memory_, matrix_, reduction_memory_;
  std::vector<int> dense_integers_, reduction_integers_;
  std::vector<unsigned char> is_free_, sweep_memory_;
  std::unique_ptr<Reduction<double>> reduction_;
  Problem<double> neighbour_;
  std::vector<double> neighbour_q_;
  Workspace<double> sweeps_;

  void reduce(Index n) {
    const auto count = static_cast<std::size_t>(n);
    matrix_.resize(count * count);
    fill_matrix(problem(), MatrixMap<double>(matrix_.data(), n, n));
    is_free_.assign(count, 0);
    for (Index i = problem().free_begin; i < n; ++i) is_free_[static_cast<std::size_t>(i)] = 1;
    reduction_memory_.resize(static_cast<std::size_t>(reduction_scalars(n)));
    reduction_integers_.resize(static_cast<std::size_t>(reduction_integers(n)));
    reduction_ = std::make_unique<Reduction<double>>(
        Span<double>{reduction_memory_.data(), reduction_scalars(n)},
        Span<int>{reduction_integers_.data(), reduction_integers(n)});
    const auto reduce_push = [&](double sigma) {
      push_by(sigma);
      return reduction_->init(n, matrix_.data(), problem().q, is_free_.data(),
                              SingularBlock::exchange);
    };
    (void)reduce_push(0.99);
    neighbour_q_.assign(reduced().q, reduced().q + reduced().size);
    const Status status = reduce_push(1);
    neighbour_ = reduced();
    neighbour_.q = neighbour_q_.data();
    if (status != Status::solved || reduced().free_begin < reduced().size) reduction_.reset();
    matrix_ = {};
  }
};

struct Outcome {
  bool solved = false;
  Index pivots = 0;
};

/// A way to solve an instance; what it holds lives as long as the instance.
using Run = std::function<Outcome()>;

Run cold_dense(Instance& instance) {
  return [&instance] {
    Lemke<double> lemke = instance.dense();
    (void)lemke.init(instance.reduced());
    const Status status = lemke.solve();
    if (status == Status::solved) instance.take_reduced(lemke.z());
    return Outcome{status == Status::solved, lemke.pivots()};
  };
}

Outcome finish(Instance& instance, Status status) {
  if (status == Status::solved) instance.take(instance.structured().z());
  return {status == Status::solved, instance.structured().pivots()};
}

Run cold_structured(Instance& instance) {
  return [&instance] {
    (void)instance.structured().init(instance.problem());
    return finish(instance, instance.structured().solve());
  };
}

/// Of the same scene with its pusher 1 % slower.
std::vector<unsigned char> neighbours_basis(Instance& instance) {
  instance.push_by(0.99);
  StructuredLemke<double>& lemke = instance.structured();
  (void)lemke.init(instance.problem());
  std::vector<unsigned char> active(instance.full_z.size(), 0);
  if (lemke.solve() == Status::solved)
    for (std::size_t i = 0; i < active.size(); ++i)
      active[i] = lemke.is_basic(static_cast<Index>(i)) ? 1 : 0;
  instance.push_by(1);
  return active;
}

/// From that basis by pivots, with all that they do for an answer.
Run warm(Instance& instance) {
  StructuredLemke<double>& lemke = instance.structured();
  return [&instance, &lemke, active = neighbours_basis(instance)] {
    LemkeOptions<double> options;
    options.covers = 1;
    Status status = lemke.init(instance.problem(), options, active.data());
    if (status == Status::running) status = lemke.solve();
    if (status != Status::solved) {
      (void)lemke.init(instance.problem());
      status = lemke.solve();
    }
    return finish(instance, status);
  };
}

/// That basis looked at alone, as Lemke's method with a warm start and no referee would.
Run held(Instance& instance) {
  const Problem<double> problem = instance.problem();
  const Index n = problem.size, cones = problem.factored->cones.size;
  const Index shared = shared_actuators(*problem.factored);
  auto look = std::make_shared<desktop::Owned<HeldBasis<double>>>(
      held_basis_scalars(n, cones, shared), held_basis_integers(n, cones));
  return [&instance, look, active = neighbours_basis(instance)] {
    const Status status = look->look(instance.problem(), active.data());
    if (status == Status::solved) instance.take(look->z());
    return Outcome{status == Status::solved, 0};
  };
}

/// Solves by rounds.hpp.
template <class Rounds> Outcome run_rounds(Instance& instance, Rounds rounds) {
  PressureRun run;
  rounds.begin(instance.problem(), false, instance.pressure());
  Status status = Status::running;
  while (status == Status::running) status = rounds.step(instance.pressure(), run);
  if (status == Status::solved) instance.take(instance.pressure().z.data);
  return {status == Status::solved, run.pivots};
}

Run hybrid(Instance& instance) {
  return [&instance] {
    BlockGaussSeidel<double> sweeps = instance.sweeps();
    SweepRounds<double> first{sweeps};
    first.options.tolerance = 1e-6;
    first.options.max_sweeps = 200;
    using Pivots = LemkeRounds<double, const Unwatched, StructuredLemke<double>>;
    return run_rounds(instance, HybridRounds<double, const Unwatched, StructuredLemke<double>>{
                                    first, Pivots{instance.structured()}});
  };
}

Run gauss_seidel(Instance& instance) {
  return [&instance] {
    BlockGaussSeidel<double> sweeps = instance.sweeps();
    return run_rounds(instance, SweepRounds<double>{sweeps});
  };
}

Run predicted(Instance& instance) {
  return [&instance] {
    using Pivots = StructuredLemke<double>;
    using Rounds = LemkeRounds<double, const Unwatched, Pivots>;
    return run_rounds(instance, PredictedRounds<double, const Unwatched, Pivots>{
                                    instance.assembly(), Rounds{instance.structured()}});
  };
}

/// What one solver did on all instances of a size and law.
struct Tally {
  int tried = 0, right = 0, wrong = 0;
  std::vector<double> times, per_instance, pivots, us_a_pivot;
  std::vector<double> tried_ms;                      // of all instances, right or not
  std::map<std::string, std::vector<double>> ratios; // to each peer
};

class Table {
public:
  /// The time of one solver on one instance, and whether its answer is right.
  struct Row {
    std::string name;
    double ms;
    bool right;
    std::string peer; // empty: ours
    bool is_warm;
  };

  void begin_size(std::string label, Index n) {
    label_ = std::move(label);
    n_ = n;
    tallies_.clear();
    order_.clear();
  }
  Row add(const std::string& name, Instance& instance, const Run& run, double budget,
          const std::string& peer = {}) {
    const bool is_warm = name.rfind("warm") != std::string::npos;
    if (tallies_.count(name) == 0) order_.push_back(name);
    Tally& tally = tallies_[name];
    std::fill(instance.full_z.begin(), instance.full_z.end(), 0.0);
    std::vector<double> times;
    Outcome outcome;
    bench::sample([&] { outcome = run(); }, budget, times);
    const bool is_right = outcome.solved && instance.residual() <= right;
    ++tally.tried;
    tally.right += is_right ? 1 : 0;
    tally.wrong += outcome.solved && !is_right ? 1 : 0;
    const double ms = bench::median(times);
    tally.tried_ms.push_back(ms);
    if (!is_right) return {name, ms, false, peer, is_warm};
    tally.times.insert(tally.times.end(), times.begin(), times.end());
    tally.per_instance.push_back(ms);
    tally.pivots.push_back(static_cast<double>(outcome.pivots));
    if (outcome.pivots > 0)
      tally.us_a_pivot.push_back(1e3 * ms / static_cast<double>(outcome.pivots));
    return {name, ms, true, peer, is_warm};
  }
  void compare(const std::vector<Row>& rows) {
    for (const Row& ours : rows)
      for (const Row& theirs : rows)
        if (ours.right && theirs.right && !theirs.peer.empty() && ours.is_warm == theirs.is_warm)
          tallies_[ours.name].ratios[theirs.peer].push_back(theirs.ms / ours.ms);
  }
  void print(const std::vector<std::string>& peers) {
    for (const std::string& name : order_) {
      const Tally& tally = tallies_[name];
      std::printf("%-15s %6td  %-16s %3d/%-3d %5d %7.0f %10.4f %10.4f", label_.c_str(), n_,
                  name.c_str(), tally.right, tally.tried, tally.wrong, bench::median(tally.pivots),
                  bench::median(tally.times), bench::quantile(tally.times, 0.99));
      for (const std::string& peer : peers) {
        const auto found = tally.ratios.find(peer);
        if (found == tally.ratios.end() || name.rfind(peer, 0) == 0)
          std::printf(" %9s", "");
        else
          std::printf(" %8.1fx", bench::median(found->second));
      }
      std::printf("\n");
    }
    std::fflush(stdout);
  }
  const std::map<std::string, Tally>& tallies() const { return tallies_; }
  static void header(const std::vector<std::string>& peers) {
    std::printf("%-15s %6s  %-16s %7s %5s %7s %10s %10s", "scenes", "n", "solver", "right", "wrong",
                "pivots", "median ms", "99 % ms");
    for (const std::string& peer : peers) std::printf(" %9.9s", peer.c_str());
    std::printf("\n");
  }

private:
  std::string label_;
  Index n_ = 0;
  std::map<std::string, Tally> tallies_;
  std::vector<std::string> order_;
};

/// Nothing is printed as long as it lives: some libraries report their troubles line by line.
class Silence {
public:
  Silence() : out_(dup(1)), error_(dup(2)), nothing_(open("/dev/null", O_WRONLY)) {
    turn(nothing_, nothing_);
  }
  ~Silence() {
    turn(out_, error_);
    for (const int file : {out_, error_, nothing_}) close(file);
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

private:
  int out_, error_, nothing_;
  static void turn(int out, int error) {
    std::fflush(nullptr);
    std::cout.flush();
    (void)dup2(out, 1);
    (void)dup2(error, 2);
  }
};

/// Another library on one instance. It gets `limit` ms a size, and is left out where the last size
/// says that one solve takes longer.
class PeerRun {
public:
  PeerRun(std::unique_ptr<Peer> peer, double limit) : peer_(std::move(peer)), limit_(limit) {}

  std::string name() const { return peer_->name(); }
  void begin_size(Index n) {
    spent_ = 0;
    const double ratio = last_n_ > 0 ? static_cast<double>(n) / static_cast<double>(last_n_) : 1;
    expected_ = last_ms_ * std::pow(ratio, 3.0);
  }
  void end_size(Index n, const Tally& tally) {
    last_n_ = n;
    last_ms_ = bench::median(tally.tried_ms);
  }
  bool has_time() const { return spent_ < limit_ && expected_ < limit_; }
  void run(Instance& instance, Table& table, std::vector<Table::Row>& rows) {
    const double begin = bench::cpu_ms();
    rows.push_back(time(instance, table, lcpush_peer_cold, name()));
    if (prepare_warm(instance))
      rows.push_back(time(instance, table, lcpush_peer_warm, name() + " warm"));
    spent_ += bench::cpu_ms() - begin;
  }

private:
  std::unique_ptr<Peer> peer_;
  double limit_, spent_ = 0, expected_ = 0, last_ms_ = 0;
  Index last_n_ = 0;
  std::vector<double> start_, z_; // of the neighbour; of the last solve

  Table::Row time(Instance& instance, Table& table, lcpush_peer_task task,
                  const std::string& label) {
    load(instance.reduced());
    z_.resize(static_cast<std::size_t>(instance.reduced().size));
    const Silence silence;
    const Run run = [&] {
      if (task == lcpush_peer_warm) z_ = start_;
      const bool solved = peer_->solve(task, z_.data()) == lcpush_peer_solved;
      instance.take_reduced(z_.data());
      return Outcome{solved, 0};
    };
    return table.add(label, instance, run, 5, name());
  }
  /// The neighbour's answer; false where this library knows no warm start.
  bool prepare_warm(Instance& instance) {
    const Silence silence;
    load(instance.neighbour());
    start_.resize(static_cast<std::size_t>(instance.neighbour().size));
    if (peer_->solve(lcpush_peer_cold, start_.data()) != lcpush_peer_solved) return false;
    std::vector<double> answer = start_;
    return peer_->solve(lcpush_peer_warm, answer.data()) != lcpush_peer_cannot;
  }
  void load(const Problem<double>& lcp) {
    peer_->load(static_cast<int>(lcp.size), lcp.matrix, lcp.q);
  }
};

std::vector<PeerRun> find_peers(const Arguments& arguments) {
  std::vector<PeerRun> peers;
  std::vector<std::string> files;
  std::stringstream built(LCPUSH_PEERS);
  for (std::string file; arguments.peers && std::getline(built, file, ':');) files.push_back(file);
  files.insert(files.end(), arguments.plugins.begin(), arguments.plugins.end());
  for (const std::string& file : files)
    peers.emplace_back(std::make_unique<Peer>(file), 1e3 * arguments.peer_seconds);
  return peers;
}

/// How the times of every solver grow over the sizes.
class Growth {
public:
  void add(const std::string& law, Index n, const std::map<std::string, Tally>& tallies) {
    for (const auto& [name, tally] : tallies) {
      if (tally.per_instance.empty()) continue;
      Curve& curve = curves_[law + " " + name];
      curve.n.push_back(static_cast<double>(n));
      curve.ms.push_back(bench::median(tally.per_instance));
      if (tally.us_a_pivot.empty() || n < 200) continue;
      curve.large_n.push_back(static_cast<double>(n));
      curve.us.push_back(bench::median(tally.us_a_pivot));
    }
  }
  void print() const {
    std::printf("\ntime grows with n to the power (a pivot's time from n = 200 on):\n");
    for (const auto& [name, curve] : curves_) {
      std::printf("  %-24s %5.2f", name.c_str(), bench::growth(curve.n, curve.ms));
      if (curve.us.size() > 1) std::printf("  (%.2f)", bench::growth(curve.large_n, curve.us));
      std::printf("   n %.0f to %.0f\n", curve.n.front(), curve.n.back());
    }
  }

private:
  struct Curve {
    std::vector<double> n, ms, large_n, us;
  };
  std::map<std::string, Curve> curves_;
};

const char* text(Pressure law) { return law == Pressure::rigid ? "rigid" : "pad"; }

class Bench {
public:
  explicit Bench(const Arguments& arguments)
      : arguments_(arguments), peers_(find_peers(arguments)) {
    for (const PeerRun& peer : peers_) names_.push_back(peer.name());
  }

  void run() {
    Table::header(names_);
    for (const Pressure law : {Pressure::rigid, Pressure::pad}) {
      if (!asks_for(law)) continue;
      for (const auto& [k, g] : arguments_.sizes) run_discs(k, g, law, true);
      for (const auto& [k, g] : arguments_.wide) run_discs(k, g, law, false);
    }
    growth_.print();
    std::printf("\nthe dense dictionary's pivots and the memory's speed:\n");
    for (const auto& [k, g] : arguments_.sizes) bench::print_pivot_speed((2 * k + 2) * (g + 2));
    std::printf("\n");
    Table::header(names_);
    for (const Pressure law : {Pressure::rigid, Pressure::pad})
      for (const auto& [k, g] : arguments_.sizes)
        if (asks_for(law) && k > 1 && k <= 20) run_primitives(k, g, law);
  }

private:
  Arguments arguments_;
  std::vector<PeerRun> peers_;
  std::vector<std::string> names_;
  Table table_;
  Growth growth_;

  bool asks_for(Pressure law) const {
    return arguments_.law.empty() || arguments_.law == text(law);
  }
  bool asks_for(const std::string& name) const {
    return arguments_.only.empty() || arguments_.only == name;
  }

  void run_discs(Index k, Index g, Pressure law, bool with_peers) {
    std::vector<test::OwnedScene<double>> scenes;
    for (unsigned seed = 0; seed < arguments_.seeds; ++seed)
      scenes.push_back(bench::disc_grasp(k, g, law, seed));
    const Index n = (2 * k + 2) * (g + 2);
    run_size(text(law), n, scenes, with_peers);
    growth_.add(text(law), n, table_.tallies());
  }

  void run_primitives(Index k, Index g, Pressure law) {
    std::vector<test::OwnedScene<double>> scenes;
    for (const auto which :
         {bench::Primitive::slide, bench::Primitive::pivot, bench::Primitive::roll})
      scenes.push_back(bench::primitive(which, k, g, law));
    run_size(std::string(text(law)) + " primitives", (2 * k + 2) * (g + 2), scenes, true);
  }

  void run_size(const std::string& label, Index n,
                const std::vector<test::OwnedScene<double>>& scenes, bool with_peers) {
    table_.begin_size(label, n);
    for (PeerRun& peer : peers_) peer.begin_size(n);
    const double budget = arguments_.quick ? 5 : 30;
    for (const test::OwnedScene<double>& scene : scenes) {
      Instance instance(scene, with_peers);
      std::vector<Table::Row> rows;
      if (instance.has_dense() && asks_for("dense"))
        rows.push_back(table_.add("dense", instance, cold_dense(instance), budget));
      const std::pair<const char*, Run (*)(Instance&)> ours[] = {
          {"structured", cold_structured}, {"warm", warm},     {"warm, held", held},
          {"predicted", predicted},        {"hybrid", hybrid}, {"Gauss-Seidel", gauss_seidel}};
      for (const auto& [name, make] : ours)
        if (asks_for(name)) rows.push_back(table_.add(name, instance, make(instance), budget));
      for (PeerRun& peer : peers_)
        if (instance.has_dense() && peer.has_time()) peer.run(instance, table_, rows);
      table_.compare(rows);
    }
    for (PeerRun& peer : peers_)
      if (table_.tallies().count(peer.name()) > 0)
        peer.end_size(n, table_.tallies().at(peer.name()));
    table_.print(names_);
  }
};

bool read(int count, char** words, Arguments& arguments) {
  for (int i = 1; i < count; ++i) {
    if (std::strcmp(words[i], "--quick") == 0) {
      arguments.quick = true;
      arguments.seeds = 2;
      arguments.peer_seconds = 2;
    } else if (std::strcmp(words[i], "--no-peers") == 0) {
      arguments.peers = false;
    } else if (std::strcmp(words[i], "--peer") == 0 && i + 1 < count) {
      arguments.plugins.push_back(words[++i]);
    } else if (std::strcmp(words[i], "--only") == 0 && i + 1 < count) {
      arguments.only = words[++i];
    } else if (std::strcmp(words[i], "--law") == 0 && i + 1 < count) {
      arguments.law = words[++i];
    } else if (std::strcmp(words[i], "--peer-seconds") == 0 && i + 1 < count) {
      arguments.peer_seconds = std::atof(words[++i]);
    } else if (std::strcmp(words[i], "--seeds") == 0 && i + 1 < count) {
      arguments.seeds = static_cast<unsigned>(std::atoi(words[++i]));
    } else if (std::strcmp(words[i], "--sizes") == 0 && i + 1 < count) {
      arguments.sizes.clear();
      arguments.wide.clear();
      for (char* item = std::strtok(words[++i], ","); item != nullptr;
           item = std::strtok(nullptr, ",")) {
        const char* const colon = std::strchr(item, ':');
        if (colon == nullptr) return false;
        arguments.sizes.push_back({std::atoi(item), std::atoi(colon + 1)});
      }
    } else {
      return false;
    }
  }
  return true;
}

} // namespace

int main(int count, char** words) {
  // One core for all: Siconos' linear algebra would start threads of its own.
  if (std::getenv("OPENBLAS_NUM_THREADS") == nullptr) {
    setenv("OPENBLAS_NUM_THREADS", "1", 1);
    execv("/proc/self/exe", words);
  }
  Arguments arguments;
  if (!read(count, words, arguments)) {
    std::fprintf(stderr, "usage: peers [--quick] [--sizes K:G,K:G,...] [--seeds N] [--no-peers]\n"
                         "             [--only SOLVER] [--law rigid|pad] [--peer-seconds S]\n"
                         "             [--peer FILE.so]...\n");
    return 2;
  }
  try {
    Bench(arguments).run();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "peers: %s\n", error.what());
    return 2;
  }
}
