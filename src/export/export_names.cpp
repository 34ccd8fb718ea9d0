// What every column and row of an export is: name, symbol, contact, law, SI unit and scale.
#include <cmath>

#include "export/export_parts.hpp"
#include "formats/json_writer.hpp"

namespace lcpush::desktop {
namespace {

struct Quantity {
  std::string name, symbol, contact, law, unit; ///< contact and law may be empty
  double scale;                                 ///< SI value = value in the files times this
};

const char* const axes[] = {"+x", "+y", "+z"};
const char* const twist_symbols[] = {"ax", "ay", "az", "rx", "ry", "rz"};
const char* const components[] = {"n", "t", "o", "spin"};

class Names {
public:
  Names(const Push& push, const OwnedFullForm& full)
      : push_(push), form_(full.form()), assembly_(full.assembly()), layout_(assembly_.layout()),
        scene_(assembly_.scene()) {}

  std::vector<Quantity> unknowns() const {
    std::vector<Quantity> all;
    for (Index i = 0; i < layout_.size; ++i) all.push_back(reduced_unknown(i));
    for (Index k = 0; k < 6; ++k) {
      const std::string name =
          k < 3 ? "acceleration of the object along " : "angular acceleration of the object about ";
      all.push_back({name + axes[k % 3], twist_symbols[k], "", "", motion_unit(k >= 3),
                     motion_scale(k >= 3)});
    }
    each_component([&](Index point, Index c) {
      all.push_back({component_name(point, c), std::string("r_") + components[c],
                     point_name(push_.file(), point), "", motion_unit(c == 3),
                     motion_scale(c == 3)});
    });
    return all;
  }

  /// Of M x + q of the full form: first those of A, then those of Aeq.
  std::vector<Quantity> rows() const {
    std::vector<Quantity> all;
    for (Index i = 0; i < layout_.size; ++i) all.push_back(reduced_row(i));
    for (Index k = 0; k < 6; ++k) all.push_back(newton_row(k));
    each_component([&](Index point, Index c) {
      const Body<double>& body = scene_.bodies[layout_.body[point]];
      const PatchReferences<double>& patch = form_.patch(layout_.body[point]);
      const bool refers = patch.reference_of(point - body.first_point) >= 0;
      all.push_back({component_name(point, c) + (refers ? " follows from the object's"
                                                        : " follows the patch's references"),
                     std::string("r_") + components[c], point_name(push_.file(), point),
                     refers ? "[P.10]" : "[T.6]", motion_unit(c == 3), motion_scale(c == 3)});
    });
    return all;
  }

  std::vector<Quantity> answer() const {
    std::vector<Quantity> all;
    for (Index k = 0; k < 6; ++k)
      all.push_back({"object.acceleration", twist_symbols[k], "", "", motion_unit(k >= 3), 1});
    for (Index a = 0; a < layout_.actuators; ++a)
      all.push_back({"closing", "s", "", "", closing_unit(a), 1});
    for (Index i = 0; i < layout_.points; ++i) {
      const std::string contact = point_name(push_.file(), i);
      all.push_back({"normal_force", "lambda", contact, "", "N", 1});
      for (const char* axis : {"x", "y", "z"})
        all.push_back({"friction_force", axis, contact, "", "N", 1});
      all.push_back({"torsion", "n", contact, "", "N m", 1});
      for (const char* axis : {"x", "y", "z"})
        all.push_back({"acceleration", axis, contact, "", "m/s^2", 1});
    }
    return all;
  }

private:
  const Push& push_;
  const FullForm<double>& form_;
  const Assembly<double>& assembly_;
  const Layout<double>& layout_;
  const Scene<double>& scene_;

  template <class Use> void each_component(const Use& use) const {
    for (Index i = 0; i < layout_.points; ++i)
      for (Index c = 0; c < contact_components(scene_.bodies[layout_.body[i]]); ++c) use(i, c);
  }

  const char* motion_unit(bool turns) const { return turns ? "rad/s^2" : "m/s^2"; }
  double motion_scale(bool turns) const {
    return layout_.scales.acceleration / (turns ? layout_.scales.length : 1);
  }

  /// Does a unit of it move each body that it drives by 1 m, without a turn?
  bool moves_by_metres(Index actuator) const {
    for (const Drive<double>& drive : scene_.drives)
      if (drive.actuator == actuator &&
          (std::abs(drive.twist.head<3>().norm() - 1) > 1e-12 || !drive.twist.tail<3>().isZero(0)))
        return false;
    return true;
  }
  const char* closing_unit(Index actuator) const {
    return moves_by_metres(actuator) ? "m/s^2" : "1/s^2";
  }
  const char* force_unit(Index actuator) const { return moves_by_metres(actuator) ? "N" : "J"; }

