// What the solvers of raw problems share.
#pragma once

#include "lcpush/desktop/owned.hpp"
#include "lcpush/desktop/raw_problem.hpp"
#include "lcpush/lcp/pivots/reduce.hpp"

namespace lcpush::desktop {

/// Powers of two.
struct Scales {
  std::vector<double> row, column;
};
/// R and C for which the largest entries of all rows and columns of R M C are near 1.
Scales balanced_scales(const SparseRows& M);

/// [T.11] on sparse rows. The unit of an unknown is its column's scale, so that units do not
/// matter.
class Referee {
public:
  /// `problem` outlives it.
  explicit Referee(const RawProblem& problem);

  /// w becomes M z + q. Cost: four passes over the entries of M.
  WorstRow<double> judge(const std::vector<double>& z, std::vector<double>& w);

private:
  const RawProblem& problem_;
  std::vector<double> unit_, row_unit_, size_, caught_, scale_, share_;
  double given_ = 0; ///< the largest of q, and of what finite ends bring, in row units

  double box_size(std::size_t j) const;
  void measure_given();
  void measure_unknowns(const std::vector<double>& z);
  void measure_rows(const std::vector<double>& z, std::vector<double>& w);
};

/// Without boxes: rows that no entry of M connects to others, each list ascending, short lists
/// first. Row i and column i belong together.
std::vector<std::vector<Index>> pieces_of(const SparseRows& M);

/// The largest size of a number in it; 0 if it is empty.
double largest_of(const std::vector<double>& list);

/// These rows and columns alone; the list ascends.
RawProblem cut_out(const RawProblem& problem, const std::vector<Index>& rows);

/// A raw problem as pivots store it: dense, scaled by powers of two, free unknowns last.
struct DensePiece {
  std::vector<Index> order; ///< row of the raw problem, for each row here
  Index pairs = 0;          ///< rows whose unknown is not free; they come first
  std::vector<double> M, q, column_scale;
  double q_scale = 1;
  std::vector<unsigned char> free; ///< in this order

  /// Scaled so that the largest entries of rows, columns and q are near 1, or as it is.
  enum class Scaled { no, yes };
  DensePiece(const RawProblem& from, Scaled scaled);

  Index size() const { return static_cast<Index>(order.size()); }
  Problem<double> problem() const;
  /// The unknowns of the raw problem, from those of this one.
  std::vector<double> original(const double* z) const;
};

/// Attempts at one raw problem without boxes, by Lemke's pivots; what passes the referee stays.
class Attempts {
public:
  /// Precondition: options.watcher is set. Both outlive it.
  Attempts(const RawProblem& problem, const RawOptions& options);

  bool solved() const { return answer_.status == Status::solved; }
  /// Does the problem contradict itself, so that no other attempt can help?
  bool hopeless() const { return answer_.inconsistent_row >= 0; }
  RawAnswer& answer() { return answer_; }

  /// From zero, under the covering vectors of `lemke`. The first attempt's failure is the one that
  /// is told, a ray before others.
  bool cold(const DensePiece& piece, const LemkeOptions<double>& lemke);
  /// From the complementary basis of `active`, in the problem's order; free unknowns are basic.
  bool from(const DensePiece& piece, const std::vector<unsigned char>& active, Guess guess);
  /// Is z an answer? If so it is taken.
  bool take(std::vector<double> z, const std::vector<unsigned char>& basic);
  /// Points, in the problem's units, at which hardly anything of the covering vector was left.
  const std::vector<std::vector<double>>& near_points() const { return near_points_; }

private:
  const RawProblem& problem_;
  const RawOptions& options_;
  Referee referee_;
  RawAnswer answer_;
  std::vector<std::vector<double>> near_points_;
  bool tried_ = false;

  /// Free unknowns are pivoted out first; what becomes of those that cannot be, `free_block` says.
  bool attempt(const DensePiece& piece, const LemkeOptions<double>& lemke,
               SingularBlock free_block);
  void keep_near(std::vector<double> point, double artificial);
  void fail(Status status, Reason reason, std::vector<double> ray);
};

/// Looks further after a failure. `level` counts how often the undecided pairs of a problem have
/// become one of their own.
void search_further(const RawProblem& problem, const RawOptions& options, int level,
                    Attempts& attempts);

/// Lemke's pivots from zero, piece by piece. Precondition: options.watcher is set, no boxes.
/// `near`, unless it is empty, is a point to start from.
RawAnswer solve_by_pivots(const RawProblem& problem, const RawOptions& options,
                          const std::vector<double>& near, int level = 0);

/// Sweeps over the rows until the residual is `tolerance`.
void sweep_rows(const RawProblem& problem, const RawOptions& options, double tolerance,
                RawAnswer& answer);
/// -1 if every diagonal entry is positive.
Index first_bad_diagonal(const RawProblem& problem);

} // namespace lcpush::desktop
