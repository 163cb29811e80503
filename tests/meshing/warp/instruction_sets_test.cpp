#include "meshing/warp/instruction_sets.h"

#include <gtest/gtest.h>

#include <random>
#include <utility>
#include <vector>

#include "calib/capture/gray.h"
#include "meshing/depth_models/depth_model.h"
#include "meshing/filling/guided_smoothing.h"
#include "meshing/matching/window_match.h"
#include "meshing/warp/warped_rows.h"
#include "tests/meshing/depth/raycast_scene.h"

namespace lumi {
namespace {

/// Loops run on this set while this lives.
class RunOn {
 public:
    explicit RunOn(InstructionSet set) : before_(std::exchange(instruction_set_in_use(), set)) {}
    ~RunOn() { instruction_set_in_use() = before_; }
    RunOn(const RunOn&) = delete;
    RunOn& operator=(const RunOn&) = delete;

 private:
    InstructionSet before_;
};

/// What comes out is the same to the bit on every set that this machine has.
template <class Work>
void expect_the_same_on_every_set(const Work& work) {
    const auto widest = static_cast<int>(widest_instruction_set());
    const auto expected = [&] {
        const RunOn portable(InstructionSet::kPortable);
        return work();
    }();
    ASSERT_FALSE(expected.empty());
    for (int set = 1; set <= widest; ++set) {
        const RunOn wider(static_cast<InstructionSet>(set));
        EXPECT_EQ(work(), expected) << "set " << set;
    }
}

KnownDepthScene leaning_wall() {
    return known_depth_scene(
        {{{0, 0, 2}, {0.5, 0.4, 1}, [](const auto&) { return true; }, noise_texture(0.03, 5)}},
        cross_of_centres(0.12), {0.1, 1.2});
}

TEST(InstructionSets, MatchTheSame) {
    const KnownDepthScene known = leaning_wall();
    expect_the_same_on_every_set([&] {
        const DepthMap map = depth_model_named("sweep")->estimate(known.scene, 0).map;
        std::vector<float> all = map.inverse_depth.pixels();
        all.insert(all.end(), map.confidence.pixels().begin(), map.confidence.pixels().end());
        return all;
    });
}

TEST(InstructionSets, CompareWindowsTheSame) {
    const KnownDepthScene known = leaning_wall();
    const auto& views = known.scene.views;
    const GrayImage gray = gray_of(views[0].photograph);
    std::vector<ComparedView> others;
    for (std::size_t i = 1; i < views.size(); ++i) {
        others.push_back(
            compared_view(warp_from(views[0]).to(views[i]), gray_of(views[i].photograph)));
    }
    expect_the_same_on_every_set([&] {
        std::vector<float> all;
        std::vector<float> costs(others.size());
        for (int y = 3; y < 177; y += 4) {
            for (int x = 3; x < 237; x += 3) {
                const PixelPlane plane{known.inverse_depths[0](x, y), 1e-3F, -2e-3F};
                window_costs(reference_window(gray, x, y), others, x, y, plane, costs.data());
                all.insert(all.end(), costs.begin(), costs.end());
            }
        }
        return all;
    });
}

TEST(InstructionSets, SmoothTheSame) {
    std::mt19937 random(3);
    ColorImage guide(53, 37);
    FloatImage values(53, 37);
    FloatImage weights(53, 37);
    for (std::size_t i = 0; i < values.pixels().size(); ++i) {
        guide.pixels()[i].g = static_cast<std::uint8_t>(random() % 20);
        values.pixels()[i] = static_cast<float>(random() % 1000) / 7;
        weights.pixels()[i] = static_cast<float>(random() % 5) / 3;
    }
    expect_the_same_on_every_set(
        [&] { return smooth_guided(values, weights, guide, {}).pixels(); });
}

TEST(InstructionSets, WarpTheSame) {
    const KnownDepthScene known = leaning_wall();
    const FloatImage& truth = known.inverse_depths[0];
    const DepthMap map{truth, GrayImage(truth.width(), truth.height(), 255)};
    Rigid3 turned = looking_ahead_from({0.4, -0.1, 0.3});
    turned.rotation = Eigen::AngleAxisd(0.1, Eigen::Vector3d(0.2, 1, 0.3).normalized());
    const InverseDepthWarp warp =
        warp_from({small_camera(), looking_ahead_from({0, 0, 0})}).to({small_camera(), turned});
    expect_the_same_on_every_set([&] {
        std::vector<float> all;
        warp_rows(map, warp, {240, 180, 0, 0}, 1, [&](int, const WarpedRow& row) {
            all.insert(all.end(), row.columns.begin(), row.columns.end());
            all.insert(all.end(), row.rows.begin(), row.rows.end());
            for (std::size_t i = 0; i < row.rows.size(); ++i) {
                if (row.rows[i] >= 0) all.push_back(row.inverse_depths[i]);
            }
        });
        return all;
    });
}

}  // namespace
}  // namespace lumi
