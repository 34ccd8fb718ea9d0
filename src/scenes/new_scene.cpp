#include "scenes/new_scene.hpp"

#include "formats/read_number.hpp"
#include "lcpush/desktop/input_error.hpp"
#include "lcpush/desktop/scene_check.hpp"
#include "scenes/scene_units.hpp"
#include "text/format.hpp"
#include "text/wording.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace lcpush::desktop {

namespace {

constexpr double earth = 9.81;     // m/s^2
constexpr double aluminium = 2700; // kg/m^3, where nobody says how heavy the object is
constexpr double usual_pad = 0.01; // m
constexpr double too_large = 3;    // m, to be gripped
constexpr double sheet_friction = 0.5;

/// A number with its unit, as it was typed.
struct Quantity {
  double number, si;
  std::string unit;

  std::string times(double factor) const { // TOML, a tenth of a millionth is nothing
    const std::string digits = printed("%.7g", factor * number);
    return unit.empty() ? digits : "\"" + digits + " " + unit + "\"";
  }
  std::string text() const { return times(1); }
};

/// A line of the scene, and what it means.
std::string commented(std::string line, const std::string& comment) {
  constexpr std::size_t column = 31;
  if (!comment.empty()) line.resize(std::max(column, line.size() + 1), ' ');
  return line + (comment.empty() ? "\n" : "# " + comment + "\n");
}

class Writer {
public:
  /// Fills in what is usual.
  explicit Writer(NewScene given) : given_(std::move(given)), is_box_(given_.object == "box") {
    const bool rolls = given_.push == "roll";
    const bool is_own = !given_.size.empty();
    if (!is_own)
      given_.size = is_box_ ? "100 mm x 30 mm x 10 mm" : rolls ? "40 mm x 60 mm" : "20 mm x 100 mm";
    size_ = quantities("size", given_.size, "[object]\nbox",
                       is_box_ ? "80 mm x 40 mm x 20 mm" : "20 mm x 100 mm");
    if (size_.size() != (is_box_ ? 3 : 2))
      refuse("size", given_.size,
             is_box_ ? "a box has three edges, \"80 mm x 40 mm x 20 mm\""
                     : "a cylinder has a diameter and a length, \"20 mm x 100 mm\"");
    if (size_.front().unit.empty() && size_.front().si > too_large)
      refuse("size", given_.size, "these are metres; write \"80 mm x 40 mm x 20 mm\"");
    if (given_.mass.empty())
      given_.mass = is_own ? in_digits(1000 * usual_mass(), 2) + " g" : "200 g";
    mass_ = only("mass", given_.mass, "[object]\nmass", "120 g");
    const double along = size_[is_box_ ? 0 : 1].si;
    const double room = is_box_ ? std::min(along, size_[1].si) : along;
    if (given_.pads.empty())
      given_.pads = in_digits(1000 * std::min(usual_pad, room / 2), 2) + " mm";
    pads_ = quantities("pads", given_.pads, "[object]\nbox", "20 mm x 10 mm");
    if (pads_.size() > 2)
      refuse("pads", given_.pads, "a pad has two edges, \"20 mm x 10 mm\", or is round, \"8 mm\"");
    if (pads_.front().unit.empty() && pads_.front().si > along)
      refuse("pads", given_.pads, "these are metres; write \"20 mm x 10 mm\"");
    if (pads_.front().si > along || (is_box_ && pads_.back().si > size_[1].si))
      refuse("pads", given_.pads,
             "larger than where they press, " + millimetres(along) +
                 (is_box_ ? " x " + millimetres(size_[1].si) : " of the cylinder"));
    if (given_.friction.empty()) given_.friction = rolls ? "0.3" : "0.5";
    const NumberText friction = read_finite_number(given_.friction);
    if (friction.error || !(friction.value > 0))
      refuse("friction", given_.friction, "a coefficient such as 0.5 is meant");
    const double weight = mass_.si * earth, mu = friction.value, holds = weight / (2 * mu),
                 rolled = hardest_to_roll(weight, mu);
    if (rolls && !(mu < 1))
      refuse("friction", given_.friction, "fingertips so rough do not let it roll; 0.3 would");
    // Four times what holds the weight, or what slides straight; or little enough to roll.
    if (rolls) grip_comment_ += "; more slips, the sheet bears the rest";
    if (given_.grip.empty())
      given_.grip =
          in_digits(rolls ? 0.8 * rolled : std::max(4 * holds, 1.1 * straight(weight, mu)), 2) +
          " N";
    grip_ = only("grip", given_.grip, "[object]\n[[finger]]\ngrip_force", "20 N");
    if (rolls ? grip_.si > rolled : grip_.si < holds)
      grip_comment_ = rolls ? "too hard to roll; " + in_digits(0.8 * rolled, 2) + " N would"
                            : "too weak: its weight takes " + brief(holds) + " N";
  }

