// A motion as CSV: columns by name, in any order.
#include "formats/read_number.hpp"
#include "lcpush/desktop/input_error.hpp"
#include "text/wording.hpp"
#include "verify/settings.hpp"
#include "verify/trajectory_reader.hpp"

#include <algorithm>
#include <cmath>

namespace lcpush::desktop {
namespace {

/// A column's place; none: the file has not got it.
using Column = std::optional<std::size_t>;
/// Of a body or a contact, in the order of the names below: vectors first.
using Columns = std::vector<Column>;
using Names = std::vector<std::string>;

/// A cell as spreadsheets and csv writers put it.
std::string_view unquoted(std::string_view cell) {
  cell = trimmed(cell);
  const bool is_quoted = cell.size() >= 2 && cell.front() == '"' && cell.back() == '"';
  return is_quoted ? trimmed(cell.substr(1, cell.size() - 2)) : cell;
}

class CsvTrajectory {
public:
  CsvTrajectory(const std::string& file, std::string_view head, const SceneFile& scene)
      : file_(file), separator_(head.find(',') == head.npos ? '\t' : ',') {
    for (const std::string_view word : split_at(head, separator_))
      names_.emplace_back(unquoted(word));
    for (std::string& name : names_)
      if (name == "t") name = "time";
    if (!has({"time", "x", "y", "z"})) {
      Names found;
      for (const std::string& name : names_)
        if (found.size() < VerifySettings::told_names) found.push_back(quoted(name));
      throw InputError(file, 1,
                       "no motion: the first line names the columns time, x, y, z, then r11 .. r33 "
                       "(row by row) or qw, qx, qy, qz unless it does not turn, and if known vx, "
                       "vy, vz, wx, wy, wz; here it is " +
                           listed(found, "and") + (found.size() < names_.size() ? ", .." : ""));
    }
    const auto is_of_rotation = [&](const std::string& name) {
      return std::count(rows_.begin(), rows_.end(), name) > 0 ||
             std::count(quaternion_.begin(), quaternion_.end(), name) > 0;
    };
    if (!turns() && std::any_of(names_.begin(), names_.end(), is_of_rotation))
      throw InputError(file, 1, "half a rotation: give all columns r11 .. r33, or qw, qx, qy, qz");
    if (!has(speeds_) && std::any_of(names_.begin(), names_.end(), [&](const std::string& name) {
          return std::count(speeds_.begin(), speeds_.end(), name) > 0;
        }))
      throw InputError(file, 1,
                       "half a velocity: give all columns vx, vy, vz, wx, wy, wz, or none");
    find_forces(scene);
  }

  /// Columns that nothing here reads.
  Names unread() const {
    Names list;
    for (const std::string& name : names_)
      if (!is_read(name)) list.push_back(name);
    return list;
  }

  /// Adds the line's frame.
  void read(std::string_view line, int number, ReadFrames& all) const {
    const Row row{split_at(line, separator_), number};
    if (row.words.size() != names_.size())
      throw InputError(file_, number,
                       "the first line names " + std::to_string(names_.size()) +
                           " columns, this one has " + std::to_string(row.words.size()));
    TrajectoryFrame frame;
    const std::vector<double> place = values(row, {"time", "x", "y", "z"});
    frame.time = place[0];
    frame.pose.position = {place[1], place[2], place[3]};
    all.places.insert(all.places.end(), place.begin() + 1, place.end());
    frame.has_rotation = turns();
    if (turns()) {
      const std::vector<double> turn = values(row, has(rows_) ? rows_ : quaternion_);
      all.turns.insert(all.turns.end(), turn.begin(), turn.end());
      frame.pose.rotation = has(rows_) ? rotation_of_rows(turn) : rotation_of_quaternion(turn);
    }
    if (has(speeds_)) frame.twist = Eigen::Map<const Vector6<double>>(values(row, speeds_).data());
    frame.step = number_in(row, step_);
    for (const Columns& at : contacts_)
      frame.contacts.push_back({number_in(row, at[3]), vector_in(row, &at[0]),
                                number_in(row, at[4]), number_in(row, at[5])});
    for (const Columns& at : bodies_)
      frame.bodies.push_back({vector_in(row, &at[0]), vector_in(row, &at[3]), number_in(row, at[6]),
                              number_in(row, at[7])});
    all.lines.push_back(number);
    all.frames.push_back(std::move(frame));
  }

private:
  bool is_read(const std::string& name) const {
    const auto is_among = [&](const Names& list) {
      return std::find(list.begin(), list.end(), name) != list.end();
    };
    const bool is_of_motion = is_among({"time", "x", "y", "z", "step"}) || is_among(rows_) ||
                              is_among(quaternion_) || is_among(speeds_);
    const std::size_t dot = name.rfind('.');
    if (is_of_motion || dot == std::string::npos) return is_of_motion;
    const std::string what = name.substr(dot + 1); // of whom has been looked at
    return what == "mode" || std::count(of_contacts_.begin(), of_contacts_.end(), what) > 0 ||
           std::count(of_bodies_.begin(), of_bodies_.end(), what) > 0;
  }
  bool turns() const { return has(rows_) || has(quaternion_); }

  struct Row {
    std::vector<std::string_view> words;
    int number;
  };

  bool has(const Names& names) const {
    return std::all_of(names.begin(), names.end(), [&](const std::string& name) {
      return std::count(names_.begin(), names_.end(), name) == 1;
    });
  }

