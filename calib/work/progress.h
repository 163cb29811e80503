#pragma once

#include <atomic>
#include <cstddef>
#include <string>

#include "calib/work/error.h"

namespace lumi {

/// Where long work reports how far it is, and learns that it should stop.
///
/// Libraries print nothing: a command hands in an implementation that draws a bar or prints lines.
/// `advance` and `throw_if_interrupted` may be called from several threads at once.
class Progress {
 public:
    virtual ~Progress() = default;

    /// A step of `total` units begins; 0 when its length is unknown.
    virtual void begin(const std::string& step, std::size_t total) = 0;
    virtual void advance(std::size_t units = 1) = 0;
    /// Something the user should know while the work goes on.
    virtual void note(const std::string& message) = 0;

    /// Asks the work to stop. Safe in a signal handler.
    void interrupt() noexcept { interrupted_.store(true, std::memory_order_relaxed); }
    [[nodiscard]] virtual bool interrupted() const noexcept {
        return interrupted_.load(std::memory_order_relaxed);
    }
    void throw_if_interrupted() const {
        if (interrupted()) {
            throw Error(ErrorKind::kInterrupted, "E-INTERRUPTED", "stopped on request",
                        "run the same command again");
        }
    }

 private:
    std::atomic<bool> interrupted_{false};
};

/// Says nothing, and stops when the work that it is a part of is asked to.
class QuietPart final : public Progress {
 public:
    explicit QuietPart(const Progress& whole) : whole_(whole) {}
    void begin(const std::string&, std::size_t) override {}
    void advance(std::size_t) override {}
    void note(const std::string&) override {}
    [[nodiscard]] bool interrupted() const noexcept override { return whole_.interrupted(); }

 private:
    const Progress& whole_;
};

/// Says nothing. For tests and for callers that do not care.
class SilentProgress final : public Progress {
 public:
    void begin(const std::string&, std::size_t) override {}
    void advance(std::size_t) override {}
    void note(const std::string&) override {}
};

}  // namespace lumi
