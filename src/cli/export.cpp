// lcpush export: the assembled problem as Matrix Market files.
#include <filesystem>
#include <fstream>

#include "commands.hpp"
#include "lcpush/host/input_error.hpp"
#include "lcpush/host/matrix_market.hpp"
#include "lcpush/host/push.hpp"
#include "scene_argument.hpp"

namespace lcpush::cli {
namespace {

void write_file(const std::filesystem::path& path, const std::string& text) {
  std::ofstream stream(path, std::ios::binary);
  stream << text << std::flush;
  if (!stream)
    throw host::InputError(path.string() +
                           ": cannot be written; check the path and its permissions");
}

int run(const Arguments& arguments) {
  const std::optional<std::string> directory = arguments.value("--output");
  if (!directory) throw UsageError("say where to: -o DIRECTORY");
  const host::SceneFile file = read_scene_argument(arguments);
  host::Push push(file);
  const Layout<double>& layout = push.layout();
  const Problem<double> problem = push.assembly().problem();
  const auto n = static_cast<std::size_t>(problem.size);
  host::HostMatrix M{problem.size, problem.size, std::vector<double>(n * n)};
  fill_matrix(problem, MatrixMap<double>(M.values.data(), problem.size, problem.size));
  const host::HostMatrix q{problem.size, 1, {problem.q, problem.q + n}};

  std::string names, free;
  for (Index i = 0; i < problem.size; ++i) {
    names += std::to_string(i + 1) + "\t" + push.variable_name(i) + "\n";
    if (i >= problem.free_begin) free += (free.empty() ? "" : ",") + std::to_string(i + 1);
  }
  std::error_code failure;
  std::filesystem::create_directories(*directory, failure);
  if (failure) throw host::InputError(*directory + ": cannot be made: " + failure.message());
  const std::filesystem::path into(*directory);
  const std::string units = "scaled: force " + std::to_string(layout.scales.force) + " N, length " +
                            std::to_string(layout.scales.length) + " m, acceleration " +
                            std::to_string(layout.scales.acceleration) + " m/s^2";
  using host::MatrixMarketFormat;
  write_file(into / "M.mtx", host::write_matrix_market(M, MatrixMarketFormat::coordinate, units));
  write_file(into / "q.mtx", host::write_matrix_market(q, MatrixMarketFormat::array, units));
  write_file(into / "names.txt", names);
  const std::string prefix = (into / "").string();
  std::printf("Wrote %sM.mtx, q.mtx and names.txt: %zu unknowns, the literal laws, %s.\n"
              "Solve it again: lcpush lcp %sM.mtx %sq.mtx%s%s\n",
              prefix.c_str(), n, units.c_str(), prefix.c_str(), prefix.c_str(),
              free.empty() ? "" : " --free ", free.c_str());
  return 0;
}

} // namespace

Command export_command() {
  return {
      "export",
      "SCENE.toml -o DIRECTORY",
      "write the assembled problem as Matrix Market files",
      "Writes M.mtx and q.mtx (w = M z + q in the scaled units that their comment names, without\n"
      "a pressure law) and names.txt, a line an unknown.\n\n"
      "Example:\n  lcpush export fixtures/scenes/straight_slide.toml -o slide\n",
      {{"--output", "DIRECTORY", "made if missing, with its parents; -o for short"}},
      1,
      run};
}

} // namespace lcpush::cli
