#include "calib/work/child_process.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <thread>

#include "calib/work/error.h"
#include "calib/work/process_group.h"

namespace lumi {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kPollInterval{20};

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The path that `execvpe` would run; looked up before the fork, because searching allocates.
std::optional<std::string> found_program(const std::string& name) {
    if (name.find('/') != std::string::npos) {
        if (::access(name.c_str(), X_OK) == 0) return name;
        return std::nullopt;
    }
    const char* variable = std::getenv("PATH");
    const std::string paths = variable == nullptr ? "/usr/local/bin:/usr/bin:/bin" : variable;
    for (std::size_t begin = 0; begin <= paths.size();) {
        const std::size_t end = std::min(paths.find(':', begin), paths.size());
        const std::filesystem::path file =
            std::filesystem::path(paths.substr(begin, end - begin)) / name;
        std::error_code
            unreachable;  // As a shell does, folders that may not be entered are passed.
        if (std::filesystem::is_regular_file(file, unreachable) &&
            ::access(file.c_str(), X_OK) == 0) {
            return file.string();
        }
        begin = end + 1;
    }
    return std::nullopt;
}

/// Reads what has been appended to the log.
class LogReader {
 public:
    explicit LogReader(const std::filesystem::path& path)
        : descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {}

    std::string new_text() {
        std::string result;
        std::array<char, 4096> buffer{};
        for (;;) {
            const ssize_t count = ::read(descriptor_.get(), buffer.data(), buffer.size());
            if (count <= 0) return result;
            result.append(buffer.data(), static_cast<std::size_t>(count));
        }
    }

 private:
    FileDescriptor descriptor_;
};

int open_log(const std::filesystem::path& path) {
    const int log = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC, 0644);
    if (log < 0) {
        throw Error(ErrorKind::kResources, "E-FILE-WRITE",
                    path.string() + ": cannot write: " + std::strerror(errno),
                    "check that the folder exists and that the disk has space left");
    }
    return log;
}

/// Waits for the end of the group or for a limit.
ChildEnd supervise(ProcessGroup& group, LogReader& log, const ChildCommand& command,
                   const Progress& progress) {
    const Clock::time_point start_time = Clock::now();
    Clock::time_point last_output = start_time;
    const auto read_output = [&] {
        const std::string text = log.new_text();
        if (!text.empty()) last_output = Clock::now();
        if (command.on_output) command.on_output(text);
    };
    while (!group.ended()) {
        progress.throw_if_interrupted();
        read_output();
        if (seconds_since(start_time) > command.time_limit_s) {
            group.kill_and_reap();
            return ChildEnd::kTimeLimit;
        }
        if (command.silence_limit_s > 0 && seconds_since(last_output) > command.silence_limit_s) {
            group.kill_and_reap();
            return ChildEnd::kSilenceLimit;
        }
        std::this_thread::sleep_for(kPollInterval);
    }
    read_output();
    return WIFSIGNALED(group.status()) ? ChildEnd::kSignalled : ChildEnd::kExited;
}

}  // namespace

ChildResult run_child(const ChildCommand& command, const Progress& progress) {
    const Clock::time_point start_time = Clock::now();
    const std::string& name = command.arguments.at(0);
    const std::optional<std::string> program = found_program(name);
    if (!program) {
        throw Error(ErrorKind::kExternalProgram, "E-CHILD-MISSING",
                    name + ": no such program in PATH", command.missing_advice);
    }
    const FileDescriptor log(open_log(command.log_path));
    LogReader reader(command.log_path);
    ProcessGroup group = ProcessGroup::start(*program, command.arguments, log.get());
    ChildResult result;
    result.end = supervise(group, reader, command, progress);
    result.exit_status = WIFEXITED(group.status()) ? WEXITSTATUS(group.status()) : 0;
    result.signal = WIFSIGNALED(group.status()) ? WTERMSIG(group.status()) : 0;
    result.wall_s = seconds_since(start_time);
    result.cpu_s = group.cpu_s();
    return result;
}

std::string command_line_of(const std::vector<std::string>& arguments) {
    constexpr std::string_view kPlain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./,:=+@%";
    std::string line;
    for (const std::string& argument : arguments) {
        if (!line.empty()) line += ' ';
        if (!argument.empty() && argument.find_first_not_of(kPlain) == std::string::npos) {
            line += argument;
            continue;
        }
        line += '\'';
        for (const char letter : argument) {
            if (letter == '\'') {
                line += "'\\''";
            } else {
                line += letter;
            }
        }
        line += '\'';
    }
    return line;
}

std::string description_of(const ChildResult& result, const ChildCommand& command) {
    const auto whole_seconds = [](double seconds) {
        return std::to_string(static_cast<long>(seconds + 0.5)) + " s";
    };
    switch (result.end) {
        case ChildEnd::kExited:
            return "exit status " + std::to_string(result.exit_status);
        case ChildEnd::kSignalled:
            return "signal " + std::to_string(result.signal) + " (" + ::strsignal(result.signal) +
                   ")";
        case ChildEnd::kTimeLimit:
            return "no end within " + whole_seconds(command.time_limit_s);
        case ChildEnd::kSilenceLimit:
            return "no sign of life for " + whole_seconds(command.silence_limit_s);
    }
    return {};
}

}  // namespace lumi
