// Contact problems in JSON and in folders of Matrix Market files, as FCLIB and Siconos name them.
#include "contacts/contact_parts.hpp"
#include "contacts/settings.hpp"
#include "dense/decompositions.hpp"
#include "text/format.hpp"
#include "text/limits.hpp"
#include "text/text_file.hpp"

#include <cmath>
#include <filesystem>

namespace lcpush::desktop {
namespace {

using Eigen::VectorXd;

void check_symmetric(const ContactParts& parts, const SparseRows& A, const std::string& name) {
  VectorXd diagonal(A.rows());
  for (Index i = 0; i < A.rows(); ++i) diagonal[i] = A(i, i);
  std::vector<std::size_t> next = A.begins; // in each row: its entries up to column i are done
  for (Index i = 0; i < A.rows(); ++i)
    for (const auto& [j, value] : A.row(i)) {
      const auto row = static_cast<std::size_t>(j);
      std::size_t& k = next[row];
      while (k < A.begins[row + 1] && A.entries[k].column < i) ++k;
      const bool is_there = k < A.begins[row + 1] && A.entries[k].column == i;
      const double other = is_there ? A.entries[k].value : 0;
      const double size = std::sqrt(std::abs(diagonal[i])) * std::sqrt(std::abs(diagonal[j]));
      const bool is_large = std::abs(value) > (1 + ContactSettings::asymmetric) * size;
      const bool is_symmetric =
          std::abs(value - other) <= ContactSettings::asymmetric * std::max(size, std::abs(value));
      if (diagonal[i] < 0 || is_large || !is_symmetric)
        parts.refuse("the " + name + " matrix is not " +
                     (is_symmetric ? "positive semidefinite" : "symmetric") + ": row " +
                     std::to_string(i + 1) + ", column " + std::to_string(j + 1) + " is " +
                     shown(value) + ", the diagonal " + shown(diagonal[i]) + " and " +
                     shown(diagonal[j]) + ", the other side " + shown(other));
    }
}

/// W = H' M^-1 H and b = H' M^-1 f + w.
void condense(const ContactParts& parts, Index n, ContactProblem& problem) {
  const Index m = parts.part({"M"}, -1, -1, "").rows();
  const SparseRows& M = parts.part({"M"}, m, m, "a square mass matrix");
  if (m > 2 * ContactSettings::most_rows)
    parts.refuse("\"M\" has " + std::to_string(m) + " rows; at most " +
                 std::to_string(2 * ContactSettings::most_rows) + " are solved within a gigabyte");
  check_symmetric(parts, M, "mass");
  const SparseRows& any = parts.part({"H", "G"}, -1, -1, "what forces do to the bodies");
  const bool is_jacobian = any.rows() == n && any.cols == m && n != m;
  const SparseRows& H =
      is_jacobian ? any
                  : parts.part({"H", "G"}, m, n, "a row for each of M and three columns a contact");
  RowMatrix A = RowMatrix::Zero(m, m + n + 1); // [M | H | f]
  for (Index i = 0; i < m; ++i)
    for (const auto& [j, value] : M.row(i)) A(i, j) = value;
  for (Index i = 0; i < H.rows(); ++i)
    for (const auto& [j, value] : H.row(i)) (is_jacobian ? A(j, m + i) : A(i, m + j)) = value;
  A.col(m + n) = parts.vector({"f", "q"}, m, "the load, a number a row of M");
  const RowMatrix forces = A.middleCols(m, n).transpose();
  const auto moved = eliminate(A, true);
  if (!moved) parts.refuse("\"M\" is not positive definite: every mass is > 0");
  problem.W.cols = n;
  problem.b = parts.has("w") ? parts.vector({"w"}, n, "a velocity, three numbers a contact")
                             : VectorXd::Zero(n);
  for (Index c = 0; c < n; ++c) {
    Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(n + 1);
    for (Index i = 0; i < m; ++i)
      if (forces(c, i) != 0) row += forces(c, i) * moved->row(i);
    problem.W.add_row(row.head(n));
    problem.b[c] += row[n];
  }
}

void read_equalities(const ContactParts& parts, Index n, ContactProblem& problem) {
  const Index e =
      parts.has("V") ? parts.part({"V"}, n, -1, "a matrix with three rows a contact").cols : 0;
  problem.V = Eigen::MatrixXd::Zero(n, e);
  problem.R = problem.s = VectorXd::Zero(e);
  if (!parts.has("V")) return;
  for (Index i = 0; i < n; ++i)
    for (const auto& [j, value] : parts.part({"V"}, n, e, "").row(i)) problem.V(i, j) = value;
  const SparseRows& R = parts.part({"R"}, e, e, "square, a row for each column of \"V\"");
  for (Index i = 0; i < e; ++i)
    for (const auto& [j, value] : R.row(i)) {
      if (j != i || value > 0)
        parts.refuse("\"R\" must be diagonal, with entries <= 0: minus inertias");
      problem.R[i] = value;
    }
  problem.s = parts.vector({"s"}, e, "a number a column of \"V\"");
}

/// Row i of a contact with the normal last, where it comes first.
Index turned(Index i) { return i - i % 3 + (i + 1) % 3; }

VectorXd turned(const VectorXd& given) {
  VectorXd result(given.size());
  for (Index i = 0; i < given.size(); ++i) result[turned(i)] = given[i];
  return result;
}

void turn(ContactProblem& problem) {
  SparseRows W;
  W.cols = problem.W.cols;
  for (Index i = 0; i < W.cols; ++i) {
    VectorXd row = VectorXd::Zero(W.cols);
    for (const auto& [j, value] : problem.W.row(i - i % 3 + (i + 2) % 3)) row[turned(j)] = value;
    W.add_row(row);
  }
  problem.W = std::move(W);
  problem.b = turned(problem.b);
  for (Index a = 0; a < problem.V.cols(); ++a)
    problem.V.col(a) = turned(VectorXd(problem.V.col(a)));
}

void take_forces(const ContactParts& parts, ContactProblem& problem) {
  const VectorXd r = parts.vector({"r"}, problem.b.size(), "forces, three numbers a contact");
  problem.r = problem.normal_last ? turned(r) : r;
}

ContactProblem problem_of(const ContactParts& parts, bool normal_last) {
  ContactProblem problem;
  const std::string friction = "a number a contact";
  const Index k = parts.part({"mu"}, -1, 1, friction).rows(), n = 3 * k;
  if (k == 0) parts.refuse("\"mu\" is empty: there is no contact");
  if (n > ContactSettings::most_rows)
    parts.refuse(counted(k, "contact") + " have " + std::to_string(n) + " forces; at most " +
                 std::to_string(ContactSettings::most_rows) + " are solved within a gigabyte");
  problem.mu = parts.vector({"mu"}, k, friction);
  if (parts.has("M")) {
    for (const char* key : {"W", "b", "g"})
      if (parts.has(key))
        parts.refuse(desktop::quoted(key) + " beside \"M\": W and b come from M, H, f and w, so "
                                            "leave out one or the other");
    condense(parts, n, problem);
  } else {
    problem.W = parts.part({"W", "G"}, n, n, "the Delassus matrix, three rows for each of \"mu\"");
    problem.b = parts.vector({"b", "g", "q"}, n, "a column, three numbers for each of \"mu\"");
  }
  read_equalities(parts, n, problem);
  check_symmetric(parts, problem.W, "Delassus");
  for (Index c = 0; c < k; ++c)
    if (problem.mu[c] < 0)
      parts.refuse("\"mu\" of contact " + std::to_string(c + 1) + " is " + shown(problem.mu[c]) +
                   "; friction is >= 0");
  problem.unread = parts.unread;
  problem.normal_last = normal_last || parts.is_normal_last;
  if (problem.normal_last) turn(problem);
  if (parts.has("r")) take_forces(parts, problem);
  return problem;
}

} // namespace

ContactProblem in_other_order(ContactProblem problem) {
  for (int turns = problem.normal_last ? 2 : 1; turns > 0; --turns) { // three lead back
    turn(problem);
    if (problem.r) problem.r = turned(*problem.r);
  }
  problem.normal_last = !problem.normal_last;
  return problem;
}

ContactProblem parse_contacts(const std::string& text, const std::string& name, bool normal_last) {
  return problem_of(ContactParts(parse_json(text, name), name), normal_last);
}

ContactProblem read_contacts(const std::string& path, bool normal_last) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    return problem_of(ContactParts(path), normal_last);
  const std::string name = file_label(path);
  if (std::filesystem::path(path).extension() == ".toml")
    throw InputError(name + ": a scene; `lcpush export " + path +
                     " -o DIR` writes its contacts to DIR/fclib, which this command reads");
  const JsonValue root = parse_json(read_text_file(path, limits::answer_bytes), name);
  return problem_of(ContactParts(root, name), normal_last); // the text is gone before the rows come
}

void read_contact_forces(const std::string& path, ContactProblem& problem) {
  JsonValue root;
  if (std::filesystem::path(path).extension() == ".mtx") {
    const HostMatrix r = read_matrix_market(path);
    JsonArray column;
    for (const double x : r.values) column.push_back({1, x});
    root.data = column;
  } else {
    root = parse_json(read_text_file(path, limits::answer_bytes), file_label(path));
  }
  JsonValue object{root.line, root.data};
  if (root.as<JsonArray>() != nullptr) object.data = JsonObject{{"r", root}};
  take_forces(ContactParts(object, file_label(path)), problem);
}

} // namespace lcpush::desktop
