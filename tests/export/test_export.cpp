// What `lcpush export` writes, read again: the same problem, bit for bit. That other solvers solve
// it: crosscheck/.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <map>

#include "lcpush/desktop/export.hpp"
#include "lcpush/desktop/matrix_market.hpp"
#include "support/fixture_push.hpp"
#include "support/full_elimination.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

// An edge, a soft point, a bilateral pusher, an actuator that turns a body and has inertia.
const std::string mixed =
    table("[object]", "mass = 0.5; box = [0.1, 0.04, 0.02]") +
    finger("pad", "rectangle",
           "center = [0.01, 0, 0.01]; normal = [0, 0, -1]; size = [0.02, 0.01]; points = [3, 2]; "
           "friction = 0.4") +
    finger("tip", "point",
           "center = [0, 0, -0.01]; normal = [0, 0, 1]; friction = 0.6; torsion_radius = 0.003") +
    pusher("wall", "line",
           "ends = [[-0.05, -0.01, 0], [-0.05, 0.01, 0]]; points = 3; normal = [1, 0, 0]; friction "
           "= 0.3; follow = \"bilateral\"; acceleration = [0.1, 0, 0]") +
    table("[[actuator]]", "name = \"tendon\"; bodies = [\"pad\", \"tip\"]; twists = [[0, 0, -1, 0, "
                          "2, 0], [0, 0, 1, 0, 0, 0]]; force = 20; inertia = 0.05");

// A finger with inertia pushes an object that nothing else holds: the one that closes.
const std::string pushed_free =
    table("", "gravity = [0, 0, 0]") + table("[object]", "mass = 0.5; box = [0.1, 0.04, 0.02]") +
    finger("thumb", "point", "center = [-0.05, 0.01, 0]; normal = [1, 0, 0]; friction = 0.3") +
    table("[[actuator]]", "name = \"motor\"; bodies = [\"thumb\"]; twists = [[2, 0, 0, 0, 0, 0]]; "
                          "force = 2; inertia = 0.3");

struct Example {
  std::string name;
  desktop::SceneFile file;
};

std::vector<Example> examples() {
  std::vector<Example> all;
  for (const auto& entry :
       std::filesystem::directory_iterator(LCPUSH_SOURCE_DIR "/fixtures/scenes"))
    if (entry.path().extension() == ".toml")
      all.push_back({entry.path().stem().string(), desktop::read_scene(entry.path().string())});
  std::sort(all.begin(), all.end(),
            [](const Example& a, const Example& b) { return a.name < b.name; });
  REQUIRE(all.size() >= 21);
  all.push_back({"mixed", desktop::parse_scene(mixed, "mixed.toml")});
  all.push_back({"pushed_free", desktop::parse_scene(pushed_free, "pushed_free.toml")});
  for (const char* change : {"pressure = \"even\"\n", "pressure = \"even\"\nplanar = true\n"})
    all.push_back(
        {change, desktop::parse_scene(change + scene_text("straight_slide.toml"), "even.toml")});
  return all;
}

/// The matrices of an export, read from its texts.
class ReadBack {
public:
  explicit ReadBack(const desktop::Export& result) {
    for (const desktop::ExportFile& file : result.files) {
      CHECK(texts_.emplace(file.name, file.text).second);
      CHECK(file.text.size() > 0);
    }
  }
  bool has(const std::string& name) const { return texts_.count(name + ".mtx") > 0; }
  MatrixX<double> operator()(const std::string& name) const {
    REQUIRE(has(name));
    const desktop::HostMatrix read = desktop::parse_matrix_market(texts_.at(name + ".mtx"), name);
    MatrixX<double> matrix(read.rows, read.cols);
    for (Index j = 0; j < read.cols; ++j)
      for (Index i = 0; i < read.rows; ++i) matrix(i, j) = read(i, j);
    return matrix;
  }

private:
  std::map<std::string, std::string> texts_;
};

/// The exported program, and M and q of the full form that it must come from.
struct Program {
  MatrixX<double> H, f, A, b, Aeq, beq, lb, ub;
  MatrixX<double> M, q;

  explicit Program(const ReadBack& read)
      : H(read("H")), f(read("f")), A(read("A")), b(read("b")), Aeq(read("Aeq")), beq(read("beq")),
        lb(read("lb")), ub(read("ub")), M(A.rows() + Aeq.rows(), A.cols()), q(M.rows(), 1) {
    M << -A, Aeq;
    q << b, -beq;
  }
  Index complementary() const { return A.rows(); }
};

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

double size_of_all(const MatrixX<double>& m) { return m.size() == 0 ? 0 : m.cwiseAbs().maxCoeff(); }

} // namespace

TEST_CASE("export: the complementarity problem reads back bit for bit") {
  for (const Example& example : examples()) {
    CAPTURE(example.name);
    desktop::Push push(example.file);
    const Problem<double> problem = push.assembly().problem();
    const desktop::Export result = desktop::export_scene(example.file);
    const ReadBack read(result);
    const MatrixX<double> M = read("M"), q = read("q");
    REQUIRE(M.rows() == problem.size);
    CHECK(result.unknowns == problem.size);
    MatrixX<double> own(problem.size, problem.size);
    fill_matrix(problem, MatrixMap<double>(own.data(), problem.size, problem.size));
    Index different = 0;
    for (Index j = 0; j < problem.size; ++j) {
      different += same_bits(q(j, 0), problem.q[j]) ? 0 : 1;
      for (Index i = 0; i < problem.size; ++i) different += same_bits(M(i, j), own(i, j)) ? 0 : 1;
    }
    CHECK(different == 0);
  }
}