  Column column(const std::string& name) const {
    const auto at = std::find(names_.begin(), names_.end(), name);
    if (at == names_.end()) return std::nullopt;
    if (std::count(at, names_.end(), name) > 1)
      throw InputError(file_, 1, "there are two columns " + quoted(name) + ": leave one");
    return static_cast<std::size_t>(at - names_.begin());
  }
  /// Those called `of` and one of these; of the `vectors` three that come first all or none.
  Columns columns(const std::string& of, const Names& parts, std::size_t vectors) const {
    Columns found;
    for (const std::string& part : parts) found.push_back(column(of + "." + part));
    for (std::size_t k = 0; k < 3 * vectors; ++k) {
      const std::size_t first = k - k % 3;
      if (!found[k] && (found[first] || found[first + 1] || found[first + 2]))
        throw InputError(file_, 1,
                         "the column " + quoted(of + "." + parts[k]) +
                             " is missing: a vector has all of its three, or none");
    }
    return found;
  }

  void find_forces(const SceneFile& scene) {
    const PlacesByName places(scene);
    refuse_strangers(places);
    step_ = column("step");
    contacts_.resize(places.contacts.size());
    for (const auto& [name, place] : places.contacts)
      contacts_[place] = columns(name, of_contacts_, 1);
    bodies_.resize(places.bodies.size());
    for (const auto& [name, place] : places.bodies) bodies_[place] = columns(name, of_bodies_, 2);
  }

  /// A force of what the scene has not is a slip of the pen, or of another scene.
  void refuse_strangers(const PlacesByName& places) const {
    const auto is_among = [](const Names& list, const std::string& word) {
      return std::find(list.begin(), list.end(), word) != list.end();
    };
    for (const std::string& name : names_) {
      const std::size_t dot = name.rfind('.');
      if (dot == std::string::npos) {
        refuse_other_spelling(places, name);
        continue;
      }
      const std::string whose = name.substr(0, dot), what = name.substr(dot + 1);
      const bool of_body = is_among(of_bodies_, what), of_contact = is_among(of_contacts_, what);
      if ((!of_body && !of_contact) || (of_body && places.bodies.count(whose) > 0) ||
          (of_contact && places.contacts.count(whose) > 0))
        continue;
      const char* const kind = !of_contact ? "body " : !of_body ? "contact " : "body or contact ";
      throw InputError(file_, 1,
                       "column " + quoted(name) + ": the scene has no " + kind + quoted(whose) +
                           suggestion(whose, places.known()));
    }
  }

  /// "left_fx", or a turn in angles: left unread, it would be taken for nothing.
  void refuse_other_spelling(const PlacesByName& places, const std::string& name) const {
    const std::size_t bar = name.rfind('_');
    if (bar != std::string::npos && !is_read(name)) {
      const std::string meant = name.substr(0, bar) + "." + name.substr(bar + 1);
      const bool is_known = places.bodies.count(name.substr(0, bar)) > 0 ||
                            places.contacts.count(name.substr(0, bar)) > 0;
      if (is_known && is_read(meant))
        throw InputError(file_, 1, "column " + quoted(name) + ": write " + quoted(meant));
    }
    const bool is_angle = std::count(angles_.begin(), angles_.end(), name) > 0;
    if (is_angle && !turns())
      throw InputError(file_, 1,
                       "column " + quoted(name) +
                           ": a turn is told by r11 .. r33 (row by row) or qw, qx, qy, qz");
  }

  double value(const Row& row, std::size_t at) const {
    const NumberText read = read_finite_number(unquoted(row.words[at]));
    if (read.error) throw InputError(file_, row.number, names_[at] + ": " + *read.error);
    return read.value;
  }
  std::vector<double> values(const Row& row, const Names& names) const {
    std::vector<double> list;
    for (const std::string& name : names) list.push_back(value(row, *column(name)));
    return list;
  }
  /// Nothing where the cell is empty.
  std::optional<double> number_in(const Row& row, const Column& at) const {
    if (!at || unquoted(row.words[*at]).empty()) return std::nullopt;
    return value(row, *at);
  }
  std::optional<Vector3<double>> vector_in(const Row& row, const Column* at) const {
    const auto x = number_in(row, at[0]), y = number_in(row, at[1]), z = number_in(row, at[2]);
    if (!x || !y || !z) return std::nullopt;
    return Vector3<double>(*x, *y, *z);
  }

  const std::string& file_;
  char separator_;
  Names names_;
  Column step_;
  std::vector<Columns> contacts_, bodies_;
  const Names of_contacts_{"fx", "fy", "fz", "normal", "torsion", "gap"};
  const Names of_bodies_{"fx", "fy", "fz", "mx", "my", "mz", "closing", "closing_speed"};
  const Names rows_{"r11", "r12", "r13", "r21", "r22", "r23", "r31", "r32", "r33"};
  const Names quaternion_{"qw", "qx", "qy", "qz"};
  const Names speeds_{"vx", "vy", "vz", "wx", "wy", "wz"};
  const Names angles_{"roll", "pitch", "yaw", "rx", "ry", "rz", "theta", "angle", "phi", "psi"};
};

} // namespace

ReadFrames frames_of_csv(const std::string& text, const std::string& file, const SceneFile& scene) {
  const std::vector<std::string_view> all = split_at(text, '\n');
  const auto says = [](std::string_view line) {
    return !trimmed(line).empty() && trimmed(line).front() != '#';
  };
  const auto head = std::find_if(all.begin(), all.end(), says);
  const CsvTrajectory csv(file, head == all.end() ? all[0] : *head, scene);
  ReadFrames read;
  read.unread = csv.unread();
  for (auto line = head; line != all.end() && ++line != all.end();) {
    if (!says(*line)) continue;
    csv.read(*line, static_cast<int>(line - all.begin()) + 1, read);
  }
  return read;
}

} // namespace lcpush::desktop
