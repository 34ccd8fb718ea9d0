// The values of a command's options, typed and checked, wherever they come from: words of a command
// line or keys of a JSON object.
#pragma once

#include <exception>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "commands/command.hpp"
#include "lcpush/desktop/boxes.hpp"
#include "lcpush/desktop/raw_problem.hpp"
#include "lcpush/desktop/solver.hpp"
#include "lcpush/desktop/sweep.hpp"
#include "lcpush/desktop/telling.hpp"

namespace lcpush::commands {

constexpr double longest_time = 1e6;  // s
constexpr double infinite_end = 1e15; // ends from here on: 1e20 and 1e30 are PATH's and OSQP's none

/// What a command does with a scene.
enum class Needs {
  matrix, ///< holds M, or a dictionary of it
  scene,  ///< O(points): sweeps, or pivots on the structured basis
};

/// A text, and what messages call it.
struct Document {
  std::string text, name;
};

/// n numbers, and what messages call them.
struct NumberList {
  std::vector<double> numbers;
  std::string name;
};

/// M, n x n, and q, n x 1, every number as typed.
struct ExactMatrices {
  ExactMatrix M, q;
  std::string name;                ///< of M
  std::vector<unsigned char> free; ///< n; not 0: an equality
};

/// Of vx, vy and wz.
inline const std::vector<std::string> twist_units{"m/s", "m/s", "rad/s"};

class Values {
public:
  explicit Values(const Command& command) : command_(command) {}
  Values(const Values&) = delete;
  Values& operator=(const Values&) = delete;
  virtual ~Values() = default;

  // Each reader has these. All that refuse throw.
  virtual bool has(const std::string& option) const = 0; ///< of a flag: is it set?
  virtual std::optional<std::string> text(const std::string& option) const = 0;
  /// All of an option that may be repeated, in the order given.
  virtual std::vector<std::string> texts(const std::string& option) const = 0;
  /// A number and how it is written; nan if it is none.
  struct Written {
    double value;
    std::string text;
  };
  /// In `unit`, where one is given; a shell takes "30 mm" for 0.03.
  virtual std::optional<Written> written(const std::string& option,
                                         const std::string& unit = "") const = 0;
  /// A number for each of these units; `what` says what the numbers are.
  virtual std::optional<std::vector<double>> numbers(const std::string& option,
                                                     const std::vector<std::string>& units,
                                                     const std::string& what) const = 0;
  /// As messages name the option: --steps, or "steps".
  virtual std::string label(const std::string& option) const = 0;
  /// The same with a placeholder of its value, where there is one.
  virtual std::string usage(const std::string& option) const = 0;
  /// A row in messages, counted from 1.
  virtual std::string row_name(Index row) const = 0;
  /// See refuse.
  virtual void throw_refusal(const std::string& option, const std::string& sentence) const = 0;
  /// One of `known`, which begins with a shell's usual one.
  virtual std::string format(const std::vector<std::string>& known) const = 0;
  virtual Telling telling() const = 0;
  /// As somebody typed it; empty where nobody did.
  virtual std::string command_line() const { return {}; }

  // Scenes.
  virtual std::size_t scene_count() const = 0;
  virtual Document given_scene(std::size_t k = 0) const = 0;
  virtual std::size_t variation_count() const = 0;
  virtual std::vector<Variation> variations(const VariedScene& scene) const = 0;
  /// A variation a value, from = to; nothing if no curves are asked for.
  virtual std::optional<std::vector<Variation>> each(const VariedScene& scene) const = 0;

  // Raw problems, and what is to be verified.
  virtual ExactMatrices exact_matrices() const = 0;
  virtual RawProblem raw_problem() const = 0;
  virtual std::optional<NumberList> list(const std::string& option, Index n) const = 0;
  virtual Document answer() const = 0;
  virtual Document trajectory() const = 0;
  virtual std::vector<double> z(const RawProblem& problem) const = 0;
  /// Of a contact problem: its text, or only the name of its file or folder.
  virtual Document contacts() const = 0;

