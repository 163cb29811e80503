#include "render/reference/agreed_depth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "render/transfer/view_geometry.h"
#include "tests/render/analytic_scene.h"

namespace lumi {
namespace {

TEST(AgreedDepth, OfAPixelOnAnOutlineIsThatOfTheTwoSurfacesThere) {
    const Lumigraph lumigraph = card_before_wall();
    // Both are steep, so that no two samples have the same depth.
    const Eye eye = eye_at({1.6, 0.9, 0.6}, {0, 0, 4}, pinhole_camera(64, 48, 70));
    const AgreedDepth depth(lumigraph, view_geometries(lumigraph), eye, {});
    int outline = 0;
    int of_two = 0;
    for (int y = 0; y < 48; ++y) {
        for (int x = 0; x < 64; ++x) {
            const auto samples = depth.samples_at({x + 0.5, y + 0.5});
            if (samples.size() == 1) continue;
            // Those behind tears give way to others.
            ASSERT_LE(samples.size(), 4U);
            const auto behind = std::count_if(samples.begin(), samples.end(), [](const auto& s) {
                return s.depth.is_behind_tears;
            });
            EXPECT_TRUE(behind == 0 ||
                        std::none_of(samples.begin(), samples.end(), [](const auto& s) {
                            return s.depth.support > 0 && !s.depth.is_behind_tears;
                        }));
            if (samples.size() < 4) continue;
            std::set<double> depths;
            for (const AgreedPixelDepth& sample : samples)
                depths.insert(sample.depth.inverse_depth);
            ++outline;
            of_two += depths.size() == 2 ? 1 : 0;
        }
    }
    EXPECT_GT(outline, 60);
    // Elsewhere a third is stretched between the two.
    EXPECT_GT(of_two, outline / 2);
}

}  // namespace
}  // namespace lumi
