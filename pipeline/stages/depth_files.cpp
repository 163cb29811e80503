#include "pipeline/stages/depth_files.h"

#include <algorithm>
#include <utility>

#include "calib/pictures/image_io.h"
#include "calib/work/parallel_for.h"
#include "pipeline/stages/color_scale.h"
#include "pipeline/stages/depth_percentiles.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

struct Range {
    float low = 0.0F;
    float high = 1.0F;
};

/// From the 1st to the 99th percentile of what the maps say.
Range range_to_show(const std::vector<DepthMap>& depth_maps) {
    std::vector<float> values;
    for (const DepthMap& map : depth_maps) {
        const std::vector<float>& pixels = map.inverse_depth.pixels();
        for (std::size_t i = 0; i < pixels.size(); i += kPercentileStride)
            values.push_back(pixels[i]);
    }
    const std::optional<Percentiles> found = percentiles_of(std::move(values));
    if (!found) return {};
    return {found->low, found->high > found->low ? found->high : found->low + 1.0F};
}

ColorImage picture_of(const FloatImage& inverse_depth, const Range& range) {
    ColorImage picture(inverse_depth.width(), inverse_depth.height());
    std::transform(inverse_depth.pixels().begin(), inverse_depth.pixels().end(),
                   picture.pixels().begin(), [&](float value) {
                       return color_of_share((value - range.low) / (range.high - range.low));
                   });
    return picture;
}

fs::path value_path(const fs::path& folder, const std::string& stem) {
    return folder / (stem + ".inverse_depth.tif");
}
fs::path confidence_path(const fs::path& folder, const std::string& stem) {
    return folder / (stem + ".confidence.png");
}

}  // namespace

void write_depth_files(const fs::path& folder, const std::vector<std::string>& stems,
                       const std::vector<DepthMap>& depth_maps, int threads) {
    const Range range = range_to_show(depth_maps);
    parallel_for(static_cast<int>(stems.size()), threads, [&](int i) {
        const auto index = static_cast<std::size_t>(i);
        const DepthMap& map = depth_maps[index];
        write_float_tiff(value_path(folder, stems[index]), map.inverse_depth);
        write_png(confidence_path(folder, stems[index]), map.confidence);
        write_png(folder / (stems[index] + ".inverse_depth.png"),
                  picture_of(map.inverse_depth, range));
    });
}

std::vector<DepthMap> read_depth_files(const fs::path& folder,
                                       const std::vector<std::string>& stems, int threads) {
    std::vector<DepthMap> depth_maps(stems.size());
    parallel_for(static_cast<int>(stems.size()), threads, [&](int i) {
        const auto index = static_cast<std::size_t>(i);
        depth_maps[index] = {read_float_tiff(value_path(folder, stems[index])),
                             read_gray_png(confidence_path(folder, stems[index]))};
    });
    return depth_maps;
}

}  // namespace lumi
