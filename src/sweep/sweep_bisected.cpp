// Segments where no single problem describes the range: straight lines through fresh solves, their
// ends by bisection.
#include <algorithm>
#include <cmath>
#include <utility>

#include "sweep/settings.hpp"
#include "sweep/sweep_pieces.hpp"
#include "text/limits.hpp"

namespace lcpush::desktop {
namespace {

struct At {
  double t;
  DetailedAnswer answer;
};

class BisectedWalk {
public:
  BisectedWalk(SweepSolver& solver, Question question) : solver_(solver), question_(question) {}

  /// The piece that begins with `start`; `next` receives the first answer beyond it, if any.
  /// Strides that double while the answers stay on one line, then bisection.
  Piece grow(const At& start, At& next) {
    At last = start, middle = start; // the line goes through start and last
    double stride = SweepSettings::first_stride;
    bool beyond = false;
    const auto continues = [&](const At& candidate) {
      if (!same_modes(start.answer, candidate.answer)) return false;
      if (!start.answer.is_known() || last.t == start.t) return true;
      const DetailedAnswer expected =
          on_line(start.answer, start.t, last.answer, last.t, candidate.t);
      const double reach = (candidate.t - start.t) / (last.t - start.t);
      const double tolerance =
          SweepSettings::one_line *
          (question_ == Question::breaking ? SweepSettings::breaking_lines : 1);
      return !differ(expected, candidate.answer, question_, tolerance * std::max(1.0, reach));
    };
    // Two answers always lie on a line: the first stride is halved until a third lies there too.
    while (start.answer.is_known() && stride > SweepSettings::bisection_width && start.t < 1) {
      const double end = std::min(1.0, start.t + stride);
      last = start;
      const At far = solve(end), near = solve((start.t + end) / 2);
      if (continues(near)) {
        last = near;
        if (continues(far)) {
          middle = near;
          last = far;
          break;
        }
      }
      next = far;
      beyond = true;
      last = start;
      stride /= 4;
    }
    while (last.t < 1 && !(beyond && last.t == start.t)) {
      const double limit = beyond ? next.t : 1;
      double t = std::min(limit, last.t + stride);
      if (beyond && t >= next.t - SweepSettings::bisection_width / 2) t = (last.t + next.t) / 2;
      if (beyond && next.t - last.t <= SweepSettings::bisection_width) break;
      At candidate = solve(t);
      if (continues(candidate)) {
        middle = std::exchange(last, std::move(candidate));
        if (!beyond) stride *= 2;
      } else {
        next = std::move(candidate);
        beyond = true;
      }
      if (beyond) stride = (next.t - last.t) / 2;
    }
    if (!beyond) next.t = 2;
    const bool known = start.answer.is_known();
    Piece piece{start.t, beyond ? next.t : 1, known ? SegmentKind::bisected : SegmentKind::unsolved,
                start.answer, start.answer};
    if (last.t > start.t && known)
      piece.at_to = on_line(start.answer, start.t, last.answer, last.t, piece.to);
    piece.at_from.contacts = piece.at_to.contacts = middle.answer.contacts;
    return piece;
  }

  At solve(double t) {
    ++solves_;
    solver_.go_to(value_at(solver_.variations().front(), t));
    if (!solver_.has(question_))
      solver_.go_to(value_at(solver_.variations().front(), t < SweepSettings::aside_after
                                                               ? t + SweepSettings::aside
                                                               : t - SweepSettings::aside));
    RoundBases none; // fresh, so that the path here does not matter
    return {t, solver_.solve(question_, none)};
  }

