#include "verify/trajectory_reader.hpp"

#include "formats/json_fields.hpp"
#include "lcpush/desktop/naming.hpp"
#include "lcpush/mechanics/model/contact.hpp"
#include "text/wording.hpp"
#include "verify/settings.hpp"

#include <algorithm>

namespace lcpush::desktop {
namespace {

void check_frame(const std::string& file, int line, const TrajectoryFrame& frame) {
  const Matrix3<double>& R = frame.pose.rotation;
  const Matrix3<double> off = R.transpose() * R - Matrix3<double>::Identity();
  if (!(off.cwiseAbs().maxCoeff() <= VerifySettings::rotation &&
        cross<double>(R.col(0), R.col(1)).dot(R.col(2)) > 0))
    throw InputError(file, line,
                     "the rotation is none: its rows are not orthonormal, beyond what four digits "
                     "leave open");
  if (frame.step && *frame.step < 0)
    throw InputError(file, line,
                     "step is the seconds of the step that ends here, >= 0, got " +
                         shown(*frame.step));
}

void check_frames(const std::string& file, const ReadFrames& read) {
  const std::vector<TrajectoryFrame>& frames = read.frames;
  if (frames.size() < 2) throw InputError(file, 1, "a motion needs two frames or more");
  if (frames.size() < 3 && !frames[0].twist) // the first step tells a speed, and is not judged
    throw InputError(file, 1, "without velocities a motion needs three frames or more");
  for (std::size_t k = 0; k < frames.size(); ++k) {
    check_frame(file, read.lines[k], frames[k]);
    if (k == 0) continue;
    const double interval = frames[k].time - frames[k - 1].time;
    if (!(interval > 0))
      throw InputError(file, read.lines[k],
                       "time must grow from frame to frame, got " + shown(frames[k].time) +
                           " after " + shown(frames[k - 1].time));
    if (frames[k].step.value_or(0) > interval * (1 + VerifySettings::interval))
      throw InputError(file, read.lines[k],
                       "step is " + shown(*frames[k].step) +
                           " s, longer than since the frame before: it is the seconds of the one "
                           "step that ends here, whose mean the forces are");
  }
}

/// Of a rotation in few digits.
Matrix3<double> nearest_rotation(Matrix3<double> R) {
  for (int k = 0; k < VerifySettings::rotation_rounds; ++k)
    R = (R * (3 * Matrix3<double>::Identity() - R.transpose() * R) / 2).eval();
  return R;
}

/// The last digit of all numbers, a power of ten; 0: they have many, are all smaller, or whole.
double last_digit(const std::vector<double>& numbers) {
  double largest = 0;
  bool is_whole = true;
  for (const double number : numbers) {
    largest = std::max(largest, std::abs(number));
    is_whole = is_whole && std::abs(number - std::round(number)) < VerifySettings::finest_digit;
  }
  if (is_whole) return 0;
  for (double digit = VerifySettings::coarsest_digit; digit >= VerifySettings::finest_digit;
       digit /= VerifySettings::decade) {
    if (largest < digit / 2) continue;
    const auto has_more = [digit](double number) {
      const double digits = number / digit;
      return std::abs(digits - std::round(digits)) > VerifySettings::rounded;
    };
    if (std::none_of(numbers.begin(), numbers.end(), has_more)) return digit;
  }
  return 0;
}

/// Reads one list of a frame. Entries belong to the places that their names say, or, if none has a
/// name, stand in the scene's order.
class NamedEntries {
public:
  NamedEntries(const JsonFields& fields, const JsonValue& frame, const char* key,
               const std::map<std::string, std::size_t, std::less<>>& places)
      : fields_(fields), key_(key), places_(places), list_(fields.objects(frame, key)) {}

  bool is_given() const { return list_ != nullptr; }

  template <class Read> void each(const Read& read) const {
    std::vector<bool> is_taken(places_.size());
    for (std::size_t k = 0; k < list_->size(); ++k) {
      const JsonValue& entry = (*list_)[k];
      const std::size_t place = place_of(entry, k);
      if (is_taken[place])
        fields_.refuse(entry, quoted(name_of(place)) + " stands twice in " + key_);
      is_taken[place] = true;
      read(place, entry);
    }
  }

private:
  std::size_t place_of(const JsonValue& entry, std::size_t k) const {
    const std::string name = fields_.text(entry, "name");
    if (name.empty() && list_->size() != places_.size())
      fields_.refuse(entry, quoted(key_) + " has " + std::to_string(list_->size()) +
                                " entries without names, the scene " +
                                std::to_string(places_.size()) + ": say \"name\" in each");
    if (name.empty()) return k;
    const auto at = places_.find(name);
    if (at != places_.end()) return at->second;
    std::vector<std::string> known;
    for (const auto& [other, place] : places_) known.push_back(other);
    fields_.refuse(entry,
                   quoted(key_) + ": the scene has no " + quoted(name) + suggestion(name, known));
  }
  std::string name_of(std::size_t place) const {
    return std::find_if(places_.begin(), places_.end(),
                        [&](const auto& entry) { return entry.second == place; })
        ->first;
  }

