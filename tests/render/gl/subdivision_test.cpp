#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render/modes/adaptive.h"
#include "render/reference/triangle_reference.h"
#include "render/renderer/mode_reference.h"
#include "render/renderer/offscreen_renderer.h"
#include "render/subdivision/paper_subdivision.h"
#include "render/subdivision/triangle_budget.h"
#include "render/surroundings/surroundings.h"
#include "render/surroundings/triangle_surroundings.h"
#include "render/transfer/scene_plane.h"
#include "tests/render/analytic_scene.h"
#include "tests/render/frame_difference.h"

namespace lumi {
namespace {

void expect_equal(const Frame& drawn, const Frame& expected, const std::string& what) {
    const FrameDifference difference = difference_between(drawn.color, expected.color);
    EXPECT_LE(difference.mean, 1.0) << what;
    EXPECT_LE(difference.share_beyond_two, 0.01) << what;
    EXPECT_GT(drawn.statistics.triangles, 0U) << what;
}

void expect_gl_equals_reference(GlApi api) {
    for (const Lumigraph& lumigraph : {card_before_wall(), ball_in_sky()}) {
        const Camera camera = pinhole_camera(160, 120, 140);
        const bool is_ball = lumigraph.mesh.scene_centre_in_world.norm() < 1;
        const Eye eye = is_ball ? eye_at({0.5, 0.6, -2}, {0, 0, 0}, camera)
                                : eye_at({0.21, 0.13, 0.02}, {0, 0, 4}, camera);
        OffscreenRenderer renderer(lumigraph, api);
        for (const RenderMode mode : {RenderMode::kAdaptive, RenderMode::kPaper2001})
            expect_equal(renderer.draw(eye, {.mode = mode}),
                         draw_mode_reference(lumigraph, eye, {.mode = mode}), name_of(mode));
    }
}

TEST(SubdivisionGl, AdaptiveWithoutASurfaceEqualsTheReference) {
    const Lumigraph lumigraph = card_without_surface();
    const Camera camera = pinhole_camera(160, 120, 140);
    OffscreenRenderer renderer(lumigraph);
    for (const Eigen::Vector3d& place :
         {Eigen::Vector3d(0.21, 0.13, 0.02), Eigen::Vector3d(-0.1, 0.1, 1.2),
          Eigen::Vector3d(1.2, 0.3, 0.2)}) {
        const Eye eye = eye_at(place, {0, 0, 4}, camera);
        const Frame drawn = renderer.draw(eye, {.mode = RenderMode::kAdaptive});
        expect_equal(drawn, draw_mode_reference(lumigraph, eye, {.mode = RenderMode::kAdaptive}),
                     "without a surface");
        const auto& coverage = drawn.coverage.pixels();
        EXPECT_GT(std::count(coverage.begin(), coverage.end(), 255), 1000);
    }
}

const Camera kShellEyeCamera = pinhole_camera(160, 120, 140);

TEST(SubdivisionGl, AdaptiveLaysShellsOverTheMesh) {
    const Lumigraph lumigraph = card_with_close_ups();
    Lumigraph without = lumigraph;
    without.mesh.shells.clear();
    OffscreenRenderer renderer(lumigraph);
    OffscreenRenderer plain_renderer(without);
    const RenderOptions options{.mode = RenderMode::kAdaptive};
    for (const Eigen::Vector3d& place :
         {Eigen::Vector3d(0.02, 0.06, 2.25), Eigen::Vector3d(0.05, 0, 1.2),
          Eigen::Vector3d(0.5, 0.1, 2.0), Eigen::Vector3d(0.2, 0.1, 0)}) {
        const Eye eye = eye_at(place, {0, 0, 3}, kShellEyeCamera);
        const Frame drawn = renderer.draw(eye, options);
        expect_equal(drawn, draw_mode_reference(lumigraph, eye, options), "with a shell");
        const ColorImage truth = ideal_photograph(AnalyticScene::kPrintedCard, eye);
        const double error = difference_between(drawn.color, truth).mean;
        const double plain_error =
            difference_between(plain_renderer.draw(eye, options).color, truth).mean;
        EXPECT_LE(error, 1.02 * plain_error + 0.2) << place.transpose();
        // Between the close-ups the print is theirs.
        if (place.z() > 2.2) {
            EXPECT_LT(error, 0.5 * plain_error);
        }
    }
}

/// The picture as it fades ray by ray.
ColorImage faded(ColorImage picture, const CameraMesh& mesh, const Eye& eye) {
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const Eigen::Vector3d direction =
                eye.cam_from_world.rotation.conjugate() * unproject(eye.camera, {x + 0.5, y + 0.5});
            const auto ray = weights_of_ray(mesh, centre_in_world(eye.cam_from_world), direction);
            const double fade = ray ? capture_fade(*ray) : 0.0;
            const auto dimmed = [fade](std::uint8_t value) {
                return static_cast<std::uint8_t>(std::lround(fade * value));
            };
            Rgb8& color = picture(x, y);
            color = {dimmed(color.r), dimmed(color.g), dimmed(color.b)};
        }
    }
    return picture;
}

