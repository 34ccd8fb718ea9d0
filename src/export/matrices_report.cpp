#include <algorithm>

#include "formats/json_writer.hpp"
#include "lcpush/desktop/matrices.hpp"
#include "scenes/warnings_json.hpp"
#include "text/format.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {
namespace {

/// What rounding leaves of a zero in this matrix.
double zero_of(const NamedMatrix& matrix) {
  double largest = 0;
  for (const double x : matrix.values.values) largest = std::max(largest, std::abs(x));
  return 1e-14 * largest;
}

std::string matrix_table(const NamedMatrix& matrix, bool transposed) {
  const std::vector<std::string>& rows = transposed ? matrix.columns : matrix.rows;
  const std::vector<std::string>& columns = transposed ? matrix.rows : matrix.columns;
  const double zero = zero_of(matrix);
  TableRows cells{{""}};
  cells[0].insert(cells[0].end(), columns.begin(), columns.end());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    cells.push_back({rows[i]});
    for (std::size_t j = 0; j < columns.size(); ++j) {
      const auto row = static_cast<Index>(transposed ? j : i);
      const auto column = static_cast<Index>(transposed ? i : j);
      cells.back().push_back(number(matrix.values(row, column), zero));
    }
  }
  return table_text(cells);
}

std::string rigidity_text(const PatchRigidity& patch) {
  const std::string name = "\n" + patch.body + ": ";
  if (patch.points.size() == 1) return name + "a single point, nothing to keep rigid\n";
  const Index k = static_cast<Index>(patch.points.size());
  const Index m = static_cast<Index>(patch.references.size()) - 1;
  std::string text =
      name + std::to_string(k) + " points, references " + joined(patch.references, ", ");
  text += "\n  " + std::to_string(patch.check.count) + " conditions";
  if (m <= 2)
    text += " (3k - m - 4 with k = " + std::to_string(k) + ", m = " + std::to_string(m) + ")";
  if (patch.checked)
    text += ", rank found " + std::to_string(patch.check.rank) +
            (patch.check.holds() ? ", met by every rigid motion" : ": NOT as it should be");
  else
    text += ", rank not looked for: more than " + std::to_string(largest_checked_patch) + " points";
  TableRows followers{{""}};
  followers[0].insert(followers[0].end(), patch.references.begin(), patch.references.end());
  for (std::size_t j = 0; j < patch.points.size(); ++j) {
    if (std::count(patch.references.begin(), patch.references.end(), patch.points[j]) > 0) continue;
    followers.push_back({patch.points[j]});
    for (const double alpha : patch.weights[j]) followers.back().push_back(number(alpha, 1e-14));
  }
  return text + "\n" + (followers.size() == 1 ? "" : table_text(followers));
}

void write_matrix(JsonWriter& json, const NamedMatrix& matrix) {
  json.member("rows", matrix.rows).member("columns", matrix.columns);
  json.list("values", matrix.values.rows, [&](Index i) {
    std::vector<double> row;
    for (Index j = 0; j < matrix.values.cols; ++j) row.push_back(matrix.values(i, j));
    json.value(row);
  });
}

void write_rigidity(JsonWriter& json, const PatchRigidity& patch) {
  json.member("body", patch.body).member("points", patch.points);
  json.member("references", patch.references).member("count", patch.check.count);
  json.member("rank", when(patch.checked, patch.check.rank));
  json.member("holds", when(patch.checked, patch.check.holds()));
  json.member("weights", patch.weights);
}

/// Matrices of the same rows, side by side.
NamedMatrix beside(NamedMatrix left, const NamedMatrix& right) {
  left.columns.insert(left.columns.end(), right.columns.begin(), right.columns.end());
  left.values.values.insert(left.values.values.end(), right.values.values.begin(),
                            right.values.values.end());
  left.values.cols += right.values.cols;
  return left;
}

std::string jacobian_text(const PaperMatrices& matrices) {
  std::string text =
      "\nHand Jacobian J: acceleration of the body's point for a unit of an actuator;\n"
      "v: its acceleration as prescribed. Relative to its body a point of the object\n"
      "accelerates with r = G' a - J s - v [P.10]\n" +
      matrix_table(beside(beside(matrices.J, matrices.J_prescribed), matrices.v), false);
  if (!matrices.s_prescribed.rows.empty())
    text += "\nPrescribed accelerations of actuators; their columns times these are part of v\n" +
            matrix_table(matrices.s_prescribed, true);
  for (const PusherJacobian& pusher : matrices.J_pusher)
    text += "\nThe block of J of " + pusher.body + ", times its twist A a part of v\n" +
            matrix_table(pusher.J, false) + "\n" + matrix_table(pusher.twist, true);
  return text;
}

} // namespace

std::string matrices_text(const SceneFile& file, const PaperMatrices& matrices) {
  std::string text = file.title.empty() ? "" : file.title + "\n\n";
  text += "SI units, scene axes; wrenches and twists at the object's centre of mass.\n"
          "n, t, o are each contact's own axes, torsion is about n; d0, d1, .. its friction "
          "generators.\n";
  if (file.planar) text += "The scene is planar: it is solved without the rows fz, mx and my.\n";
  text += "\nInertia M, kg and kg m^2\n" + matrix_table(matrices.M, false);
  text += "\nLoad w, N and N m\n" + matrix_table(matrices.w, true);
  text += "\nGrasp matrix G, transposed: the wrench of a unit force (of a unit moment: torsion)\n" +
          matrix_table(matrices.G, true);
  text +=
      "\nPolyhedral grasp matrix G-bar, transposed: the wrench of a unit along each generator\n" +
      matrix_table(matrices.G_bar, true);
  text += jacobian_text(matrices);
  text += "\nFriction generators D of a body's points, transposed: components of a unit of each\n";
  for (const BodyGenerators& generators : matrices.D)
    text += "\n" + generators.body +
            (generators.D.columns.empty() ? ": no friction\n"
                                          : "\n" + matrix_table(generators.D, true));
  text += "\nPatch rigidity: references, the weights with which other points follow them, and the\n"
          "number of independent conditions\n";
  for (const PatchRigidity& patch : matrices.rigidity) text += rigidity_text(patch);
  return text;
}

std::string matrices_json(const PaperMatrices& matrices, const std::vector<SceneDoubt>& warnings) {
  JsonWriter json;
  json.begin_object();
  write_warnings(json, warnings);
  const std::pair<const char*, const NamedMatrix&> named[] = {
      {"M", matrices.M},
      {"w", matrices.w},
      {"G", matrices.G},
      {"G_bar", matrices.G_bar},
      {"J", matrices.J},
      {"J_prescribed", matrices.J_prescribed},
      {"s_prescribed", matrices.s_prescribed},
      {"v", matrices.v}};
  for (const auto& [name, matrix] : named) {
    json.key(name).begin_object();
    write_matrix(json, matrix);
    json.end_object();
  }
  json.objects("J_pusher", matrices.J_pusher, [&](const PusherJacobian& pusher) {
    json.member("body", pusher.body);
    write_matrix(json, pusher.J);
    json.key("twist").begin_object();
    write_matrix(json, pusher.twist);
    json.end_object();
  });
  json.objects("D", matrices.D, [&](const BodyGenerators& generators) {
    json.member("body", generators.body);
    write_matrix(json, generators.D);
  });
  json.objects("rigidity", matrices.rigidity,
               [&](const PatchRigidity& patch) { write_rigidity(json, patch); });
  return json.end_object().text();
}

} // namespace lcpush::desktop
