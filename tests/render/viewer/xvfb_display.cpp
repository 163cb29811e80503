#include "tests/render/viewer/xvfb_display.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>

namespace lumi {
namespace {

/// Xvfb writes its number and a line feed once it is ready; nothing comes where it cannot start.
std::string read_line(int descriptor) {
    std::string line;
    char c = 0;
    while (::read(descriptor, &c, 1) == 1 && c != '\n') line += c;
    return line;
}

}  // namespace

XvfbDisplay::XvfbDisplay() {
    std::array<int, 2> ends{};
    if (::pipe(ends.data()) != 0) return;
    const pid_t test = ::getpid();
    process_ = ::fork();
    if (process_ == 0) {
        // Not longer than the test, which may be killed.
        ::prctl(PR_SET_PDEATHSIG, SIGTERM);
        if (::getppid() != test) ::_exit(127);
        const int nowhere = ::open("/dev/null", O_RDWR);
        ::dup2(nowhere, STDOUT_FILENO);
        ::dup2(nowhere, STDERR_FILENO);
        ::close(ends[0]);
        const std::string descriptor = std::to_string(ends[1]);
        ::execlp("Xvfb", "Xvfb", "-displayfd", descriptor.c_str(), "-screen", "0", "1280x1024x24",
                 "-noreset", "-nolisten", "tcp", static_cast<char*>(nullptr));
        ::_exit(127);
    }
    ::close(ends[1]);
    number_ = read_line(ends[0]);
    ::close(ends[0]);
    if (!is_running()) return;
    if (const char* before = std::getenv("DISPLAY")) display_before_ = before;
    ::setenv("DISPLAY", (":" + number_).c_str(), 1);
}

XvfbDisplay::~XvfbDisplay() {
    if (is_running() && display_before_) ::setenv("DISPLAY", display_before_->c_str(), 1);
    if (is_running() && !display_before_) ::unsetenv("DISPLAY");
    if (process_ <= 0) return;
    ::kill(process_, SIGTERM);
    ::waitpid(process_, nullptr, 0);
}

}  // namespace lumi
