// Places between a start and a goal, joined by pushes that stick.
#pragma once

#include "plan/pushing.hpp"

#include <functional>
#include <limits>
#include <random>

namespace lcpush::desktop {

/// A push in which the object slips over the pusher.
struct Slip {
  std::size_t pusher;
  Planar velocity; ///< m/s, of the pusher where the object's centre of mass is at the begin
  double turn;     ///< rad/s
  double time;     ///< s
};
/// Where the object then ends up, if anywhere.
using Slide = std::function<std::optional<PlanarPose>(const PlanarPose& from, const Slip& slip)>;

/// One push of a plan under way.
struct Leg {
  std::size_t pusher;
  PlanarPose from, to;
  std::optional<Slip> slip; ///< none: it sticks
};
struct Legs {
  std::vector<Leg> list;
  double cost = 0;
};

class Roadmap {
public:
  /// `near_enough`: a slipping push that ends within x and angle of the goal has reached it.
  Roadmap(const Pushing& pushing, const PlanarPose& start, const PlanarPose& goal,
          const PlanarPose& near_enough);

  /// Adds one place, drawn at random, and joins it to all others.
  void add_place();
  /// Adds the place where a sticking push drawn at random leads from one that is reached, or comes
  /// from to one that leads to the goal; none if that does not stick.
  void add_pushed();
  /// Adds the place where a push drawn at random ends, which may slip; or tries one beside that
  /// which came nearest to the goal.
  void add_slip(const Slide& slide, double speed);
  /// The cheapest way from the start to the goal; none: no way yet.
  std::optional<Legs> cheapest() const;
  /// The same way with its turning places moved, as often as asked, to where it is cheaper.
  Legs smoothed(Legs way, int tries);
  /// Of all places that are reached from the start, the one nearest to the goal.
  PlanarPose nearest_reached() const;

private:
  struct Edge {
    std::size_t to;
    unsigned pushers;
    double way;
    std::optional<Slip> slip;
  };
  const Pushing& pushing_;
  PlanarPose near_enough_;
  std::vector<PlanarPose> places_; ///< the start, the goal, others
  std::vector<std::vector<Edge>> edges_;
  std::mt19937 random_{2018};
  PlanarPose low_, high_;
  std::optional<Slip> nearest_slip_; ///< to the goal: from where, and by how much it missed it
  std::size_t nearest_from_ = 0;
  double nearest_way_ = std::numeric_limits<double>::infinity();

  double drawn(double low, double high);
  std::optional<PlanarPose> drawn_place();
  std::size_t chosen(std::size_t count);
  bool is_goal(const PlanarPose& place) const;
  bool join(std::size_t from, std::size_t to);
  void join_to_all(std::size_t added);
  /// The cheapest pushers along these places, if all legs stick.
  std::optional<Legs> along(const std::vector<PlanarPose>& places) const;
  struct Label;
  std::vector<std::size_t> reached() const;
  std::vector<std::size_t> leading() const; ///< to the goal, by sticking pushes
  std::vector<Label> labels() const;
};

} // namespace lcpush::desktop
