// A body that is turned to another face.
#pragma once

#include "lcpush/mechanics/model/scene.hpp"

namespace lcpush::desktop {

/// The body with its normal along n, and its tangent turned as little as that takes.
inline Body<double> facing(Body<double> body, const Vector3<double>& n) {
  const Vector3<double> middle = n + body.normal, t = body.tangent;
  if (middle.norm() > 1e-9)
    body.tangent =
        t - t.dot(middle) / (1 + n.dot(body.normal)) * middle + 2 * t.dot(body.normal) * n;
  body.normal = n;
  return body;
}

} // namespace lcpush::desktop
