#include "lcpush/desktop/spread.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <limits>
#include <optional>
#include <string>
#include <unordered_set>

#include "lcpush/mechanics/solve/breaking.hpp"
#include "spread/face_study.hpp"
#include "spread/mode_tree.hpp"
#include "spread/settings.hpp"
#include "text/limits.hpp"

namespace lcpush::desktop {
namespace {

std::uint64_t mixed(std::uint64_t x) { // splitmix64
  x += 0x9e3779b97f4a7c15U;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31);
}

std::uint64_t mixed(std::uint64_t key, const std::vector<Index>& list) {
  for (const Index j : list) key = mixed(key ^ static_cast<std::uint64_t>(j));
  return key;
}

/// Lists of modes have the same key only if they are the same, but for once in 10^18: it is the sum
/// of its contacts' keys, so that what differs in one contact costs one of them.
std::uint64_t key_of(std::size_t contact, const ContactMode& mode) {
  return mixed(mixed(8 * contact + static_cast<std::uint64_t>(mode.kind) + (mode.pulls ? 4 : 0)),
               mode.active);
}

std::uint64_t key_of(const FaceModes& modes) {
  std::uint64_t key = 0;
  for (std::size_t i = 0; i < modes.size(); ++i) key += key_of(i, modes[i]);
  return key;
}

std::uint64_t key_of(std::size_t contact, const ContactReading& at) {
  std::uint64_t key = contact;
  for (const bool flag : {at.pressed, at.pulls, at.gap_closed, at.slips, at.at_limit})
    key = 2 * key + (flag ? 1 : 0);
  return mixed(mixed(mixed(mixed(key), at.carrying)), at.opposing);
}

/// The same text for answers that are the same to a few roundings, as a rule.
std::string corner_key(const Eigen::VectorXd& z) {
  const Eigen::VectorXf rounded =
      (z.array().abs() > SpreadSettings::zero).select(z, 0).cast<float>();
  return {reinterpret_cast<const char*>(rounded.data()),
          static_cast<std::size_t>(rounded.size()) * sizeof(float)};
}

class Search {
public:
  Search(const SceneFile& file, const SpreadOptions& options)
      : options_(options), problem_(file), report_(begin_report(problem_, options.breaking)) {
    report_.asked = options.enumeration;
    study_.emplace(problem_, report_, options.breaking);
  }

  SpreadReport run() {
    solve_covering_vectors();
    if (options_.enumeration != Enumeration::none) enumerate();
    include_paths();
    if (!report_.complete) walk();
    if (report_.complete) report_.stop = Stop::none;
    if (report_.faces > 0 || (!options_.breaking && report_.covering_vectors_solved > 0)) {
      report_.status = Status::solved;
      conclude(options_.breaking ? 1 : push_size(problem_.scene()), report_);
      return report_;
    }
    Push push(problem_.file());
    PushOptions options;
    options.lemke = options_.lemke;
    if (options_.breaking)
      static_cast<RunReport&>(report_.failure) = push.find_breaking(first_pusher(), options);
    else
      report_.failure = push.solve(options);
    report_.failure.answer = {}; // its arrays go with the Push
    report_.status = report_.failure.status == Status::solved ? Status::numerical_breakdown
                                                              : report_.failure.status;
    return report_;
  }

private:
  struct Path {
    Face::Answer moving; ///< pushed as asked, or a little; modes and neighbours are told from it
    Face::Answer asked;  ///< what the ranges are to hold
    bool falls = false;  ///< the object moves before the push
  };

  SpreadOptions options_;
  LiteralProblem problem_;
  SpreadReport report_;
  std::optional<FaceStudy> study_;
  std::vector<Path> paths_;
  std::unordered_set<std::uint64_t> known_, studied_, proposed_; // by key_of
  std::deque<FaceModes> waiting_;
  double most_work_ = 0, part_of_time_ = 1;
  double walked_ = 0; // work of finding faces next to others
  double begun_ = 0,
         reported_ = 0; // of the progress: where this stage began, and what was said last

