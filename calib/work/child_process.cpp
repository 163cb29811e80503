#include "calib/work/child_process.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <optional>
#include <thread>

#include "calib/work/error.h"

namespace lumi {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kPollInterval{20};

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

double seconds_of(const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

class Descriptor {
 public:
    explicit Descriptor(int value) : value_(value) {}
    ~Descriptor() { reset(); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    [[nodiscard]] int get() const { return value_; }
    void reset() {
        if (value_ >= 0) ::close(value_);
        value_ = -1;
    }

 private:
    int value_;
};

/// The environment without a display: a program that looks for one must not find the user's.
std::vector<std::string> headless_environment() {
    std::vector<std::string> result{"QT_QPA_PLATFORM=offscreen"};
    for (char** entry = environ; entry != nullptr && *entry != nullptr; ++entry) {
        const std::string_view text(*entry);
        const std::string_view name = text.substr(0, text.find('='));
        if (name == "DISPLAY" || name == "WAYLAND_DISPLAY" || name == "XAUTHORITY" ||
            name == "QT_QPA_PLATFORM") {
            continue;
        }
        result.emplace_back(text);
    }
    return result;
}

std::vector<char*> pointers_to(std::vector<std::string>& texts) {
    std::vector<char*> result;
    for (std::string& text : texts) result.push_back(text.data());
    result.push_back(nullptr);
    return result;
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
        if (std::filesystem::is_regular_file(file) && ::access(file.c_str(), X_OK) == 0) {
            return file.string();
        }
        begin = end + 1;
    }
    return std::nullopt;
}

struct ChildSetup {
    const char* program;
    char* const* arguments;
    char* const* environment;
    int log;
    int error_pipe;
    pid_t parent;
};

/// Between fork and exec: only calls that are safe in a signal handler, because other threads of
/// this process may have held any lock. posix_spawn cannot ask for the death signal, without which
/// a program would outlive a killed parent and go on writing into the folder of the next run.
[[noreturn]] void become(const ChildSetup& setup) {
    ::setpgid(0, 0);
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != setup.parent) ::_exit(127);
    sigset_t none;
    ::sigemptyset(&none);
    ::sigprocmask(SIG_SETMASK, &none, nullptr);
    for (const int signal : {SIGINT, SIGTERM, SIGPIPE, SIGHUP}) ::signal(signal, SIG_DFL);
    const int nothing = ::open("/dev/null", O_RDONLY);
    if (nothing >= 0 && ::dup2(nothing, STDIN_FILENO) >= 0 &&
        ::dup2(setup.log, STDOUT_FILENO) >= 0 && ::dup2(setup.log, STDERR_FILENO) >= 0) {
        ::execve(setup.program, setup.arguments, setup.environment);
    }
    const int reason = errno;
    [[maybe_unused]] const ssize_t written = ::write(setup.error_pipe, &reason, sizeof reason);
    ::_exit(127);
}

[[noreturn]] void refuse_start(const std::string& program, int reason) {
    throw Error(ErrorKind::kExternalProgram, "E-CHILD-START",
                program + ": cannot be started: " + std::strerror(reason),
                "check that the program may be run, and that memory and processes are left");
}

pid_t start(const ChildCommand& command, const std::string& program, int log) {
    std::vector<std::string> arguments = command.arguments;
    std::vector<std::string> environment = headless_environment();
    const std::vector<char*> argument_pointers = pointers_to(arguments);
    const std::vector<char*> environment_pointers = pointers_to(environment);
    std::array<int, 2> ends{-1, -1};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) refuse_start(program, errno);
    const Descriptor read_end(ends[0]);
    Descriptor write_end(ends[1]);
    const ChildSetup setup{program.c_str(),
                           argument_pointers.data(),
                           environment_pointers.data(),
                           log,
                           write_end.get(),
                           ::getpid()};
    const pid_t child = ::fork();
    if (child < 0) refuse_start(program, errno);
    if (child == 0) become(setup);
    ::setpgid(child, child);  // In the child too: whichever comes first, the group exists now.
    write_end.reset();
    int reason = 0;
    ssize_t received = 0;
    do {
        received = ::read(read_end.get(), &reason, sizeof reason);
    } while (received < 0 && errno == EINTR);
    if (received > 0) {
        ::waitpid(child, nullptr, 0);
        refuse_start(program, reason);
    }
    return child;
}

/// The running group; killed and reaped when it is left behind.
class RunningGroup {
 public:
    explicit RunningGroup(pid_t leader) : leader_(leader) {}
    ~RunningGroup() {
        if (!reaped_) kill_and_reap();
    }
    RunningGroup(const RunningGroup&) = delete;
    RunningGroup& operator=(const RunningGroup&) = delete;

    /// True when the leader has ended; what it left behind in its group is killed.
    bool ended() {
        // Looked at without reaping: as long as the leader is not reaped its id is not reused.
        siginfo_t information{};
        if (::waitid(P_PID, static_cast<id_t>(leader_), &information,
                     WEXITED | WNOHANG | WNOWAIT) != 0 ||
            information.si_pid == 0) {
            return false;
        }
        kill_and_reap();
        return true;
    }
    void kill_and_reap() {
        ::kill(-leader_, SIGKILL);
        while (::wait4(leader_, &status_, 0, &usage_) < 0 && errno == EINTR) {
        }
        reaped_ = true;
    }
    [[nodiscard]] int status() const { return status_; }
    [[nodiscard]] double cpu_s() const {
        return seconds_of(usage_.ru_utime) + seconds_of(usage_.ru_stime);
    }

 private:
    pid_t leader_;
    bool reaped_ = false;
    int status_ = 0;
    rusage usage_{};
};

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
    Descriptor descriptor_;
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
ChildEnd supervise(RunningGroup& group, LogReader& log, const ChildCommand& command,
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
    const Descriptor log(open_log(command.log_path));
    LogReader reader(command.log_path);
    RunningGroup group(start(command, *program, log.get()));
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
