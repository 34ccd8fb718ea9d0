#include "play/picture_request.hpp"

#include "formats/json_fields.hpp"

#include <cmath>

namespace lcpush::desktop {
namespace {

const std::string look_name = "look";

struct LookReader {
  JsonFields fields{look_name};

  template <int n> Eigen::Matrix<double, n, 1> needed(const JsonValue& object, const char* key) {
    const auto vector = fields.vector<n>(object, key);
    if (!vector) fields.refuse(object, quoted(key) + " is missing");
    return *vector;
  }
  Pose<double> pose(const JsonValue& object, const char* matrix) {
    Pose<double> pose;
    pose.position = needed<3>(object, "position");
    pose.rotation = Eigen::Map<const Matrix3<double>>(needed<9>(object, matrix).data());
    return pose;
  }
  Moment::Pressing pressing(const JsonValue& body) {
    return {pose(body, "columns"), needed<3>(body, "middle"), needed<3>(body, "normal"),
            needed<3>(body, "force"), fields.number(body, "normal_force")};
  }
  Moment moment(const JsonValue& object) {
    Moment moment;
    moment.object = pose(object, "rotation");
    moment.object.rotation.transposeInPlace(); // it is given row by row
    moment.most_force = fields.number(object, "most_force").value_or(0);
    if (const JsonArray* const bodies = fields.objects(object, "bodies"); bodies != nullptr)
      for (const JsonValue& body : *bodies) moment.bodies.push_back(pressing(body));
    const std::vector<double> path =
        fields.numbers(object, "path", -1).value_or(std::vector<double>());
    for (std::size_t k = 0; k + 3 <= path.size(); k += 3)
      moment.path.emplace_back(path[k], path[k + 1], path[k + 2]);
    return moment;
  }
};

} // namespace

PictureRequest read_picture_request(std::string_view text) {
  const JsonValue value = parse_json(text, look_name);
  LookReader reader;
  PictureRequest look;
  if (const JsonValue* const full = value.find("full"); full != nullptr && full->as<bool>())
    look.in_full = *full->as<bool>();
  look.view = reader.fields.text(value, "view");
  if (look.view.empty()) {
    look.right = reader.needed<3>(value, "right");
    look.up = reader.needed<3>(value, "up");
  }
  look.meters = reader.fields.number(value, "meters").value_or(look.meters);
  look.letter = reader.fields.number(value, "letter").value_or(look.letter);
  if (const JsonArray* const dots = reader.fields.objects(value, "dots"); dots != nullptr)
    for (const JsonValue& dot : *dots)
      look.dots.push_back({reader.needed<3>(dot, "at"), reader.fields.text(dot, "kind"),
                           reader.fields.text(dot, "words")});
  if (const JsonValue* const moment = value.find("moment"); moment != nullptr)
    look.moment = reader.moment(*moment);
  return look;
}

} // namespace lcpush::desktop
