// lcpush: dispatches to the commands and turns errors into messages and exit codes.
#include <exception>
#include <iostream>
#include <new>

#include "cli/commands.hpp"
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
          "version this is.\n";
  return wrapped(text, columns_of(Stream::output));
}

int run(const std::vector<Command>& commands, const std::vector<std::string>& words) {
  if (words.empty()) {
    std::cerr << overview(commands);
    return bad_input_or_usage;
  }
  if (words[0] == "--help" || words[0] == "-h" || words[0] == "help") {
    std::cout << overview(commands);
    return 0;
  }
  if (words[0] == "--version") {
    std::cout << "lcpush " << version_text << "\n";
    return 0;
  }
  std::vector<std::string> names;
  for (const Command& command : commands) {
    names.push_back(command.name);
    if (command.name != words[0]) continue;
    for (const std::string& word : words)
      if (word == "--help" || word == "-h") {
        std::cout << help_text(command);
        return 0;
      }
    try {
      return command.run(Arguments(command, {words.begin() + 1, words.end()}));
    } catch (const UsageError& error) {
      std::cerr << "lcpush " << command.name << ": " << error.what() << "\nTry: lcpush "
                << command.name << " --help\n";
      return bad_input_or_usage;
    }
  }
  std::cerr << "lcpush: unknown command " << desktop::quoted(words[0])
            << suggestion(words[0], names) << "\nTry: lcpush --help\n";
  return bad_input_or_usage;
}

} // namespace

std::vector<Command> all_commands() {
  return {solve_command(),     break_command(),    lcp_command(),     report_command(),
          sweep_command(),     pivots_command(),   verify_command(),  spread_command(),
          export_command(),    matrices_command(), example_command(), new_command(),
          completion_command()};
}

} // namespace lcpush::cli

int main(int count, char** words) {
  using namespace lcpush;
  try {
    return cli::run(cli::all_commands(), std::vector<std::string>(words + 1, words + count));
  } catch (const desktop::InputError& error) {
    std::cerr << error.what() << "\n";
  } catch (const std::bad_alloc&) {
    std::cerr << "lcpush: out of memory; the problem is too large for this machine\n";
  } catch (const std::exception& error) {
    std::cerr << "lcpush: internal error: " << error.what() << "; please report it\n";
  }
  return 2;
}
