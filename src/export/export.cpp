#include "export/export_parts.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {
namespace {

std::string units_text(const Scales<double>& scales) {
  return "scaled: force " + shown(scales.force) + " N, length " + shown(scales.length) +
         " m, acceleration " + shown(scales.acceleration) + " m/s^2";
}

void add_lcp(const Push& push, const Problem<double>& problem, Export& result, Folder& folder) {
  HostMatrix M = zero_matrix(problem.size, problem.size);
  fill_matrix(problem, map_of(M));
  const HostMatrix q{problem.size, 1, {problem.q, problem.q + problem.size}};
  folder.matrix("M", M, result.units);
  folder.vector("q", q, result.units);
  std::string names;
  for (Index i = 0; i < problem.size; ++i) {
    names += std::to_string(i + 1) + "\t" + push.variable_name(i) + "\n";
    if (i >= problem.free_begin)
      result.free += (result.free.empty() ? "" : ",") + std::to_string(i + 1);
  }
  folder.text("names.txt", names);
  folder.text("free.txt", result.free + "\n");
}

} // namespace

Export export_scene(const SceneFile& file) {
  Push push(file);
  Export result;
  result.unknowns = push.layout().size;
  result.units = units_text(push.layout().scales);
  Folder folder;
  add_lcp(push, push.assembly().problem(), result, folder);
  const OwnedFullForm full(push.assembly());
  add_program(full, result.units, folder);
  folder.text("names.json", export_names(push, full));
  folder.text("solve_push.py", python_script());
  folder.text("solve_push.m", octave_script());
  add_fclib(file, result, folder);
  result.files = std::move(folder.files);
  return result;
}

} // namespace lcpush::desktop
