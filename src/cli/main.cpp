// lcpush: dispatches to the commands and turns errors into messages and exit codes.
#include <exception>
#include <iostream>
#include <new>

#include "cli/commands.hpp"
#include "cli/time_limit.hpp"
#include "lcpush/desktop/input_error.hpp"
#include "lcpush/version.hpp"
#include "text/wording.hpp"
#include "text/wrap.hpp"

namespace lcpush::cli {
namespace {

constexpr int bad_input_or_usage = 2;

std::string overview(const std::vector<Command>& commands) {
  std::string text = "lcpush " + std::string(version_text) +
                     ": what happens when a grasped object is pushed against its environment\n\n"
                     "Usage: lcpush COMMAND FILE.. [OPTIONS]\n\nCommands:\n";
  for (const Command& command : commands) {
    std::string name = "  " + command.name;
    name.resize(13, ' ');
    text += name + command.summary + "\n";
  }
  text += "\nExample:\n  lcpush solve fixtures/scenes/straight_slide.toml\n\n"
          "`lcpush COMMAND --help` explains a command; `lcpush --version` says which "
          "version this is. No command takes more than about 1 GB of memory: what would is "
          "refused before it is begun.\n";
  return wrapped(text, columns_of(Stream::output));
}

/// Wrong usage, and what to type instead.
int refuse(const std::string& message, const std::string& instead) {
  std::cerr << wrapped(message, columns_of(Stream::errors)) << "\nTry: " << instead << "\n";
  return bad_input_or_usage;
}

/// The first word is none: what it is instead, and what to write.
int refuse_command(const std::vector<Command>& commands, const std::vector<std::string>& words) {
  const std::string &first = words.front(), label = "lcpush: " + desktop::quoted(first);
  if (first[0] == '-')
    return refuse(label + " stands before the command; options follow it",
                  "lcpush solve SCENE.toml " + first);
  if (first.find_first_of("./") != std::string::npos)
    return refuse(label + " is no command", "lcpush solve " + first);
  std::vector<std::string> names;
  for (const Command& command : commands) names.push_back(command.name);
  return refuse("lcpush: unknown command " + desktop::quoted(first) + suggestion(first, names),
                "lcpush --help");
}

int run(const Command& command, const std::vector<std::string>& words, bool asks_for_help) {
  for (const std::string& word : words) asks_for_help |= word == "--help" || word == "-h";
  if (asks_for_help) {
    std::cout << help_text(command);
    return 0;
  }
  try {
    const Arguments arguments(command, words);
    limit_time(command, arguments);
    return command.run(arguments);
  } catch (const UsageError& error) {
    return refuse("lcpush " + command.name + ": " + error.what(),
                  "lcpush " + command.name + " --help");
  }
}

int run(const std::vector<Command>& commands, const std::vector<std::string>& words) {
  if (words.empty()) {
    std::cerr << overview(commands);
    return bad_input_or_usage;
  }
  const bool asks_for_help = words[0] == "--help" || words[0] == "-h" || words[0] == "help";
  if (words[0] == "--version" || words[0] == "version") {
    std::cout << "lcpush " << version_text << "\n";
    return 0;
  }
  const std::string& name = asks_for_help && words.size() > 1 ? words[1] : words[0];
  for (const Command& command : commands)
    if (command.name == name)
      return run(command, {&name + 1, words.data() + words.size()}, asks_for_help);
  if (asks_for_help) {
    std::cout << overview(commands);
    return 0;
  }
  return refuse_command(commands, words);
}

} // namespace

std::vector<Command> all_commands() {
  return {solve_command(),     break_command(),    lcp_command(),     report_command(),
          sweep_command(),     move_command(),     cone_command(),    plan_command(),
          play_command(),      pivots_command(),   verify_command(),  spread_command(),
          export_command(),    matrices_command(), example_command(), new_command(),
          completion_command()};
}

} // namespace lcpush::cli

int main(int count, char** words) {
  using namespace lcpush;
  try {
    return cli::run(cli::all_commands(), std::vector<std::string>(words + 1, words + count));
  } catch (const desktop::InputError& error) {
    std::cerr << desktop::wrapped(error.what(), cli::columns_of(cli::Stream::errors)) << "\n";
  } catch (const std::bad_alloc&) {
    std::cerr << "lcpush: out of memory; the problem is too large for this machine\n";
  } catch (const std::exception& error) {
    std::cerr << "lcpush: internal error: " << error.what() << "; please report it\n";
  }
  return 2;
}
