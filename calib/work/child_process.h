#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "calib/work/progress.h"

namespace lumi {

/// A program to run, without a shell.
struct ChildCommand {
    std::vector<std::string> arguments;  ///< The program first; it is looked up in PATH.
    std::filesystem::path log_path;      ///< Receives standard output and standard error.
    double time_limit_s = 3600;          ///< The program is killed after this long. > 0.
    double silence_limit_s = 0;  ///< Killed when it has printed nothing for so long. 0: never.
    std::string missing_advice;  ///< What to do when the program is not there.
    /// Called with what the program has printed since the last call; may be empty.
    std::function<void(std::string_view)> on_output;
};

enum class ChildEnd {
    kExited,
    kSignalled,
    kTimeLimit,     ///< Killed at `time_limit_s`.
    kSilenceLimit,  ///< Killed at `silence_limit_s`.
};

/// How a program ended and what it cost. An exit status of 0 is no evidence that it did its work.
struct ChildResult {
    ChildEnd end = ChildEnd::kExited;
    int exit_status = 0;  ///< When it exited.
    int signal = 0;       ///< When it was killed by a signal.
    double wall_s = 0.0;
    double cpu_s = 0.0;  ///< User and system time, with those of its own finished children.
};

/// Runs a program to its end in a process group of its own, in an environment without a display.
///
/// The whole group is killed at a limit, on interruption and on any exception; the program also
/// dies with this process. Throws Error: E-CHILD-MISSING (no such program), E-CHILD-START,
/// E-CHILD-LOST (somebody else waited for it), E-INTERRUPTED, E-FILE-WRITE (the log).
[[nodiscard]] ChildResult run_child(const ChildCommand& command, const Progress& progress);

/// The command as a user would type it, for messages and reports.
[[nodiscard]] std::string command_line_of(const std::vector<std::string>& arguments);

/// "exit status 1", "signal 6 (Aborted)", "no end within 60 s": for messages.
[[nodiscard]] std::string description_of(const ChildResult& result, const ChildCommand& command);

}  // namespace lumi
