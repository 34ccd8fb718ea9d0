// Contact problems in JSON and in folders of Matrix Market files, as FCLIB and Siconos name them.
#include "contacts/settings.hpp"
#include "formats/json_fields.hpp"
#include "lcpush/desktop/contacts.hpp"
#include "lcpush/desktop/matrix_market.hpp"
#include "text/format.hpp"
#include "text/limits.hpp"
#include "text/text_file.hpp"

#include <Eigen/SparseCholesky>
#include <filesystem>
#include <map>

namespace lcpush::desktop {
namespace {

using Eigen::VectorXd;
using Sparse = ContactProblem::Sparse;
using Triplets = std::vector<Eigen::Triplet<double>>;

constexpr const char* known_keys[] = {"W", "G", "M",  "H", "b", "g", "q",
                                      "f", "w", "mu", "V", "R", "s", "r"};

Sparse sparse_of(const SparseRows& rows) {
  Sparse matrix(rows.rows(), rows.cols);
  matrix.reserve(static_cast<Index>(rows.entries.size()));
  for (Index i = 0; i < rows.rows(); ++i) {
    matrix.startVec(i);
    for (const SparseEntry& entry : rows.row(i)) matrix.insertBack(i, entry.column) = entry.value;
  }
  matrix.finalize();
  return matrix;
}

/// An array of rows, or of the numbers of a column.
Sparse sparse_of(const JsonValue& value, const JsonFields& fields, const std::string& key) {
  const JsonArray* const array = value.as<JsonArray>();
  if (array == nullptr)
    fields.refuse(value, desktop::quoted(key) + " must be an array of numbers or of rows, got " +
                             value.type());
  SparseRows rows;
  for (const JsonValue& entry : *array) {
    const JsonArray* const row = entry.as<JsonArray>();
    const auto width = row != nullptr ? static_cast<Index>(row->size()) : 1;
    if (rows.rows() == 0) rows.cols = width;
    if (width != rows.cols)
      fields.refuse(entry, "row " + std::to_string(rows.rows() + 1) + " of " +
                               desktop::quoted(key) + " has " + counted(width, "number") +
                               ", the first has " + std::to_string(rows.cols));
    for (Index j = 0; j < width; ++j) {
      const JsonValue& number = row != nullptr ? (*row)[static_cast<std::size_t>(j)] : entry;
      if (number.as<double>() == nullptr)
        fields.refuse(number, desktop::quoted(key) + " must hold numbers, got " + number.type());
      if (*number.as<double>() != 0) rows.add(j, *number.as<double>());
    }
    rows.end_row();
  }
  return sparse_of(rows);
}

/// The parts of a problem by their names, of a file or folder.
class Parts {
public:
  Parts(const JsonValue& root, std::string name) : name_(std::move(name)) {
    const JsonFields fields(name_);
    if (root.as<JsonObject>() == nullptr)
      fields.refuse(root, std::string("a contact problem is an object with \"W\", \"b\" and "
                                      "\"mu\", or with \"M\", \"H\", \"f\" and \"mu\", got ") +
                              root.type());
    for (const char* key : known_keys)
      if (const JsonValue* const value = root.find(key))
        parts_[key] = sparse_of(*value, fields, key);
    const std::string normal = fields.text(root, "normal");
    is_normal_last = normal == "last";
    if (!normal.empty() && normal != "first" && normal != "last")
      fields.refuse(*root.find("normal"), "\"normal\" says which of a contact's three numbers is "
                                          "the normal's: \"first\" or \"last\", not " +
                                              desktop::quoted(normal));
  }
  explicit Parts(const std::string& folder) : name_(folder) {
    for (const char* key : known_keys) {
      const std::string path = folder + "/" + key + ".mtx";
      std::error_code ignored;
      if (std::filesystem::exists(path, ignored)) parts_[key] = sparse_of(read_sparse_matrix(path));
    }
    if (!has("V") && has("R") && !has("r")) parts_["r"] = parts_["R"]; // reactions
  }

  bool is_normal_last = false;

