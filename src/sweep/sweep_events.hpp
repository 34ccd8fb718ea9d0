// What happens along a sweep, as data that texts and pictures tell.
#pragma once

#include "lcpush/desktop/sweep.hpp"

namespace lcpush::desktop {

/// What a contact does from here on.
enum class ContactEvent { turns, takes_load, drops_load, separates, lands, sticks, grazes, slides };

/// Several contacts that do the same.
struct SharedEvent {
  ContactEvent event;
  Vector3<double> along; ///< of those that begin to slide: their direction, or zero
  std::vector<Index> contacts;
};

/// What is told of an AnswerChange.
struct ToldChange {
  AnswerChange::Kind kind = AnswerChange::Kind::modes;
  Status from = Status::solved, to = Status::solved;
  std::vector<SharedEvent> events;
  bool jumps = false;
  PathBreak path = PathBreak::none;

  /// The grasp holds the object from here on, or no longer does.
  bool turns_to(Status status) const { return from != to && to == status; }
  bool is_of_holding() const {
    return turns_to(Status::does_not_hold) ||
           (from == Status::does_not_hold && to == Status::solved);
  }
};

/// What happens to the push, to the instant of breaking, or to both alike.
struct SweepEvent {
  OfBoth<std::optional<double>> at; ///< the parameter's value; one of them may be missing
  std::vector<ToldChange> changes;
  bool jumps = false;

  /// Of breaking, if it happens there.
  double value() const { return at.breaking ? *at.breaking : *at.push; }
};

/// In the sweep's order. brief: what sticks, slides, opens, breaks or jumps; full: also friction
/// that turns, and forces that are shared in another way.
/// `List`: segments or points.
template <class List>
std::vector<SweepEvent> events_of(const Sweep& sweep, const List& list, Telling telling);

/// "at breaking: left.2 separates; the answer jumps", without its value.
std::string event_text(const Sweep& sweep, const SweepEvent& event);

} // namespace lcpush::desktop
