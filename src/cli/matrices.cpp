// lcpush matrices: the paper's matrices of a scene.
#include "lcpush/host/matrices.hpp"
#include "commands.hpp"
#include "scene_argument.hpp"

namespace lcpush::cli {
namespace {

int run(const Arguments& arguments) {
  const std::string format = arguments.format({"text", "json"});
  const host::SceneFile file = read_scene_argument(arguments);
  const host::PaperMatrices matrices = host::paper_matrices(file);
  write_output(arguments, format == "json" ? host::matrices_json(matrices)
                                           : host::matrices_text(file, matrices));
  return 0;
}

} // namespace

Command matrices_command() {
  return {"matrices",
          "SCENE.toml [OPTIONS]",
          "the paper's matrices: inertia, grasp matrix, hand Jacobian, generators",
          "Prints the object's inertia M and load w, the grasp matrix G and its polyhedral form\n"
          "G-bar, the hand Jacobian J, the friction generators D and, for each patch, its\n"
          "reference points, weights and number of independent rigidity conditions. SI units,\n"
          "scene axes, at the object's centre of mass; the scene as written, unsolved.\n\n"
          "Example:\n  lcpush matrices fixtures/scenes/straight_slide.toml\n",
          with_common_options({}),
          1,
          run};
}

} // namespace lcpush::cli
