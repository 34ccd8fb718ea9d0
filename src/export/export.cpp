#include "export/export_parts.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {
namespace {

using Format = MatrixMarketFormat;

class Folder {
public:
  void text(const std::string& name, std::string text) { files.push_back({name, std::move(text)}); }
  void matrix(const std::string& name, const HostMatrix& matrix, Format format,
              const std::string& comment) {
    text(name + ".mtx", write_matrix_market(matrix, format, comment));
  }
  void vector(const std::string& name, const HostMatrix& vector, const std::string& comment) {
    matrix(name, vector, Format::array, comment);
  }
  std::vector<ExportFile> files;
};

std::string units_text(const Scales<double>& scales) {
  return "scaled: force " + shown(scales.force) + " N, length " + shown(scales.length) +
         " m, acceleration " + shown(scales.acceleration) + " m/s^2";
}

void add_lcp(const Push& push, const Problem<double>& problem, Export& result, Folder& folder) {
  HostMatrix M = zero_matrix(problem.size, problem.size);
  fill_matrix(problem, map_of(M));
  const HostMatrix q{problem.size, 1, {problem.q, problem.q + problem.size}};
  folder.matrix("M", M, Format::coordinate, result.units);
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

void add_program(const PaperProgram& program, const std::string& units, Folder& folder) {
  const std::string bounds = units + "; 1e30 stands for no bound";
  folder.matrix("H", program.H, Format::coordinate, "minimise x' H x / 2 + f' x; " + units);
  folder.vector("f", program.f, units);
  folder.matrix("A", program.A, Format::coordinate, "A x <= b; " + units);
  folder.vector("b", program.b, units);
  folder.matrix("Aeq", program.Aeq, Format::coordinate, "Aeq x = beq; " + units);
  folder.vector("beq", program.beq, units);
  folder.vector("lb", program.lb, bounds);
  folder.vector("ub", program.ub, bounds);
  folder.matrix("answer", program.answer, Format::coordinate, "the answer in SI units: answer x");
}

/// All of them or, as FCLIB has it, V, R and s only where there are equalities.
void add_fclib(const FclibProblem& problem, Export& result, Folder& folder) {
  result.fclib_refusal = problem.refusal;
  const auto add = [&](const char* name, const HostMatrix& matrix, Format format) {
    if (matrix.values.empty())
      result.absent.push_back(std::string(name) + ".mtx");
    else
      folder.matrix(name, matrix, format, "FCLIB's local problem, SI units");
  };
  add("fclib/W", problem.W, Format::coordinate);
  add("fclib/V", problem.V, Format::coordinate);
  add("fclib/R", problem.R, Format::coordinate);
  add("fclib/mu", problem.mu, Format::array);
  add("fclib/q", problem.q, Format::array);
  add("fclib/s", problem.s, Format::array);
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
  add_program(paper_program(full), result.units, folder);
  folder.text("names.json", export_names(push, full));
  folder.text("solve_push.py", python_script());
  folder.text("solve_push.m", octave_script());
  add_fclib(fclib_problem(file), result, folder);
  result.files = std::move(folder.files);
  return result;
}

} // namespace lcpush::desktop
