#include "calib/work/process_group.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <string_view>

#include "calib/work/cpu_time.h"
#include "calib/work/error.h"

namespace lumi {
namespace {

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

struct ChildSetup {
    const char* program;
    char* const* arguments;
    char* const* environment;
    int output;
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
    for (const int signal : {SIGINT, SIGTERM, SIGPIPE, SIGHUP, SIGCHLD}) ::signal(signal, SIG_DFL);
    const int nothing = ::open("/dev/null", O_RDONLY);
    if (nothing >= 0 && ::dup2(nothing, STDIN_FILENO) >= 0 &&
        ::dup2(setup.output, STDOUT_FILENO) >= 0 && ::dup2(setup.output, STDERR_FILENO) >= 0) {
        ::execve(setup.program, setup.arguments, setup.environment);
    }
    const int reason = errno;
    [[maybe_unused]] const ssize_t written = ::write(setup.error_pipe, &reason, sizeof reason);
    ::_exit(127);
}

/// Whoever started this process may have ignored SIGCHLD, which outlives exec: the kernel then
/// forgets children as they end. A handler stays as it is.
void let_ended_children_wait() {
    struct sigaction action {};
    if (::sigaction(SIGCHLD, nullptr, &action) != 0) return;
    const bool is_ignored = (action.sa_flags & SA_SIGINFO) == 0 && action.sa_handler == SIG_IGN;
    if (!is_ignored && (action.sa_flags & SA_NOCLDWAIT) == 0) return;
    if (is_ignored) action.sa_handler = SIG_DFL;
    action.sa_flags &= ~SA_NOCLDWAIT;
    ::sigaction(SIGCHLD, &action, nullptr);
}

[[noreturn]] void refuse_start(const std::string& program, int reason) {
    throw Error(ErrorKind::kExternalProgram, "E-CHILD-START",
                program + ": cannot be started: " + std::strerror(reason),
                "check that the program may be run, and that memory and processes are left");
}

}  // namespace

ProcessGroup ProcessGroup::start(const std::string& program, std::vector<std::string> arguments,
                                 int output_descriptor) {
    std::vector<std::string> environment = headless_environment();
    const std::vector<char*> argument_pointers = pointers_to(arguments);
    const std::vector<char*> environment_pointers = pointers_to(environment);
    std::array<int, 2> ends{-1, -1};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) refuse_start(program, errno);
    const FileDescriptor read_end(ends[0]);
    FileDescriptor write_end(ends[1]);
    const ChildSetup setup{program.c_str(),   argument_pointers.data(), environment_pointers.data(),
                           output_descriptor, write_end.get(),          ::getpid()};
    let_ended_children_wait();
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
    return {program, child};
}

bool ProcessGroup::ended() {
    // Looked at without reaping: as long as the leader is not reaped its id is not reused.
    siginfo_t information{};
    if (::waitid(P_PID, static_cast<id_t>(leader_), &information, WEXITED | WNOHANG | WNOWAIT) !=
        0) {
        throw Error(ErrorKind::kExternalProgram, "E-CHILD-LOST",
                    program_ + ": how it ended is not known: " + std::strerror(errno),
                    "let nothing else in this process wait for its children, and run it again");
    }
    if (information.si_pid == 0) return false;
    kill_and_reap();
    return true;
}

void ProcessGroup::kill_and_reap() {
    ::kill(-leader_, SIGKILL);
    while (::wait4(leader_, &status_, 0, &usage_) < 0 && errno == EINTR) {
    }
    reaped_ = true;
}

double ProcessGroup::cpu_s() const { return cpu_s_of(usage_); }

}  // namespace lumi
