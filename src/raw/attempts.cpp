// Attempts at one raw problem by Lemke's pivots: from zero, with free unknowns pivoted out first,
// or from a basis. The referee judges every point that one of them ends at.
#include <algorithm>
#include <cmath>
#include <optional>

#include "raw/raw_parts.hpp"
#include "raw/settings.hpp"

namespace lcpush::desktop {
namespace {

/// A basis that a run ended at without an answer: rounding may have made a ray of it.
struct LastPoint {
  std::vector<double> z;
  std::vector<unsigned char> basic;
  double artificial = 0; ///< as the dictionary is scaled
};

/// Tells another watcher, and keeps the points at which covering vectors failed.
class PointKeeper : public Watcher {
public:
  explicit PointKeeper(Watcher& other) : other_(other) {}

  std::vector<LastPoint> points;

  void starts(const Lemke<double>& lemke) override { other_.starts(lemke); }
  Index choose_leaving_row(const Lemke<double>& lemke, const PendingPivot& pending) override {
    return other_.choose_leaving_row(lemke, pending);
  }
  void stepped(const Lemke<double>& lemke) override {
    other_.stepped(lemke);
    if (lemke.status() == Status::ray || lemke.status() == Status::numerical_breakdown) keep(lemke);
  }

private:
  Watcher& other_;

  void keep(const Lemke<double>& lemke) {
    const Dictionary<double>& dictionary = lemke.dictionary();
    const Index n = dictionary.size(), finite = dictionary.values.cols() > 3 ? 1 : 0;
    LastPoint point{std::vector<double>(static_cast<std::size_t>(n), 0.0),
                    std::vector<unsigned char>(static_cast<std::size_t>(n), 0)};
    for (Index i = 0; i < n; ++i) {
      const Index j = dictionary.basic[i] - n;
      if (j == n) point.artificial = dictionary.values(i, finite);
      if (j < 0 || j >= n) continue;
      point.z[static_cast<std::size_t>(j)] = dictionary.values(i, finite) * lemke.unknown_unit(j);
      point.basic[static_cast<std::size_t>(j)] = 1;
    }
    points.push_back(std::move(point));
  }
};

/// Some rows and columns of a piece, in a given order.
struct Submatrix {
  std::vector<Index> rows, columns;
  std::vector<double> M, q;
  Problem<double> problem;

