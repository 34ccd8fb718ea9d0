#include <lcpush/lcpush.hpp>

using namespace lcpush;
constexpr AssemblySize size{/*points*/ 3, /*generators*/ 12, /*actuators*/ 2, /*drives*/ 2};
alignas(8) static unsigned char arena[push_bytes<float>(size)]; // all there is

// The normal force needed to push the scene's object as prescribed; < 0 if there is none.
float push_force(const Scene<float>& scene, Index pusher) {
  Workspace<float> work = make_workspace<float>({arena, sizeof arena}, size);
  Assembly<float> assembly(work.assembly);
  if (assembly.assemble(scene) != Status::running) return -1; // more contacts than `size` says
  Lemke<float> lemke(work.lemke_scalars, work.lemke_integers);
  PressureRun run;
  if (solve_pressure(assembly, LemkeRounds{lemke}, work.pressure, {}, run) != Status::solved)
    return -1;
  read_answer(assembly, work.pressure.z.data, work.answer, 1.0F);
  const Residuals<float> residual = check(scene, assembly.layout().scales, work.answer, 1.0F);
  if (!(residual.max() <= Tolerances<float>().residual)) return -1;
  return normal_sum(work.answer, scene.bodies[pusher]);
}
