#include "pipeline/commands/interruption.h"

#include <atomic>
#include <csignal>

namespace lumi {
namespace {

std::atomic<Progress*> interruptible{nullptr};
static_assert(std::atomic<Progress*>::is_always_lock_free, "used in a signal handler");

extern "C" void ask_to_stop(int) {
    if (Progress* progress = interruptible.load()) progress->interrupt();
}

void handle(int signal) {
    struct sigaction action {};
    action.sa_handler = ask_to_stop;
    sigemptyset(&action.sa_mask);
    action.sa_flags =
        static_cast<int>(SA_RESETHAND) | SA_RESTART;  // The second signal ends it all.
    sigaction(signal, &action, nullptr);
}

}  // namespace

Interruption::Interruption(Progress& progress) {
    interruptible = &progress;
    handle(SIGINT);
    handle(SIGTERM);
}

Interruption::~Interruption() {
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
    interruptible = nullptr;
}

}  // namespace lumi
