#include "certify/exact_search.hpp"

#include "certify/fine_pivots.hpp"
#include "text/limits.hpp"

#include <algorithm>

namespace lcpush::desktop {
namespace {

enum class Digits : unsigned char { some, all };

class ExactSearch {
public:
  explicit ExactSearch(const MixedProblem& problem) : problem_(problem) {}

  /// Did this basis end the search?
  bool ends_with(Basis basic) {
    if (basic.empty() || std::find(bases_.begin(), bases_.end(), basic) != bases_.end())
      return false;
    answer_ = answer_from_bases(problem_, {basic}, 0);
    bases_.push_back(std::move(basic));
    return answer_.has_value();
  }

  /// Pivots under one covering vector after the other, as many as `scale` allows. Many end on rays,
  /// and of the bases in 32 digits one is right where others are not.
  template <class S> bool ends_with_pivots(double scale, Digits digits) {
    FinePivots<S> fine(problem_);
    const auto n = static_cast<double>(std::max<Index>(fine.unknowns(), 1));
    const auto left = static_cast<Index>(scale * (2 * n + limits::entries_certified / (n * n)));
    if (digits == Digits::all && !bases_.empty() && // a number or two may be what fails in it
        ends_with(fine.basis_from(bases_.back(), left / 4)))
      return true;
    for (Index cover = 0; cover < limits::covers_certified && left > fine.pivots(); ++cover) {
      if (ends_with(fine.basis(cover, left - fine.pivots()))) return true;
    }
    return false;
  }

  const std::vector<Basis>& bases() const { return bases_; }
  std::optional<ExactAnswer> take_answer() { return std::move(answer_); }

private:
  const MixedProblem& problem_;
  std::vector<Basis> bases_; // tried in vain, but the last
  std::optional<ExactAnswer> answer_;
};

} // namespace

std::optional<ExactAnswer> searched_answer(const MixedProblem& problem,
                                           const std::function<Basis(Index)>& rounded_basis,
                                           Index rounded_bases) {
  ExactSearch search(problem);
  for (Index k = 0; k < rounded_bases; ++k)
    if (search.ends_with(rounded_basis(k))) return search.take_answer();
  if (static_cast<Index>(problem.size()) > limits::unknowns_fine)
    return answer_from_bases(problem, search.bases(), limits::pivots_certified);
  // A pivot in 77 digits costs four times one in 32.
  if (search.ends_with_pivots<DoubleDouble>(1, Digits::some) ||
      search.ends_with_pivots<WideFloat>(0.25, Digits::all))
    return search.take_answer();
  return std::nullopt;
}

} // namespace lcpush::desktop
