#include "lcpush/desktop/spread.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <set>

#include "spread/spread_face.hpp"
#include "spread/spread_quantities.hpp"
#include "text/limits.hpp"

namespace lcpush::desktop {
namespace {

using Kind = ContactMode::Kind;
using Point = Eigen::VectorXd;

constexpr double equal_answers = 1e-7;    // of the scale of forces, or of motions
constexpr double enumeration_factor = 10; // work and faces that enumeration may take

class Search {
public:
  Search(const SceneFile& file, const SpreadOptions& options) : options_(options), problem_(file) {
    report_.scales = problem_.layout().scales;
    report_.contacts.resize(static_cast<std::size_t>(problem_.layout().points));
    for (Index b = 0; b < problem_.scene().bodies.size; ++b)
      if (problem_.scene().bodies[b].role == Role::pusher) report_.pushers.push_back({b, {}});
    quantities_ = list_quantities(problem_, report_);
  }

  SpreadReport run() {
    solve_covering_vectors();
    if (options_.enumerate) {
      most_faces_ = static_cast<Index>(enumeration_factor) * options_.most_faces;
      most_work_ = enumeration_factor * options_.most_work;
      enumerate();
    }
    if (!report_.complete) {
      most_faces_ = report_.faces + options_.most_faces;
      most_work_ = work_ + options_.most_work;
      walk();
    }
    if (report_.faces > 0 || report_.faces_left > 0 || report_.covering_vectors_solved > 0) {
      report_.status = Status::solved;
      conclude();
      return report_;
    }
    Push push(problem_.file());
    PushOptions options;
    options.lemke = options_.lemke;
    report_.failure = push.solve(options);
    report_.failure.answer = {}; // its arrays go with the Push
    report_.status = report_.failure.status == Status::solved ? Status::numerical_breakdown
                                                              : report_.failure.status;
    return report_;
  }

private:
  struct Waiting {
    FaceModes modes;
    Point z; // a point of the face
  };

  SpreadOptions options_;
  LiteralProblem problem_;
  SpreadReport report_;
  std::vector<Quantity> quantities_;
  std::set<FaceModes> known_, studied_;
  std::deque<Waiting> waiting_;
  std::map<FaceModes, bool> possible_;
  double work_ = 0, most_work_ = 0;
  Index most_faces_ = 0;

  void solve_covering_vectors() {
    const Index n = problem_.layout().size;
    OwnedLemke<double> lemke(n);
    Watcher nobody;
    for (Index k = 0; k < options_.covering_vectors; ++k) {
      LemkeOptions<double> options = options_.lemke;
      options.first_cover = k;
      options.covers = 1;
      ++report_.covering_vectors;
      Status status = lemke.init(problem_.problem(), options);
      if (status == Status::running)
        status = lemke.solve(options_.watcher != nullptr ? *options_.watcher : nobody);
      if (status != Status::solved) continue;
      const Point z = Eigen::Map<const Point>(lemke.z(), n);
      FaceModes modes = problem_.face_of(z, problem_.dense().w(z));
      if (!accept_if_checked(z, modes)) {
        ++report_.failures;
        continue;
      }
      ++report_.covering_vectors_solved;
      propose(std::move(modes), z);
    }
  }

  void propose(FaceModes modes, const Point& z) {
    if (known_.insert(modes).second) waiting_.push_back({std::move(modes), z});
  }

  /// The faces next to an answer on a known face: one contact does something else that it may be
  /// said to do there.
  void propose_adjacent_faces(const Point& z) {
    const Eigen::VectorXd w = problem_.dense().w(z);
    const FaceModes modes = problem_.face_of(z, w);
    propose(modes, z);
    for (std::size_t i = 0; i < modes.size(); ++i)
      for (const ContactMode& other : problem_.modes_at(static_cast<Index>(i), z, w)) {
        FaceModes next = modes;
        next[i] = other;
        propose(std::move(next), z);
      }
  }

  /// Takes z if the referee does.
  bool accept_if_checked(Point z, const FaceModes& modes) {
    problem_.complete(modes, z);
    const Answer<double>& answer = problem_.read(z);
    const Residuals<double> residuals =
        check(problem_.scene(), problem_.layout().scales, answer, 1.0);
    if (!problem_.passes(residuals)) return false;
    report_.residual = std::max(report_.residual, residuals.max());
    include(answer, problem_.scene(), report_);
    return true;
  }

  void study(const Waiting& waiting) {
    Face face(problem_, waiting.modes);
    work_ += 10 * std::pow(static_cast<double>(problem_.layout().size), 2);
    if (!face.start_at(waiting.z) || !accept_if_checked(waiting.z, waiting.modes)) {
      ++report_.failures;
      return;
    }
    propose_adjacent_faces(waiting.z);
    study_bounds(face, waiting.modes);
  }

