#include "plan/roadmap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

namespace lcpush::desktop {
namespace {

constexpr double far = std::numeric_limits<double>::infinity();
constexpr double wider = 0.4;        // of the object's size: beyond start and goal
constexpr double wider_angle = 0.35; // rad
constexpr double widest_slip = 1.4;  // rad, from the pusher's normal

} // namespace

/// The cheapest way to a place by a push of this pusher.
struct Roadmap::Label {
  double cost = far;
  std::size_t from = 0, pusher_before = 0;
};

Roadmap::Roadmap(const Pushing& pushing, const PlanarPose& start, const PlanarPose& goal,
                 const PlanarPose& near_enough)
    : pushing_(pushing), near_enough_(near_enough), places_{start, goal}, edges_(2) {
  const double by = wider * pushing.length();
  low_ = {std::min(start.x, goal.x) - by, std::min(start.y, goal.y) - by,
          std::min(start.angle, goal.angle) - wider_angle};
  high_ = {std::max(start.x, goal.x) + by, std::max(start.y, goal.y) + by,
           std::max(start.angle, goal.angle) + wider_angle};
  join(0, 1);
}

double Roadmap::drawn(double low, double high) {
  // The distributions of the standard library differ from one to the next.
  return low + (high - low) * static_cast<double>(random_()) / 4294967296.0;
}

/// None where the grip holds the object almost nowhere.
std::optional<PlanarPose> Roadmap::drawn_place() {
  constexpr int draws = 200;
  for (int k = 0; k < draws; ++k) {
    const PlanarPose place = {drawn(low_.x, high_.x), drawn(low_.y, high_.y),
                              drawn(low_.angle, high_.angle)};
    if (pushing_.holds(place)) return place;
  }
  return std::nullopt;
}

std::size_t Roadmap::chosen(std::size_t count) {
  return static_cast<std::size_t>(drawn(0, static_cast<double>(count)));
}

bool Roadmap::join(std::size_t from, std::size_t to) {
  const Arc arc(places_[from], places_[to]);
  const unsigned pushers = pushing_.sticking(arc);
  if (pushers != 0) edges_[from].push_back({to, pushers, pushing_.way(arc), std::nullopt});
  return pushers != 0;
}

void Roadmap::add_place() {
  const std::optional<PlanarPose> place = drawn_place();
  if (!place) return;
  places_.push_back(*place);
  edges_.emplace_back();
  join_to_all(places_.size() - 1);
}

void Roadmap::join_to_all(std::size_t added) {
  for (std::size_t k = 0; k < added; ++k) {
    if (k != 1) join(k, added);
    if (k != 0) join(added, k);
  }
}

void Roadmap::add_pushed() {
  const bool is_forward = random_() % 2 == 0;
  const std::vector<std::size_t> ends = is_forward ? reached() : leading();
  const std::size_t from = ends[chosen(ends.size())], pusher = chosen(pushing_.pushers());
  std::vector<double> shares;
  for (std::size_t k = 0; k < pushing_.edges(pusher); ++k)
    shares.push_back(-std::log(1 - drawn(0, 1)));
  const double way = drawn(0.05, 0.8) * pushing_.length();
  const PlanarPose place =
      pushing_.mixed(pusher, places_[from], shares, is_forward ? way : -way).at(1);
  if (!pushing_.holds(place)) return;
  const std::size_t added = places_.size();
  places_.push_back(place);
  edges_.emplace_back();
  if (is_forward ? join(from, added) : join(added, from)) {
    edges_[is_forward ? from : added].pop_back(); // it is found again with all others
    join_to_all(added);
  } else {
    places_.pop_back();
    edges_.pop_back();
  }
}

void Roadmap::add_slip(const Slide& slide, double speed) {
  const bool refines = nearest_slip_ && random_() % 2 == 0;
  Slip slip;
  std::size_t from = 0;
  if (refines) { // the one that came nearest to the goal, changed by as much as it missed it
    const double by = std::min(1.0, nearest_way_ / pushing_.length());
    from = nearest_from_;
    slip = *nearest_slip_;
    slip.velocity = turned(slip.velocity, by * drawn(-1, 1));
    slip.turn += by * drawn(-1, 1) * speed / pushing_.length();
    slip.time *= 1 + by * drawn(-1, 1) / 2;
  } else {
    const std::vector<std::size_t> starts = reached();
    from = starts[chosen(starts.size())];
    slip.pusher = chosen(pushing_.pushers());
    const Vector3<double> n =
        turned(pushing_.normal(slip.pusher), places_[from].angle + drawn(-1, 1) * widest_slip);
    slip.velocity = speed * n.head<2>();
    slip.turn = drawn(-1, 1) * speed / pushing_.length();
    slip.time = drawn(0.1, 0.5) * pushing_.length() / speed;
  }
  if (!pushing_.touches_whole(places_[from])) return; // no motion begins with points beside a face
  const std::optional<PlanarPose> end = slide(places_[from], slip);
  if (!end || !pushing_.holds(*end)) return;
  const Edge edge{0, 1U << slip.pusher, pushing_.way(Arc(places_[from], *end)), slip};
  const Arc missed(*end, places_[1]);
  if (const double way = pushing_.way(missed); way < nearest_way_) {
    nearest_way_ = way;
    nearest_from_ = from;
    nearest_slip_ = slip;
  }
  if (is_goal(*end)) {
    edges_[from].push_back(edge);
    edges_[from].back().to = 1;
    return;
  }
  if (refines) return;
  const std::size_t added = places_.size();
  places_.push_back(*end);
  edges_.emplace_back();
  edges_[from].push_back(edge);
  edges_[from].back().to = added;
  join_to_all(added);
}

bool Roadmap::is_goal(const PlanarPose& place) const {
  return (place_of(place) - place_of(places_[1])).norm() <= near_enough_.x &&
         std::abs(place.angle - places_[1].angle) <= near_enough_.angle;
}

// Dijkstra over places and the pusher that was used last.
std::vector<Roadmap::Label> Roadmap::labels() const {
  const std::size_t pushers = pushing_.pushers();
  std::vector<Label> label(places_.size() * pushers);
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const auto visit = [&](std::size_t from, std::size_t before, double cost) {
    for (const Edge& edge : edges_[from])
      for (std::size_t k = 0; k < pushers; ++k) {
        if ((edge.pushers >> k & 1U) == 0) continue;
        const double there = cost + edge.way + (k == before ? 0 : change_of_pusher);
        Label& next = label[edge.to * pushers + k];
        if (there >= next.cost) continue;
        next = {there, from, before};
        open.push({there, edge.to * pushers + k});
      }
  };
  visit(0, pushers, 0);
  while (!open.empty()) {
    const auto [cost, state] = open.top();
    open.pop();
    if (cost == label[state].cost) visit(state / pushers, state % pushers, cost);
  }
  return label;
}

std::optional<Legs> Roadmap::cheapest() const {
  const std::size_t pushers = pushing_.pushers();
  const std::vector<Label> label = labels();
  std::size_t place = 1, pusher = 0;
  for (std::size_t k = 0; k < pushers; ++k)
    if (label[pushers + k].cost < label[pushers + pusher].cost) pusher = k;
  Legs way;
  way.cost = label[pushers + pusher].cost;
  if (way.cost == far) return std::nullopt;
  while (pusher != pushers) {
    const Label& at = label[place * pushers + pusher];
    Leg leg{pusher, places_[at.from], places_[place], std::nullopt};
    for (const Edge& edge : edges_[at.from]) // a slipping push has its end for itself
      if (edge.to == place && edge.slip) leg.slip = edge.slip;
    way.list.push_back(leg);
    place = at.from;
    pusher = at.pusher_before;
  }
  std::reverse(way.list.begin(), way.list.end());
  return way;
}

std::vector<std::size_t> Roadmap::reached() const {
  const std::vector<Label> label = labels();
  const std::size_t pushers = pushing_.pushers();
  std::vector<std::size_t> list{0};
  for (std::size_t place = 1; place < places_.size(); ++place)
    for (std::size_t k = 0; k < pushers; ++k)
      if (label[place * pushers + k].cost < far) {
        list.push_back(place);
        break;
      }
  return list;
}

std::vector<std::size_t> Roadmap::leading() const {
  std::vector<std::size_t> list{1};
  std::vector<bool> leads(places_.size(), false);
  leads[1] = true;
  for (std::size_t known = 0; known < list.size(); ++known)
    for (std::size_t place = 0; place < places_.size(); ++place)
      for (const Edge& edge : edges_[place])
        if (edge.to == list[known] && !leads[place]) {
          leads[place] = true;
          list.push_back(place);
        }
  return list;
}

PlanarPose Roadmap::nearest_reached() const {
  std::size_t best = 0;
  const auto way = [&](std::size_t place) { return pushing_.way(Arc(places_[place], places_[1])); };
  for (const std::size_t place : reached())
    if (way(place) < way(best)) best = place;
  return places_[best];
}

std::optional<Legs> Roadmap::along(const std::vector<PlanarPose>& places) const {
  const std::size_t pushers = pushing_.pushers(), count = places.size();
  std::vector<double> cost(pushers, 0);
  std::vector<std::vector<std::size_t>> before;
  double way = 0;
  for (std::size_t i = 0; i + 1 < count; ++i) {
    const Arc arc(places[i], places[i + 1]);
    const unsigned sticking = pushing_.sticking(arc);
    if (sticking == 0) return std::nullopt;
    way += pushing_.way(arc);
    const std::size_t cheapest =
        static_cast<std::size_t>(std::min_element(cost.begin(), cost.end()) - cost.begin());
    std::vector<double> next(pushers, far);
    before.emplace_back(pushers, cheapest);
    for (std::size_t k = 0; k < pushers; ++k) {
      if ((sticking >> k & 1U) == 0) continue;
      const bool changes = i == 0 || cost[cheapest] + change_of_pusher < cost[k];
      next[k] = changes ? cost[cheapest] + change_of_pusher : cost[k];
      if (!changes) before.back()[k] = k;
    }
    cost = next;
  }
  Legs legs;
  std::size_t pusher =
      static_cast<std::size_t>(std::min_element(cost.begin(), cost.end()) - cost.begin());
  legs.cost = way + cost[pusher];
  for (std::size_t i = count - 1; i-- > 0;) {
    legs.list.push_back({pusher, places[i], places[i + 1], std::nullopt});
    pusher = before[i][pusher];
  }
  std::reverse(legs.list.begin(), legs.list.end());
  return legs;
}

Legs Roadmap::smoothed(Legs way, int tries) {
  for (const Leg& leg : way.list)
    if (leg.slip) return way; // what comes after begins where it ends
  for (int k = 0; k < tries && way.list.size() > 1; ++k) {
    std::vector<PlanarPose> places{way.list.front().from};
    for (const Leg& leg : way.list) places.push_back(leg.to);
    const auto at = static_cast<std::size_t>(drawn(1, static_cast<double>(places.size() - 1)));
    if (k % 4 == 0) {
      places.erase(places.begin() + static_cast<std::ptrdiff_t>(at));
    } else {
      // Nearer and nearer, and towards the straight way between its neighbours.
      const double spread =
          pushing_.length() * 0.5 * std::pow(0.02, static_cast<double>(k) / tries);
      const PlanarPose middle = Arc(places[at - 1], places[at + 1]).at(drawn(0, 1));
      const double pull = drawn(0, 0.5);
      PlanarPose& place = places[at];
      place.x += pull * (middle.x - place.x) + spread * drawn(-1, 1);
      place.y += pull * (middle.y - place.y) + spread * drawn(-1, 1);
      place.angle +=
          pull * (middle.angle - place.angle) + spread / pushing_.length() * drawn(-1, 1);
    }
    if (auto cheaper = along(places); cheaper && cheaper->cost < way.cost)
      way = std::move(*cheaper);
  }
  return way;
}

} // namespace lcpush::desktop
