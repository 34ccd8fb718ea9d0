// What every question that solves a push begins with.
#pragma once

#include "calls/listener.hpp"
#include "lcpush/desktop/push.hpp"

#include <utility>

namespace lcpush::desktop {

/// A scene's push, ended by the listener at any pivot, also of the search for other answers.
struct AskedPush {
  AskedPush(SceneFile scene, Solver solver, Listener& listener)
      : file(std::move(scene)), push(file), watcher(listener) {
    options.solver = solver;
    options.watcher = options.searching = &watcher;
  }
  AskedPush(const AskedPush&) = delete; // its parts point at each other
  AskedPush& operator=(const AskedPush&) = delete;

  HoldReport holds_without_push() { return push.holds_without_push(options); }

  SceneFile file;
  Push push;
  ListeningWatcher watcher;
  PushOptions options;
};

} // namespace lcpush::desktop