  const JsonFields& fields_;
  const char* key_;
  const std::map<std::string, std::size_t, std::less<>>& places_;
  const JsonArray* list_;
};

void read_forces(const JsonFields& fields, const JsonValue& entry, const PlacesByName& places,
                 TrajectoryFrame& frame) {
  frame.step = fields.number(entry, "step");
  const NamedEntries contacts(fields, entry, "contacts", places.contacts);
  if (contacts.is_given()) {
    // What is left out of the list presses nothing.
    const Vector3<double> none = Vector3<double>::Zero();
    frame.contacts.assign(places.contacts.size(), {0.0, none, 0.0, std::nullopt});
    contacts.each([&](std::size_t place, const JsonValue& value) {
      frame.contacts[place] = {fields.number(value, "normal_force"),
                               fields.vector<3>(value, "friction_force"),
                               fields.number(value, "torsion"), fields.number(value, "gap")};
    });
  }
  const NamedEntries bodies(fields, entry, "bodies", places.bodies);
  if (!bodies.is_given()) return;
  frame.bodies.resize(places.bodies.size());
  bodies.each([&](std::size_t place, const JsonValue& value) {
    frame.bodies[place] = {fields.vector<3>(value, "force"), fields.vector<3>(value, "moment"),
                           fields.number(value, "closing"), fields.number(value, "closing_speed")};
  });
}

/// Notes keys that a frame has not.
void note_strangers(const JsonValue& entry, std::vector<std::string>& unread) {
  constexpr const char* known[] = {"time",       "t",     "step",   "position", "rotation",
                                   "quaternion", "twist", "bodies", "contacts"};
  const JsonObject* const object = entry.as<JsonObject>();
  if (object == nullptr) return;
  for (const auto& [key, value] : *object)
    if (std::find(std::begin(known), std::end(known), key) == std::end(known) &&
        std::find(unread.begin(), unread.end(), key) == unread.end())
      unread.push_back(key);
}

} // namespace

PlacesByName::PlacesByName(const SceneFile& scene) {
  for (std::size_t b = 0; b < scene.body_names.size(); ++b) bodies[scene.body_names[b]] = b;
  for (std::size_t i = 0; i < scene.points.size(); ++i)
    contacts[point_name(scene, static_cast<Index>(i))] = i;
}

std::vector<std::string> PlacesByName::known() const {
  std::vector<std::string> names;
  for (const auto& [name, place] : bodies) names.push_back(name);
  for (const auto& [name, place] : contacts) names.push_back(name);
  return names;
}

Matrix3<double> rotation_of_rows(const std::vector<double>& r) {
  Matrix3<double> R;
  R << r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8];
  return R;
}

Matrix3<double> rotation_of_quaternion(const std::vector<double>& q) {
  const double norm = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  const double w = q[0] / norm, x = q[1] / norm, y = q[2] / norm, z = q[3] / norm;
  Matrix3<double> R;
  R << 1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y), 2 * (x * y + w * z),
      1 - 2 * (x * x + z * z), 2 * (y * z - w * x), 2 * (x * z - w * y), 2 * (y * z + w * x),
      1 - 2 * (x * x + y * y);
  return R;
}

ReadFrames frames_of_json(const std::string& text, const std::string& file,
                          const SceneFile& scene) {
  const JsonValue root = parse_json(text, file);
  const JsonFields fields(file);
  const JsonArray* const list = fields.objects(root, "frames");
  if (list == nullptr) fields.refuse(root, "no motion: give \"frames\": [{..}, ..]");
  const PlacesByName places(scene);
  ReadFrames read;
  for (const JsonValue& entry : *list) {
    note_strangers(entry, read.unread);
    TrajectoryFrame frame;
    const auto time = fields.number(entry, entry.find("time") != nullptr ? "time" : "t");
    const auto position = fields.vector<3>(entry, "position");
    const auto rotation = fields.numbers(entry, "rotation", 9),
               quaternion = fields.numbers(entry, "quaternion", 4);
    if (!time || !position)
      fields.refuse(entry, "a frame needs \"time\" and \"position\" [3], and if it turns "
                           "\"rotation\" [9] or \"quaternion\" [4], w first");
    frame.has_rotation = rotation || quaternion;
    if (!read.frames.empty() && frame.has_rotation != read.frames[0].has_rotation)
      fields.refuse(entry, "frames have rotations in all of them or in none");
    frame.time = *time;
    frame.pose.position = *position;
    if (frame.has_rotation)
      frame.pose.rotation =
          rotation ? rotation_of_rows(*rotation) : rotation_of_quaternion(*quaternion);
    read.places.insert(read.places.end(), position->begin(), position->end());
    for (const auto* const numbers : {&rotation, &quaternion})
      if (*numbers) read.turns.insert(read.turns.end(), (*numbers)->begin(), (*numbers)->end());
    frame.twist = fields.vector<6>(entry, "twist");
    read_forces(fields, entry, places, frame);
    read.frames.push_back(frame);
    read.lines.push_back(entry.line);
  }
  return read;
}

Trajectory parse_trajectory(const std::string& text, const std::string& file,
                            const SceneFile& scene) {
  constexpr std::string_view mark = "\xEF\xBB\xBF"; // of the byte order
  if (text.compare(0, mark.size(), mark) == 0)
    return parse_trajectory(text.substr(mark.size()), file, scene);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  const bool is_json = first != std::string::npos && text[first] == '{';
  ReadFrames read = is_json ? frames_of_json(text, file, scene) : frames_of_csv(text, file, scene);
  check_frames(file, read);
  for (TrajectoryFrame& frame : read.frames)
    frame.pose.rotation = nearest_rotation(frame.pose.rotation);
  return {std::move(read.frames), std::move(read.unread), last_digit(read.places),
          last_digit(read.turns)};
}

} // namespace lcpush::desktop
