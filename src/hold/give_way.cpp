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

std::vector<Index> listed_bodies(const std::set<Index>& bodies) {
  return {bodies.begin(), bodies.end()};
}

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
  gives.turns = !(sum.norm() > path / 2);
  const Vector3<double> axis = twist.tail<3>();
  const Vector3<double>& along = gives.turns ? axis : sum;
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
  std::set<Index> slips, opens, stays;
  std::vector<Index> slipping;
  for (std::size_t c = 0; c < statics.cones().size(); ++c) {
    const GripStatics::Cone& cone = statics.cones()[c];
    const ContactMotion there = motion_at(cone, motion);
    const Index b = file.body_of(cone.point);
    const bool presses = contacts.empty() || contacts[c].normal > statics_settings.slips;
    if (presses && there.slips > statics_settings.slips * fastest) {
      slips.insert(b);
      slipping.push_back(cone.point);
    } else if (!presses && there.parts > statics_settings.slips * fastest) {
      opens.insert(b);
    } else {
      stays.insert(b);
    }
  }
  GiveWay gives;
  gives.slips = listed_bodies(slips);
  gives.opens = listed_bodies(opens);
  for (const Index b : opens)
    if (stays.count(b) + slips.count(b) == 0) gives.leaves.push_back(b);
  for (const Drive<double>& drive : file.drives) {
    const Index row = statics.moving() + drive.actuator;
    if (slips.empty() && opens.empty() && row < statics.sum_row() && motion[row] < 0)
      gives.yields.push_back(drive.body);
  }
  const Vector6<double> twist = twist_of(statics, motion);
  if (!slipping.empty()) {
    read_slips(file, slipping, twist, gives);
  } else {
    const double turn = statics.scales().length * twist.tail<3>().norm();
    gives.turns = turn > twist.head<3>().norm() / 2;
    const Vector3<double> along = gives.turns ? twist.tail<3>() : twist.head<3>();
    if (along.norm() > 0) gives.along = along.normalized();
  }
  return gives;
}

std::string give_way_words(const SceneFile& file, const GiveWay& gives) {
  const auto names = [&](const std::vector<Index>& bodies) {
    std::vector<std::string> list;
    for (const Index b : bodies) list.push_back(file.body_name(b));
    return listed(list, "and");
  };
  const std::string way = direction_text(gives.along);
  if (!gives.slips.empty()) {
    const bool patches = std::all_of(gives.slips.begin(), gives.slips.end(), [&](Index b) {
      return file.body(b).point_count > 1 || file.body(b).torsion_radius > 0;
    });
    const bool pads = patches && std::all_of(gives.slips.begin(), gives.slips.end(), [&](Index b) {
                        return file.body(b).preload > 0 || is_driven(file.view(), b);
                      });
    if (gives.turns)
      return "turns it about " + way +
             (pads ? " in the pads" : (patches ? " on " : " over ") + names(gives.slips));
    return "slides it along " + way + " over " + names(gives.slips);
  }
  if (!gives.opens.empty())
    return (gives.turns ? "tips it, and it parts from " : "lifts it off ") + names(gives.opens);
  if (!gives.yields.empty()) return "pushes back " + names(gives.yields);
  if (gives.along.isZero(0)) return "is more than its pads bear"; // statics knows no limit
  return (gives.turns ? "turns it about " : "moves it along ") + way;
}

} // namespace lcpush::desktop
