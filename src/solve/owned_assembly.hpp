// An assembly with its memory, for any scalar; solve_pressure's workspaces are for numbers that
// need no destructor.
#pragma once

#include "lcpush/desktop/owned.hpp"
#include "lcpush/mechanics/solve/workspace.hpp"

namespace lcpush::desktop {

template <class S> class OwnedAssembly {
public:
  /// `scene` outlives the assembly.
  explicit OwnedAssembly(const Scene<S>& scene) : OwnedAssembly(scene, size_of(scene)) {}
  OwnedAssembly(const OwnedAssembly&) = delete;
  OwnedAssembly& operator=(const OwnedAssembly&) = delete;

  Assembly<S>& get() { return assembly_; }

  /// The first round of the pad law; nothing changes under the other laws.
  void enter_first_round(const S& compliance) {
    const PressureMemory<S> memory{span_of(preload_), span_of(compliance_), {}, {}};
    pad_preload(assembly_, memory);
    set_compliance(assembly_, memory, compliance);
  }

private:
  std::vector<Vector6<S>> wrenches_;
  std::vector<ConeGroup<S>> cones_;
  std::vector<SumGroup<S>> sums_;
  std::vector<int> coupled_variable_;
  std::vector<Index> body_;
  std::vector<S> coupling_, reach_, push_, q_, preload_, compliance_;
  Assembly<S> assembly_;

  template <class T> static Span<T> resized(std::vector<T>& list, Index size) {
    list.resize(static_cast<std::size_t>(size));
    return span_of(list);
  }

  OwnedAssembly(const Scene<S>& scene, const AssemblySize& size)
      : preload_(static_cast<std::size_t>(size.points)),
        compliance_(static_cast<std::size_t>(size.points)),
        assembly_({resized(wrenches_, size.forces()), resized(cones_, size.points),
                   resized(sums_, size.actuators), resized(coupled_variable_, size.couplings()),
                   resized(coupling_, size.couplings()), resized(body_, size.points),
                   resized(reach_, size.actuators), resized(push_, size.unknowns()),
                   resized(q_, size.unknowns())}) {
    (void)assembly_.assemble(scene);
  }
};

} // namespace lcpush::desktop