TEST(SubdivisionGl, AdaptiveFadesBeyondTheCapture) {
    const Lumigraph lumigraph = card_before_wall();
    OffscreenRenderer renderer(lumigraph);
    const RenderOptions fading{.mode = RenderMode::kAdaptive, .fade_beyond_capture = true};
    for (const Eigen::Vector3d& place :
         {Eigen::Vector3d(0.21, 0.13, 0.02), Eigen::Vector3d(2.4, 0.3, 0.2)}) {
        const Eye eye = eye_at(place, {0, 0, 4}, kShellEyeCamera);
        const Frame drawn = renderer.draw(eye, fading);
        expect_equal(drawn, draw_mode_reference(lumigraph, eye, fading), "fading");
        const Frame plain =
            renderer.draw(eye, {.mode = RenderMode::kAdaptive, .guess_surroundings = false});
        EXPECT_LT(difference_between(drawn.color, faded(plain.color, lumigraph.mesh, eye)).mean,
                  1.5)
            << place.transpose();
    }
}

TEST(SubdivisionGl, DrawsWhatThePlainCodeDraws) { expect_gl_equals_reference(GlApi::kAny); }
TEST(SubdivisionGl, DrawsTheSameOnOpenGlEs) { expect_gl_equals_reference(GlApi::kEs); }

/// Pixels that both show, and in which the one is half as bright again as the other, or brighter.
int count_brighter(const Frame& drawn, const Frame& expected) {
    int brighter = 0;
    for (int y = 0; y < expected.color.height(); ++y) {
        for (int x = 0; x < expected.color.width(); ++x) {
            const int green = expected.color(x, y).g;
            if (expected.coverage(x, y) == 255 && 2 * drawn.color(x, y).g > 3 * green + 20)
                ++brighter;
        }
    }
    return brighter;
}

TEST(SubdivisionGl, NoPixelIsBrighterWherePatchesOfPaper2001Meet) {
    const Lumigraph lumigraph = card_before_wall();
    OffscreenRenderer renderer(lumigraph);
    const RenderOptions options{.mode = RenderMode::kPaper2001};
    int brighter = 0;
    for (const double behind : {0.5, 1.0, 1.5, 2.0, 2.5, 3.0}) {
        const Eye eye =
            eye_at({0.1, 0.05, -behind}, {0, 0, 4}, pinhole_camera(480, 360, 300 + 90 * behind));
        brighter += count_brighter(renderer.draw(eye, options),
                                   draw_mode_reference(lumigraph, eye, options));
    }
    EXPECT_LE(brighter, 2);
}

TEST(SubdivisionGl, AFrameDoesNotDependOnHowTheEyeCameThere) {
    const Lumigraph lumigraph = card_before_wall();
    OffscreenRenderer travelled(lumigraph);
    const Camera camera = pinhole_camera(160, 120, 140);
    for (int i = 0; i < 6; ++i) {
        // Stands still for every second frame; then the options change, too.
        const Eye eye = eye_at({0.2 - 0.01 * (i / 2), 0.1, 0.02}, {0, 0, 4}, camera);
        const RenderOptions options{.mode = RenderMode::kAdaptive,
                                    .max_triangles = i < 4 ? std::size_t{5000} : 300U};
        OffscreenRenderer fresh(lumigraph);
        const Frame expected = fresh.draw(eye, options);
        for (int again = 0; again < 2; ++again) {
            const Frame drawn = travelled.draw(eye, options);
            EXPECT_TRUE(drawn.color.pixels() == expected.color.pixels()) << i;
            EXPECT_TRUE(drawn.coverage.pixels() == expected.coverage.pixels()) << i;
            EXPECT_EQ(drawn.statistics.triangles, expected.statistics.triangles) << i;
        }
    }
}

