// Scenes that can be solved and were not meant.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <sstream>
#include <tuple>

#include "lcpush/desktop/scene_check.hpp"
#include "support/scene_text.hpp"

using namespace lcpush;
using namespace lcpush::desktop;

namespace {

std::string text_of(const std::string& path) {
  std::ifstream stream(std::string(LCPUSH_SOURCE_DIR) + path);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string slide() { return text_of("/tests/scenes/box_slide.toml"); }

/// The codes of what is odd about the scene.
std::vector<std::string> codes(const std::string& text) {
  std::vector<std::string> found;
  for (const SceneDoubt& doubt : check_scene(parsed(text)))
    found.emplace_back(doubt_code(doubt.doubt));
  return found;
}

using Codes = std::vector<std::string>;

std::string vector_of(const Vector3<double>& v) {
  std::ostringstream text;
  text << "[" << v[0] << ", " << v[1] << ", " << v[2] << "]";
  return text.str();
}

/// A hand that grips a box of any size anywhere, and a wall that pushes it: all as it should be.
std::string sensible_scene(unsigned seed) {
  std::mt19937 random(seed);
  const auto uniform = [&](double from, double to) {
    return from + (to - from) * static_cast<double>(random() % 100001) / 100000;
  };
  const Vector3<double> size(uniform(0.01, 0.3), uniform(0.01, 0.3), uniform(0.002, 0.1));
  const Vector3<double> middle(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
  const Index grip = static_cast<Index>(random() % 3),
              push = (grip + 1 + static_cast<Index>(random() % 2)) % 3;
  const auto on_face = [&](Index axis, double side) {
    Vector3<double> p;
    for (Index k = 0; k < 3; ++k) p[k] = middle[k] + uniform(-0.4, 0.4) * size[k];
    p[axis] = middle[axis] + side * size[axis] / 2;
    return p;
  };
  std::ostringstream text;
  text << "gravity = [0, " << uniform(-10, 0)
       << ", 0]\n[object]\nmass = " << uniform(100, 9000) * size.prod()
       << "\nbox = " << vector_of(size) << "\ncenter_of_mass = " << vector_of(middle) << "\n";
  const double force = uniform(1, 50);
  for (const double side : {-1.0, 1.0})
    text << "[[finger]]\nname = \"" << (side < 0 ? "left" : "right")
         << "\"\nshape = \"point\"\ncenter = " << vector_of(on_face(grip, side))
         << "\nnormal = " << vector_of(-side * Vector3<double>::Unit(grip))
         << "\nfriction = " << uniform(0, 1) << "\ngrip_force = " << force << "\n";
  Vector3<double> motion = Vector3<double>::Zero();
  motion[push] = uniform(0.01, 2); // toward the object
  text << "[[pusher]]\nname = \"wall\"\nshape = \"points\"\npoints = ["
       << vector_of(on_face(push, -1)) << ", " << vector_of(on_face(push, -1))
       << "]\nnormal = " << vector_of(Vector3<double>::Unit(push))
       << "\nfriction = 0.3\nacceleration = " << vector_of(motion) << "\n";
  return text.str();
}

} // namespace

TEST_CASE("nothing is odd about any shipped scene") {
  Index count = 0;
  for (const auto& folder : {"scenes", "rays", "regressions"})
    for (const auto& entry : std::filesystem::directory_iterator(std::string(LCPUSH_SOURCE_DIR) +
                                                                 "/fixtures/" + folder)) {
      std::ifstream stream(entry.path());
      const std::string text((std::istreambuf_iterator<char>(stream)), {});
      CAPTURE(entry.path().string());
      CHECK(codes(text) == Codes{});
      ++count;
    }
  CHECK(count >= 25);
}

TEST_CASE("nothing is odd about 1,000 random grasps of boxes, wherever they are") {
  for (unsigned seed = 0; seed < 1000; ++seed) {
    CAPTURE(seed);
    CHECK(codes(sensible_scene(seed)) == Codes{});
  }
}

TEST_CASE("what of an edge or a rectangle lies beside the box does not press") {
  const auto read = [](const std::string& from, const std::string& to) {
    return parsed(with(slide(), from, to));
  };
  const std::string ends = "ends = [[-0.05, -0.015, 0], [-0.05, 0.015, 0]]";
  const SceneFile whole = read(ends, ends);
  for (const auto& [low, high, beyond] :
       {std::tuple("-0.1", "0.1", "85 mm"), std::tuple("-0.015", "0.3", "285 mm")}) {
    const std::string longer =
        std::string("ends = [[-0.05, ") + low + ", 0], [-0.05, " + high + ", 0]]";
    const SceneFile cut = read(ends, longer);
    for (std::size_t i = 0; i < whole.points.size(); ++i)
      CHECK(cut.points[i].isApprox(whole.points[i], 1e-12));
    const std::vector<SceneDoubt> doubts = check_scene(cut);
    REQUIRE(doubts.size() == 1);
    CHECK(doubts[0].doubt == Doubt::overhang);
    CHECK(doubts[0].text.find(beyond) != std::string::npos);
    // A motion goes on: what lies beside now may press later.
    const SceneFile moved = parse_scene(with(slide(), ends, longer), "s.toml", Strokes::all);
    CHECK(moved.points.back().y() != doctest::Approx(0.015));
    const SceneOf<Rational> exact = parse_scene<Rational>(with(slide(), ends, longer), "s.toml");
    CHECK(exact.points.back()[1] == Rational(15) / Rational(1000));
  }
  // Within what models round off nothing is cut; nor where the whole object stands elsewhere.
  CHECK(read(ends, "ends = [[-0.05, -0.016, 0], [-0.05, 0.016, 0]]").points.back().y() ==
        doctest::Approx(0.016));
  const SceneFile pads = parsed(
      with(with(slide(), "shape = \"disc\" ", "shape = \"rectangle\"\ntangent = [1, 0, 0]\n"),
           "radius = 0.005 ", "size = [0.02, 0.08]\n"));
  for (const Index i : points_of(pads.body(0)))
    CHECK(std::abs(pads.points[static_cast<std::size_t>(i)].y()) < 0.0151);
  CHECK(pads.overhang[0] == doctest::Approx(0.025));
}

TEST_CASE("a slip of the hand is named, with its line and what to do") {
  const std::string edge = "ends = [[-0.05, -0.015, 0], [-0.05, 0.015, 0]]";
  const struct {
    std::string what, from, to;
    Doubt doubt;
    std::string says = "";
    int line = 0; ///< or any
  } slips[] = {{"a finger beside the box", "center = [0, 0, 0.005]", "center = [0, 0.18, 0.005]",
                Doubt::outside_object, "169 mm outside of the box", 16},
               {"a finger in the middle of the box", "center = [0, 0, 0.005]", "center = [0, 0, 0]",
                Doubt::outside_object, "5 mm inside of the box"},
               {"a pusher far below", edge, "ends = [[-0.05, -5, 0], [-0.05, -5.015, 0]]",
                Doubt::far_from_object},
               {"a normal that points outward", "normal = [0, 0, -1]", "normal = [0, 0, 1]",
                Doubt::normal_outward, "here [0, 0, -1]"},
               {"a pusher whose normal is reversed: the face that all its points touch",
                "normal = [1, 0, 0]", "normal = [-1, 0, 0]", Doubt::normal_outward,
                "points out of the box; normals point into the object, here [1, 0, 0]"},
               {"a line along its own normal", "[-0.05, 0.015, 0]]", "[0.05, -0.015, 0]]",
                Doubt::normal_along},
               {"friction in percent", "friction = 0.3", "friction = 30", Doubt::friction, "", 36},
               {"gravity in mm/s^2", "-9.81", "-9810", Doubt::gravity},
               {"a push that no machine makes", "acceleration = [0.1", "acceleration = [1e6",
                Doubt::acceleration},
               {"inertia in g mm^2", "box = [0.1, 0.03, 0.01]", "inertia = [17000, 168000, 182000]",
                Doubt::inertia},
               {"a pusher that moves away", "acceleration = [0.1", "acceleration = [-0.1",
                Doubt::moves_away},
               {"a centre of mass that is not the box's middle", "mass = 0.2",
                "center_of_mass = [0.3, 0, 0]\nmass = 0.2", Doubt::center_of_mass},
               {"grams for kilograms", "mass = 0.2", "mass = 200", Doubt::density}};
  for (const auto& slip : slips) {
    CAPTURE(slip.what);
    const std::vector<SceneDoubt> doubts = check_scene(parsed(with(slide(), slip.from, slip.to)));
    REQUIRE(doubts.size() == 1);
    CHECK(doubts[0].doubt == slip.doubt);
    CHECK(doubts[0].file == "s.toml");
    CHECK(doubts[0].text.find(slip.says) != std::string::npos);
    if (slip.line > 0) CHECK(doubts[0].line == slip.line);
  }
  const std::string same = with(slide(), "center = [0, 0, -0.005]", "center = [0.02, 0, 0.005]");
  CHECK(codes(with(same, "normal = [0, 0, 1]", "normal = [0, 0, -1]")) == Codes{"jaws_same_side"});
  std::string corner = with(slide(), "center = [0, 0, 0.005]", "center = [0.05, 0.015, 0.01]");
  corner = with(corner, "center = [0, 0, -0.005]", "center = [0.05, 0.015, 0]");
  corner = with(corner, edge, "ends = [[0, 0, 0.005], [0, 0.03, 0.005]]");
  CHECK(codes(corner) == Codes{"center_of_mass"});
  CHECK(check_scene(parsed(corner))[0].text.find("around [0.05, 0.015, 0.005]") !=
        std::string::npos);
  const std::vector<SceneDoubt> millimetres =
      check_scene(parsed(with(slide(), "box = [0.1, 0.03, 0.01]", "box = [100, 30, 10]")));
  CHECK(millimetres.front().doubt == Doubt::density);
  CHECK(millimetres.size() == 4); // and no contact is on its surface
}

TEST_CASE("a pusher that was moved along its face is no slip of the object's middle") {
  // A long bar, so that what presses beside its narrow face is not far off, of its length.
  const std::string bar =
      with(with(slide(), "box = [0.1, 0.03, 0.01]", "box = [0.12, 0.022, 0.01]"),
           "ends = [[-0.05, -0.015, 0], [-0.05, 0.015, 0]]",
           "ends = [[-0.06, -0.003, 0], [-0.06, 0.019, 0]]");
  const std::vector<SceneDoubt> doubts = check_scene(parsed(bar));
  REQUIRE(doubts.size() == 1);
  CHECK(doubts[0].doubt == Doubt::overhang);
  CHECK(doubts[0].text.find("it reaches 8 mm beyond the box") != std::string::npos);
}

TEST_CASE("a finger that nothing meets, and a table that ends where the object does") {
  const std::string object = "gravity = [0, -9.81, 0]\n[object]\nmass = 0.06\n"
                             "box = [0.12, 0.022, 0.014]\n";
  const auto finger = [](const std::string& name, const std::string& more) {
    return "[[finger]]\nname = \"" + name + "\"\nfriction = 0.5\n" + more;
  };
  const std::string pad = "shape = \"disc\"\nradius = 0.004\n", grip = pad + "grip_force = 25\n";
  const std::string push = "[[pusher]]\nname = \"wall\"\nshape = \"point\"\non = \"-x\"\n"
                           "friction = 0.3\nvelocity = [0.01, 0, 0]\n";
  const std::string alone = object + finger("pad", grip + "on = \"+z\"\n");
  CHECK(codes(alone + push) == Codes{"unopposed"});
  CHECK(codes(alone + finger("stop", pad + "on = \"-z\"\n") + push) == Codes{});
  CHECK(codes(object + finger("lift", grip + "on = \"-y\"\n") + push) == Codes{}); // its weight
  const std::string flat = "planar = true\n" + object + finger("left", grip + "on = \"+z\"\n");
  const auto right = [&](const std::string& force, const std::string& face) {
    return finger("right", pad + "grip_force = " + force + "\non = \"" + face + "\"\n");
  };
  CHECK(codes(flat + right("25", "-z") + push) == Codes{});
  CHECK(codes(flat + right("20", "-z") + push) == Codes{"unopposed"});
  CHECK(codes(flat + right("25", "+z") + push) == Codes{"unopposed"});
  CHECK(codes(flat + right("20", "-z") + finger("stop", pad + "on = \"-z\"\n") + push) == Codes{});
  const std::string both = with(flat, "planar = true", "planar = false");
  CHECK(codes(both + right("25", "-z")) == Codes{});
  CHECK(codes(both + right("25", "+z")) == Codes{"unopposed"});
  CHECK(codes(both + right("20", "-z")) == Codes{"unopposed"});
  const std::string table = object + finger("table", "shape = \"rectangle\"\nsize = [0.12, 0.014]\n"
                                                     "on = \"-y\"\n");
  CHECK(codes(table + push) == Codes{"small_table"});
  CHECK(codes(with(table, "size = ", "points_on = \"object\"\nsize = ") + push) == Codes{});
  CHECK(codes(table) == Codes{});
  CHECK(codes(with(table, "gravity = ", "# gravity = ") + push) == Codes{"no_load"});
}

TEST_CASE("fingers that yield to the push are named, and only those") {
  const std::string roll = text_of("/tests/scenes/cylinder_roll.toml");
  CHECK(codes(with(roll, "jaws = \"parallel\"", "jaws = \"independent\"")) ==
        Codes{"jaws_independent"});
  CHECK(codes(with(slide(), "jaws = \"parallel\"", "jaws = \"independent\"")) == Codes{});
}

TEST_CASE("where the shape is not known, only far places and retreating pushers are odd") {
  const std::string bare = with(slide(), "box = [0.1, 0.03, 0.01]", "inertia = [1e-5, 1e-4, 1e-4]");
  CHECK(codes(bare) == Codes{});
  CHECK(codes(with(bare, "normal = [0, 0, -1]", "normal = [0, 0, 1]")) == Codes{"jaws_same_side"});
  CHECK(codes(with(bare, "center = [0, 0, 0.005]", "center = [0, 0, 5]")) ==
        Codes{"far_from_object"});
  CHECK(codes(with(bare, "acceleration = [0.1", "acceleration = [-0.1")) == Codes{"moves_away"});
}
