#pragma once

#include <chrono>
#include <iosfwd>
#include <mutex>
#include <string>

#include "calib/work/progress.h"

namespace lumi {

/// "7 of 40, about 12 s left". Empty when the length of the step is unknown (`total` 0).
[[nodiscard]] std::string progress_text(std::size_t done, std::size_t total, double elapsed_s);

/// A bar that is redrawn in place, for terminals; notes are made printable, as a name within one
/// may be anything.
class BarProgress final : public Progress {
 public:
    explicit BarProgress(std::ostream& out) : out_(out) {}
    ~BarProgress() override;
    BarProgress(const BarProgress&) = delete;
    BarProgress& operator=(const BarProgress&) = delete;

    void begin(const std::string& step, std::size_t total) override;
    void advance(std::size_t units) override;
    void note(const std::string& message) override;
    /// Takes the bar away for other words; it comes back when the step advances.
    void clear();

 private:
    using Clock = std::chrono::steady_clock;
    void draw();
    void erase();

    std::ostream& out_;
    std::mutex mutex_;
    std::string step_;
    std::size_t done_ = 0;
    std::size_t total_ = 0;
    Clock::time_point started_;
    Clock::time_point drawn_;
};

/// One line a step and a note, for logs; notes are made printable.
class LineProgress final : public Progress {
 public:
    explicit LineProgress(std::ostream& out) : out_(out) {}

    void begin(const std::string& step, std::size_t total) override;
    void advance(std::size_t) override {}
    void note(const std::string& message) override;

 private:
    std::ostream& out_;
    std::mutex mutex_;
};

}  // namespace lumi
