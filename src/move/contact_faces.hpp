// Which face each body of a scene touches.
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

/// Throws InputError, with file and line, where a body meets no face.
ContactFaces contact_faces(const SceneFile& file);

/// A later stroke begins, the object being turned: its body touches the face that its normal points
/// into now. Throws InputError where there is none.
void begin_stroke(const SceneFile& file, Index body, const Matrix3<double>& turned,
                  ContactFaces& faces);

} // namespace lcpush::desktop