  double work() const { return study_->work() + walked_; }
  Index first_pusher() const { return report_.pushers.empty() ? 0 : report_.pushers.front().body; }

  /// To the push as it is; of the instant of breaking, to one so small that the modes are its own.
  Status solve_path(OwnedLemke<double>& lemke, Index cover, Path& path) {
    constexpr double small = SpreadSettings::small_push;
    const Index n = problem_.layout().size;
    LemkeOptions<double> options = options_.lemke;
    options.first_cover = cover;
    options.covers = 1;
    Watcher nobody;
    Status status = lemke.init(options_.breaking ? problem_.breaking_problem()
                                                 : problem_.problem(problem_.push()),
                               options);
    if (status == Status::running)
      status = lemke.solve(options_.watcher != nullptr ? *options_.watcher : nobody);
    if (status != Status::solved) return status;
    const Eigen::VectorXd z = Eigen::Map<const Eigen::VectorXd>(lemke.z(), n);
    path.moving = path.asked = {z, options_.breaking ? 0 : problem_.push()};
    if (!options_.breaking) return status;
    path.falls = problem_.motion_of(z, 0).head(problem_.moving()).norm() > at_rest<double>();
    const double reach = lemke.valid_to() * problem_.push();
    path.moving.push = reach < 0 ? small : std::min(small, reach / 2);
    path.moving.z +=
        path.moving.push / problem_.push() * Eigen::Map<const Eigen::VectorXd>(lemke.z_push(), n);
    return status;
  }

  void solve_covering_vectors() {
    OwnedLemke<double> lemke(problem_.layout().size);
    allow(0, 0.5);
    for (Index k = 0; k < options_.covering_vectors; ++k) {
      if (k > 0 && is_stopped()) return;
      ++report_.covering_vectors;
      Path path;
      if (solve_path(lemke, k, path) == Status::solved) paths_.push_back(std::move(path));
    }
  }

  /// After an enumeration that saw every answer they bring nothing new. If they do, it did not.
  void include_paths() {
    const SpreadReport enumerated = report_;
    for (const Path& path : paths_) {
      report_.falls = report_.falls || path.falls;
      if (path.falls || study_->accept(path.asked))
        ++report_.covering_vectors_solved;
      else
        ++report_.failures;
    }
    if (!report_.complete || !is_wider(report_, enumerated)) return;
    report_.complete = false;
    report_.enumeration = "an answer was reached that lies outside of all that were enumerated";
  }

  void propose(const FaceModes& modes) {
    if (known_.insert(key_of(modes)).second) waiting_.push_back(modes);
  }

  /// The faces next to an answer on a known face: one contact does something else that it may be
  /// said to do there.
  void propose_adjacent_faces(const Face::Answer& answer) {
    const std::vector<ContactReading> readings = problem_.readings_at(answer.z, answer.push);
    FaceModes modes = problem_.face_of(readings);
    propose(modes);
    const std::uint64_t here = key_of(modes);
    for (std::size_t i = 0; i < modes.size(); ++i) {
      // Corners are alike in most contacts: what one leads to has been proposed.
      const std::uint64_t rest = here - key_of(i, modes[i]);
      if (!proposed_.insert(rest + key_of(i, readings[i])).second) continue;
      for (ContactMode& other : problem_.modes_of(static_cast<Index>(i), readings[i])) {
        if (!known_.insert(rest + key_of(i, other)).second) continue;
        std::swap(modes[i], other);
        waiting_.push_back(modes);
        std::swap(modes[i], other);
      }
    }
    walked_ += SpreadSettings::work_of_a_contact * static_cast<double>(modes.size());
  }

