#include "hold/give_way.hpp"

#include <algorithm>
#include <set>

#include "lcpush/desktop/naming.hpp"
#include "lcpush/mechanics/model/answer.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {
namespace {

/// The motion as a twist, [1; 1/m].
Vector6<double> twist_of(const GripStatics& statics, const Eigen::VectorXd& motion) {
  Vector6<double> twist = Vector6<double>::Zero();
  for (Index row = 0; row < statics.moving(); ++row) {
    const Index axis = statics.axis(row);
    twist[axis] = motion[row] / (axis < 3 ? 1 : statics.scales().length);
  }
  return twist;
}

/// What a contact does in a motion.
struct ContactMotion {
  double parts, slips; ///< how fast, along the normal and across it
};

ContactMotion motion_at(const GripStatics::Cone& cone, const Eigen::VectorXd& motion) {
  double slips = 0;
  for (Index k = 0; k < cone.directions.cols(); ++k) {
    const double along = cone.directions.col(k).dot(motion);
    slips = cone.is_round ? std::hypot(slips, along) : std::max(slips, along);
  }
  return {cone.normal.dot(motion), slips};
}

/// The bodies by what their contacts do, and the points that slip.
struct SortedContacts {
  std::set<Index> slips, opens, stays;
  std::vector<Index> slipping;

  void slip(Index body, Index point) {
    slips.insert(body);
    slipping.push_back(point);
  }

  bool any_moves() const { return !slips.empty() || !opens.empty(); }

  /// A body leaves where every point of it opens.
  GiveWay gives() const {
    GiveWay gives;
    gives.slips = {slips.begin(), slips.end()};
    gives.opens = {opens.begin(), opens.end()};
    for (const Index b : opens)
      if (stays.count(b) + slips.count(b) == 0) gives.leaves.push_back(b);
    return gives;
  }
};

/// Do the points that slip go one way, or around?
void read_slips(const SceneFile& file, const std::vector<Index>& points,
                const Vector6<double>& twist, GiveWay& gives) {
  Vector3<double> sum = Vector3<double>::Zero();
  double path = 0;
  for (const Index i : points) {
    const Body<double>& body = file.body(file.body_of(i));
    const Vector3<double>& n = body.normal;
    const Vector3<double> v = acceleration_at(file.points[static_cast<std::size_t>(i)], twist);
    const Vector3<double> slip = v - n.dot(v) * n;
    sum += slip;
    path += slip.norm() + body.torsion_radius * std::abs(n.dot(twist.tail<3>()));
  }
  const Vector3<double> axis = twist.tail<3>();
  const double slide = sum.norm() / static_cast<double>(points.size());
  gives.slides_too = sum.norm() > path / 2 && axis.norm() * object_size(file) / 2 > slide / 2;
  gives.turns = gives.slides_too || !(sum.norm() > path / 2);
  const Vector3<double>& along = gives.turns ? axis : sum;
  if (along.norm() > 0) gives.along = along.normalized();
}

void read_way(const SceneFile& file, const std::vector<Index>& slipping,
              const Vector6<double>& twist, double length, GiveWay& gives) {
  if (!slipping.empty()) return read_slips(file, slipping, twist, gives);
  const double turn = length * twist.tail<3>().norm();
  gives.turns = turn > twist.head<3>().norm() / 2;
  const Vector3<double> along = gives.turns ? twist.tail<3>() : twist.head<3>();
  if (along.norm() > 0) gives.along = along.normalized();
}

} // namespace

GiveWay read_motion(const SceneFile& file, const GripStatics& statics,
                    const Eigen::VectorXd& motion,
                    const std::vector<StaticsProgram::Contact>& contacts) {
  double fastest = 0;
  for (const GripStatics::Cone& cone : statics.cones()) {
    const ContactMotion there = motion_at(cone, motion);
    fastest = std::max({fastest, there.parts, there.slips});
  }
  SortedContacts sorted;
  for (std::size_t c = 0; c < statics.cones().size(); ++c) {
    const GripStatics::Cone& cone = statics.cones()[c];
    const ContactMotion there = motion_at(cone, motion);
    const Index b = file.body_of(cone.point);
    // Where forces are open, one of many is known: a contact at its cone's edge may have some.
    const double lifts = there.parts - file.body(b).friction * there.slips;
    const bool is_at_edge = there.parts > statics_settings.slips * fastest &&
                            std::abs(lifts) <= statics_settings.slips * fastest;
    const bool presses =
        contacts.empty() || contacts[c].normal > statics_settings.slips || is_at_edge;
    if (presses && there.slips > statics_settings.slips * fastest)
      sorted.slip(b, cone.point);
    else
      (!presses && there.parts > statics_settings.slips * fastest ? sorted.opens : sorted.stays)
          .insert(b);
  }
  GiveWay gives = sorted.gives();
  for (const Drive<double>& drive : file.drives) {
    const Index row = statics.moving() + drive.actuator;
    if (!sorted.any_moves() && row < statics.sum_row() && motion[row] < 0)
      gives.yields.push_back(drive.body);
  }
  read_way(file, sorted.slipping, twist_of(statics, motion), statics.scales().length, gives);
  return gives;
}

