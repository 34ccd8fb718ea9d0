// A peer's shared library, loaded as long as it lives.
#pragma once

#include <dlfcn.h>

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>

#include "bench/peers/peer.h"

namespace lcpush::bench {

class Peer {
public:
  /// Throws with dlopen's own words where the file is no peer.
  explicit Peer(const std::string& file)
      : name_(std::filesystem::path(file).stem().string()),
        library_(dlopen(std::filesystem::absolute(file).c_str(), RTLD_NOW | RTLD_LOCAL), &close) {
    void* const symbol = library_ != nullptr ? dlsym(library_.get(), "lcpush_peer") : nullptr;
    if (symbol == nullptr) throw std::runtime_error(dlerror());
    solve_ = reinterpret_cast<decltype(solve_)>(symbol);
    for (const char* prefix : {"lib", "peer_"})
      if (name_.rfind(prefix, 0) == 0) name_.erase(0, std::string(prefix).size());
  }

  const std::string& name() const { return name_; }
  void load(int n, const double* M, const double* q) {
    n_ = n, M_ = M, q_ = q;
    (void)solve_(lcpush_peer_load, n, M, q, nullptr);
  }
  int solve(lcpush_peer_task task, double* z) { return solve_(task, n_, M_, q_, z); }

private:
  static void close(void* library) {
    if (library != nullptr) dlclose(library);
  }
  std::string name_;
  std::unique_ptr<void, void (*)(void*)> library_;
  int (*solve_)(int, int, const double*, const double*, double*) = nullptr;
  int n_ = 0;
  const double *M_ = nullptr, *q_ = nullptr;
};

} // namespace lcpush::bench
