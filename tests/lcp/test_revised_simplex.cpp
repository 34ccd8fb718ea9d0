// Programs of few rows by exchanges, against the desktop's tableau, which shares no code with them.
#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <vector>

#include "dense/simplex.hpp"
#include "lcpush/lcp/revised_simplex.hpp"

using namespace lcpush;

namespace {

/// A stored matrix, and the memory of its programs.
struct StoredProgram {
  Eigen::MatrixXd C;
  Eigen::VectorXd e, b;

  Index count() const { return C.cols(); }
  void write(Index j, const Span<double>& column) const {
    for (Index i = 0; i < C.rows(); ++i) column[i] = C(i, j);
  }
  template <class Visit> void for_each_product(const Span<double>& y, const Visit& visit) const {
    for (Index j = 0; j < C.cols(); ++j)
      visit(j, Eigen::Map<const Eigen::VectorXd>(y.data, y.size).dot(C.col(j)));
  }

  Status minimise(double c, bool with_x, Index most_exchanges, double& value) const {
    const Index m = C.rows();
    Eigen::MatrixXd numbers = Eigen::MatrixXd::Zero(m, m + 6);
    Eigen::Matrix<Index, Eigen::Dynamic, 1> basis(m);
    const auto span = [&](Index k) { return Span<double>{numbers.col(k).data(), m}; };
    numbers.col(m) = b;
    numbers.col(m + 1) = e;
    const SimplexMemory<double> memory{{numbers.data(), m * m},
                                       span(m),
                                       span(m + 1),
                                       span(m + 2),
                                       span(m + 3),
                                       span(m + 4),
                                       span(m + 5),
                                       {basis.data(), m}};
    RevisedSimplex<double, StoredProgram> program(*this, memory);
    value = 0;
    return program.minimise(c, with_x, most_exchanges, value);
  }

  /// By the tableau.
  Status expected(double c, bool with_x, double& value) const {
    using Ending = desktop::Simplex::Ending;
    if (desktop::Simplex feasible(C, b, 0); !with_x && feasible.find_point() == Ending::none)
      return Status::does_not_hold;
    Eigen::MatrixXd A(C.rows(), C.cols() + 1);
    A << e, C;
    desktop::Simplex program(A, b, 0);
    const Ending found = program.find_point();
    if (found != Ending::found)
      return found == Ending::none ? Status::does_not_hold : Status::bad_input;
    const Ending ended = program.minimise(c * Eigen::VectorXd::Unit(A.cols(), 0));
    value = program.point()[0];
    return ended == Ending::found       ? Status::solved
           : ended == Ending::unbounded ? Status::ray
                                        : Status::bad_input;
  }
};

} // namespace

TEST_CASE("a row that is met without an unknown of its own stays met") {
  StoredProgram program{Eigen::Vector2d(1, 0), Eigen::Vector2d(1, -1), Eigen::Vector2d(1, 0)};
  double value = 1;
  CHECK(program.minimise(-1, false, 9, value) == Status::solved);
  CHECK(value == 0);
  program.C = Eigen::Matrix2d::Identity(); // now the second row has one
  CHECK(program.minimise(-1, false, 9, value) == Status::solved);
  CHECK(value == doctest::Approx(1));
}

TEST_CASE("Beale's program, where the steepest exchanges may go round for ever, ends at 1/20") {
  StoredProgram program{Eigen::MatrixXd(4, 7), Eigen::Vector4d(0, 0, 0, 1),
                        Eigen::Vector4d(0, 0, 1, 0)};
  program.C << 0.25, -60, -0.04, 9, 1, 0, 0, //
      0.5, -90, -0.02, 3, 0, 1, 0,           //
      0, 0, 1, 0, 0, 0, 1,                   //
      -0.75, 150, -0.02, 6, 0, 0, 0;
  double value = 0;
  CHECK(program.minimise(-1, true, 50, value) == Status::solved);
  CHECK(value == doctest::Approx(0.05));
}

TEST_CASE("2000 programs of small whole numbers end as the tableau's, ties or not") {
  std::mt19937 random(1);
  const auto whole = [&](int least, int most) {
    return least + static_cast<int>(random() % static_cast<unsigned>(most - least + 1));
  };
  int solved = 0, endless = 0, empty = 0;
  for (int k = 0; k < 2000; ++k) {
    CAPTURE(k);
    const Index m = whole(1, 6);
    StoredProgram program{Eigen::MatrixXd(m, whole(1, 12)), Eigen::VectorXd(m), Eigen::VectorXd(m)};
    for (double& entry : program.C.reshaped()) entry = whole(-1, 1);
    for (double& entry : program.e) entry = whole(-1, 1);
    for (double& entry : program.b) entry = whole(-2, 2);
    const double c = whole(0, 1) == 0 ? -1 : 1;
    const bool with_x = whole(0, 1) == 0;
    double value = 0, expected = 0;
    const Status status = program.minimise(c, with_x, 200, value);
    CHECK(status == program.expected(c, with_x, expected));
    if (status == Status::solved) CHECK(std::abs(value - expected) < 1e-9);
    ++(status == Status::solved ? solved : status == Status::ray ? endless : empty);
  }
  CHECK(solved > 200);
  CHECK(endless > 50);
  CHECK(empty > 200);
}