  void cut(const DensePiece& from, Index free_begin) {
    for (const Index j : columns)
      for (const Index i : rows) M.push_back(from.M[static_cast<std::size_t>(j * from.size() + i)]);
    for (const Index i : rows) q.push_back(from.q[static_cast<std::size_t>(i)]);
    problem.size = static_cast<Index>(rows.size());
    problem.free_begin = free_begin;
    problem.matrix = M.data();
    problem.q = q.data();
  }
};

/// The flags of a piece in the raw problem's order.
std::vector<unsigned char> in_problem_order(const DensePiece& piece,
                                            const std::vector<unsigned char>& flags) {
  std::vector<unsigned char> all(flags.size());
  for (std::size_t k = 0; k < flags.size(); ++k)
    all[static_cast<std::size_t>(piece.order[k])] = flags[k];
  return all;
}

/// The basis that the reduced problem found, refined on the piece: its complementary pairs first,
/// then the equalities and free unknowns that are independent. Empty: the pivots did not settle.
std::vector<double> refined(const DensePiece& piece, const Reduction<double>& reduction,
                            const LemkeOptions<double>& options, Watcher& watcher,
                            std::vector<unsigned char>& basic, Index& pivots) {
  const auto contains = [](const Span<const int>& list, Index i) {
    return std::find(list.begin(), list.end(), i) != list.end();
  };
  Submatrix whole;
  for (Index i = 0; i < piece.size(); ++i) {
    if (i < piece.pairs || !contains(reduction.redundant_rows(), i)) whole.rows.push_back(i);
    if (i < piece.pairs || !contains(reduction.fixed_unknowns(), i)) whole.columns.push_back(i);
  }
  whole.cut(piece, piece.pairs);
  std::vector<unsigned char> active;
  for (const Index j : whole.columns) active.push_back(basic[static_cast<std::size_t>(j)]);
  OwnedLemke<double> lemke(whole.problem.size);
  if (lemke.init(whole.problem, options, active.data()) != Status::running) return {};
  const Status status = lemke.solve(watcher);
  pivots += lemke.pivots();
  if (status != Status::solved) return {};
  std::vector<double> z(static_cast<std::size_t>(piece.size()), 0.0);
  for (std::size_t k = 0; k < whole.columns.size(); ++k) {
    const auto j = static_cast<std::size_t>(whole.columns[k]);
    z[j] = lemke.z()[k];
    basic[j] = lemke.is_basic(static_cast<Index>(k)) ? 1 : 0;
  }
  return z;
}

} // namespace

Attempts::Attempts(const RawProblem& problem, const RawOptions& options)
    : problem_(problem), options_(options), referee_(problem) {}

bool Attempts::take(std::vector<double> z, const std::vector<unsigned char>& basic) {
  for (std::size_t i = 0; i < z.size(); ++i) // what is below zero by rounding is zero
    if (problem_.free[i] == 0 && z[i] < 0) z[i] = 0;
  std::vector<double> w;
  const double residual = referee_.judge(z, w).residual;
  if (!(residual <= options_.lemke.tolerances.residual)) return false;
  answer_.status = Status::solved;
  answer_.reason = Reason::none;
  answer_.z = std::move(z);
  answer_.w = std::move(w);
  answer_.basic = basic;
  answer_.residual = residual;
  answer_.ray.clear();
  return true;
}

void Attempts::fail(Status status, Reason reason, std::vector<double> ray) {
  const bool tells_more = !tried_ || (status == Status::ray && answer_.status != Status::ray);
  tried_ = true;
  if (!tells_more) return;
  answer_.status = status;
  answer_.reason = reason;
  answer_.ray = std::move(ray);
}

void Attempts::keep_near(std::vector<double> point, double artificial) {
  if (std::abs(artificial) <= raw_settings.gone) near_points_.push_back(std::move(point));
}

bool Attempts::attempt(const DensePiece& piece, const LemkeOptions<double>& options,
                       SingularBlock free_block) {
  const Index n = piece.size();
  std::optional<Owned<Reduction<double>>> reduction; // without free unknowns there is none
  if (piece.pairs < n) {
    reduction.emplace(reduction_scalars(n), reduction_integers(n));
    if (reduction->init(n, piece.M.data(), piece.q.data(), piece.free.data(), free_block) !=
        Status::solved) {
      answer_.inconsistent_row =
          piece.order[static_cast<std::size_t>(reduction->inconsistent_row())];
      return false;
    }
  }
  const Problem<double> problem = reduction ? reduction->problem() : piece.problem();
  const auto basis_of = [&](const auto& is_basic) {
    std::vector<unsigned char> basic(piece.free);
    if (reduction)
      for (const int j : reduction->fixed_unknowns()) basic[static_cast<std::size_t>(j)] = 0;
    for (Index k = 0; k < problem.free_begin; ++k) {
      const ReducedUnknown pair = reduction ? reduction->unknown_of(k) : ReducedUnknown{k, false};
      basic[static_cast<std::size_t>(pair.index)] = is_basic(k) != pair.swapped ? 1 : 0;
    }
    return basic;
  };
  const auto original = [&](const double* reduced, bool is_direction) {
    if (!reduction) return piece.original(reduced);
    std::vector<double> z(static_cast<std::size_t>(n));
    if (is_direction)
      reduction->recover_direction(reduced, z.data());
    else
      reduction->recover(reduced, z.data());
    return piece.original(z.data());
  };
  const auto settle = [&] {
    answer_.redundant_rows.clear();
    if (reduction)
      for (const int row : reduction->redundant_rows())
        answer_.redundant_rows.push_back(piece.order[static_cast<std::size_t>(row)]);
    return true;
  };
  OwnedLemke<double> lemke(problem.size);
  PointKeeper keeper(*options_.watcher);
  if (lemke.init(problem, options) == Status::running) (void)lemke.solve(keeper);
  answer_.pivots += lemke.pivots();
  answer_.covers += lemke.covers_tried();
  if (lemke.status() == Status::solved) {
    auto basic = basis_of([&](Index k) { return lemke.is_basic(k); });
    // What passes stays, should the refined basis not.
    const bool passes = take(original(lemke.z(), false), in_problem_order(piece, basic));
    if (passes && !reduction) return true;
    if (reduction) {
      const std::vector<double> z =
          refined(piece, *reduction, options, *options_.watcher, basic, answer_.pivots);
      if (!z.empty()) (void)take(piece.original(z.data()), in_problem_order(piece, basic));
    } else if (options_.searches) {
      (void)from(piece, basic, Guess::near);
    }
    if (solved()) return settle();
    keep_near(original(lemke.z(), false), 0);
    fail(Status::numerical_breakdown, Reason::residual, {});
    return false;
  }
  std::vector<double> ray;
  if (lemke.status() == Status::ray) ray = original(lemke.ray(), true);
  fail(lemke.status(), lemke.reason(), std::move(ray));
  if (!options_.searches) return false;
  for (const LastPoint& point : keeper.points) {
    const auto basic =
        basis_of([&](Index k) { return point.basic[static_cast<std::size_t>(k)] != 0; });
    if (take(original(point.z.data(), false), in_problem_order(piece, basic))) return settle();
    keep_near(original(point.z.data(), false), point.artificial);
  }
  return false;
}

bool Attempts::cold(const DensePiece& piece, const LemkeOptions<double>& options) {
  // Bounding keeps the class that Lemke is proved for; exchanging reaches what it leaves out.
  if (attempt(piece, options, SingularBlock::bound) || hopeless()) return solved();
  return piece.pairs < piece.size() && attempt(piece, options, SingularBlock::exchange);
}

bool Attempts::from(const DensePiece& piece, const std::vector<unsigned char>& active,
                    Guess guess) {
  std::vector<unsigned char> start;
  for (std::size_t k = 0; k < piece.order.size(); ++k)
    start.push_back(piece.free[k] != 0 ? 1 : active[static_cast<std::size_t>(piece.order[k])]);
  LemkeOptions<double> single = options_.lemke;
  single.covers = 1;
  OwnedLemke<double> lemke(piece.size());
  if (lemke.init(piece.problem(), single, start.data(), guess) == Status::running)
    (void)lemke.solve(*options_.watcher);
  answer_.pivots += lemke.pivots();
  if (lemke.status() != Status::solved) return false;
  std::vector<unsigned char> basic;
  for (Index k = 0; k < piece.size(); ++k) basic.push_back(lemke.is_basic(k) ? 1 : 0);
  return take(piece.original(lemke.z()), in_problem_order(piece, basic));
}

} // namespace lcpush::desktop