  bool is_used_up() const { return solves_ >= limits::bisection_solves; }

private:
  SweepSolver& solver_;
  Question question_;
  Index solves_ = 0;
};

/// Everything that is a straight line over a piece.
using Values = Eigen::Matrix<double, 10, 1>;

/// Where two lines meet, if they do so next to where the one ends and the other begins.
void sharpen(Question question, Piece& before, Piece& after, double nearest) {
  if (before.kind != SegmentKind::bisected || after.kind != SegmentKind::bisected) return;
  if (before.at_to.status != after.at_from.status) return;
  const double at = before.to;
  // At breaking the motion need not go on where the force does.
  const auto values = [&](const DetailedAnswer& o) {
    Values v = Values::Zero();
    v[0] = o.normal;
    if (question == Question::push) v.tail<9>() << o.force, o.twist;
    return v;
  };
  const auto slope = [&](const Piece& piece) {
    return Values((values(piece.at_to) - values(piece.at_from)) / (piece.to - piece.from));
  };
  if (!(before.to > before.from) || !(after.to > after.from)) return;
  const Values off = values(before.at_to) - values(after.at_from);
  const Values kink = slope(after) - slope(before);
  // Each question in its own size, so that forces do not drown motions.
  const Values size = values(before.at_to).cwiseAbs() + Values::Constant(SweepSettings::sharpened);
  const Values scaled_kink = kink.cwiseQuotient(size);
  Index largest = 0;
  if (!(scaled_kink.cwiseAbs().maxCoeff(&largest) > 0)) return;
  const double t = at + off[largest] / size[largest] / scaled_kink[largest];
  if (!(std::abs(t - at) <= nearest)) return;
  before.at_to = before.at(t);
  after.at_from = after.at(t);
  before.to = after.from = t;
}

/// Next to a change of mode the small pushes that breaking is extrapolated from lie on both sides
/// of it: what looks like a short piece there is blur. The pieces beside it meet in its middle.
std::vector<Piece> without_slivers(const std::vector<Piece>& pieces, double shortest) {
  std::vector<Piece> list;
  for (Piece piece : pieces) {
    const bool is_sliver = piece.to - piece.from < shortest && piece.from > 0 && piece.to < 1;
    if (is_sliver && !list.empty() && list.back().kind == SegmentKind::bisected) continue;
    if (!list.empty() && list.back().to < piece.from) {
      Piece& last = list.back();
      const double middle = (last.to + piece.from) / 2;
      last.at_to = last.at(middle);
      if (piece.kind == SegmentKind::bisected) piece.at_from = piece.at(middle);
      last.to = piece.from = middle;
    }
    list.push_back(std::move(piece));
  }
  return list;
}

void walk_through(SweepSolver& solver, Question question, const Progress& progress,
                  std::vector<Piece>& pieces) {
  BisectedWalk walk(solver, question);
  At start = walk.solve(0), next = start;
  while (static_cast<Index>(pieces.size()) < SweepSettings::most_pieces && !walk.is_used_up()) {
    pieces.push_back(walk.grow(start, next));
    if (pieces.back().to >= 1 || next.t > 1) break;
    progress(pieces.back().to);
    start = next;
  }
  start.t = std::min(start.t, 1.0);
  // Where answers branch all the time there is no end to bisection.
  const double begin = pieces.back().to;
  for (Index k = 1; begin < 1 && k <= SweepSettings::strokes; ++k) {
    At end = walk.solve(k == SweepSettings::strokes ? 1
                                                    : begin + (1 - begin) * static_cast<double>(k) /
                                                                  SweepSettings::strokes);
    const bool known = start.answer.is_known() && start.answer.status == end.answer.status;
    pieces.push_back({start.t, end.t, known ? SegmentKind::sampled : SegmentKind::unsolved,
                      start.answer, end.answer});
    start = std::move(end);
  }
}

} // namespace

std::vector<Piece> bisected_pieces(SweepSolver& solver, Question question,
                                   const Progress& progress) {
  std::vector<Piece> pieces;
  try {
    walk_through(solver, question, progress, pieces);
  } catch (const Stopped&) { // with what there is
  }
  const double blur = question == Question::breaking ? SweepSettings::breaking_blur : 0;
  std::vector<Piece> list = without_slivers(pieces, blur);
  for (std::size_t i = 1; i < list.size(); ++i)
    sharpen(question, list[i - 1], list[i], 2 * SweepSettings::bisection_width + blur);
  return list;
}

} // namespace lcpush::desktop
