#include "pipeline/commands/frame_size.h"

#include <charconv>

#include "calib/work/error.h"

namespace lumi {
namespace {

constexpr int kMaxSidePx = 16384;

}  // namespace

FrameSize frame_size_from(const std::string& text) {
    FrameSize size;
    const char* const end = text.data() + text.size();
    const auto width = std::from_chars(text.data(), end, size.width_px);
    const bool has_cross = width.ptr != end && *width.ptr == 'x';
    const auto height = std::from_chars(has_cross ? width.ptr + 1 : end, end, size.height_px);
    const auto is_side = [](int side_px) { return side_px >= 1 && side_px <= kMaxSidePx; };
    if (height.ptr != end || !is_side(size.width_px) || !is_side(size.height_px)) {
        throw Error(ErrorKind::kUsage, "E-RENDER-SIZE", "--size " + text + " is not a size",
                    "write it as 1280x720, at most 16384 a side");
    }
    return size;
}

}  // namespace lumi
