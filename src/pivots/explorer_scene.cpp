#include "pivots/explorer.hpp"

#include "draw/marks.hpp"
#include "draw/view.hpp"
#include "formats/json_writer.hpp"
#include "lcpush/desktop/push.hpp"
#include "scenes/drawn_object.hpp"

namespace lcpush::desktop {
namespace {

void write_object(JsonWriter& json, const SceneFile& file) {
  const bool is_cylinder = file.shape.kind == ObjectShape::Kind::cylinder;
  json.member("title", file.title).member("planar", file.planar);
  json.member("gravity", file.gravity).member("mass", file.object.mass);
  json.member("center_of_mass", file.object.center_of_mass);
  json.key("shape").begin_object().member("kind", is_cylinder ? "cylinder" : "box");
  json.member("size", file.shape.size).member("axis", file.shape.axis).end_object();
  // In SI units: the scales of Layout, all 1.
  const Scene<double> scene = file.view();
  const Scales<double> units{file.object.mass, 1.0, 1.0};
  const Matrix6<double> mobility = laws::newton(scene, units) / file.object.mass;
  json.list("mobility", Index{6}, [&](Index i) { json.value(Vector6<double>(mobility.row(i))); });
  json.member("load", laws::load(scene, {1.0, 1.0, 1.0})).member("facets", file.facets);
}

void write_bodies(JsonWriter& json, const Push& push) {
  const Scene<double>& scene = push.scene();
  json.objects("bodies", scene.bodies.size, [&](Index b) {
    const Body<double>& body = scene.bodies[b];
    const Index of_file = push.file().body_of(body.first_point);
    json.member("name", push.file().body_name(of_file));
    json.member("role", body.role == Role::finger ? "finger" : "pusher");
    json.member("normal", body.normal).member("tangent", body.tangent);
    json.member("friction", body.friction).member("acceleration", body.acceleration);
    json.key("actuators").begin_array();
    for (const Drive<double>& drive : scene.drives) {
      if (drive.body != b) continue;
      json.begin_object().member("variable", push.layout().closing_index(drive.actuator));
      json.member("twist", drive.twist).end_object();
    }
    json.end_array();
  });
}

/// The plane alone, unless that shows a round object from its side.
std::vector<View> shown_views(const SceneFile& file) {
  const Vector3<double> in_plane(0, file.gravity.y(), 0);
  std::vector<View> views =
      two_views(file.planar ? in_plane : file.gravity, file.shape.size, file.bodies);
  const bool is_round_elsewhere =
      file.shape.kind == ObjectShape::Kind::cylinder && views[0].toward[file.shape.axis] == 0;
  if (file.planar && !is_round_elsewhere) views.resize(1);
  return views;
}

void write_points(JsonWriter& json, const Push& push, bool is_drawn) {
  const std::vector<Vector3<double>> drawn = drawn_positions(push.file());
  const Scene<double>& scene = push.scene();
  const Layout<double>& layout = push.layout();
  json.objects("points", layout.points, [&](Index i) {
    const ConeGroup<double>& cone = layout.cones[i];
    const Body<double>& body = scene.bodies[layout.body[i]];
    json.member("name", point_name(push.file(), i)).member("body", layout.body[i]);
    json.member("position", push.file().positions[static_cast<std::size_t>(i)]);
    if (is_drawn) json.member("drawn_at", drawn[static_cast<std::size_t>(i)]);
    const Index normal = layout.normal_index(i);
    json.member("normal", normal).member("pull", when(cone.normals == 2, normal + 1));
    json.list("friction", cone.generators,
              [&](Index j) { json.value(layout.friction_index(i, j)); });
    json.member("slip", when(cone.generators > 0, layout.slip_index(i)));
    json.objects("generators", cone.generators, [&](Index j) {
      const Generator<double> d = generator(body, j, scene.facets);
      json.member("force", d.force).member("torque", d.torque);
    });
  });
}

/// A body as a view shows it: its pad, corners as a place in metres with an offset in pixels, and
/// its friction cone for a normal force of 1 N.
void write_body_in_view(JsonWriter& json, const Push& push, const View& view, Index b) {
  const Scene<double>& scene = push.scene();
  const Body<double>& body = scene.bodies[b];
  const std::vector<Vector3<double>> drawn = drawn_positions(push.file());
  std::vector<Eigen::Vector4d> corners, pad;
  std::vector<Pixel> around, cone{Pixel::Zero()};
  // Which corners stand out does not depend on the scale: the pad is a sum of two convex sets.
  const double any_scale = 200 / push.file().shape.size.norm();
  for (Index i = body.first_point; i < body.first_point + body.point_count; ++i)
    for (const Pixel& offset : pad_rim(view, body.normal)) {
      const Pixel at = view.flat(drawn[static_cast<std::size_t>(i)]);
      corners.emplace_back(at.x(), at.y(), offset.x(), offset.y());
      around.emplace_back(any_scale * at + offset);
    }
  for (const std::size_t i : hull_corners(around)) pad.push_back(corners[i]);
  for (Index j = 0; j < push.layout().cones[body.first_point].generators; ++j)
    cone.push_back(
        -view.flat(body.normal + body.friction * generator(body, j, scene.facets).force));
  json.member("body", b).member("behind", view.is_behind(body.normal));
  json.member("pad", pad).member("cone", cone.size() > 1 ? hull(cone) : std::vector<Pixel>());
}

void write_view(JsonWriter& json, const Push& push, const View& view) {
  const SceneFile& file = push.file();
  json.member("title", view.title).member("axes", axes_elements(view));
  json.member("right", view.right).member("toward", view.toward);
  json.member("down", Vector3<double>(Vector3<double>::Zero() - view.up));
  std::vector<Pixel> box, shown;
  for (const auto& corner : box_corners(file.object.center_of_mass, file.shape.size))
    box.push_back(view.flat(corner));
  shown = box;
  for (const auto& position : drawn_positions(file)) shown.push_back(view.flat(position));
  const Frame frame = bounds(shown);
  json.member("frame", Eigen::Vector4d(frame.left, frame.top, frame.right, frame.bottom));
  json.member("outline", hull(box));
  json.member("radius",
              is_round_in(view, file.shape) ? std::abs(view.right.dot(file.shape.size)) / 2 : 0.0);
  json.objects("bodies", bodies_back_to_front(view, push.scene().bodies),
               [&](Index b) { write_body_in_view(json, push, view, b); });
}

/// What a contact does in a basis, its mark, and the words of the table and of the key.
struct ModeWords {
  const char* mode;
  Mark mark;
  const char *verb, *in_key;
};
constexpr ModeWords mode_words[] = {
    {"stick", Mark::square, "sticks", "sticks"},
    {"slide", Mark::triangle, "slips", "slips"},
    {"separate", Mark::ring, "opens", "opens"},
    {"touch", Mark::small_ring, "touches", "only touches"},
    {"sink", Mark::cross, "sinks in", "sinks in, while z0 > 0"},
};

/// What is drawn about the origin, to be moved where it belongs; and the key that explains it.
void write_marks(JsonWriter& json) {
  const auto small = [](const std::string& elements) { return sample("0 0 26 14", elements); };
  const auto arrow = [&](const char* kind) { return small(arrow_element(kind, {2, 7}, {25, 7})); };
  KeyItems key{{arrow("force normal"), "normal force"},
               {arrow("force friction"), "friction"},
               {arrow("motion"), "acceleration"},
               {small(polygon_element("cone", {{24, 7}, {4, 1}, {4, 13}})), "friction cone"}};
  const Pixel origin(0, 0);
  json.key("marks").begin_object();
  for (const ModeWords& words : mode_words) {
    json.member(words.mode, mark_element(words.mark, words.mode, origin));
    key.emplace_back(small(mark_element(words.mark, words.mode, {13, 7})), words.in_key);
  }
  key.emplace_back(sample("-17 -9 34 18", turning_center(origin)), "centre of turning");
  json.member("clockwise", turning_arc(origin, true));
  json.member("counterclockwise", turning_arc(origin, false));
  json.member("turning_center", turning_center(origin));
  json.member("into", sight_ring(origin, false)).member("out_of", sight_ring(origin, true));
  json.end_object().key("verbs").begin_object();
  for (const ModeWords& words : mode_words) json.member(words.mode, words.verb);
  json.end_object().member("key", key_html(key));
}

} // namespace

void write_scene(JsonWriter& json, const Push& push, bool draws) {
  json.begin_object();
  write_object(json, push.file());
  write_bodies(json, push);
  write_points(json, push, draws);
  if (draws) {
    json.objects("views", shown_views(push.file()),
                 [&](const View& view) { write_view(json, push, view); });
    write_marks(json);
    json.member("longest_force", longest_force).member("fastest", fastest);
  }
  json.end_object();
}

} // namespace lcpush::desktop
