// What every command that solves a push begins with.
#pragma once

#include <utility>

#include "commands/listener.hpp"
#include "lcpush/desktop/push.hpp"

namespace lcpush::commands {

using namespace desktop;

/// A scene's push, watched by the listener, also in the search for other answers.
struct AskedPush {
  AskedPush(SceneFile scene, Solver solver, Listener& listener)
      : file(std::move(scene)), push(file) {
    options.solver = solver;
    options.watcher = options.searching = &listener;
    options.stop = [this, &listener](double part) {
      const Stop now = listener.stop(part);
      if (now != Stop::none && !std::exchange(is_late_, true))
        listener.announce("The answer took long: what else there may be (other answers, the least "
                          "grip) was not searched for to the end. More --seconds do.");
      return now;
    };
    if (!file.start.isZero(0))
      listener.announce("The object is taken at rest; with its velocity begins `lcpush move`.");
  }
  AskedPush(const AskedPush&) = delete; // its parts point at each other
  AskedPush& operator=(const AskedPush&) = delete;

  SceneFile file;
  Push push;
  PushOptions options;

private:
  bool is_late_ = false;
};

} // namespace lcpush::commands