TEST_CASE("export: the paper's program rebuilds the full form, number for number") {
  for (const Example& example : examples()) {
    CAPTURE(example.name);
    desktop::Push push(example.file);
    const FullElimination full(push.assembly());
    const Program program((ReadBack(desktop::export_scene(example.file))));
    const Index n = full.form.size(), c = program.complementary();
    REQUIRE(program.M.rows() == n);
    REQUIRE(program.M.cols() == n);
    CHECK(c == push.layout().size - push.layout().actuators);
    CHECK(program.M == full.M);
    CHECK(program.q.col(0) == full.q);
    MatrixX<double> C = full.M;
    C.bottomRows(n - c).setZero();
    CHECK(program.H == MatrixX<double>(C + C.transpose()));
    CHECK(program.f.topRows(c) == full.q.head(c));
    CHECK(program.f.bottomRows(n - c).isZero(0));
    CHECK(program.lb.topRows(c).isZero(0));
    CHECK((program.lb.bottomRows(n - c).array() == -desktop::no_bound).all());
    CHECK((program.ub.array() == desktop::no_bound).all());
  }
}

TEST_CASE("export: FCLIB's arrays give the same motion, and its cone holds up to the facets") {
  Index sliding = 0, refused = 0;
  for (const Example& example : examples()) {
    CAPTURE(example.name);
    const desktop::Export result = desktop::export_scene(example.file);
    const ReadBack read(result);
    if (!result.fclib_refusal.empty()) {
      ++refused;
      CHECK(result.absent.size() == 6);
      CHECK_FALSE(read.has("fclib/W"));
      continue;
    }
    desktop::Push push(example.file);
    const Index k = push.layout().points, e = push.layout().actuators;
    CHECK(result.absent.size() == (e > 0 ? 0 : 3));
    const desktop::PushReport report = push.solve({});
    if (report.status != Status::solved) continue;
    const MatrixX<double> W = read("fclib/W"), mu = read("fclib/mu"), q = read("fclib/q");
    const auto of_actuators = [&](const std::string& name, Index rows, Index cols) {
      return e > 0 ? read(name) : MatrixX<double>(rows, cols);
    };
    const MatrixX<double> V = of_actuators("fclib/V", 3 * k, 0), R = of_actuators("fclib/R", 0, 0),
                          s = of_actuators("fclib/s", 0, 1);
    CHECK(W == MatrixX<double>(W.transpose()));
    REQUIRE(V.cols() == e);
    const double force = push.layout().scales.force, rate = push.layout().scales.acceleration;
    VectorX<double> r(3 * k), u(3 * k), l(e);
    for (Index i = 0; i < k; ++i) {
      const ContactAnswer<double>& contact = report.answer.contacts[i];
      const Body<double>& body = push.scene().bodies[push.layout().body[i]];
      const Vector3<double> axes[] = {body.normal, body.tangent, cross(body.normal, body.tangent)};
      for (Index c = 0; c < 3; ++c) {
        r[3 * i + c] = axes[c].dot(contact.normal_force * body.normal + contact.friction_force);
        u[3 * i + c] = axes[c].dot(contact.acceleration);
      }
    }
    for (Index a = 0; a < e; ++a) l[a] = -report.answer.closing[a];
    if (example.name == "pushed_free") CHECK(size_of_all(l) > 0.1); // R has something to say
    const double size = larger(larger(1, size_of_all(r) / force), size_of_all(l) / rate);
    CHECK(size_of_all(W * r + V * l + q.col(0) - u) <= 1e-9 * size * rate);
    if (e > 0) CHECK(size_of_all(V.transpose() * r + R * l + s.col(0)) <= 1e-9 * size * force);
    for (Index i = 0; i < k; ++i) {
      const double friction = r.segment<2>(3 * i + 1).norm(), slip = u.segment<2>(3 * i + 1).norm();
      const double bound = mu(i, 0) * r[3 * i];
      CHECK(friction <= bound + 1e-9 * size * force);
      // r in K and u + mu |u_t| n: zero product for the round cone.
      const double gap = r.segment<3>(3 * i).dot(u.segment<3>(3 * i)) + bound * slip;
      const double facets = 1 - std::cos(3.14159265358979 / double(push.scene().facets));
      CHECK(gap >= -1e-9 * size * size * force * rate);
      CHECK(gap <= facets * bound * slip + 1e-9 * size * size * force * rate);
      if (slip > 1e-6 * rate && bound > 1e-6 * force) ++sliding;
    }
  }
  CHECK(sliding > 20);
  CHECK(refused >= 2); // soft_fingers, mixed
}

TEST_CASE("export: pad and rigid scenes have the same files, even ones are spread") {
  const auto text = [](const std::string& pressure) {
    const desktop::SceneFile file = desktop::parse_scene(
        "pressure = \"" + pressure + "\"\n" + scene_text("straight_slide.toml"), "slide.toml");
    return desktop::export_scene(file);
  };
  const desktop::Export pad = text("pad"), rigid = text("rigid"), even = text("even");
  REQUIRE(pad.files.size() == rigid.files.size());
  for (std::size_t i = 0; i < pad.files.size(); ++i) {
    CHECK(pad.files[i].name == rigid.files[i].name);
    CHECK(pad.files[i].text == rigid.files[i].text);
  }
  CHECK(!pad.free.empty());
  CHECK(std::count(pad.free.begin(), pad.free.end(), ',') == 0);   // one jaw
  CHECK(std::count(even.free.begin(), even.free.end(), ',') == 7); // four points a finger
}