TEST(SubdivisionGl, ACameraReturnsItsPhotographButForEdges) {
    const Lumigraph lumigraph = ball_in_sky();
    OffscreenRenderer renderer(lumigraph);
    const LumigraphView& view = lumigraph.views[2];
    for (const RenderMode mode : {RenderMode::kAdaptive, RenderMode::kPaper2001}) {
        const Frame drawn = renderer.draw({view.camera, view.cam_from_world}, {.mode = mode});
        EXPECT_LT(difference_between(drawn.color, view.photograph).mean, 1.0) << name_of(mode);
    }
}

TEST(SubdivisionGl, EveryDebugPictureIsDrawn) {
    const Lumigraph lumigraph = card_before_wall();
    OffscreenRenderer renderer(lumigraph);
    const Eye eye = eye_at({0.21, 0.13, 0.02}, {0, 0, 4}, pinhole_camera(80, 60, 70));
    for (const RenderMode mode : {RenderMode::kAdaptive, RenderMode::kPaper2001}) {
        const Frame picture = renderer.draw(eye, {.mode = mode});
        for (const DebugPicture debug : all_debug_pictures()) {
            if (debug == DebugPicture::kNone) continue;
            const Frame drawn = renderer.draw(eye, {.mode = mode, .debug_picture = debug});
            EXPECT_GT(difference_between(drawn.color, picture.color).mean, 5.0)
                << name_of(mode) << ' ' << name_of(debug);
        }
    }
}

TEST(SubdivisionGl, TheGridShowsTheEdgesOfTheTrianglesOverThePicture) {
    const Lumigraph lumigraph = card_before_wall();
    OffscreenRenderer renderer(lumigraph);
    const Eye eye = eye_at({0.21, 0.13, 0.02}, {0, 0, 4}, pinhole_camera(160, 120, 140));
    const RenderOptions options{.mode = RenderMode::kAdaptive,
                                .debug_picture = DebugPicture::kGrid};
    const ColorImage picture = renderer.draw(eye, {.mode = RenderMode::kAdaptive}).color;
    const ColorImage grid = renderer.draw(eye, options).color;
    const BlendTriangles triangles =
        adaptive_layers(lumigraph, searched_views(lumigraph), eye, options).front();
    const auto is_line = [&](int x, int y) {
        return grid.contains(x, y) && grid(x, y).r == 255 && grid(x, y).b == 26;
    };
    std::size_t edges = 0;
    std::size_t shown = 0;
    for (std::size_t i = 0; i < triangles.indices.size(); ++i) {
        const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
        const auto& from = triangles.vertices[triangles.indices[i]].pixel;
        const auto& to = triangles.vertices[triangles.indices[next]].pixel;
        const int x = static_cast<int>(0.5F * (from[0] + to[0]));
        const int y = static_cast<int>(0.5F * (from[1] + to[1]));
        if (x < 2 || y < 2 || x > 157 || y > 117) continue;
        ++edges;
        if (is_line(x, y) || is_line(x - 1, y) || is_line(x + 1, y) || is_line(x, y - 1) ||
            is_line(x, y + 1))
            ++shown;
    }
    EXPECT_GT(edges, 100U);
    EXPECT_EQ(shown, edges);
    for (int y = 0; y < 120; ++y)
        for (int x = 0; x < 160; ++x)
            EXPECT_TRUE(is_line(x, y) || grid(x, y) == picture(x, y)) << x << ' ' << y;
}

TEST(SubdivisionGl, AdaptiveKeepsToItsTrianglesWithShellsToo) {
    const Lumigraph lumigraph = card_with_close_ups();
    const SearchedViews views = searched_views(lumigraph);
    const Camera camera = pinhole_camera(640, 480, 560);
    for (const Eigen::Vector3d& place :
         {Eigen::Vector3d(0.02, 0.06, 2.25), Eigen::Vector3d(0.05, 0, 1.2),
          Eigen::Vector3d(0.5, 0.1, 2.0)}) {
        const Eye eye = eye_at(place, {0, 0, 3}, camera);
        const auto in_layers = [&](std::size_t most) {
            std::vector<std::size_t> counts;
            for (const BlendTriangles& layer : adaptive_layers(
                     lumigraph, views, eye, {.triangle_error_ratio = 0.1, .max_triangles = most}))
                counts.push_back(layer.count());
            return counts;
        };
        const std::vector<std::size_t> all = in_layers(0);
        ASSERT_EQ(all.size(), 2U);
        ASSERT_GT(all[1], 0U) << "the shell is seen from " << place.transpose();
        const std::size_t most = (all[0] + all[1]) / 2;
        const std::vector<std::size_t> kept = in_layers(most);
        EXPECT_LE(kept[0] + kept[1], most) << place.transpose();
        EXPECT_GT(kept[0] + kept[1], most / 3) << place.transpose();
        EXPECT_GT(kept[1], 0U) << "the mesh beneath must not take all";
    }
}