  /// The bounds over a face, once; its corners lead on.
  void study(const FaceModes& modes, bool lead_on) {
    if (!studied_.insert(key_of(modes)).second) return;
    std::vector<Face::Answer> corners;
    switch (study_->study(modes, most_work_ - walked_, corners)) {
    case FaceStudy::Result::studied: ++report_.faces; break;
    case FaceStudy::Result::failed: ++report_.failures; break;
    case FaceStudy::Result::out_of_work: ++report_.faces_left; break;
    case FaceStudy::Result::empty: break;
    }
    if (!lead_on) return;
    std::unordered_set<std::string> seen; // corners are met again and again
    for (const Face::Answer& corner : corners)
      if (seen.insert(corner_key(corner.z)).second) propose_adjacent_faces(corner);
  }

  void walk() {
    allow(options_.most_work, 1);
    const double before = work();
    for (const Path& path : paths_) // their own faces first
      propose(problem_.face_of(problem_.readings_at(path.moving.z, path.moving.push)));
    for (const Path& path : paths_) propose_adjacent_faces(path.moving);
    while (!waiting_.empty() && !is_used_up() && report_.faces < options_.most_faces) {
      const FaceModes next = std::move(waiting_.front());
      waiting_.pop_front();
      study(next, true);
      tell((work() - before) / options_.most_work);
    }
    report_.faces_left += static_cast<Index>(
        std::count_if(waiting_.begin(), waiting_.end(),
                      [&](const FaceModes& next) { return studied_.count(key_of(next)) == 0; }));
  }

  /// The work, or the seconds asked for, from now on; `part` of them.
  void allow(double more, double part) {
    most_work_ = options_.by_time ? std::numeric_limits<double>::infinity() : work() + more;
    part_of_time_ = options_.by_time ? part : 1;
    begun_ = reported_;
  }

  /// By the clock or by the user, whatever work is left.
  bool is_stopped() {
    const Stop stop = stop_now(options_.stop, part_of_time_);
    if (stop != Stop::none) report_.stop = stop;
    return stop != Stop::none;
  }

  bool is_used_up() { return work() > most_work_ || is_stopped(); }

  /// `share` of this stage, which is the rest, or of enumeration half of it.
  void tell(double share, double part = 1) {
    reported_ = std::max(reported_, begun_ + part * (1 - begun_) * std::min(share, 1.0));
    if (options_.progress) options_.progress(reported_);
  }

  void enumerate() {
    if (problem_.has_soft_points()) {
      report_.enumeration = "soft contacts have too many modes to enumerate";
      return;
    }
    const bool thorough = options_.enumeration == Enumeration::thorough;
    const double most = options_.most_work * (thorough ? SpreadSettings::thorough_factor : 1);
    const double before = work();
    allow(most, thorough ? 1 : SpreadSettings::part_of_time);
    const Index failures = report_.failures;
    bool given_up = false;
    ModeTree tree(problem_);
    tree.may_have_answers = [&](const FaceModes& part) { return study_->may_have_answers(part); };
    tree.leaf = [&](const FaceModes& modes) { study(modes, false); };
    tree.is_used_up = [&] {
      const double used = (work() - before) / most;
      tell(std::max(used, tree.share()), SpreadSettings::part_of_enumeration);
      // Branches are left sooner later on, so that the share grows faster than the work.
      const bool out_of_sight =
          used > SpreadSettings::judged_after && tree.share() < used * used / 2;
      given_up = given_up || is_used_up() || (out_of_sight && !thorough && !options_.by_time);
      return given_up;
    };
    tree.visit();
    report_.assignments = tree.assignments();
    if (given_up)
      report_.enumeration = report_.stop == Stop::signal ? "it was interrupted"
                            : report_.stop == Stop::time ? "the time was up"
                                                         : "the limit of work was reached";
    else if (report_.failures > failures)
      report_.enumeration = "some assignments of modes could not be settled";
    else
      report_.complete = true;
  }
};

} // namespace

double same_force(const SpreadReport& report) {
  return std::max(report.noise.force, SpreadSettings::same * report.scales.force);
}
double same_acceleration(const SpreadReport& report) {
  return std::max(report.noise.acceleration, SpreadSettings::same * report.motion);
}

SpreadReport find_spread(const SceneFile& file, const SpreadOptions& options) {
  return Search(file, options).run();
}

} // namespace lcpush::desktop
