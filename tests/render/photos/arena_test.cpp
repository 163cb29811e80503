#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include "calib/capture/colmap_model.h"
#include "calib/pictures/image_io.h"
#include "meshing/cameras/camera_mesh_builder.h"
#include "render/renderer/offscreen_renderer.h"
#include "tests/calib/photographs.h"

namespace lumi {
namespace {

/// The rendered wall, floor, ball and box: six views, three held-out targets.
class ArenaPhotos : public testing::Test {
 protected:
    void SetUp() override {
        if (!std::filesystem::exists(folder_ / "sparse"))
            GTEST_SKIP() << folder_ << " is not there; set LUMI_PHOTOS to run this test";
        capture_ = read_colmap_model(folder_ / "sparse");
    }

    [[nodiscard]] bool is_target(std::size_t view) const {
        return capture_.views[view].name.starts_with("test");
    }

    /// Holes take the inverse depth of the farther side of their row, without confidence.
    [[nodiscard]] static DepthMap depth_from(const FloatImage& z) {
        DepthMap depth{FloatImage(z.width(), z.height()), GrayImage(z.width(), z.height())};
        for (int y = 0; y < z.height(); ++y) {
            for (int x = 0; x < z.width(); ++x) {
                int left = x;
                int right = x;
                while (left >= 0 && z(left, y) <= 0) --left;
                while (right < z.width() && z(right, y) <= 0) ++right;
                const float farther =
                    std::max(left >= 0 ? z(left, y) : 0.0F, right < z.width() ? z(right, y) : 0.0F);
                depth.inverse_depth(x, y) = farther > 0 ? 1 / farther : 0.0F;
                depth.confidence(x, y) = z(x, y) > 0 ? 255 : 0;
            }
        }
        return depth;
    }

    [[nodiscard]] Lumigraph lumigraph_with(const std::string& depth_folder) const {
        Lumigraph lumigraph;
        Capture views;
        std::vector<int> indices;
        for (std::size_t i = 0; i < capture_.views.size(); ++i) {
            if (is_target(i)) continue;
            const View& view = capture_.views[i];
            const std::string stem = std::filesystem::path(view.name).stem().string();
            indices.push_back(static_cast<int>(indices.size()));
            views.views.push_back(view);
            lumigraph.views.push_back(
                {view.name, camera_of(capture_, view), view.cam_from_world, 1,
                 read_color_image(folder_ / "images" / view.name),
                 depth_from(read_float_tiff(folder_ / depth_folder / (stem + ".tiff")))});
            append_points(lumigraph.views.back(), indices.back(), views);
        }
        views.cameras = capture_.cameras;
        lumigraph.mesh = build_camera_mesh(views, indices, {}).mesh;
        lumigraph.near_depth = 2.5;
        lumigraph.far_depth = 7;
        return lumigraph;
    }

    static void append_points(const LumigraphView& view, int view_index, Capture& capture) {
        for (int y = 8; y < view.camera.height_px; y += 32) {
            for (int x = 8; x < view.camera.width_px; x += 32) {
                const double inverse_depth = view.depth.inverse_depth(x, y);
                if (inverse_depth <= 0) continue;
                const Eigen::Vector2d pixel(x + 0.5, y + 0.5);
                ScenePoint point;
                point.position_in_world =
                    inverse(view.cam_from_world) * (unproject(view.camera, pixel) / inverse_depth);
                point.track.push_back({view_index, pixel});
                capture.points.push_back(point);
            }
        }
    }

    [[nodiscard]] static double psnr_db(const ColorImage& a, const ColorImage& b) {
        double sum = 0;
        for (std::size_t i = 0; i < a.pixels().size(); ++i) {
            const Rgb8& p = a.pixels()[i];
            const Rgb8& q = b.pixels()[i];
            sum +=
                (p.r - q.r) * (p.r - q.r) + (p.g - q.g) * (p.g - q.g) + (p.b - q.b) * (p.b - q.b);
        }
        return 10 * std::log10(255 * 255 * 3 * static_cast<double>(a.pixels().size()) / sum);
    }

    /// Mean over the three targets, all of their pixels.
    [[nodiscard]] double mean_target_psnr_db(const std::string& depth_folder,
                                             const RenderOptions& options = {}) const {
        OffscreenRenderer renderer(lumigraph_with(depth_folder));
        double sum = 0;
        int targets = 0;
        for (std::size_t i = 0; i < capture_.views.size(); ++i) {
            if (!is_target(i)) continue;
            const View& view = capture_.views[i];
            const Frame drawn =
                renderer.draw({camera_of(capture_, view), view.cam_from_world}, options);
            sum += psnr_db(drawn.color, read_color_image(folder_ / "images" / view.name));
            ++targets;
        }
        EXPECT_EQ(targets, 3);
        return sum / targets;
    }

    std::filesystem::path folder_ = photographs_folder() / "arena";
    Capture capture_;
};

// RVS 4.0 reaches 48.1 dB here, drawing all six views in 1.5 CPU seconds.
TEST_F(ArenaPhotos, ExactDepthGivesTheTargets) {
    EXPECT_GT(mean_target_psnr_db("depth_exact"), 49.4);
}

TEST_F(ArenaPhotos, SilhouettesInStepsCostMoreThanADecibel) {
    EXPECT_GT(mean_target_psnr_db("depth_exact", {.smooth_silhouettes = false}), 47.9);
}

// RVS 4.0 reaches 50.0 dB here.
TEST_F(ArenaPhotos, FourSamplesAPixelSmoothTheSilhouettes) {
    EXPECT_GT(mean_target_psnr_db("depth_exact", {.supersample = true}), 49.4);
}

// With one per cent of noise, fattened edges and a tenth of the samples missing.
TEST_F(ArenaPhotos, DamagedDepthCostsNineDecibels) {
    EXPECT_GT(mean_target_psnr_db("depth_damaged"), 37.3);
}

// RVS 4.0 reaches 37.5 dB from the three nearest views.
TEST_F(ArenaPhotos, TrianglesDrawDamagedDepthBest) {
    for (const bool supersample : {false, true})
        EXPECT_GT(mean_target_psnr_db("depth_damaged",
                                      {.mode = RenderMode::kAdaptive, .supersample = supersample}),
                  38.2);
}

}  // namespace
}  // namespace lumi
