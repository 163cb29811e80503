#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "calib/capture/colmap_model.h"
#include "calib/pictures/image_io.h"
#include "meshing/depth/depth_stage.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

fs::path photographs_folder() {
    const char* named = std::getenv("LUMI_PHOTOS");
    return named != nullptr ? fs::path(named) : fs::path(LUMI_SOURCE_DIR) / "../shared/data";
}

TEST(ArenaDepth, NearlyAllConfidentPixelsAreWithinAPixelOfTheTruth) {
    const fs::path arena = photographs_folder() / "arena";
    if (!fs::exists(arena)) GTEST_SKIP() << "no photographs at " << arena;
    PosedPhotographs photographs;
    photographs.capture = read_colmap_model(arena / "sparse");
    std::vector<int> listed;
    for (const View& view : photographs.capture.views) {
        if (view.name.starts_with("in")) {
            listed.push_back(static_cast<int>(photographs.picture_paths.size()));
        }
        photographs.picture_paths.push_back(arena / "images" / view.name);
    }
    SilentProgress progress;
    const DepthResult result = estimate_depth(photographs, listed, {}, 0, progress);
    for (std::size_t i = 0; i < listed.size(); ++i) {
        const DepthMap& map = result.depth_maps[i];
        const std::string& name = result.evidence[i].view_name;
        const FloatImage depth =
            read_float_tiff((arena / "depth_exact" / name).replace_extension(".tiff"));
        // One pixel of disparity to a camera half a unit away.
        const float one_pixel = 1.0F / (576.0F * 0.5F);
        int confident = 0;
        int right = 0;
        for (std::size_t p = 0; p < depth.pixels().size(); ++p) {
            if (map.confidence.pixels()[p] == 0) continue;
            ++confident;
            const float truth = 1.0F / depth.pixels()[p];
            if (std::abs(map.inverse_depth.pixels()[p] - truth) <= one_pixel) ++right;
        }
        const double pixels = static_cast<double>(depth.pixels().size());
        EXPECT_GT(confident / pixels, 0.85) << name;
        EXPECT_GT(static_cast<double>(right) / confident, 0.98) << name;
    }
}

}  // namespace
}  // namespace lumi
