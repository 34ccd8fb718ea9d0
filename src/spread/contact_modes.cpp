#include "lcpush/desktop/contact_modes.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

#include "lcpush/mechanics/solve/breaking.hpp"
#include "lcpush/mechanics/study/motion.hpp"
#include "solve/word_settings.hpp"
#include "spread/face_study.hpp"
#include "spread/mode_tree.hpp"
#include "spread/settings.hpp"

namespace lcpush::desktop {
namespace {

using Kind = ContactMode::Kind;

Mode mode_of(Kind kind) {
  return kind == Kind::open ? Mode::separate : kind == Kind::slide ? Mode::slide : Mode::stick;
}

class ModeSearch {
public:
  ModeSearch(const SceneFile& file, const SpreadOptions& options)
      : options_(options), problem_(file), pruned_(begin_report(problem_)),
        pruning_(problem_, pruned_, false) {
    report_.points.resize(static_cast<std::size_t>(problem_.layout().points));
    slips_.resize(report_.points.size());
    for (const ConeGroup<double>& cone : problem_.layout().cones)
      report_.possible *= (cone.normals == 1 ? 1 : 0) + (cone.generators > 0 ? 2 : 1);
  }

  ModesReport run() {
    ModeTree tree(problem_);
    tree.may_have_answers = [this](const FaceModes& part) {
      return pruning_.may_have_answers(part);
    };
    tree.leaf = [this](const FaceModes& modes) { add(modes); };
    tree.is_used_up = [&] { return is_used_up(tree.share()); };
    tree.visit();
    report_.complete = report_.enumeration.empty();
    for (Found& found : found_) {
      conclude(push_size(problem_.scene()), found.combination.ranges);
      report_.combinations.push_back(std::move(found.combination));
    }
    std::stable_sort(report_.combinations.begin(), report_.combinations.end(),
                     [](const ModeCombination& one, const ModeCombination& other) {
                       return !one.ranges.pushers.empty() &&
                              one.ranges.pushers[0].force.low < other.ranges.pushers[0].force.low;
                     });
    return report_;
  }

private:
  /// Its study widens its ranges.
  struct Found {
    Found(LiteralProblem& problem, std::vector<Mode> modes)
        : combination{std::move(modes), begin_report(problem), {}},
          study(problem, combination.ranges, false) {}
    ModeCombination combination;
    FaceStudy study;
  };

  SpreadOptions options_;
  LiteralProblem problem_;
  SpreadReport pruned_; // counts what pruning does
  FaceStudy pruning_;
  ModesReport report_;
  std::deque<Found> found_;                            // does not move what studies refer to
  std::vector<std::vector<std::vector<Index>>> slips_; // a point: the generators of each slip
  double studied_ = 0;                                 // work

  bool is_used_up(double share) {
    const double most =
        options_.most_work *
        (options_.enumeration == Enumeration::thorough ? SpreadSettings::thorough_factor : 1);
    const double work = pruning_.work() + studied_;
    if (options_.progress) options_.progress(std::max(options_.by_time ? 0 : work / most, share));
    report_.stop = stop_now(options_.stop);
    const bool is_over = report_.stop != Stop::none || (!options_.by_time && work > most);
    if (is_over)
      report_.enumeration = report_.stop == Stop::signal ? "it was interrupted"
                            : report_.stop == Stop::time ? "the time was up"
                                                         : "the limit of work was reached";
    return is_over;
  }

  void leave_unsettled() { report_.enumeration = "some assignments of modes could not be settled"; }

