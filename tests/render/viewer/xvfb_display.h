#pragma once

#include <sys/types.h>

#include <optional>
#include <string>

namespace lumi {

/// A display that nobody sees: an Xvfb of its own on a free number, DISPLAY set to it while this
/// lives, and afterwards what it was.
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
    std::optional<std::string> display_before_;
};

}  // namespace lumi