  bool has(const std::string& key) const { return parts_.count(key) > 0; }
  [[noreturn]] void refuse(const std::string& sentence) const {
    throw InputError(name_ + ": " + sentence);
  }
  /// The first that is there. A size < 0 may be any.
  const Sparse& part(const std::vector<std::string>& keys, Index rows, Index cols,
                     const std::string& what) const {
    for (const std::string& key : keys) {
      if (!has(key)) continue;
      const Sparse& part = parts_.at(key);
      if ((rows >= 0 && part.rows() != rows) || (cols >= 0 && part.cols() != cols))
        refuse(desktop::quoted(key) + " is " + std::to_string(part.rows()) + " x " +
               std::to_string(part.cols()) + ", but it is " + what +
               (rows < 0 || cols < 0 ? ""
                                     : ": " + std::to_string(rows) + " x " + std::to_string(cols)));
      return part;
    }
    refuse(desktop::quoted(keys[0]) + " is missing: " + what);
  }
  VectorXd vector(const std::vector<std::string>& keys, Index rows, const std::string& what) const {
    return Eigen::MatrixXd(part(keys, rows, 1, what)).col(0);
  }

private:
  std::string name_;
  std::map<std::string, Sparse> parts_;
};

/// W = H' M^-1 H and b = H' M^-1 f + w.
void condense(const Parts& parts, Index n, ContactProblem& problem) {
  const Index m = parts.part({"M"}, -1, -1, "").rows();
  const Eigen::SparseMatrix<double> M = parts.part({"M"}, m, m, "a square mass matrix");
  Eigen::SparseMatrix<double> H = parts.part({"H", "G"}, -1, -1, "what forces do to the bodies");
  if (H.rows() == n && H.cols() == m && n != m)
    H = Eigen::SparseMatrix<double>(H.transpose()); // as a Jacobian
  else
    H = parts.part({"H", "G"}, m, n, "a row for each of M and three columns a contact");
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(M);
  if (factor.info() != Eigen::Success || !(factor.vectorD().minCoeff() > 0))
    parts.refuse("\"M\" is not positive definite: every mass is > 0");
  const Eigen::SparseMatrix<double> moved = factor.solve(H), W = H.transpose() * moved;
  problem.W = 0.5 * (W + Eigen::SparseMatrix<double>(W.transpose()));
  problem.b = moved.transpose() * parts.vector({"f", "q"}, m, "the load, a number a row of M");
  if (parts.has("w")) problem.b += parts.vector({"w"}, n, "a velocity, three numbers a contact");
}

void read_equalities(const Parts& parts, Index n, ContactProblem& problem) {
  problem.V = Eigen::MatrixXd(n, 0);
  if (!parts.has("V")) return;
  problem.V = Eigen::MatrixXd(parts.part({"V"}, n, -1, "a matrix with three rows a contact"));
  const Index e = problem.V.cols();
  const Eigen::MatrixXd R = parts.part({"R"}, e, e, "square, a row for each column of \"V\"");
  problem.R = R.diagonal();
  if (!R.isDiagonal(0) || (e > 0 && problem.R.maxCoeff() > 0))
    parts.refuse("\"R\" must be diagonal, with entries <= 0: minus inertias");
  problem.s = parts.vector({"s"}, e, "a number a column of \"V\"");
}

void check(const Parts& parts, const ContactProblem& problem) {
  const Sparse& W = problem.W;
  const VectorXd diagonal = W.diagonal();
  for (Index i = 0; i < W.rows(); ++i)
    for (Sparse::InnerIterator entry(W, i); entry; ++entry) {
      const Index j = entry.col();
      const double size = std::sqrt(std::abs(diagonal[i])) * std::sqrt(std::abs(diagonal[j]));
      const bool is_large = std::abs(entry.value()) > (1 + ContactSettings::asymmetric) * size;
      if (diagonal[i] < 0 || is_large ||
          std::abs(entry.value() - W.coeff(j, i)) > ContactSettings::asymmetric * size)
        parts.refuse(
            "the Delassus matrix is not " +
            std::string(diagonal[i] < 0 || is_large ? "positive semidefinite" : "symmetric") +
            ": row " + std::to_string(i + 1) + ", column " + std::to_string(j + 1) + " is " +
            shown(entry.value()) + ", the diagonal " + shown(diagonal[i]) + " and " +
            shown(diagonal[j]) + ", the other side " + shown(W.coeff(j, i)));
    }
  for (Index c = 0; c < problem.contacts(); ++c)
    if (problem.mu[c] < 0)
      parts.refuse("\"mu\" of contact " + std::to_string(c + 1) + " is " + shown(problem.mu[c]) +
                   "; friction is >= 0");
}

/// Row i of a contact with the normal last, where it comes first.
Index turned(Index i) { return i - i % 3 + (i + 1) % 3; }

VectorXd turned(const VectorXd& given) {
  VectorXd result(given.size());
  for (Index i = 0; i < given.size(); ++i) result[turned(i)] = given[i];
  return result;
}

void turn(ContactProblem& problem) {
  Triplets entries;
  for (Index i = 0; i < problem.W.rows(); ++i)
    for (Sparse::InnerIterator entry(problem.W, i); entry; ++entry)
      entries.emplace_back(static_cast<int>(turned(i)), static_cast<int>(turned(entry.col())),
                           entry.value());
  problem.W.setFromTriplets(entries.begin(), entries.end());
  problem.b = turned(problem.b);
  for (Index a = 0; a < problem.V.cols(); ++a)
    problem.V.col(a) = turned(VectorXd(problem.V.col(a)));
}

void take_forces(const Parts& parts, ContactProblem& problem) {
  const VectorXd r = parts.vector({"r"}, problem.b.size(), "forces, three numbers a contact");
  problem.r = problem.normal_last ? turned(r) : r;
}

ContactProblem problem_of(const Parts& parts, bool normal_last) {
  ContactProblem problem;
  const std::string friction = "a number a contact";
  const Index k = parts.part({"mu"}, -1, 1, friction).rows(), n = 3 * k;
  if (k == 0) parts.refuse("\"mu\" is empty: there is no contact");
  if (n > ContactSettings::most_rows)
    parts.refuse(counted(k, "contact") + " have " + std::to_string(n) + " forces; at most " +
                 std::to_string(ContactSettings::most_rows) + " are solved within a gigabyte");
  problem.mu = parts.vector({"mu"}, k, friction);
  if (parts.has("M")) {
    condense(parts, n, problem);
  } else {
    problem.W = parts.part({"W", "G"}, n, n, "the Delassus matrix, three rows for each of \"mu\"");
    problem.b = parts.vector({"b", "g", "q"}, n, "a column, three numbers for each of \"mu\"");
  }
  read_equalities(parts, n, problem);
  check(parts, problem);
  problem.normal_last = normal_last || parts.is_normal_last;
  if (problem.normal_last) turn(problem);
  if (parts.has("r")) take_forces(parts, problem);
  return problem;
}

} // namespace

ContactProblem parse_contacts(const std::string& text, const std::string& name, bool normal_last) {
  return problem_of(Parts(parse_json(text, name), name), normal_last);
}

ContactProblem read_contacts(const std::string& path, bool normal_last) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) return problem_of(Parts(path), normal_last);
  return parse_contacts(read_text_file(path, limits::answer_bytes), file_label(path), normal_last);
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
  take_forces(Parts(object, file_label(path)), problem);
}

} // namespace lcpush::desktop
