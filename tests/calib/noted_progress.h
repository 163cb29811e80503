#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "calib/work/progress.h"

namespace lumi {

/// Keeps what is noted on the way.
class NotedProgress final : public Progress {
 public:
    void begin(const std::string&, std::size_t) override {}
    void advance(std::size_t) override {}
    void note(const std::string& message) override { notes.push_back(message); }

    std::vector<std::string> notes;
};

}  // namespace lumi
