#pragma once

#include <sys/types.h>

#include <string>

namespace lumi {

/// A display that nobody sees: an Xvfb of its own on a free number, DISPLAY set to it while this
/// lives.
class XvfbDisplay {
 public:
    XvfbDisplay();
    ~XvfbDisplay();
    XvfbDisplay(const XvfbDisplay&) = delete;
    XvfbDisplay& operator=(const XvfbDisplay&) = delete;

    [[nodiscard]] bool is_running() const { return !number_.empty(); }

 private:
    pid_t process_ = -1;
    std::string number_;
};

}  // namespace lumi
