// All solutions: faces of the polyhedron on which every pair has a side that is zero.
#include <algorithm>
#include <numeric>
#include <unordered_map>

#include "enumerate/polyhedron_face.hpp"

namespace lcpush::desktop {
namespace {

class Search {
public:
  explicit Search(const AllOptions& options) : options_(options) {}

  AllSolutions run(PolyhedronFace face) {
    result_.cases = 1;
    if (face.find_vertex()) {
      lines_ = face.lines();
      visit(face, {});
    }
    keep_largest();
    join();
    return std::move(result_);
  }

private:
  const AllOptions& options_;
  AllSolutions result_;
  std::unordered_map<Variables, Index> points_, rays_; // what is zero tells them apart
  std::vector<Variables> zeros_;                       // of each set
  std::vector<ExactVector> lines_;

  /// `more` vertices and rays are being found.
  bool is_over(std::size_t more = 0) {
    if (result_.complete()) {
      result_.stop = stop_now(options_.stop);
      const auto most = static_cast<std::size_t>(options_.most);
      if (std::max(zeros_.size(), points_.size() + rays_.size() + more) >= most)
        result_.most = options_.most;
    }
    return !result_.complete();
  }

  /// All faces of solutions on this one, but for those on which one of `needed` is zero: they lie
  /// in faces that were visited before.
  void visit(PolyhedronFace& face, const Variables& needed) {
    const Index n = face.size();
    for (Index z = n; z < 2 * n; ++z)
      if (has(needed, z) && !face.can_be_positive(z)) return;
    const Index pair = face.open_pair();
    if (is_over()) return;
    if (pair < 0) return take(face);
    const Index w = slack(pair), z = unknown(pair, n);
    for (const Index zero : {z, w}) {
      ++result_.cases;
      if (face.is_always_positive(zero)) continue;
      PolyhedronFace part = face;
      Variables still_needed = needed;
      if (zero == w) add(still_needed, z);
      if (part.fix(zero)) visit(part, still_needed);
    }
  }

  void take(PolyhedronFace& face) {
    SolutionSet set;
    Variables zero = Variables().set();
    set.dimension = face.dimension() + static_cast<Index>(lines_.size());
    const auto generators = face.generators([this](std::size_t count) { return is_over(count); });
    if (!generators) return;
    const auto half = static_cast<std::ptrdiff_t>(face.size());
    for (const FaceGenerator& one : *generators) {
      zero &= one.zero;
      const auto middle = one.values.begin() + half;
      const ExactVector z(middle, middle + half);
      auto& numbers = one.is_ray() ? rays_ : points_;
      const auto [place, is_new] =
          numbers.try_emplace(one.zero, static_cast<Index>(numbers.size()));
      (one.is_ray() ? set.rays : set.vertices).push_back(place->second);
      if (is_new && one.is_ray()) result_.rays.push_back(z);
      if (is_new && !one.is_ray())
        result_.points.push_back({z, ExactVector(one.values.begin(), middle)});
    }
    result_.sets.push_back(std::move(set));
    zeros_.push_back(zero);
  }

  /// One face lies in another if whatever is zero on that one is zero on it.
  void keep_largest() {
    const auto& sets = result_.sets;
    std::vector<std::size_t> wide;
    for (std::size_t k = 0; k < sets.size(); ++k)
      if (sets[k].dimension > static_cast<Index>(lines_.size())) wide.push_back(k);
    std::vector<SolutionSet> kept;
    for (std::size_t k = 0; k < sets.size(); ++k)
      if (std::none_of(wide.begin(), wide.end(), [&](std::size_t j) {
            return sets[j].dimension > sets[k].dimension && (zeros_[j] & ~zeros_[k]).none();
          }))
        kept.push_back(sets[k]);
    result_.sets = std::move(kept);
  }

  /// Sets that share a point share a vertex: they are faces of one polyhedron. Lines are in all.
  void join() {
    std::vector<Index> linked(result_.points.size());
    std::iota(linked.begin(), linked.end(), Index{0});
    const auto root = [&linked](Index k) {
      while (linked[static_cast<std::size_t>(k)] != k) k = linked[static_cast<std::size_t>(k)];
      return k;
    };
    for (const SolutionSet& set : result_.sets)
      for (const Index vertex : set.vertices)
        linked[static_cast<std::size_t>(root(vertex))] = root(set.vertices.front());
    for (ExactVector line : lines_)
      for (int side = 0; side < 2; ++side) {
        for (SolutionSet& set : result_.sets)
          set.rays.push_back(static_cast<Index>(result_.rays.size()));
        result_.rays.push_back(line);
        for (Rational& x : line) x.negate();
      }
    for (SolutionSet& set : result_.sets)
      if (set.dimension > 0) set.component = root(set.vertices.front());
    std::stable_sort(result_.sets.begin(), result_.sets.end(),
                     [](const auto& a, const auto& b) { return a.component < b.component; });
  }
};

/// What is to be added so that all payoffs are positive: equilibria do not change.
Rational lift(const ExactMatrix& payoffs) {
  return Rational(1) - *std::min_element(payoffs.values.begin(), payoffs.values.end());
}

} // namespace

AllSolutions all_solutions(const ExactMatrix& M, const ExactMatrix& q,
                           const std::vector<unsigned char>& free, const AllOptions& options) {
  return Search(options).run(PolyhedronFace(M, q, free));
}

/// x, y >= 0, A y <= 1, B' x <= 1, each complementary [Lemke and Howson 1964]: what is not zero is
/// an equilibrium once x and y are divided by their sums, whose reciprocals are the payoffs.
AllSolutions all_equilibria(const ExactMatrix& A, const ExactMatrix& B, const AllOptions& options) {
  const Index m = A.rows, n = m + A.cols;
  const Rational lift_A = lift(A), lift_B = lift(B);
  const auto size = static_cast<std::size_t>(n);
  ExactMatrix M{n, n, ExactVector(size * size)};
  for (Index i = 0; i < m; ++i)
    for (Index j = m; j < n; ++j) {
      M.values[static_cast<std::size_t>(j * n + i)] = -(A(i, j - m) + lift_A);
      M.values[static_cast<std::size_t>(i * n + j)] = -(B(i, j - m) + lift_B);
    }
  AllSolutions found = all_solutions(M, {n, 1, ExactVector(size, Rational(1))},
                                     std::vector<unsigned char>(size, 0), options);
  for (SolutionPoint& point : found.points) {
    const auto begin = point.z.begin(), middle = begin + m, end = point.z.end();
    const Rational x = std::accumulate(begin, middle, Rational(0)),
                   y = std::accumulate(middle, end, Rational(0));
    point.w.clear();
    if (x.sign() == 0) continue; // z = 0, a solution that is no equilibrium
    for (auto p = begin; p != end; ++p) *p /= p < middle ? x : y;
    point.w = {Rational(1) / y - lift_A, Rational(1) / x - lift_B};
  }
  const auto is_zero = [&found](const SolutionSet& set) {
    return found.points[static_cast<std::size_t>(set.vertices.front())].w.empty();
  };
  found.sets.erase(std::remove_if(found.sets.begin(), found.sets.end(), is_zero), found.sets.end());
  return found;
}

} // namespace lcpush::desktop
