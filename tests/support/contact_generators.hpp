// E of the paper's matrices: forces along generators as components of contact forces.
#pragma once

#include "lcpush/mechanics/paper/paper_matrices.hpp"
#include "support/dense_lcp.hpp"

namespace lcpush::test {

/// Columns of G-bar: the forces of the complementarity problem, in its order.
inline Index force_count(const Scene<double>& scene) {
  Index count = 0;
  for (const Body<double>& body : scene.bodies)
    count += body.point_count * (normal_count(body) + generator_count(scene, body));
  return count;
}

/// E = diag(n, D), block diagonal, a block a point: [1, (-1), 0 ; 0, D]. It turns forces along
/// generators into components, and G into G-bar = G E.
inline MatrixX<double> contact_generators(const Scene<double>& scene) {
  MatrixX<double> E = MatrixX<double>::Zero(contact_components(scene), force_count(scene));
  Index row = 0, column = 0;
  for (const Body<double>& body : scene.bodies) {
    const Vector3<double> o = cross(body.normal, body.tangent);
    for (Index i = 0; i < body.point_count; ++i) {
      E(row, column++) = 1;
      if (normal_count(body) == 2) E(row, column++) = -1;
      for (Index j = 0; j < generator_count(scene, body); ++j) {
        const Generator<double> d = generator(body, j, scene.facets);
        E(row + 1, column) = d.force.dot(body.tangent);
        E(row + 2, column) = d.force.dot(o);
        if (contact_components(body) == 4) E(row + 3, column) = d.torque;
        ++column;
      }
      row += contact_components(body);
    }
  }
  return E;
}

} // namespace lcpush::test