  // What follows from these.
  /// Throws; `sentence` says what is wrong with the option.
  [[noreturn]] void refuse(const std::string& option, const std::string& sentence) const {
    throw_refusal(option, sentence);
    std::terminate(); // never; but of a virtual function the compiler does not know
  }
  std::string format() const { return format(command_.formats); }
  /// A command that also has residuals instead of its answer, as "csv", too.
  std::string format_with_history(Solver solver) const;
  const std::string& one_of(const std::string& option, const std::string& word,
                            const std::vector<std::string>& known) const;
  [[noreturn]] void refuse_value(const std::string& option, const std::string& word,
                                 const std::string& rule,
                                 const std::vector<std::string>& known = {}) const;
  struct Range {
    Index smallest;
    Index largest = std::numeric_limits<Index>::max(); ///< or no limit
    bool even = false;
  };
  std::optional<Index> whole(const std::string& option, const Range& range) const;
  /// Between 0 and `end` without the two; `hint` goes on with what it is.
  std::optional<double> number(const std::string& option, double end, const std::string& hint,
                               const std::string& unit = "") const;
  Solver solver() const;
  std::string scene_name(std::size_t k = 0) const { return given_scene(k).name; }
  /// With the values of --set.
  Document scene_document(std::size_t k = 0) const;
  SceneFile scene(Needs needs, Strokes strokes = Strokes::first) const;
  /// Of every scene that is read: what is odd about it is said, and refused with --strict.
  virtual void inspect(const SceneFile&) const {}
  virtual void doubt(const std::vector<SceneDoubt>&) const {}
  /// For a question that knows pyramids alone; the listener hears what stands for a round cone.
  void take_pyramids(SceneFile& file, Listener& listener) const;
  /// With the laws of --pressure and --facets, if they are given.
  VariedScene varied_scene(Needs needs, std::size_t k = 0) const;
  /// The same with the ranges of --tolerance; whether any number has one, see VariedScene::ranges.
  VariedScene scene_with_ranges(Needs needs) const;
  /// The same where the middle of the ranges is answered, and is what is inspected.
  VariedScene scene_of_middle(Needs needs) const;
  /// The corner at which an answer fails, as a scene file; refuses where there is none.
  std::string corner_scene(const BoxAnswer& answer) const;
  /// The body of --pusher, or the only pusher.
  Index pusher(const SceneFile& file) const;
  /// The scene in which that one alone pushes; the listener hears which others are left out.
  VariedScene with_only_pusher(const VariedScene& scene, Listener& listener) const;
  /// Refuses a scene with more unknowns than `most`, whose `what`.
  void refuse_unknowns(const SceneFile& file, Index most, const std::string& what) const;
  /// Refuses a pusher of that name that begins only later.
  void refuse_later(const SceneFile& file, const std::string& option,
                    const std::string& name) const;
  /// The same of each PATH=VALUES of an option.
  void refuse_later_in(const SceneFile& file, const std::string& option) const;
  /// Refuses `press` of a scene where nothing presses.
  void refuse_no_press(const SceneFile& file) const;
  /// Refuses a scene in which nothing moves.
  void refuse_still(const SceneFile& file) const;
  /// Is the scene to be taken as planar, since it is plane by its own symmetry? The listener hears
  /// it.
  bool lies_in_plane(const SceneFile& file, Listener& listener) const;
  /// The box of a raw problem of n rows; none if no option is given.
  RawBounds bounds(Index n) const;

protected:
  const Command& command() const { return command_; }

private:
  const Command& command_;

  VariedScene read_scene(std::size_t k) const;
  VariedScene inspected(VariedScene scene, Needs needs) const;
  void refuse_size(const SceneFile& file, Needs needs) const;
};

/// Says once how many ends were so large.
void announce_infinite(const RawProblem& problem, Listener& listener);

} // namespace lcpush::commands