  void add(const FaceModes& modes) {
    const ModeMotions motions = motions_of(problem_, modes);
    Face face(problem_, modes, motions, Instant::pushed);
    Face::Ending own = face.find_point();
    if (own == Face::Ending::found) own = face.find_own_point(motions);
    studied_ += face.work();
    if (own == Face::Ending::none) return; // what it holds has other modes
    Face::Answer inner = own == Face::Ending::found ? face.inner_point() : Face::Answer{};
    if (own == Face::Ending::found) problem_.complete(inner.push, inner.z);
    if (own != Face::Ending::found || !obeys(inner)) {
      leave_unsettled();
      return;
    }
    Found& found = combination_of(modes);
    note_slips(modes, problem_.read(inner.z, inner.push));
    if (found.combination.shown.status != Status::solved) show(inner, found.combination.shown);
    const double before = found.study.work();
    std::vector<Face::Answer> corners;
    if (found.study.study(modes, std::numeric_limits<double>::infinity(), corners) !=
        FaceStudy::Result::studied)
      leave_unsettled();
    studied_ += found.study.work() - before;
  }

  bool obeys(const Face::Answer& answer) {
    return problem_.passes(problem_.check(problem_.read(answer.z, answer.push), answer.push),
                           answer.push);
  }

  Found& combination_of(const FaceModes& modes) {
    std::vector<Mode> kinds;
    for (const ContactMode& mode : modes) kinds.push_back(mode_of(mode.kind));
    for (Found& found : found_)
      if (found.combination.modes == kinds) return found;
    for (std::size_t i = 0; i < kinds.size(); ++i)
      report_.points[i].can[static_cast<std::size_t>(kinds[i])] = true;
    return found_.emplace_back(problem_, std::move(kinds));
  }

  void note_slips(const FaceModes& modes, const Answer<double>& answer) {
    for (std::size_t i = 0; i < modes.size(); ++i) {
      const std::vector<Index>& active = modes[i].active;
      if (modes[i].kind != Kind::slide ||
          std::find(slips_[i].begin(), slips_[i].end(), active) != slips_[i].end())
        continue;
      const ContactAnswer<double>& contact = answer.contacts[static_cast<Index>(i)];
      const Vector3<double>& n = problem_.scene().bodies[contact.body].normal;
      slips_[i].push_back(active);
      report_.points[i].slips.push_back(
          (contact.acceleration - contact.acceleration.dot(n) * n).normalized());
    }
  }

  void show(const Face::Answer& answer, PushReport& shown) {
    const Answer<double>& read = problem_.read(answer.z, answer.push);
    const Scales<double>& scales = problem_.layout().scales;
    const double push = push_size(problem_.scene());
    shown.status = Status::solved;
    shown.hand_moves = true; // tables have no room for "in the grip"
    shown.scales = scales;
    shown.answer.acceleration = read.acceleration;
    shown.motion = describe_motion(problem_.scene(), read, scales.length,
                                   pruned_.noise.acceleration / word_settings.rounding, push);
  }
};

/// The combination of an answer of `solve`.
std::optional<std::size_t> find_chosen(const SceneFile& file, const PushReport& solved,
                                       const std::vector<ModeCombination>& combinations) {
  if (solved.status != Status::solved) return {};
  for (std::size_t k = 0; k < combinations.size(); ++k) {
    const auto same = [&](std::size_t i) {
      const ContactAnswer<double>& contact = solved.answer.contacts[static_cast<Index>(i)];
      const bool slips = contact.mode == Mode::slide && file.body(contact.body).friction > 0;
      const Mode mode = contact.mode == Mode::separate ? Mode::separate
                        : slips                        ? Mode::slide
                                                       : Mode::stick;
      return mode == combinations[k].modes[i];
    };
    std::size_t i = 0;
    while (i < combinations[k].modes.size() && same(i)) ++i;
    if (i == combinations[k].modes.size()) return k;
  }
  return {};
}

} // namespace

ModesReport find_modes(const SceneFile& file, const SpreadOptions& options) {
  ModesReport report = ModeSearch(file, options).run();
  Push push(file);
  report.solved = push.solve({});
  report.chosen = find_chosen(file, report.solved, report.combinations);
  report.solved.answer = {}; // its arrays go with the Push
  report.status = !report.combinations.empty()             ? Status::solved
                  : report.solved.status != Status::solved ? report.solved.status
                                                           : Status::numerical_breakdown;
  return report;
}

} // namespace lcpush::desktop
