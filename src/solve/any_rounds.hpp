// The core's rounds (mechanics/solve/rounds.hpp) behind one virtual interface: on the desktop
// pressure and breaking are compiled once, whichever solver they ask.
#pragma once

#include <memory>
#include <utility>

#include "lcpush/mechanics/solve/breaking.hpp"

namespace lcpush::desktop {

class AnyRounds {
public:
  template <class Rounds>
  explicit AnyRounds(const Rounds& rounds) : rounds_(std::make_unique<Of<Rounds>>(rounds)) {}
  AnyRounds(const AnyRounds& other) : rounds_(other.rounds_->copy()) {}
  AnyRounds& operator=(const AnyRounds&) = delete;

  void begin(const Problem<double>& problem, bool warm, const PressureMemory<double>& memory) {
    rounds_->begin(problem, warm, memory);
  }
  Status step(const PressureMemory<double>& memory, PressureRun& run) {
    return rounds_->step(memory, run);
  }
  void vary() { rounds_->vary(); }
  void require(double tolerance) { rounds_->require(tolerance); }
  bool carries_push() const { return rounds_->carries_push(); }
  bool goes_on() const { return rounds_->goes_on(); }
  static constexpr bool goes_on_turning() { return true; }
  Status solve_limit(Assembly<double>& assembly, const PressureMemory<double>& memory,
                     PressureRun& run, PushLimit<double>& limit) {
    return rounds_->solve_limit(assembly, memory, run, limit);
  }

private:
  struct Interface {
    virtual ~Interface() = default;
    virtual std::unique_ptr<Interface> copy() const = 0;
    virtual void begin(const Problem<double>&, bool warm, const PressureMemory<double>&) = 0;
    virtual Status step(const PressureMemory<double>&, PressureRun&) = 0;
    virtual void vary() = 0;
    virtual void require(double) = 0;
    virtual bool carries_push() const = 0;
    virtual bool goes_on() const = 0;
    virtual Status solve_limit(Assembly<double>&, const PressureMemory<double>&, PressureRun&,
                               PushLimit<double>&) = 0;
  };
  template <class Rounds> struct Of final : Interface {
    Rounds rounds;
    explicit Of(const Rounds& its_rounds) : rounds(its_rounds) {}
    std::unique_ptr<Interface> copy() const override { return std::make_unique<Of>(rounds); }
    void begin(const Problem<double>& problem, bool warm,
               const PressureMemory<double>& memory) override {
      rounds.begin(problem, warm, memory);
    }
    Status step(const PressureMemory<double>& memory, PressureRun& run) override {
      return rounds.step(memory, run);
    }
    void vary() override { rounds.vary(); }
    void require(double tolerance) override { rounds.require(tolerance); }
    bool carries_push() const override { return Rounds::carries_push(); }
    bool goes_on() const override { return Rounds::goes_on(); }
    Status solve_limit(Assembly<double>& assembly, const PressureMemory<double>& memory,
                       PressureRun& run, PushLimit<double>& limit) override {
      return rounds.solve_limit(assembly, memory, run, limit);
    }
  };
  std::unique_ptr<Interface> rounds_;
};

} // namespace lcpush::desktop

namespace lcpush {

extern template Status solve_pressure(Assembly<double>&, const desktop::AnyRounds&,
                                      const PressureMemory<double>&, const PressureOptions<double>&,
                                      PressureRun&, const FrictionMemory<double>&);
extern template Status find_breaking(Assembly<double>&, desktop::AnyRounds, Workspace<double>&,
                                     const Body<double>&, const PressureOptions<double>&,
                                     Breaking<double>&, PressureRun&);

} // namespace lcpush
