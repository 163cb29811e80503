#pragma once

#include <cstddef>
#include <string>

#include "calib/work/progress.h"

namespace lumi {

/// Asks the work to stop once it has been asked whether it should so many times. On one thread.
class InterruptedProgress final : public Progress {
 public:
    explicit InterruptedProgress(int questions) : questions_(questions) {}
    void begin(const std::string&, std::size_t) override {}
    void advance(std::size_t) override {}
    void note(const std::string&) override {}
    [[nodiscard]] bool interrupted() const noexcept override { return --questions_ < 0; }

 private:
    mutable int questions_;
};

}  // namespace lumi