  void study_bounds(Face& face, const FaceModes& modes) {
    if (!studied_.insert(modes).second) return;
    bool in_time = true;
    for (const Quantity& quantity : quantities_) {
      if (!face.varies(quantity.f)) continue;
      in_time = in_time && work_ + face.work() <= most_work_;
      for (const double sign : {1.0, -1.0})
        if (in_time) bound(face, modes, quantity, sign);
    }
    ++(in_time ? report_.faces : report_.faces_left);
    report_.programs += face.programs();
    work_ += face.work();
  }

  void bound(Face& face, const FaceModes& modes, const Quantity& quantity, double sign) {
    Point z;
    const Face::Point found = face.lowest(sign * quantity.f, z);
    const bool exists = found == Face::Point::found || found == Face::Point::unbounded;
    if (!exists || !accept_if_checked(z, modes)) {
      ++report_.failures;
      return;
    }
    if (found == Face::Point::unbounded) {
      (sign > 0 ? quantity.bounds->low : quantity.bounds->high) =
          -sign * std::numeric_limits<double>::infinity();
      return;
    }
    problem_.complete(modes, z);
    propose_adjacent_faces(z);
  }

  void walk() {
    while (!waiting_.empty() && !is_used_up()) {
      const Waiting next = std::move(waiting_.front());
      waiting_.pop_front();
      if (studied_.count(next.modes) == 0) study(next);
    }
    report_.faces_left += static_cast<Index>(
        std::count_if(waiting_.begin(), waiting_.end(),
                      [&](const Waiting& next) { return studied_.count(next.modes) == 0; }));
  }

  bool is_used_up() const { return report_.faces >= most_faces_ || work_ > most_work_; }

  void enumerate() {
    const Index points = problem_.layout().points;
    if (problem_.has_soft_points()) {
      report_.enumeration = "soft contacts have too many modes to enumerate";
      return;
    }
    if (points > limits::points_enumerated) {
      report_.enumeration = "more than " + std::to_string(limits::points_enumerated) +
                            " contact points have too many modes to enumerate";
      return;
    }
    FaceModes modes(static_cast<std::size_t>(points));
    const Index before = report_.failures;
    enumerate_modes_from(0, modes);
    if (is_used_up())
      report_.enumeration = "the limit of work was reached";
    else if (report_.failures > before)
      report_.enumeration = "some assignments of modes could not be settled";
    else
      report_.complete = true;
  }

  /// Has a face with these modes, signs alone where nothing is decided, a point? Remembered: the
  /// same pairs of modes come back in every branch.
  bool can_be(const FaceModes& part) {
    const auto known = possible_.find(part);
    if (known != possible_.end()) return known->second;
    Face face(problem_, part);
    const bool possible = face.find_point() != Face::Point::none;
    report_.programs += face.programs();
    work_ += face.work() + std::pow(static_cast<double>(problem_.layout().size), 3);
    possible_[part] = possible;
    return possible;
  }

  /// Does the mode of contact `next` go with each earlier one, taken by itself?
  bool goes_with_earlier(const FaceModes& modes, std::size_t next) {
    FaceModes pair(modes.size());
    pair[next] = modes[next];
    if (!can_be(pair)) return false;
    for (std::size_t i = 0; i < next; ++i) {
      pair[i] = modes[i];
      if (!can_be(pair)) return false;
      pair[i] = {};
    }
    return true;
  }

  /// Contact by contact, every mode; what has no point with signs alone for the rest is left.
  void enumerate_modes_from(std::size_t next, FaceModes& modes) {
    for (const ContactMode& mode : problem_.every_mode(static_cast<Index>(next))) {
      if (is_used_up()) return;
      modes[next] = mode;
      ++report_.assignments;
      if (!goes_with_earlier(modes, next)) continue;
      Face face(problem_, modes);
      const Face::Point point = face.find_point();
      work_ += face.work() + std::pow(static_cast<double>(problem_.layout().size), 3);
      if (point == Face::Point::none) continue;
      if (next + 1 < modes.size()) {
        enumerate_modes_from(next + 1, modes);
        continue;
      }
      // A face of a single point has no bounds to look for: the point itself is the answer.
      if (point == Face::Point::failed || !accept_if_checked(face.origin(), modes)) {
        ++report_.failures;
        continue;
      }
      study_bounds(face, modes);
    }
    modes[next] = {};
  }

  void conclude() {
    const double length = report_.scales.length;
    for (Index k = 0; k < 6; ++k) {
      const double lever = k < 3 ? 1 : length;
      for (const double x : {report_.twist[k].low, report_.twist[k].high})
        if (std::isfinite(x)) report_.motion = std::max(report_.motion, std::abs(x) * lever);
    }
    report_.motion = std::max(report_.motion, push_size(problem_.scene()));
    report_.verdict = verdict_on(report_);
  }
};

} // namespace

double same_force(const SpreadReport& report) { return equal_answers * report.scales.force; }
double same_acceleration(const SpreadReport& report) { return equal_answers * report.motion; }

SpreadReport find_spread(const SceneFile& file, const SpreadOptions& options) {
  return Search(file, options).run();
}

} // namespace lcpush::desktop
