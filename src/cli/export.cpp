// lcpush export: the assembled problem as files that other solvers read.
#include <filesystem>

#include "cli/shell.hpp"
#include "lcpush/desktop/export.hpp"
#include "lcpush/desktop/input_error.hpp"
#include "text/limits.hpp"
#include "text/wording.hpp"
#include "text/wrap.hpp"

namespace lcpush::cli {
namespace {

/// main.c of the C interface.
int write_program(const Arguments& arguments, const SceneFile& file, const std::string& directory) {
  arguments.refuse_unknowns(file, limits::unknowns_device, "push fits the C interface");
  make_directory(directory);
  const std::string path = (std::filesystem::path(directory) / "main.c").string();
  write_file(path, c_program(file));
  tell("Wrote " + path + "; docs/embed/embedding.md says what it is compiled with.");
  return 0;
}

/// scene.xml or scene.sdf.
int write_engine_scene(const Arguments& arguments, const std::string& directory) {
  const bool is_mjcf = arguments.format() == "mjcf";
  if (const auto ending = std::filesystem::path(directory).extension();
      ending == ".xml" || ending == ".sdf")
    throw UsageError(std::string("-o names the directory that ") +
                     (is_mjcf ? "scene.xml" : "scene.sdf") + " is written into, not " +
                     desktop::quoted(directory));
  const SceneFile file = arguments.scene(commands::Needs::scene, Strokes::all);
  const std::string text = is_mjcf ? mjcf_text(file) : sdf_text(file);
  make_directory(directory);
  const std::string path =
      (std::filesystem::path(directory) / (is_mjcf ? "scene.xml" : "scene.sdf")).string();
  write_file(path, text);
  tell("Wrote " + path + "; docs/check/export.md says what stands for contact points.");
  return 0;
}

int run_export(const Arguments& arguments) {
  const std::optional<std::string> directory = arguments.text("output");
  if (!directory) throw UsageError("say where to: -o DIRECTORY");
  const bool is_program = arguments.format() == "c";
  if (arguments.format() == "mjcf" || arguments.format() == "sdf")
    return write_engine_scene(arguments, *directory);
  SceneFile file = arguments.scene(is_program ? commands::Needs::scene : commands::Needs::matrix);
  if (is_program) return write_program(arguments, file, *directory);
  file.is_round = false;
  arguments.refuse_unknowns(file, limits::unknowns_exported, "files fit into 1 GB");
  const Export result = export_scene(file);
  const std::filesystem::path into(*directory);
  const std::string prefix = (into / "").string();
  for (const ExportFile& text : result.files) {
    make_directory((into / text.name).parent_path().string());
    write_file((into / text.name).string(), text.text);
  }
  std::error_code nothing_there;
  for (const std::string& name : result.absent) std::filesystem::remove(into / name, nothing_there);
  const std::string told =
      "Wrote " + prefix + "M.mtx, q.mtx and names.txt: " + std::to_string(result.unknowns) +
      " unknowns, the literal laws with pyramids of " + std::to_string(file.facets) + " facets, " +
      result.units + ".\nThe paper's program: H, f, A, b, Aeq, beq, lb, ub and answer.mtx; " +
      "names.json says what they hold.\n" +
      (result.fclib_refusal.empty()
           ? "FCLIB's local problem: W, V, R, mu, q and s.mtx in " + (into / "fclib" / "").string()
           : "No fclib/: " + result.fclib_refusal) +
      ".\n";
  std::printf("%s", wrapped(told, columns_of(Stream::output)).c_str());
  std::printf("Solve it again: lcpush lcp %sM.mtx %sq.mtx%s%s\n", prefix.c_str(), prefix.c_str(),
              result.free.empty() ? "" : " --free ", result.free.c_str());
  std::printf("Solve it the paper's way: python3 %ssolve_push.py\n"
              "                      or: octave --path %s --eval solve_push\n"
              "Then judge the answer: lcpush verify %s %sanswer.json\n",
              prefix.c_str(), prefix.c_str(), arguments.files()[0].c_str(), prefix.c_str());
  return 0;
}

} // namespace

ShellCommand export_command() {
  return {
      {"export",
       "SCENE.toml [--format c|mjcf|sdf] -o DIRECTORY",
       "the problem for other solvers, with scripts that run them",
       R"(Writes M.mtx and q.mtx (w = M z + q in the scaled units that their comment names, without
a pressure law), names.txt, a line an unknown, and free.txt, which of them are free; the
paper's quadratic program (H, f, A, b, Aeq, beq, lb, ub) with names.json; the local problem
of FCLIB; and solve_push.py and solve_push.m, which solve the program and write answer.json.
With --format c instead main.c: the scene, its memory and a control loop for a device. With
--format mjcf or sdf instead scene.xml for MuJoCo or scene.sdf for Gazebo.

Example:
  lcpush export fixtures/scenes/straight_slide.toml -o slide
  lcpush export fixtures/scenes/straight_slide.toml --format c -o device
  lcpush export fixtures/scenes/straight_slide.toml --format mjcf -o mujoco
)",
       {commands::format_option("files (default), c, mjcf or sdf", "files|c|mjcf|sdf"),
        commands::set_option,
        {"output", "DIRECTORY", "made if missing, with its parents; -o for short"}},
       nullptr,
       {"files", "c", "mjcf", "sdf"}},
      run_export};
}

} // namespace lcpush::cli
