// lcpush completion: what shells and man read, made from the table that --help prints.
#include "cli/shell.hpp"
#include "lcpush/version.hpp"
#include "text/wording.hpp"
#include "text/wrap.hpp"

namespace lcpush::cli {
namespace {

/// What an option's value may be; empty if it is free.
std::string value_words(const Command& command, const Option& option) {
  return option.label() == "--format" ? joined(command.formats, " ") : "";
}

std::string bash_script() {
  std::string text = "# bash completion for lcpush\n_lcpush() {\n"
                     "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]}\n"
                     "  local words=\"\"\n  case ${COMP_WORDS[1]}:$before in\n";
  for (const Command& command : all_commands())
    for (const Option& option : command.options)
      if (const std::string values = value_words(command, option); !values.empty())
        text += "    " + command.name + ":" + option.label() + ") words=\"" + values + "\" ;;\n";
  text += "  esac\n  if [[ -z $words && $word == -* ]]; then\n    case ${COMP_WORDS[1]} in\n";
  std::vector<std::string> names;
  for (const Command& command : all_commands()) {
    names.push_back(command.name);
    text += "      " + command.name + ") words=\"--help";
    for (const Option& option : command.options) text += " " + option.label();
    text += "\" ;;\n";
  }
  return text + "    esac\n  elif [[ $COMP_CWORD == 1 ]]; then\n    words=\"" + joined(names, " ") +
         "\"\n  fi\n  if [[ -n $words ]]; then\n"
         "    mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$word\")\n"
         "  else\n    mapfile -t COMPREPLY < <(compgen -f -- \"$word\")\n  fi\n}\n"
         "complete -o filenames -F _lcpush lcpush\n";
}

std::string zsh_script() {
  std::string text = "#compdef lcpush\n_lcpush() {\n  local -a commands\n  commands=(\n";
  for (const Command& command : all_commands())
    text += "    " + quoted_for_shell(command.name + ":" + command.summary) + "\n";
  text += "  )\n  if (( CURRENT == 2 )); then\n    _describe command commands\n    return\n  fi\n"
          "  case $words[2] in\n";
  for (const Command& command : all_commands()) {
    text += "    " + command.name + ")\n      _arguments '*:file:_files'";
    for (const Option& option : command.options) {
      std::string help = option.help;
      for (std::size_t at = 0; (at = help.find_first_of("[]:", at)) != std::string::npos; at += 2)
        help.insert(at, "\\");
      std::string value;
      if (const std::string values = value_words(command, option); !values.empty())
        value = ":value:(" + values + ")";
      else if (!option.is_flag())
        value = std::string(":") + option.value + ":_files";
      text += " \\\n        " + quoted_for_shell(option.label() + "[" + help + "]" + value);
    }
    text += "\n      ;;\n";
  }
  // In a folder of fpath zsh loads the file as the function itself; else somebody has sourced it.
  return text + "  esac\n}\nif [[ $funcstack[1] == _lcpush ]]; then\n  _lcpush \"$@\"\nelse\n"
                "  compdef _lcpush lcpush\nfi\n";
}

std::string fish_script() {
  std::string text = "# fish completion for lcpush\n";
  for (const Command& command : all_commands()) {
    text += "complete -c lcpush -n __fish_use_subcommand -f -a " + command.name + " -d " +
            quoted_for_shell(command.summary) + "\n";
    for (const Option& option : command.options) {
      const std::string values = value_words(command, option);
      text += "complete -c lcpush -n '__fish_seen_subcommand_from " + command.name + "' -l " +
              option.name + (option.is_flag() ? "" : " -r") +
              (values.empty() ? "" : " -f -a " + quoted_for_shell(values)) + " -d " +
              quoted_for_shell(option.help) + "\n";
    }
  }
  return text;
}

/// Fit for a line of roff.
std::string roff(const std::string& text) {
  std::string result;
  for (const char c : text) {
    const bool starts_line = result.empty() || result.back() == '\n';
    if (starts_line && (c == '.' || c == '\'')) result += "\\&";
    result += c == '\\' ? std::string("\\e") : c == '-' ? std::string("\\-") : std::string(1, c);
  }
  return result;
}

constexpr std::size_t man_width = usual_width - 8; // within man's margins

std::string man_page() {
  std::string text = ".TH LCPUSH 1 \"\" \"lcpush " + std::string(version_text) +
                     "\" \"User Commands\"\n.SH NAME\nlcpush \\- what happens when a grasped "
                     "object is pushed against its environment\n.SH SYNOPSIS\n.B lcpush\n"
                     "COMMAND FILE.. [OPTIONS]\n.SH COMMANDS\n";
  for (const Command& command : all_commands()) {
    text += ".SS lcpush " + command.name + " " + roff(command.synopsis) + "\n" +
            roff(command.summary) + "\n.nf\n\n" +
            roff(wrapped(reflowed(command.details), man_width)) + "\n.fi\n";
    for (const Option& option : command.options)
      text += ".TP\n.B " + roff(option.usage()) + "\n" + roff(option.help) + "\n";
  }
  return text + ".SH EXIT STATUS\n0 solved, 1 not solved (the output says why), 2 bad input or "
                "usage.\n";
}

int run_completion(const Arguments& arguments) {
  const std::string wanted = arguments.files().empty() ? "" : arguments.files()[0];
  const std::vector<std::string> known = {"bash", "zsh", "fish", "man"};
  for (std::size_t k = 0; k < known.size(); ++k)
    if (wanted == known[k]) {
      std::string (*const scripts[])() = {bash_script, zsh_script, fish_script, man_page};
      write_output(arguments, scripts[k]());
      return 0;
    }
  throw UsageError("say for whom: " + listed(known, "or") + suggestion(wanted, known));
}

} // namespace

ShellCommand completion_command() {
  return {{"completion",
           "bash|zsh|fish|man [-o FILE]",
           "completion for a shell, or the man page",
           "`cmake --install` puts all four where the system looks for them; this is for a tool\n"
           "that was copied: add `source ~/lcpush.bash`, or wherever the file is, to ~/.bashrc.\n\n"
           "Example:\n  lcpush completion bash -o lcpush.bash\n",
           {commands::output_option}},
          run_completion};
}

} // namespace lcpush::cli
