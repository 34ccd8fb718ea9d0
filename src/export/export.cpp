#include "export/export_parts.hpp"
#include "text/format.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {
namespace {

template <class Digits> std::string units_text(const Scales<double>& scales, Digits digits) {
  return "scaled: force " + digits(scales.force) + " N, length " + digits(scales.length) +
         " m, acceleration " + digits(scales.acceleration) + " m/s^2";
}

void add_lcp(const Push& push, const Problem<double>& problem, const std::string& units,
             Export& result, Folder& folder) {
  HostMatrix M = zero_matrix(problem.size, problem.size);
  fill_matrix(problem, map_of(M));
  const HostMatrix q{problem.size, 1, {problem.q, problem.q + problem.size}};
  folder.matrix("M", M, units);
  folder.vector("q", q, units);
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
  const Scales<double>& scales = push.layout().scales;
  result.units = units_text(scales, [](double x) { return number(x); });
  const std::string units = units_text(scales, [](double x) { return shown(x); });
  Folder folder;
  add_lcp(push, push.assembly().problem(), units, result, folder);
  const OwnedFullForm full(push.assembly());
  add_program(full, units, folder);
  folder.text("names.json", export_names(push, full));
  folder.text("solve_push.py", python_script());
  folder.text("solve_push.m", octave_script());
  add_fclib(file, result, folder);
  result.files = std::move(folder.files);
  return result;
}

} // namespace lcpush::desktop
