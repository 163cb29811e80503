#include "pipeline/commands/text_progress.h"

#include <algorithm>
#include <cmath>
#include <ostream>

#include "calib/work/printable.h"

namespace lumi {
namespace {

constexpr std::size_t kBarWidth = 24;
constexpr std::chrono::milliseconds kRedrawInterval{100};

std::string bar(std::size_t done, std::size_t total) {
    const std::size_t filled = kBarWidth * std::min(done, total) / total;
    return "[" + std::string(filled, '#') + std::string(kBarWidth - filled, '.') + "] ";
}

}  // namespace

std::string progress_text(std::size_t done, std::size_t total, double elapsed_s) {
    if (total == 0) return {};
    std::string text = std::to_string(done) + " of " + std::to_string(total);
    if (done > 0 && done < total) {
        const double left_s =
            elapsed_s * static_cast<double>(total - done) / static_cast<double>(done);
        text += ", about " + std::to_string(std::lround(std::ceil(left_s))) + " s left";
    }
    return text;
}

BarProgress::~BarProgress() { erase(); }

void BarProgress::begin(const std::string& step, std::size_t total) {
    const std::scoped_lock lock(mutex_);
    step_ = step;
    done_ = 0;
    total_ = total;
    started_ = Clock::now();
    draw();
}

void BarProgress::advance(std::size_t units) {
    const std::scoped_lock lock(mutex_);
    done_ += units;
    if (Clock::now() - drawn_ >= kRedrawInterval) draw();
}

void BarProgress::note(const std::string& message) {
    const std::scoped_lock lock(mutex_);
    erase();
    out_ << printable(message) << '\n';
    if (done_ < total_) draw();
}

void BarProgress::clear() {
    const std::scoped_lock lock(mutex_);
    erase();
}

void BarProgress::draw() {
    drawn_ = Clock::now();
    const double elapsed_s = std::chrono::duration<double>(drawn_ - started_).count();
    erase();
    if (total_ > 0) out_ << bar(done_, total_);
    out_ << step_ << ' ' << progress_text(done_, total_, elapsed_s) << std::flush;
}

void BarProgress::erase() { out_ << "\r\x1b[K" << std::flush; }

void LineProgress::begin(const std::string& step, std::size_t total) {
    const std::scoped_lock lock(mutex_);
    out_ << "  " << step;
    if (total > 0) out_ << " (" << total << ')';
    out_ << std::endl;
}

void LineProgress::note(const std::string& message) {
    const std::scoped_lock lock(mutex_);
    out_ << printable(message) << std::endl;
}

}  // namespace lumi
