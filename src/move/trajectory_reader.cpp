#include "lcpush/desktop/trajectory.hpp"

#include "formats/json_fields.hpp"
#include "formats/read_number.hpp"
#include "lcpush/mechanics/model/contact.hpp"
#include "text/limits.hpp"
#include "text/text_file.hpp"
#include "text/wording.hpp"

#include <algorithm>
#include <cmath>

namespace lcpush::desktop {
namespace {

constexpr double rotation_slack = 1e-6; // single precision, printed

Matrix3<double> by_rows(const std::vector<double>& r) {
  Matrix3<double> R;
  R << r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8];
  return R;
}

/// w first; of any length but zero.
Matrix3<double> by_quaternion(const std::vector<double>& q) {
  const double norm = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  const double w = q[0] / norm, x = q[1] / norm, y = q[2] / norm, z = q[3] / norm;
  Matrix3<double> R;
  R << 1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y), 2 * (x * y + w * z),
      1 - 2 * (x * x + z * z), 2 * (y * z - w * x), 2 * (x * z - w * y), 2 * (y * z + w * x),
      1 - 2 * (x * x + y * y);
  return R;
}

void check_frames(const std::string& file, const std::vector<TrajectoryFrame>& frames,
                  const std::vector<int>& lines) {
  if (frames.size() < 2) throw InputError(file, 1, "a motion needs two frames or more");
  if (frames.size() < 3 && !frames[0].twist) // the first step tells a speed, and is not judged
    throw InputError(file, 1, "without velocities a motion needs three frames or more");
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const Matrix3<double>& R = frames[k].pose.rotation;
    const Matrix3<double> off = R.transpose() * R - Matrix3<double>::Identity();
    if (!(off.cwiseAbs().maxCoeff() <= rotation_slack &&
          cross<double>(R.col(0), R.col(1)).dot(R.col(2)) > 0))
      throw InputError(file, lines[k], "the rotation is none: its rows are not orthonormal");
    if (k > 0 && !(frames[k].time > frames[k - 1].time))
      throw InputError(file, lines[k],
                       "time must grow from frame to frame, got " + shown(frames[k].time) +
                           " after " + shown(frames[k - 1].time));
  }
}

std::vector<TrajectoryFrame> from_json(const std::string& text, const std::string& file) {
  const JsonValue root = parse_json(text, file);
  const JsonFields fields(file);
  const JsonArray* const list = fields.objects(root, "frames");
  if (list == nullptr) fields.refuse(root, "no motion: give \"frames\": [{..}, ..]");
  std::vector<TrajectoryFrame> frames;
  std::vector<int> lines;
  for (const JsonValue& entry : *list) {
    TrajectoryFrame frame;
    const auto time = fields.number(entry, "time");
    const auto position = fields.vector<3>(entry, "position");
    const auto rotation = fields.numbers(entry, "rotation", 9);
    if (!time || !position || !rotation)
      fields.refuse(entry, "a frame needs \"time\", \"position\" [3] and \"rotation\" [9]");
    frame.time = *time;
    frame.pose = {*position, by_rows(*rotation)};
    frame.twist = fields.vector<6>(entry, "twist");
    frames.push_back(frame);
    lines.push_back(entry.line);
  }
  check_frames(file, frames, lines);
  return frames;
}

class CsvTrajectory {
public:
  CsvTrajectory(const std::string& file, std::string_view head) : file_(file) {
    for (const std::string_view word : split_at(head, ',')) names_.emplace_back(trimmed(word));
    if (!has({"time", "x", "y", "z"}))
      throw InputError(file, 1,
                       "no motion: the first line names the columns time, x, y, z, then r11 .. r33 "
                       "(row by row) or qw, qx, qy, qz, and if known vx, vy, vz, wx, wy, wz");
    if (!has(rows_) && !has(quaternion_))
      throw InputError(file, 1, "no rotation: give the columns r11 .. r33, or qw, qx, qy, qz");
  }

  TrajectoryFrame read(std::string_view line, int number) const {
    const std::vector<std::string_view> words = split_at(line, ',');
    if (words.size() != names_.size())
      throw InputError(file_, number,
                       "the first line names " + std::to_string(names_.size()) +
                           " columns, this one has " + std::to_string(words.size()));
    const auto values = [&](const std::vector<std::string>& names) {
      std::vector<double> list;
      for (const std::string& name : names) {
        const auto at = std::find(names_.begin(), names_.end(), name) - names_.begin();
        const NumberText read = read_finite_number(trimmed(words[static_cast<std::size_t>(at)]));
        if (read.error) throw InputError(file_, number, name + ": " + *read.error);
        list.push_back(read.value);
      }
      return list;
    };
    TrajectoryFrame frame;
    const std::vector<double> place = values({"time", "x", "y", "z"});
    frame.time = place[0];
    frame.pose.position = {place[1], place[2], place[3]};
    frame.pose.rotation = has(rows_) ? by_rows(values(rows_)) : by_quaternion(values(quaternion_));
    if (has(speeds_)) frame.twist = Eigen::Map<const Vector6<double>>(values(speeds_).data());
    return frame;
  }

private:
  bool has(const std::vector<std::string>& names) const {
    return std::all_of(names.begin(), names.end(), [&](const std::string& name) {
      return std::count(names_.begin(), names_.end(), name) == 1;
    });
  }

  const std::string& file_;
  std::vector<std::string> names_;
  const std::vector<std::string> rows_{"r11", "r12", "r13", "r21", "r22",
                                       "r23", "r31", "r32", "r33"};
  const std::vector<std::string> quaternion_{"qw", "qx", "qy", "qz"};
  const std::vector<std::string> speeds_{"vx", "vy", "vz", "wx", "wy", "wz"};
};

std::vector<TrajectoryFrame> from_csv(const std::string& text, const std::string& file) {
  const std::vector<std::string_view> all = split_at(text, '\n');
  const CsvTrajectory csv(file, all[0]);
  std::vector<TrajectoryFrame> frames;
  std::vector<int> lines;
  for (std::size_t k = 1; k < all.size(); ++k) {
    if (trimmed(all[k]).empty()) continue;
    lines.push_back(static_cast<int>(k) + 1);
    frames.push_back(csv.read(all[k], lines.back()));
  }
  check_frames(file, frames, lines);
  return frames;
}

} // namespace

std::vector<TrajectoryFrame> read_trajectory(const std::string& path) {
  return parse_trajectory(read_text_file(path, limits::answer_bytes), file_label(path));
}

std::vector<TrajectoryFrame> parse_trajectory(const std::string& text, const std::string& file) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  const bool is_json = first != std::string::npos && text[first] == '{';
  return is_json ? from_json(text, file) : from_csv(text, file);
}

} // namespace lcpush::desktop
