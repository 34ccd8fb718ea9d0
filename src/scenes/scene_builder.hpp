// Builds a scene from the tables of a parsed document.
#pragma once

#include "formats/toml.hpp"
#include "lcpush/desktop/scene_io.hpp"
#include "scenes/scene_patch.hpp"
#include "scenes/table_reader.hpp"

#include <map>
#include <string>

namespace lcpush::desktop {

/// S is double or Rational.
template <class S> class SceneBuilder {
public:
  /// `document` must outlive the builder.
  explicit SceneBuilder(const TomlDocument& document) : document_(document) {}

  /// Throws InputError if the document is no scene. Call once.
  SceneOf<S> build();

private:
  const std::vector<TomlTable>& tables(const std::string& section) const;
  TableReader reader(const std::string& section, std::size_t index = 0) const;
  std::string claim_name(const TableReader& table);
  Index body_called(const std::string& name) const;

  void read_settings();
  void read_bodies(Role role);
  void read_body(Role role, const TableReader& table);
  void add_points(const TableReader& table, const Patch<S>& patch);
  Vector6<S> prescribed_twist(const TableReader& table) const;

  void drive_fingers();
  void drive_parallel_jaws(const TableReader& gripper);
  void drive_pusher(const TableReader& table, Index body);
  void drive_along_normal(Index body, Index actuator);
  Index add_actuator(const std::string& name, const S& force, const S& inertia);

  void read_actuator(const TableReader& table);
  void refuse_squeezes_out_of_plane() const;
  Vector6<S> moved_to_center_of_mass(const std::vector<S>& twist) const;

  const TomlDocument& document_;
  SceneOf<S> scene_;
  std::map<std::string, int> name_lines_; ///< of bodies and [[actuator]]s
};

} // namespace lcpush::desktop
