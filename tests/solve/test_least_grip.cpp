// The smallest grip is the least: a little less does not hold, a little more does.
#include "support/fixture_push.hpp"
#include "support/random_grasp.hpp"
#include "support/seeds.hpp"

#include "lcpush/desktop/assembled_scene.hpp"
#include "lcpush/desktop/smallest_grip.hpp"
#include "lcpush/mechanics/study/holding.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

/// Writes a body's table: `more` is its shape, and what else it has.
std::string body(const std::string& name, const Vector3<double>& at, const Vector3<double>& normal,
                 double friction, const std::string& more, const char* role = "finger") {
  std::ostringstream text;
  text.precision(12);
  text << "[[" << role << "]]\nname = \"" << name << "\"\ncenter = [" << at[0] << ", " << at[1]
       << ", " << at[2] << "]\nnormal = [" << normal[0] << ", " << normal[1] << ", " << normal[2]
       << "]\nfriction = " << friction << "\n"
       << more;
  return text.str();
}

std::string number(const char* key, double value) {
  std::ostringstream text;
  text.precision(12);
  text << key << " = " << value << "\n";
  return text.str();
}

/// What a finger ends in.
std::string tip(Random& random, bool is_soft) {
  if (is_soft) return "shape = \"point\"\n" + number("torsion_radius", random.uniform(1e-3, 6e-3));
  switch (random.integer(0, 2)) {
  case 0: return "shape = \"point\"\n";
  case 1: return "shape = \"disc\"\n" + number("radius", random.uniform(2e-3, 8e-3));
  default: return "shape = \"rectangle\"\nsize = [0.008, 0.006]\npoints = [2, 2]\n";
  }
}

constexpr const char* laws[] = {"pad", "even", "rigid"};
std::string head(Random& random, const char* law, const char* object) {
  const auto part = [&] {
    return static_cast<double>(random.integer(0, 1)) * random.uniform(-10, 10);
  };
  std::ostringstream text;
  text << "facets = 8\npressure = \"" << law << "\"\ngravity = [" << part() << ", -9.81, " << part()
       << "]\n[object]\nmass = " << random.uniform(0.02, 2) << "\n"
       << object;
  return text.str();
}

/// Two fingers on a box, and on a table or not.
std::string pinched(Random& random, const char* law, bool is_soft, bool has_table) {
  std::string text = head(random, law, "box = [0.1, 0.03, 0.01]\n");
  const bool is_parallel = law != laws[1] && random.integer(0, 1) == 0;
  text += std::string("[gripper]\njaws = \"") + (is_parallel ? "parallel" : "independent") + "\"\n";
  const double force = random.uniform(0.5, 60), x = random.uniform(-0.02, 0.02),
               y = random.uniform(-0.008, 0.008);
  for (const double side : {1.0, -1.0})
    text += body(side > 0 ? "left" : "right", {x, y, side * 0.005}, {0, 0, -side},
                 random.uniform(0.1, 1.2), tip(random, is_soft) + number("grip_force", force));
  if (has_table)
    text +=
        body("table", {random.uniform(-0.03, 0.03), -0.015, 0}, {0, 1, 0}, random.uniform(0, 0.8),
             "shape = \"rectangle\"\nsize = [0.02, 0.008]\npoints = [2, 2]\n");
  return text;
}

/// Three fingers around a disc.
std::string around(Random& random, const char* law) {
  std::string text =
      head(random, law, "cylinder_radius = 0.02\ncylinder_length = 0.02\naxis = \"z\"\n");
  const double force = random.uniform(0.5, 60), friction = random.uniform(0.1, 1.2);
  text += "[gripper]\njaws = \"independent\"\n";
  for (int k = 0; k < 3; ++k) {
    const double angle =
        2.0943951023932 * k + static_cast<double>(random.integer(0, 1)) * random.uniform(-0.4, 0.4);
    const Vector3<double> out(std::cos(angle), std::sin(angle), 0);
    text += body(std::string(1, static_cast<char>('a' + k)),
                 0.02 * out + Vector3<double>(0, 0, random.uniform(-0.005, 0.005)), -out, friction,
                 "shape = \"point\"\n" + number("grip_force", force));
  }
  return text;
}

std::string scene(std::uint64_t seed) {
  Random random(seed);
  const char* const law = laws[seed % 3];
  switch (seed / 3 % 4) {
  case 0: return pinched(random, law, false, false);
  case 1: return pinched(random, law, true, false);
  case 2: return pinched(random, law, random.integer(0, 1) == 0, true);
  default: return around(random, law);
  }
}

bool holds(desktop::SceneFile file, double factor) {
  for (std::size_t a = 0; a < file.actuators.size(); ++a) file.actuators[a].force *= factor;
  desktop::Push push(file);
  const desktop::HoldReport at = push.holds_without_push({});
  return at.status == Status::solved && at.holds;
}

/// The least factor of the devices' program, which has another solver and other columns.
double devices_factor(desktop::SceneFile file) {
  // Any pressure will do, which the program cannot see where pads' normals depend on each other.
  if (file.pressure == Pressure::pad) file.pressure = Pressure::rigid;
  const desktop::AssembledScene assembled(file.view());
  std::vector<unsigned char> bytes(
      static_cast<std::size_t>(holding_bytes<double>(assembled.scene.actuators.size)));
  Holding<double> holding(assembled.assembly, {bytes.data(), static_cast<Index>(bytes.size())});
  const Held<double> held = holding.least_grip(1000);
  REQUIRE(held.status == Status::solved);
  return held.value;
}

} // namespace

// Where laws leave forces open, the one that Lemke's pivots come to may fall though others hold:
// with a little more, forces that hold exist, which the devices' program finds.
TEST_CASE("[T.12] a little less than the smallest grip does not hold, a little more does") {
  int known = 0, searched = 0, of_statics = 0;
  for (std::uint64_t seed = 800; seed < 800 + seeds(400); ++seed) {
    CAPTURE(seed);
    const desktop::SceneFile file = desktop::parse_scene(scene(seed), "test.toml");
    desktop::Push push(file);
    const desktop::HoldReport hold = push.holds_without_push({});
    const desktop::SmallestGrip grip =
        desktop::find_smallest_grip(file, hold, desktop::BreakReport(), {}).alone;
    if (grip.source == desktop::GripSource::no_grip)
      for (const double factor : {0.1, 1.0, 10.0, 1000.0}) CHECK_FALSE(holds(file, factor));
    if (!grip.is_known() || grip.factor == 0) continue;
    ++known;
    searched += grip.source == desktop::GripSource::search ? 1 : 0;
    for (const double part : {0.5, 0.8, 0.9, 0.95, 0.98, 0.99, 0.999, 0.9999, 1 - 1e-5}) {
      CAPTURE(part);
      CHECK_FALSE(holds(file, part * grip.factor));
    }
    if (grip.source == desktop::GripSource::statics) {
      ++of_statics;
      CHECK(devices_factor(file) == doctest::Approx(grip.factor).epsilon(1e-9));
    } else {
      CHECK(holds(file, (1 + 2e-6) * grip.factor));
    }
  }
  CHECK(known >= static_cast<int>(seeds(250)));
  CHECK(searched >= static_cast<int>(seeds(15)));
  CHECK(of_statics >= static_cast<int>(seeds(200)));
}
