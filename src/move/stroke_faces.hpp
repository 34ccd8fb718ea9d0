// What a motion's bodies touch, and what is prescribed of their ways, as strokes come and go.
#pragma once

#include "lcpush/desktop/scene_io.hpp"
#include "lcpush/mechanics/model/faces.hpp"

#include <vector>

namespace lcpush::desktop {

/// The arrays behind a motion's Surroundings, about the object's centre of mass.
struct ContactFaces {
  std::vector<Touching> touching;
  std::vector<Face<double>> faces;
  std::vector<std::vector<Vector3<double>>> corners; ///< of the faces
  std::vector<RoundSide<double>> sides;
  std::vector<unsigned char> absent; ///< of the bodies, as strokes come and go

  /// Valid while this lives unchanged; the flags may change.
  Surroundings<double> view();
};

class StrokeFaces {
public:
  /// `file` must outlive it. Throws InputError, with file and line, where a body meets no face.
  explicit StrokeFaces(const SceneFile& file);
  StrokeFaces(const StrokeFaces&) = delete; // views would look into the other one
  StrokeFaces& operator=(const StrokeFaces&) = delete;

  /// To be called where strokes may begin, with the object's turn: their bodies touch the faces
  /// that their normals point into there. Throws InputError where there is none.
  void begin_strokes(double time, const Matrix3<double>& turned);
  /// Faces end so far, m, beyond their rims: for motions whose places are off by little.
  void widen(double by);
  /// Who is there in a step with this middle?
  void place_strokes(double middle);

  bool is_absent(Index body) const { return faces_.absent[static_cast<std::size_t>(body)] != 0; }
  const Touching& touching(Index body) const {
    return faces_.touching[static_cast<std::size_t>(body)];
  }
  /// With their faces' normals.
  const std::vector<Body<double>>& bodies() const { return bodies_; }
  /// Valid while this lives; strokes may come and go.
  Surroundings<double> view() { return faces_.view(); }

  /// What prescribes a body's motion at `time`, a twist at the object's first centre of mass.
  Vector6<double> prescribed(Index body, double time) const;
  /// Where that has led by `time`: the body has moved by this twist.
  Vector6<double> path(Index body, double time) const;

private:
  void face_object(std::size_t b, const Matrix3<double>& turned);

  const SceneFile& file_;
  ContactFaces faces_;
  std::vector<Body<double>> bodies_;
  std::vector<unsigned char> has_begun_;
};

} // namespace lcpush::desktop
