// The terminal: which commands there are, and where their output goes.
#pragma once

#include "cli/arguments.hpp"

namespace lcpush::cli {

/// A command that a shell alone has writes its own output.
struct ShellCommand : Command {
  int (*run_alone)(const Arguments&) = nullptr; ///< the exit status
};
ShellCommand play_command();
ShellCommand export_command();
ShellCommand example_command();
ShellCommand new_command();
ShellCommand completion_command();

/// In the order of the overview.
std::vector<ShellCommand> all_commands();

enum class Stream { output, errors };
/// Of the terminal behind it; 80 where there is none.
std::size_t columns_of(Stream stream);

/// A line for people on standard error, wrapped.
void tell(const std::string& sentence);

/// Writes to the file of -o (whole or not at all), or to standard output. Says so of what is to be
/// looked at. Throws InputError.
void write_output(const Arguments& arguments, const std::string& text);

/// The same to the file at `path`.
void write_file(const std::string& path, const std::string& text);

/// Writes the proof of the answer to the file of --certify, and says so on stderr; nothing without
/// the option. Returns false if there was to be a certificate and is none.
bool write_certificate(const Arguments& arguments, const commands::Result& result);

/// Refuses to write a page to a terminal.
void refuse_page_on_terminal(const Arguments& arguments, const std::string& name);

/// Makes the folder, with its parents. Throws InputError.
void make_directory(const std::string& path);

} // namespace lcpush::cli