std::optional<GiveWay> read_fall(const SceneFile& hand, const PushOptions& options) {
  Push push(hand);
  const HoldReport rest = push.holds_without_push(options);
  if (rest.status != Status::solved || rest.holds) return std::nullopt;
  const Answer<double>& answer = push.last_answer();
  double fastest = 0;
  for (Index i = 0; i < answer.contacts.size; ++i)
    fastest = std::max(
        {fastest, answer.contacts[i].acceleration.norm(),
         acceleration_at(hand.points[static_cast<std::size_t>(i)], answer.acceleration).norm()});
  SortedContacts sorted;
  for (Index i = 0; i < answer.contacts.size; ++i) {
    const ContactAnswer<double>& contact = answer.contacts[i];
    const Index b = hand.body_of(i); // even pressure gives each point a body of its own
    const Vector3<double>& n = hand.body(b).normal;
    const double parts = contact.acceleration.dot(n),
                 slip = (contact.acceleration - parts * n).norm() +
                        hand.body(b).torsion_radius * std::abs(contact.spin);
    if (contact.normal_force > 0 && slip > statics_settings.slips * fastest)
      sorted.slip(b, i);
    else
      (parts > statics_settings.slips * fastest ? sorted.opens : sorted.stays).insert(b);
  }
  GiveWay gives = sorted.gives();
  for (Index b = 0; b < static_cast<Index>(hand.bodies.size()); ++b)
    if (!sorted.any_moves() && mean_closing(answer, hand.body(b)) < 0) gives.yields.push_back(b);
  if (!sorted.any_moves() && gives.yields.empty()) return std::nullopt; // none presses
  read_way(hand, sorted.slipping, answer.acceleration, rest.length, gives);
  return gives;
}

std::string give_way_words(const SceneFile& file, const GiveWay& gives, const std::string& given) {
  const auto names = [&](const std::vector<Index>& bodies) {
    std::vector<std::string> list;
    for (const Index b : bodies) list.push_back(file.body_name(b));
    return listed(list, "and");
  };
  const std::string way =
      !given.empty() ? given : (gives.turns ? "about " : "along ") + direction_text(gives.along);
  std::vector<Index> left; // by what does not press by itself, as a table
  for (const Index b : gives.opens)
    if (!(file.body(b).preload > 0) && !is_driven(file.view(), b)) left.push_back(b);
  if (gives.turns && !left.empty()) {
    std::vector<Index> slips;
    for (const Index b : gives.slips)
      if (std::count(left.begin(), left.end(), b) == 0) slips.push_back(b);
    return "tips it, and it parts from " + names(left) +
           (slips.empty() ? "" : " and slips over " + names(slips));
  }
  if (!gives.slips.empty()) {
    const bool patches = std::all_of(gives.slips.begin(), gives.slips.end(), [&](Index b) {
      return file.body(b).point_count > 1 || file.body(b).torsion_radius > 0;
    });
    const bool pads = patches && std::all_of(gives.slips.begin(), gives.slips.end(), [&](Index b) {
                        return file.body(b).preload > 0 || is_driven(file.view(), b);
                      });
    if (gives.slides_too) return "turns it " + way + " and slides it over " + names(gives.slips);
    if (gives.turns)
      return "turns it " + way +
             (pads ? " in the pads" : (patches ? " on " : " over ") + names(gives.slips));
    return "slides it " + way + " over " + names(gives.slips);
  }
  if (!gives.opens.empty())
    return (gives.turns ? "tips it, and it parts from " : "lifts it off ") + names(gives.opens);
  if (!gives.yields.empty()) return "pushes back " + names(gives.yields);
  if (gives.along.isZero(0)) return "is more than its pads bear"; // statics knows no limit
  return (gives.turns ? "turns it " : "moves it ") + way;
}

} // namespace lcpush::desktop
