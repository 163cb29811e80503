#include "render/depth_mesh/small_regions.h"

#include <cstddef>

namespace lumi {
namespace {

/// Finds the region around a sample: those of its value that are joined with it.
class RegionFinder {
 public:
    RegionFinder(const std::vector<std::uint8_t>& values, int columns)
        : values_(values),
          columns_(static_cast<std::size_t>(columns)),
          is_known_(values.size(), 0) {}

    [[nodiscard]] bool is_known(std::size_t sample) const { return is_known_[sample] != 0; }

    /// The samples of a region that is not known yet; valid until the next call.
    const std::vector<std::size_t>& region_of(std::size_t first) {
        region_.assign(1, first);
        is_known_[first] = 1;
        for (std::size_t next = 0; next < region_.size(); ++next) {
            const std::size_t at = region_[next];
            const std::size_t column = at % columns_;
            if (column > 0) join(at, at - 1);
            if (column + 1 < columns_) join(at, at + 1);
            if (at >= columns_) join(at, at - columns_);
            if (at + columns_ < values_.size()) join(at, at + columns_);
        }
        return region_;
    }

 private:
    void join(std::size_t at, std::size_t other) {
        if (is_known_[other] != 0 || values_[other] != values_[at]) return;
        is_known_[other] = 1;
        region_.push_back(other);
    }

    const std::vector<std::uint8_t>& values_;
    std::size_t columns_;
    std::vector<std::uint8_t> is_known_;
    std::vector<std::size_t> region_;
};

}  // namespace

void absorb_small_regions(std::vector<std::uint8_t>& values, int columns, std::size_t max_samples) {
    RegionFinder finder(values, columns);
    std::vector<std::size_t> absorbed;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (finder.is_known(i)) continue;
        const std::vector<std::size_t>& region = finder.region_of(i);
        if (region.size() <= max_samples && region.size() < values.size())
            absorbed.insert(absorbed.end(), region.begin(), region.end());
    }
    for (const std::size_t i : absorbed) values[i] = values[i] == 0 ? 1 : 0;
}

}  // namespace lumi
