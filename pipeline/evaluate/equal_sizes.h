#pragma once

#include <string>

#include "calib/capture/image.h"
#include "calib/work/error.h"

namespace lumi {

/// "640x480".
[[nodiscard]] inline std::string size_text(int width, int height) {
    return std::to_string(width) + "x" + std::to_string(height);
}

/// Throws Error (E-EVAL-SIZE) when two pictures to compare differ in size.
template <class A, class B>
void expect_equal_sizes(const Image<A>& a, const Image<B>& b) {
    if (a.width() == b.width() && a.height() == b.height()) return;
    throw Error(ErrorKind::kBadInput, "E-EVAL-SIZE",
                "pictures to compare differ in size: " + size_text(a.width(), a.height()) +
                    " and " + size_text(b.width(), b.height()),
                "compare pictures of one size");
}

}  // namespace lumi
