#pragma once

#include <cstdint>
#include <vector>

namespace lumi {

/// Gives the value of what is around them to regions of a raster of zeros and ones, connected along
/// rows and columns, of at most `max_samples`. Regions that were larger stay larger. `values` are
/// rows of `columns` each.
void absorb_small_regions(std::vector<std::uint8_t>& values, int columns, std::size_t max_samples);

}  // namespace lumi
