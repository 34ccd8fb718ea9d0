// What can be asked: one table of each command's options. The command line and other languages only
// read values (values.hpp), help and completion only print the table.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lcpush/desktop/boxes.hpp"
#include "lcpush/desktop/certify.hpp"
#include "lcpush/desktop/stop.hpp"

namespace lcpush::commands {

using namespace desktop;

class Listener;
class Values;

struct Option {
  const char* name;  ///< "stop-after"; "--stop-after" in a shell, "stop_after" as a key of JSON
  const char* value; ///< placeholder of its value, "" for a flag
  const char* help;
  bool repeats = false;       ///< may be given several times
  bool in_shell_only = false; ///< no key of JSON

  bool is_flag() const { return *value == '\0'; }
  std::string label() const { return std::string("--") + name; }                 ///< "--steps"
  std::string usage() const { return label() + (is_flag() ? "" : " ") + value; } ///< "--steps N"
};

struct Result {
  bool is_good = false; ///< solved, found, valid: exit status 0
  std::string text;     ///< in the format asked for
  /// The proof of the answer, or none was found; empty where there is nothing to prove.
  std::function<std::optional<Certificate>()> certify = {};
  Stop stop = Stop::none; ///< what ended the work early: then this is what there was
  std::optional<BoxCertificate> box_certificate = {}; ///< that of a box, if it is asked for
};

struct Command {
  std::string name;
  std::string synopsis; ///< what follows the name
  std::string summary;  ///< one line for the list of commands
  std::string details;  ///< paragraphs for --help, an example included
  std::vector<Option> options;
  /// Throws InputError, and what `values` refuse with.
  Result (*run)(const Values& values, Listener& listener) = nullptr;
  std::vector<std::string> formats = {"text", "json"}; ///< the first is a shell's usual one
  std::size_t most_files = 1;
  bool ends_with_what_there_is = false;    ///< when its seconds are over
  std::vector<std::string> more_keys = {}; ///< of JSON alone
  std::string exits = "0 solved, 1 not solved (the output says why)";

  const Option* find(const std::string& option) const;
};

Command solve_command();
Command break_command();
Command lcp_command();
Command contacts_command();
Command report_command();
Command sweep_command();
Command move_command();
Command hold_command();
Command cone_command();
Command plan_command();
Command design_command();
Command pivots_command();
Command verify_command();
Command spread_command();
Command matrices_command();

/// The command's answer; JSON begins with what --set has set.
Result run(const Command& command, const Values& values, Listener& listener);

/// lcp --all: every solution.
Result find_all(const Values& values, Listener& listener);

// The three questions of verify.
Result verify_push(const Values& values, Listener& listener);
Result verify_motion(const Values& values, Listener& listener);
Result verify_raw_problem(const Values& values, Listener& listener);

// What several of them take.
inline const Option output_option{
    "output", "FILE", "write there instead of to standard output; -o for short", false, true};
inline const Option verbose_option{
    "verbose", "", "also all digits, the theory, how it was found; -v for short", false, true};
inline const Option set_option{
    "set", "PATH=VALUE", "instead of the file's, such as wall.friction=0.4; may be repeated", true};
inline const Option certify_option{
    "certify", "FILE", "also write an exact proof of the answer for docs/check/lcpush_check.py",
    false, true};
inline const Option seconds_option{"seconds", "S", "stop after so much processor time (8)", false,
                                   true};
inline const Option solver_option{"solver", "NAME",
                                  "lemke (default), gauss-seidel (sweeps) or hybrid (both)"};
inline const Option pressure_option{"pressure", "LAW",
                                    "pad, even or rigid instead of the scene's own"};

inline const Option tolerance_option{
    "tolerance", "PATH=R%",
    "for every value so near, or in PATH=FROM:TO; PATH alone: by how much it may be off", true};

inline const Option press_option{
    "press", "", "pushers with a normal_force press with it, without friction: a load to hold"};

inline const Option facets_option{
    "facets", "G", "sides of the friction pyramids, or round, instead of the scene's own"};

/// Those that state a raw problem, between some and some more.
std::vector<Option> with_raw_options(std::vector<Option> before, const std::vector<Option>& after);
/// Also --format, unless it is there, and --output.
std::vector<Option> with_common_options(std::vector<Option> own);
/// Also --set, --strict and --seconds, of a command that answers about a scene.
std::vector<Option> with_scene_options(std::vector<Option> own);
/// --format of a command that has more than text and json.
Option format_option(const char* help, const char* placeholder = "FORMAT");

} // namespace lcpush::commands