  /// With what is usual in the place of what nobody gave.
  const NewScene& scene() const { return given_; }

  std::string text() const {
    std::string text =
        "# Made by `lcpush new`; docs/guide/scenes.md explains every key.\ntitle = \"A " +
        given_.object + title() + "\"\ngravity = [0, \"-9.81 m/s^2\", 0]\n";
    if (given_.push != "roll" && given_.push != "none")
      text +=
          commented("planar = true", "it stays in the x-y plane; without this line it need not");
    text += "\n" + commented("[object]", "its middle is at [0, 0, 0]") + "mass = " + mass_.text() +
            "\n";
    if (is_box_)
      text += "box = " + list({size_[0].text(), size_[1].text(), size_[2].text()}) + "\n";
    else
      text += "cylinder_radius = " + size_[0].times(0.5) +
              "\ncylinder_length = " + size_[1].text() +
              "\naxis = " + (given_.push == "roll" ? "\"z\"" : "\"x\"") + "\n";
    text += finger("left", 1) + finger("right", -1) + pusher();
    return text;
  }

private:
  /// The grip from which on a sheet slips: slipping fingers resist with 2 mu g, which the sheet's
  /// friction turns against, pressed by the weight and by what the uneven fingers pull down. From
  /// mu = 1 on the sheet pushes one finger away instead.
  static double hardest_to_roll(double weight, double mu) {
    return sheet_friction * weight / (2 * mu * (1 - sheet_friction * mu));
  }

  /// The grip from which on a wall on the whole end pushes straight: its rim bears the moment of
  /// the weight, half a length away, with the 2 mu g that it takes to slide.
  double straight(double weight, double mu) const {
    if (given_.push != "slide") return 0;
    const double length = size_[is_box_ ? 0 : 1].si, height = size_[is_box_ ? 1 : 0].si;
    return weight * length / height / (2 * mu);
  }

  double usual_mass() const {
    const double d = size_[0].si;
    const double volume = is_box_ ? d * size_[1].si * size_[2].si : M_PI / 4 * d * d * size_[1].si;
    return aluminium * volume;
  }

  [[noreturn]] static void refuse(const std::string& option, const std::string& typed,
                                  const std::string& why) {
    throw InputError("--" + option + " " + quoted(typed) + ": " + why);
  }

  static std::string list(const std::vector<std::string>& entries) {
    return "[" + joined(entries, ", ") + "]";
  }

  /// "80 mm x 40 mm x 20 mm"; a unit at the end alone is that of all. `key`: what such a number is
  /// in a scene, with its table's header.
  static std::vector<Quantity> quantities(const std::string& option, const std::string& typed,
                                          const std::string& key, const std::string& example) {
    std::string text = typed;
    for (const char* cross : {"\xC3\x97", "X", "*"})
      for (std::size_t at; (at = text.find(cross)) != std::string::npos;)
        text.replace(at, std::string_view(cross).size(), "x");
    std::vector<Quantity> list;
    for (const std::string_view part : split_at(text, 'x')) {
      const std::string_view word = trimmed(part);
      const auto [length, is_whole] = decimal_prefix(word);
      const std::string_view unit = trimmed(word.substr(std::min(length, word.size())));
      const std::size_t digit = unit.find_first_of("0123456789"); // "80 40 20", "80 mm 40 mm"
      const bool is_other = digit != unit.npos && (digit == 0 || unit[digit - 1] == ' ');
      if (!is_whole || is_other || word.find(',') != std::string_view::npos)
        refuse(option, typed,
               "write " + quoted(example) + (is_other ? "" : ", with a point in decimals"));
      list.push_back({read_finite_number(word.substr(0, length)).value, 0,
                      std::string(trimmed(word.substr(length)))});
    }
    for (Quantity& one : list) {
      if (one.unit.empty()) one.unit = list.back().unit;
      if (list.back().unit.empty() && !one.unit.empty())
        refuse(option, typed, "write the unit of each, " + quoted(example));
      one.si = in_si(option, typed, key, one.text());
      if (!(one.si > 0)) refuse(option, typed, "must be more than 0, such as " + quoted(example));
    }
    return list;
  }

  static Quantity only(const std::string& option, const std::string& typed, const std::string& key,
                       const std::string& example) {
    const std::vector<Quantity> list = quantities(option, typed, key, example);
    if (list.size() > 1) refuse(option, typed, "one number is meant, " + quoted(example));
    return list.front();
  }

  static double in_si(const std::string& option, const std::string& typed, const std::string& key,
                      const std::string& value) {
    try {
      const TomlDocument document = parse_scene_tables(key + " = " + value, "");
      return document.sections.back().tables[0].entries[0].value.number().value_or(0);
    } catch (const InputError& error) {
      const std::string what = error.what(), before = value + ": ";
      const std::size_t at = what.find(before);
      refuse(option, typed, at == std::string::npos ? what : what.substr(at + before.size()));
    }
  }

