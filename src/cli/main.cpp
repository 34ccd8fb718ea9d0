// lcpush: dispatches to the commands and turns errors into messages and exit codes.
#include <algorithm>
#include <exception>
#include <iostream>
#include <limits>
#include <new>
#include <utility>

#include <unistd.h>

#include "cli/ending.hpp"
#include "cli/shell.hpp"
#include "cli/shell_listener.hpp"
#include "lcpush/desktop/input_error.hpp"
#include "lcpush/version.hpp"
#include "text/wording.hpp"
#include "text/wrap.hpp"

namespace lcpush::cli {
namespace {

using desktop::Stop;

constexpr int bad_input_or_usage = 2;

/// What the commands from this one on are for.
constexpr std::pair<const char*, const char*> groups[] = {{"new", "start"},
                                                          {"solve", "ask"},
                                                          {"report", "look"},
                                                          {"verify", "check"},
                                                          {"pivots", "teach"}};

/// It fits a terminal of 80 columns and 24 lines.
std::string overview(const std::vector<ShellCommand>& commands) {
  std::string text = "lcpush " + std::string(version_text) +
                     ": how hard to push a gripped object, and how it then slips\n"
                     "Usage: lcpush COMMAND FILE.. [OPTIONS]\n";
  for (const ShellCommand& command : commands) {
    std::string line;
    for (const auto& [first, group] : groups)
      if (command.name == first) line = group;
    line.resize(7, ' ');
    line += command.name;
    line.resize(19, ' ');
    text += line + command.summary + "\n";
  }
  text += "\nExample: lcpush solve fixtures/scenes/straight_slide.toml; --help explains it\n";
  return wrapped(text, columns_of(Stream::output));
}

/// Wrong usage, and what to type instead.
int refuse(const std::string& message, const std::string& instead) {
  tell(message);
  std::cerr << "Try: " << instead << "\n";
  return bad_input_or_usage;
}

/// The first word is none: what it is instead, and what to write.
int refuse_command(const std::vector<ShellCommand>& commands,
                   const std::vector<std::string>& words) {
  const std::string &first = words.front(), label = "lcpush: " + desktop::quoted(first);
  if (first[0] == '-')
    return refuse(label + " stands before the command; options follow it",
                  "lcpush solve SCENE.toml " + first);
  if (first.find_first_of("./") != std::string::npos)
    return refuse(label + " is no command", "lcpush solve " + first);
  if (const std::vector<std::string> owners = commands_with("--" + first); !owners.empty()) {
    const auto owner = std::find_if(commands.begin(), commands.end(), [&](const auto& command) {
      return command.name == owners.front();
    });
    return refuse(label + " is no command but an option, of " + listed(owners, "and"),
                  "lcpush " + owner->name +
                      (owner->synopsis.find("SCENE") == 0 ? " SCENE.toml " : " ") +
                      owner->find(first)->usage());
  }
  std::vector<std::string> names;
  for (const ShellCommand& command : commands) names.push_back(command.name);
  return refuse("lcpush: unknown command " + desktop::quoted(first) + suggestion(first, names),
                "lcpush --help");
}

std::string help_text(const Command& command) {
  std::string text = "lcpush " + command.name + ": " + command.summary + "\n\nUsage: lcpush " +
                     command.name + " " + command.synopsis + "\n\n" + reflowed(command.details) +
                     "\nOptions:\n";
  for (const Option& option : command.options) {
    std::string left = "  " + option.usage();
    left.resize(std::max<std::size_t>(left.size() + 2, 28), ' ');
    text += left + option.help + "\n";
  }
  return wrapped(text + "  --help                    this text\n\nExit status: " + command.exits +
                     ", 2 bad input or usage.\nMemory: about 1 GB at most; "
                     "what would take more is refused before it begins.\n",
                 columns_of(Stream::output));
}

/// Of a scene that no file has.
void refuse_certificate_without_file(const Arguments& arguments) {
  const std::vector<std::string>& files = arguments.files();
  if (arguments.has("certify") && std::find(files.begin(), files.end(), "-") != files.end())
    throw UsageError("--certify ties its proof to a file: name one instead of -");
  if (arguments.has("certify") && arguments.has("set"))
    throw UsageError("--certify ties its proof to a file: change that instead of --set");
}

/// How long the command may take, in seconds. What ends with what there is gets more for that.
double limit_time(const Command& command, const Arguments& arguments) {
  constexpr double longest_enumeration = 300; // who asks for all contact modes, waits
  if (command.find("seconds") == nullptr) return std::numeric_limits<double>::infinity();
  const double seconds =
      arguments.number("seconds", commands::longest_time, ", in seconds")
          .value_or(arguments.has("enumerate") ? longest_enumeration : usual_seconds);
  const bool ends_with_what_there_is = command.ends_with_what_there_is || arguments.has("all");
  if (ends_with_what_there_is) listen_for_signals();
  cli::limit_time(command.name, ends_with_what_there_is ? seconds + usual_seconds : seconds);
  return seconds;
}

/// " --set 'wall.friction=0.4'", fit for a shell.
std::string set_words(const Arguments& arguments) {
  std::string words;
  for (const std::string& one : arguments.texts("set")) words += " --set " + quoted_for_shell(one);
  return words;
}

void tell_doubts(const Arguments& arguments) {
  for (const std::string& doubt : arguments.doubts()) tell("Check: " + doubt + ".");
}

int answer(const Command& command, const Arguments& arguments) {
  refuse_certificate_without_file(arguments);
  const std::string format = arguments.text("format").value_or(command.formats[0]);
  if (format == "html") refuse_page_on_terminal(arguments, command.name);
  const double seconds = limit_time(command, arguments);
  commands::Result result;
  {
    ShellListener listener(seconds);
    result = commands::run(command, arguments, listener);
    const std::string rest = "; what there was by then is written";
    if (result.stop == Stop::signal) listener.announce(command.name + ": interrupted" + rest + ".");
    if (result.stop == Stop::time)
      listener.announce(command.name + ": stopped after " + shown(seconds) +
                        " s of processor time" + rest + "; --seconds " + shown(10 * seconds) +
                        " gives it more.");
  }
  const std::size_t width = arguments.has("output") ? usual_width : columns_of(Stream::output);
  write_output(arguments, format == "text" ? wrapped(result.text, width) : result.text);
  if (format == "text" && (command.name == "solve" || command.name == "break") &&
      isatty(STDOUT_FILENO) != 0 && !arguments.has("output") && arguments.files()[0] != "-")
    tell("next: lcpush report " + arguments.files()[0] + set_words(arguments) + " -o page.html");
  tell_doubts(arguments);
  const bool is_proved = write_certificate(arguments, result);
  return result.is_good && is_proved ? 0 : 1;
}

int run(const ShellCommand& command, const std::vector<std::string>& words, bool asks_for_help) {
  for (const std::string& word : words) asks_for_help |= word == "--help" || word == "-h";
  if (asks_for_help) {
    std::cout << help_text(command);
    return 0;
  }
  try {
    const Arguments arguments(command, words);
    if (command.run_alone == nullptr) return answer(command, arguments);
    const int status = command.run_alone(arguments);
    tell_doubts(arguments);
    return status;
  } catch (const UsageError& error) {
    return refuse("lcpush " + command.name + ": " + error.what(),
                  "lcpush " + command.name + " --help");
  }
}

int run(const std::vector<ShellCommand>& commands, const std::vector<std::string>& words) {
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
  for (const ShellCommand& command : commands)
    if (command.name == name)
      return run(command, {&name + 1, words.data() + words.size()}, asks_for_help);
  if (asks_for_help) {
    std::cout << overview(commands);
    return 0;
  }
  return refuse_command(commands, words);
}

} // namespace

std::vector<ShellCommand> all_commands() {
  using namespace commands;
  return {new_command(),      example_command(),    completion_command(), {solve_command()},
          {break_command()},  {hold_command()},     {move_command()},     {sweep_command()},
          {spread_command()}, {cone_command()},     {plan_command()},     {design_command()},
          {lcp_command()},    {contacts_command()}, {report_command()},   play_command(),
          {verify_command()}, export_command(),     {matrices_command()}, {pivots_command()}};
}

} // namespace lcpush::cli

int main(int count, char** words) {
  using namespace lcpush;
  try {
    return cli::run(cli::all_commands(), std::vector<std::string>(words + 1, words + count));
  } catch (const desktop::InputError& error) {
    cli::tell(error.what());
  } catch (const std::bad_alloc&) {
    std::cerr << "lcpush: out of memory; the problem is too large for this machine\n";
  } catch (const std::exception& error) {
    std::cerr << "lcpush: internal error: " << error.what() << "; please report it\n";
  }
  return 2;
}