  std::string component_name(Index point, Index c) const {
    const Body<double>& body = scene_.bodies[layout_.body[point]];
    const Vector3<double> axis[] = {body.normal, body.tangent, cross(body.normal, body.tangent)};
    const std::string of = " of " + point_name(push_.file(), point);
    if (c == 3) return "spin" + of + " about n";
    return "acceleration" + of + " along " + components[c] + " = " + direction_text(axis[c]);
  }

  std::string symbol(const Name& name) const {
    switch (name.meaning) {
    case Meaning::normal: return "lambda";
    case Meaning::pull: return "lambda-";
    case Meaning::friction: return "beta" + std::to_string(name.generator);
    case Meaning::slip: return "xi";
    case Meaning::closing: break;
    }
    return "s";
  }

  std::string contact(const Name& name) const {
    return name.meaning == Meaning::closing ? "" : point_name(push_.file(), name.of);
  }

  Quantity reduced_unknown(Index i) const {
    const Name name = name_of(layout_, i);
    const bool closes = name.meaning == Meaning::closing, slips = name.meaning == Meaning::slip;
    return {push_.variable_name(i),
            symbol(name),
            contact(name),
            "",
            closes  ? closing_unit(name.of)
            : slips ? "m/s^2"
                    : "N",
            unknown_unit(layout_, i)};
  }

  Quantity reduced_row(Index i) const {
    const Name name = name_of(layout_, i);
    const std::string of = contact(name);
    const double scale = row_unit(layout_, i);
    switch (name.meaning) {
    case Meaning::normal: return {"separation of " + of, "n'r", of, "[T.2]", "m/s^2", scale};
    case Meaning::pull: return {"approach of " + of, "-n'r", of, "[T.2]", "m/s^2", scale};
    case Meaning::friction:
      return {"slip of " + of + " minus the motion" + against(name),
              "d" + std::to_string(name.generator) + "'r + xi",
              of,
              "[T.3]",
              "m/s^2",
              scale};
    case Meaning::slip:
      return {"friction left unused in the cone of " + of,
              "mu lambda - sum beta",
              of,
              "[T.4]",
              "N",
              scale};
    case Meaning::closing: break;
    }
    return {"force of " + push_.actuator_name(name.of) + " beyond its set force",
            "J'f + m_a s - tau",
            "",
            "[T.5]",
            force_unit(name.of),
            scale};
  }

  /// The motion that a generator acts against.
  std::string against(const Name& name) const {
    const Body<double>& body = scene_.bodies[layout_.body[name.of]];
    const Generator<double> d = generator(body, name.generator, scene_.facets);
    return generator_text({-d.force, -d.torque}, body.torsion_radius);
  }

  Quantity newton_row(Index k) const {
    const std::string axis = axes[k % 3];
    if (scene_.planar && k >= 2 && k <= 4)
      return {k == 2 ? "no motion along +z: planar" : "no turn about " + axis + ": planar",
              twist_symbols[k],
              "",
              "[T.1]",
              motion_unit(k >= 3),
              motion_scale(k >= 3)};
    const Scales<double>& scales = layout_.scales;
    if (k < 3)
      return {"force balance along " + axis, "Ma - w - Gf", "", "[T.1]", "N", scales.force};
    return {"moment balance about " + axis, "Ma - w - Gf", "", "[T.1]", "N m",
            scales.force * scales.length};
  }
};

/// One array; `count` of them from `first` on, numbered from 1.
void write_quantities(JsonWriter& json, const char* key, const std::vector<Quantity>& all,
                      std::size_t first, std::size_t end) {
  json.objects(key, static_cast<Index>(end - first), [&](Index i) {
    const Quantity& q = all[first + static_cast<std::size_t>(i)];
    json.member("index", i + 1).member("name", q.name).member("symbol", q.symbol);
    json.member("contact", unless_empty(q.contact)).member("law", unless_empty(q.law));
    json.member("unit", q.unit).member("scale", q.scale);
  });
}

} // namespace

std::string export_names(const Push& push, const OwnedFullForm& full) {
  const Names names(push, full);
  const Layout<double>& layout = push.layout();
  const auto complementary = static_cast<std::size_t>(full.complementary());
  JsonWriter json;
  json.begin_object().member("title", push.file().title);
  json.member("complementary", full.complementary()).member("lcp_unknowns", layout.size);
  json.member("no_bound", no_bound);
  json.key("contacts").begin_array();
  for (Index i = 0; i < layout.points; ++i) json.value(point_name(push.file(), i));
  json.end_array().key("actuators").begin_array();
  for (Index a = 0; a < layout.actuators; ++a) json.value(push.actuator_name(a));
  json.end_array();
  const std::vector<Quantity> unknowns = names.unknowns(), rows = names.rows(),
                              answer = names.answer();
  write_quantities(json, "unknowns", unknowns, 0, unknowns.size());
  write_quantities(json, "A", rows, 0, complementary);
  write_quantities(json, "Aeq", rows, complementary, rows.size());
  write_quantities(json, "answer", answer, 0, answer.size());
  return json.end_object().text();
}

} // namespace lcpush::desktop
