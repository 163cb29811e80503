#include "meshing/cameras/written_names.h"

#include <algorithm>

namespace lumi {

bool WrittenNames::claim(const Eigen::Vector2d& at, const std::string& name) {
    // Of the letters' size; usual names are narrower.
    constexpr double kLetterWidth = 0.6;
    const Eigen::Vector2d end =
        at + Eigen::Vector2d(kLetterWidth * letter_size_ * static_cast<double>(name.size()), 0);
    const Eigen::AlignedBox2d box(at - Eigen::Vector2d(0, letter_size_), end);
    const bool is_free = std::none_of(boxes_.begin(), boxes_.end(),
                                      [&](const auto& other) { return box.intersects(other); });
    if (is_free) boxes_.push_back(box);
    return is_free;
}

}  // namespace lumi
