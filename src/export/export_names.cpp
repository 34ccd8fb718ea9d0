// What every column and row of an export is: name, symbol, contact, law, SI unit and scale.
#include <cmath>

#include "export/export_parts.hpp"
#include "formats/json_writer.hpp"

namespace lcpush::desktop {
namespace {

struct Unit {
  const char* name;
  double scale; ///< SI value = value in the files times this
};

struct Quantity {
  std::string name, symbol, contact, law; ///< contact and law may be empty
  Unit unit;
};

const char* const signed_axes[] = {"+x", "+y", "+z"};
const char* const twist_symbols[] = {"ax", "ay", "az", "rx", "ry", "rz"};
const char* const row_names[] = {"n", "t", "o", "spin"};

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
      all.push_back({name + signed_axes[k % 3], twist_symbols[k], "", "", motion(k >= 3)});
    }
    for_each_component([&](Index point, Index c) { all.push_back(component(point, c, "", "")); });
    return all;
  }

  /// Of M x + q of the full form: first those of A, then those of Aeq.
  std::vector<Quantity> rows() const {
    std::vector<Quantity> all;
    for (Index i = 0; i < layout_.size; ++i) all.push_back(reduced_row(i));
    for (Index k = 0; k < 6; ++k) all.push_back(newton_row(k));
    for_each_component([&](Index point, Index c) {
      const Index first = scene_.bodies[layout_.body[point]].first_point;
      const bool refers = form_.patch(layout_.body[point]).reference_of(point - first) >= 0;
      all.push_back(refers ? component(point, c, " follows from the object's", "[P.10]")
                           : component(point, c, " follows the patch's references", "[T.6]"));
    });
    return all;
  }

  std::vector<Quantity> answer() const {
    std::vector<Quantity> all;
    for (Index k = 0; k < 6; ++k)
      all.push_back({"object.acceleration", twist_symbols[k], "", "", {motion(k >= 3).name, 1}});
    for (Index a = 0; a < layout_.actuators; ++a)
      all.push_back({"closing", "s", "", "", {closing_unit(a), 1}});
    for (Index i = 0; i < layout_.points; ++i) {
      const std::string contact = point_name(push_.file(), i);
      all.push_back({"normal_force", "lambda", contact, "", {"N", 1}});
      for (const char* axis : {"x", "y", "z"})
        all.push_back({"friction_force", axis, contact, "", {"N", 1}});
      all.push_back({"torsion", "n", contact, "", {"N m", 1}});
      for (const char* axis : {"x", "y", "z"})
        all.push_back({"acceleration", axis, contact, "", {"m/s^2", 1}});
    }
    return all;
  }

private:
  const Push& push_;
  const FullForm<double>& form_;
  const Assembly<double>& assembly_;
  const Layout<double>& layout_;
  const Scene<double>& scene_;

  template <class Use> void for_each_component(const Use& use) const {
    for (Index i = 0; i < layout_.points; ++i)
      for (Index c = 0; c < contact_components(scene_.bodies[layout_.body[i]]); ++c) use(i, c);
  }

  Unit motion(bool turns) const {
    const double scale = layout_.scales.acceleration;
    return turns ? Unit{"rad/s^2", scale / layout_.scales.length} : Unit{"m/s^2", scale};
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

  /// Acceleration c of a point relative to its body, and what a row says of it.
  Quantity component(Index point, Index c, const char* says, const char* law) const {
    const Body<double>& body = scene_.bodies[layout_.body[point]];
    const Vector3<double> axis[] = {body.normal, body.tangent, cross(body.normal, body.tangent)};
    const std::string contact = point_name(push_.file(), point);
    const std::string name = c == 3 ? "spin of " + contact + " about n"
                                    : "acceleration of " + contact + " along " + row_names[c] +
                                          " = " + direction_text(axis[c]);
    return {name + says, std::string("r_") + row_names[c], contact, law, motion(c == 3)};
  }

  std::string contact(const Name& name) const {
    return name.meaning == Meaning::closing ? "" : point_name(push_.file(), name.of);
  }

  Quantity reduced_unknown(Index i) const {
    constexpr const char* symbols[] = {"lambda", "lambda-", "beta", "xi", "s"}; // by Meaning
    const Name name = name_of(layout_, i);
    std::string symbol = symbols[static_cast<int>(name.meaning)];
    if (name.meaning == Meaning::friction) symbol += std::to_string(name.generator);
    const char* const unit = name.meaning == Meaning::slip      ? "m/s^2"
                             : name.meaning == Meaning::closing ? closing_unit(name.of)
                                                                : "N";
    return {push_.variable_name(i), symbol, contact(name), "", {unit, unknown_unit(layout_, i)}};
  }

  Quantity reduced_row(Index i) const {
    constexpr const char* symbols[] = {"n'r", "-n'r", "d", "mu lambda - sum beta",
                                       "J'f + m_a s - tau"}; // by Meaning, as the laws
    constexpr const char* laws[] = {"[T.2]", "[T.2]", "[T.3]", "[T.4]", "[T.5]"};
    const Name name = name_of(layout_, i);
    std::string symbol = symbols[static_cast<int>(name.meaning)];
    if (name.meaning == Meaning::friction) symbol += std::to_string(name.generator) + "'r + xi";
    const char* const unit = name.meaning == Meaning::slip      ? "N"
                             : name.meaning != Meaning::closing ? "m/s^2"
                             : moves_by_metres(name.of)         ? "N"
                                                                : "J";
    return {push_.row_name(i),
            symbol,
            contact(name),
            laws[static_cast<int>(name.meaning)],
            {unit, row_unit(layout_, i)}};
  }

  Quantity newton_row(Index k) const {
    const std::string axis = signed_axes[k % 3];
    if (!moves_along(scene_, k))
      return {k == 2 ? "no motion along +z: planar" : "no turn about " + axis + ": planar",
              twist_symbols[k], "", "[T.1]", motion(k >= 3)};
    const Scales<double>& scales = layout_.scales;
    return {(k < 3 ? "force balance along " : "moment balance about ") + axis, "Ma - w - Gf", "",
            "[T.1]", k < 3 ? Unit{"N", scales.force} : Unit{"N m", scales.force * scales.length}};
  }
};

/// One array: those from `first` to before `end`, numbered from 1.
void write_quantities(JsonWriter& json, const char* key, const std::vector<Quantity>& all,
                      std::size_t first, std::size_t end) {
  json.objects(key, static_cast<Index>(end - first), [&](Index i) {
    const Quantity& q = all[first + static_cast<std::size_t>(i)];
    json.member("index", i + 1).member("name", q.name).member("symbol", q.symbol);
    json.member("contact", unless_empty(q.contact)).member("law", unless_empty(q.law));
    json.member("unit", q.unit.name).member("scale", q.unit.scale);
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
  json.member("facets", push.file().facets).member("no_bound", no_bound);
  json.list("contacts", layout.points, [&](Index i) { json.value(point_name(push.file(), i)); });
  json.list("actuators", layout.actuators, [&](Index a) { json.value(push.actuator_name(a)); });
  const std::vector<Quantity> unknowns = names.unknowns(), rows = names.rows(),
                              answer = names.answer();
  write_quantities(json, "unknowns", unknowns, 0, unknowns.size());
  write_quantities(json, "A", rows, 0, complementary);
  write_quantities(json, "Aeq", rows, complementary, rows.size());
  write_quantities(json, "answer", answer, 0, answer.size());
  return json.end_object().text();
}

} // namespace lcpush::desktop