/// Frames along a path, each costing `fixed_ms` and so much more for each triangle that the mode
/// draws; what the worst but the first two of them cost, and the triangles of the last.
struct ModelledFrames {
    double worst_ms = 0.0;
    std::size_t triangles = 0;
};

ModelledFrames modelled_frames(double frames_per_second, double fixed_ms, double ms_each) {
    const Lumigraph lumigraph = card_before_wall();
    const SearchedViews views = searched_views(lumigraph);
    const Camera camera = pinhole_camera(640, 480, 560);
    TriangleBudget budget(frames_per_second);
    ModelledFrames frames;
    for (int i = 0; i < 15; ++i) {
        const Eye eye = eye_at({0.2 - 0.005 * i, 0.1, 0.02}, {0, 0, 4}, camera);
        const auto layers =
            adaptive_layers(lumigraph, views, eye, budget.within({.max_triangles = 0}));
        frames.triangles = layers.front().count();
        const double ms = fixed_ms + ms_each * static_cast<double>(frames.triangles);
        if (i > 1) frames.worst_ms = std::max(frames.worst_ms, ms);
        budget.measured(frames.triangles, ms);
    }
    return frames;
}

TEST(TriangleBudget, IsKeptAndSpentWhateverATriangleCosts) {
    const std::size_t all = modelled_frames(0, 5, 0.01).triangles;
    ASSERT_GT(all, 500U);
    for (const double ms_each : {0.005, 0.02, 0.1}) {
        // Frames that have time for a third of the triangles, which is approached by halves.
        const double afforded_ms = 5 + ms_each * static_cast<double>(all) / 3;
        const ModelledFrames frames = modelled_frames(1000 / afforded_ms, 5, ms_each);
        EXPECT_LT(frames.worst_ms, 1.2 * afforded_ms) << ms_each;
        // Errors are relaxed in steps, and the next would be too many.
        EXPECT_GT(3 * frames.triangles, all * 55 / 100) << ms_each;
    }
}

TEST(TriangleBudget, ThatCannotBeKeptLeavesFewTriangles) {
    const std::size_t all = modelled_frames(0, 5, 0.01).triangles;
    EXPECT_LT(4 * modelled_frames(1000, 5, 0.01).triangles, all);
}

TEST(TriangleBudget, GivesNoTrianglesAwayThatSaveLessThanATenthOfTheFrame) {
    const std::size_t all = modelled_frames(0, 5, 0.01).triangles;
    // All triangles together take a twentieth of what the frame takes without them.
    const double ms_each = 0.05 * 5 / static_cast<double>(all);
    EXPECT_GT(3 * modelled_frames(1000, 5, ms_each).triangles, 2 * all);
    EXPECT_GT(10 * modelled_frames(190, 5, ms_each).triangles, 9 * all);
}

TEST(TriangleBudget, WithoutALimitOrWithTimeToSpareLeavesThePictureAsItIs) {
    OffscreenRenderer renderer(card_before_wall());
    const Eye eye = eye_at({0.2, 0.1, 0.02}, {0, 0, 4}, pinhole_camera(160, 120, 140));
    const RenderOptions options{.mode = RenderMode::kAdaptive};
    const Frame plain = renderer.draw(eye, options);
    for (const double frames_per_second : {0.0, 1e-3}) {
        TriangleBudget budget(frames_per_second);
        for (int i = 0; i < 4; ++i) budget.measured(plain.statistics.triangles, 50 + i);
        const Frame limited = renderer.draw(eye, budget.within(options));
        EXPECT_EQ(limited.statistics.triangles, plain.statistics.triangles);
        EXPECT_TRUE(limited.color.pixels() == plain.color.pixels());
    }
}

}  // namespace
}  // namespace lumi
