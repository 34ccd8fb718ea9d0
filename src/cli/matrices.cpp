// lcpush matrices: the paper's matrices of a scene.
#include "lcpush/desktop/matrices.hpp"
#include "cli/commands.hpp"
#include "cli/scene_arguments.hpp"

namespace lcpush::cli {
namespace {

int run_matrices(const Arguments& arguments) {
  const std::string format = arguments.format();
  const SceneFile file = read_scene_argument(arguments);
  const PaperMatrices matrices = paper_matrices(file);
  const std::vector<SceneDoubt> doubts = check_scene(file);
  write_answer(arguments, format,
               format == "json" ? matrices_json(matrices, doubts) : matrices_text(file, matrices),
               doubts);
  return 0;
}

} // namespace

Command matrices_command() {
  return {"matrices",
          "SCENE.toml [OPTIONS]",
          "the paper's matrices: inertia, grasp matrix, hand Jacobian, generators",
          "Prints the object's inertia M and load w, the grasp matrix G and its polyhedral form\n"
          "G-bar, the hand Jacobian J with the pushers' blocks, what moves as prescribed (the\n"
          "right-hand side v of the contact accelerations r = G' a - J s - v), the friction\n"
          "generators D and, for each patch, its reference points, weights and number of\n"
          "independent rigidity conditions. SI units, scene axes, at the object's centre of mass;\n"
          "the scene as written, unsolved.\n\n"
          "Example:\n  lcpush matrices fixtures/scenes/straight_slide.toml\n",
          with_scene_options({}),
          1,
          run_matrices};
}

} // namespace lcpush::cli