  std::string title() const {
    return given_.push == "slide"   ? " pushed through the grip"
           : given_.push == "pivot" ? " turned in the grip"
           : given_.push == "roll"  ? " rolled in the grip"
                                    : " in the grip";
  }

  std::string finger(const std::string& name, int side) const {
    const auto first = [side](const char* comment) { return side > 0 ? comment : ""; };
    return "\n[[finger]]\nname = \"" + name + "\"\n" + place(side) +
           commented("friction = " + given_.friction,
                     first("docs/guide/materials.md has that of rubber, steel, ..")) +
           commented("grip_force = " + grip_.text(), first(grip_comment_.c_str()));
  }

  /// Of the finger on this side of the object.
  std::string place(int side) const {
    const std::string sign = side > 0 ? "+" : "-";
    if (is_box_)
      return (pads_.size() > 1
                  ? "shape = \"rectangle\"\nsize = " + list({pads_[0].text(), pads_[1].text()})
                  : "shape = \"disc\"\nradius = " + pads_[0].times(0.5)) +
             "\non = \"" + sign + "z\"\n";
    const bool rolls = given_.push == "roll";
    const std::string from = pads_[0].times(-0.5), to = pads_[0].times(0.5),
                      out = size_[0].times(0.5 * side);
    const std::string into = side > 0 ? "-1" : "1";
    return commented("shape = \"line\"",
                     side > 0 ? "a flat pad touches a cylinder along a line" : "") +
           "ends = " +
           (rolls ? list({list({out, "0", from}), list({out, "0", to})})
                  : list({list({from, "0", out}), list({to, "0", out})})) +
           "\nnormal = " + (rolls ? list({into, "0", "0"}) : list({"0", "0", into})) + "\n";
  }

  std::string pusher() const {
    if (given_.push == "none") return "";
    const std::string is = "\n[[pusher]]\nname = ",
                      across = commented("velocity = [0, \"10 mm/s\", 0]",
                                         "how it moves against the hand"),
                      along = commented("velocity = [\"10 mm/s\", 0, 0]",
                                        "how it moves against the hand");
    if (given_.push == "roll")
      return is + "\"sheet\"\nshape = \"line\"\nends = " +
             list({list({"0", size_[0].times(-0.5), pads_[0].times(-0.5)}),
                   list({"0", size_[0].times(-0.5), pads_[0].times(0.5)})}) +
             "\nnormal = [0, 1, 0]\nfriction = " + printed("%g", sheet_friction) + "\n" + along;
    if (given_.push == "slide")
      return is + "\"wall\"\n" +
             (is_box_
                  ? "shape = \"line\"\non = \"-x\"\n" +
                        commented("along = \"y\"",
                                  "a table's edge: \"z\", and center = [\"4 mm\", 0], its height")
                  : "shape = \"disc\"\non = \"-x\"\nradius = " + size_[0].times(0.5) + "\n") +
             "friction = 0.3\n" + along;
    return is +
           (is_box_ ? "\"edge\"\nshape = \"line\"\non = \"-y\"\nalong = \"z\"\ncenter = " +
                          list({size_[0].times(-0.4), "0"}) + "\n"
                    : "\"rod\"\nshape = \"point\"\ncenter = " +
                          list({size_[1].times(-0.4), size_[0].times(-0.5), "0"}) +
                          "\nnormal = [0, 1, 0]\n") +
           "friction = 0.3\n" + across;
  }

  NewScene given_;
  const bool is_box_;
  std::vector<Quantity> size_, pads_;
  Quantity mass_, grip_;
  std::string grip_comment_ = "the same on both: a parallel jaw";
};

/// Throws InputError if there is no such object, or no such push of it.
void expect_known(const NewScene& given) {
  const std::vector<std::string> objects = {"box", "cylinder"},
                                 pushes = {"slide", "pivot", "roll", "none"};
  if (std::find(objects.begin(), objects.end(), given.object) == objects.end())
    throw InputError("the object is box or cylinder, not " + quoted(given.object) +
                     suggestion(given.object, objects));
  if (std::find(pushes.begin(), pushes.end(), given.push) == pushes.end())
    throw InputError("--push is slide, pivot, roll or none, not " + quoted(given.push) +
                     suggestion(given.push, pushes));
  if (given.object == "box" && given.push == "roll")
    throw InputError("a box does not roll; try: lcpush new cylinder --push roll");
}

} // namespace

NewScene usual_scene(const NewScene& given) {
  expect_known(given);
  return Writer(given).scene();
}

std::string new_scene(const NewScene& given) {
  expect_known(given);
  const std::string text = Writer(given).text();
  const std::vector<SceneDoubt> doubts = check_scene(parse_scene(text, "new"));
  if (doubts.empty()) return text;
  throw InputError(
      "this scene would be odd: " + doubts.front().text +
      (doubts.front().doubt == Doubt::density ? "; check --size and --mass, and their units" : ""));
}

} // namespace lcpush::desktop
