// What of a patch lies beside the object does not press.
#include "lcpush/desktop/scene_check.hpp"
#include "support/scene_text.hpp"

using namespace lcpush;
using namespace lcpush::desktop;

namespace {

SceneFile touched(const std::string& object, const std::string& normal, const std::string& patch) {
  return parsed("[object]\nmass = 0.05\n" + object + "\n[[finger]]\nname = \"table\"\nnormal = " +
                normal + "\nfriction = 0.5\n" + patch + "\n");
}

} // namespace

TEST_CASE("a patch that reaches beyond the object presses where the two touch, and says so") {
  const std::string box = "box = [0.08, 0.06, 0.04]", rod_y =
                                                          "cylinder_radius = 0.01\naxis = \"y\"\n"
                                                          "cylinder_length = 0.1";
  const std::string up = "[0, 1, 0]", along = "[1, 0, 0]";
  const struct {
    const char* what;
    std::string object, normal, patch;
    std::size_t count;
    Vector3<double> first, last;
  } cases[] = {
      {"a long edge",
       box,
       along,
       "shape = \"line\"\nends = [[-0.04, -0.1, 0], [-0.04, 0.1, 0]]",
       4,
       {-0.04, -0.03, 0},
       {-0.04, 0.03, 0}},
      {"one that begins on the face",
       box,
       along,
       "shape = \"line\"\npoints = 3\nends = [[-0.04, 0.01, 0.01], [-0.04, 0.01, 0.1]]",
       3,
       {-0.04, 0.01, 0.01},
       {-0.04, 0.01, 0.02}},
      {"one askew",
       box,
       up,
       "shape = \"line\"\nends = [[-0.08, -0.03, -0.04], [0.08, -0.03, 0.04]]",
       4,
       {-0.04, -0.03, -0.02},
       {0.04, -0.03, 0.02}},
      {"a table",
       box,
       up,
       "shape = \"rectangle\"\ncenter = [0.1, -0.03, 0]\nsize = [0.2, 0.2]",
       16,
       {0, -0.03, -0.02},
       {0.04, -0.03, 0.02}},
      {"a round table",
       box,
       up,
       "shape = \"disc\"\ncenter = [0, -0.03, 0]\nradius = 0.2",
       16,
       {-0.04, -0.03, -0.02},
       {0.04, -0.03, 0.02}},
      {"points",
       box,
       up,
       "shape = \"points\"\npoints = [[0, -0.03, 0], [0.1, -0.03, 0], [0, -0.03, 0.01]]",
       2,
       {0, -0.03, 0},
       {0, -0.03, 0.01}},
      {"an edge along a cylinder",
       rod_y,
       along,
       "shape = \"line\"\nends = [[-0.01, -0.2, 0], [-0.01, 0.02, 0]]",
       4,
       {-0.01, -0.05, 0},
       {-0.01, 0.02, 0}},
      {"an edge across it",
       rod_y,
       along,
       "shape = \"line\"\nends = [[-0.01, 0.01, -0.2], [-0.01, 0.01, 0.1]]",
       1,
       {-0.01, 0.01, 0},
       {-0.01, 0.01, 0}},
      {"a plate along it",
       rod_y,
       along,
       "shape = \"rectangle\"\ncenter = [-0.01, 0, 0]\nsize = [0.3, 0.3]",
       4,
       {-0.01, 0.05, 0},
       {-0.01, -0.05, 0}},
      {"an edge over its end",
       rod_y,
       up,
       "shape = \"line\"\nends = [[0.006, -0.05, -0.1], [0.006, -0.05, 0.1]]",
       4,
       {0.006, -0.05, -0.008},
       {0.006, -0.05, 0.008}},
      {"a plate under a ball",
       "sphere_radius = 0.03",
       up,
       "shape = \"rectangle\"\ncenter = [0, -0.03, 0]\nsize = [0.3, 0.3]",
       1,
       {0, -0.03, 0},
       {0, -0.03, 0}},
  };
  for (const auto& c : cases) {
    CAPTURE(c.what);
    const SceneFile file = touched(c.object, c.normal, c.patch);
    REQUIRE(file.positions.size() == c.count);
    CHECK((file.positions.front() - c.first).norm() < 1e-12);
    CHECK((file.positions.back() - c.last).norm() < 1e-12);
    double sum = 0;
    for (const double weight : file.weights) sum += weight;
    CHECK(sum == doctest::Approx(1));
    const std::vector<SceneDoubt> doubts = check_scene(file);
    REQUIRE(doubts.size() == 1);
    CHECK(doubts[0].doubt == Doubt::overhang);
    CHECK(doubts[0].line > 6);
  }
}

TEST_CASE("what lies wholly beside is refused, what lies within is as it was typed") {
  const std::string box = "box = [0.08, 0.06, 0.04]";
  const std::string edge = "shape = \"line\"\nends = [[-0.04, ";
  check_says("[object]\nmass = 0.05\n" + box + "\n" +
                 with(pusher_table, "shape = \"point\"\ncenter = [-0.05, 0, 0]",
                      edge + "0.05, 0], [-0.04, 0.1, 0]]") +
                 "acceleration = [1, 0, 0]\n",
             "7: pusher \"wall\": it lies beside the box and touches nothing");
  const SceneFile file = touched(box, "[1, 0, 0]", edge + "-0.03, 0], [-0.04, 0.03, 0]]");
  CHECK(file.overhang.empty());
  CHECK(check_scene(file).empty());
}
