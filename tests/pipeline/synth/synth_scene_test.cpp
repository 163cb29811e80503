#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "calib/capture/colmap_model.h"
#include "calib/pictures/image_io.h"
#include "calib/work/error.h"
#include "calib/work/progress.h"
#include "calib/work/whole_file.h"
#include "pipeline/synth/synthesize.h"
#include "tests/calib/scratch_folder.h"
#include "tests/truth/textured_box_scene.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

constexpr const char* kBall = R"(
[camera]
width_px = 32
height_px = 24
[path]
count = 3
distance = 4
[truth]
points = 50
[[material]]
name = "grey"
[[body]]
name = "ball"
material = "grey"
solids = [{ shape = "ellipsoid", radii = [1, 1, 1] }]
)";

SceneDescription description_of(const std::string& toml) {
    return read_scene_description(ConfigSection::from_text(toml, "scene.toml"));
}

std::string with(std::string toml, const std::string& what, const std::string& instead) {
    const std::size_t at = toml.find(what);
    if (at == std::string::npos) throw std::logic_error(what + " is not there");
    return toml.replace(at, what.size(), instead);
}

TEST(SceneDescription, RefusesUnknownKeysWithASuggestion) {
    const std::vector<std::string> wrong{
        with(kBall, "width_px = 32", "widht_px = 32"),
        with(kBall, "count = 3", "count = 3\nspann_deg = 4"),
        with(kBall, "name = \"grey\"", "name = \"grey\"\ncolour = 1"),
        with(kBall, "shape = ", "radius = 1, shape = "),
    };
    for (const std::string& toml : wrong) {
        try {
            (void)description_of(toml);
            FAIL() << "accepted " << toml;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), "E-CONFIG-KEY");
            EXPECT_THAT(error.what(), HasSubstr("scene.toml:"));
        }
    }
}

TEST(SceneDescription, RefusesValuesThatMakeNoScene) {
    const std::vector<std::string> wrong{
        with(kBall, "width_px = 32", "width_px = 0"),
        with(kBall, "count = 3", "count = 0"),
        with(kBall, "count = 3", "count = 3\nkind = \"spiral\""),
        with(kBall, "count = 3", "count = 3\nkind = \"forward\"\nlength_share = 1.0"),
        with(kBall, "distance = 4", "distance = -1"),
        with(kBall, "name = \"grey\"",
             "name = \"grey\"\ncolors = [\"red\", \"#000000\", \"#00000g\"]"),
        with(kBall, "material = \"grey\"", "material = \"gray\""),
        with(kBall, "radii = [1, 1, 1]", "radii = [1, 0, 1]"),
        with(kBall, "\"ellipsoid\", radii = [1, 1, 1]",
             "\"capsule\", to = [0, 0, 1], from_radius = 2, to_radius = 1"),
        with(kBall, "height_px = 24", "height_px = 24\nlens_model = \"RADIAL\"\ndistortion = [1]"),
    };
    for (const std::string& toml : wrong) {
        try {
            (void)description_of(toml);
            FAIL() << "accepted " << toml;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), "E-CONFIG-VALUE") << toml;
            EXPECT_EQ(error.kind(), ErrorKind::kUsage);
        }
    }
}

TEST(SceneDescription, ResolvedDescriptionMakesTheSamePhotographs) {
    const SceneDescription given = description_of(kBall);
    const SceneDescription again = description_of(given.resolved_toml);
    EXPECT_EQ(again.resolved_toml, given.resolved_toml);
    SilentProgress progress;
    EXPECT_EQ(synthesize(again, 1, progress).photographs,
              synthesize(given, 1, progress).photographs);
}

TEST(SceneDescription, DemoIsTheFileInConfigs) {
    const fs::path file = fs::path(LUMI_SOURCE_DIR) / "configs/demo-scene.toml";
    EXPECT_EQ(demo_scene_toml(), read_whole_text(file));
    const SceneDescription demo = description_of(std::string(demo_scene_toml()));
    EXPECT_GE(demo.path.count, 24);
    const Capture capture = exact_capture(demo);
    EXPECT_GT(capture.points.size(), 1500u);
}

TEST(Synthesize, SameBytesForAnyNumberOfThreads) {
    const SceneDescription description =
        textured_box_description({.width_px = 64, .height_px = 48});
    SilentProgress progress;
    const SyntheticCapture one = synthesize(description, 1, progress);
    const SyntheticCapture many = synthesize(description, 7, progress);
    EXPECT_EQ(one.photographs, many.photographs);
    EXPECT_EQ(one.depths, many.depths);
    ASSERT_EQ(one.capture.points.size(), many.capture.points.size());
    for (std::size_t i = 0; i < one.capture.points.size(); ++i) {
        EXPECT_EQ(one.capture.points[i].color, many.capture.points[i].color);
    }
}

TEST(Synthesize, SeedDecidesPathAndTexture) {
    const std::string shaky = with(kBall, "count = 3", "count = 3\nposition_jitter_share = 0.05");
    SilentProgress progress;
    const auto seeded = [&](int seed) {
        return synthesize(description_of("seed = " + std::to_string(seed) + "\n" + shaky), 1,
                          progress);
    };
    const SyntheticCapture first = seeded(4);
    EXPECT_EQ(first.photographs, seeded(4).photographs);
    const SyntheticCapture other = seeded(5);
    EXPECT_NE(first.photographs, other.photographs);
    EXPECT_GT((first.capture.views[0].cam_from_world.translation -
               other.capture.views[0].cam_from_world.translation)
                  .norm(),
              1e-3);
}

TEST(Synthesize, PointsReprojectExactlyIntoTheViewsThatSeeThem) {
    const SceneDescription description = textured_box_description();
    const Capture capture = exact_capture(description);
    ASSERT_GT(capture.points.size(), 300u);
    for (const ScenePoint& point : capture.points) {
        EXPECT_GE(point.track.size(), 2u);
        for (const Observation& observation : point.track) {
            const View& view = capture.views[static_cast<std::size_t>(observation.view_index)];
            const auto pixel =
                project(camera_of(capture, view), view.cam_from_world * point.position_in_world);
            ASSERT_TRUE(pixel.has_value());
            EXPECT_LT((*pixel - observation.pixel).norm(), 1e-9);
            const Eigen::Vector3d eye = centre_in_world(view.cam_from_world);
            const Ray ray{eye, (point.position_in_world - eye).normalized()};
            const auto hit = first_hit(description.scene, ray);
            ASSERT_TRUE(hit.has_value());
            EXPECT_NEAR(hit->distance, (point.position_in_world - eye).norm(), 1e-5);
        }
    }
}

TEST(Synthesize, AnInterruptedSceneDoesNotPassForAFinishedOne) {
    const ScratchFolder folder;
    const SceneDescription description = description_of(kBall);
    SilentProgress progress;
    synthesize_into(folder.path(), description, 1, progress);
    ASSERT_TRUE(fs::exists(folder.path() / "truth/scene.toml"));
    progress.interrupt();
    EXPECT_THROW(synthesize_into(folder.path(), description, 1, progress), Error);
    EXPECT_FALSE(fs::exists(folder.path() / "truth/scene.toml"));
}

TEST(Synthesize, FilesHoldWhatMemoryHolds) {
    const ScratchFolder folder;
    const SceneDescription description = description_of(kBall);
    SilentProgress progress;
    const SyntheticCapture expected = synthesize(description, 2, progress);
    synthesize_into(folder.path(), description, 2, progress);
    const Capture capture = read_colmap_model(folder.path() / "truth/sparse");
    ASSERT_EQ(capture.views.size(), 3u);
    EXPECT_EQ(capture.points.size(), expected.capture.points.size());
    for (std::size_t i = 0; i < 3; ++i) {
        const std::string& name = capture.views[i].name;
        EXPECT_EQ(name, "IMG_000" + std::to_string(i + 1) + ".png");
        EXPECT_LT((capture.views[i].cam_from_world.translation -
                   expected.capture.views[i].cam_from_world.translation)
                      .norm(),
                  1e-12);
        EXPECT_EQ(read_color_image(folder.path() / "photos" / name), expected.photographs[i]);
        EXPECT_EQ(
            read_float_tiff(folder.path() / "truth/depth" / fs::path(name).stem().concat(".tiff")),
            expected.depths[i]);
    }
    EXPECT_EQ(read_whole_text(folder.path() / "truth/scene.toml"), description.resolved_toml);
}

TEST(Synthesize, RefusesAFolderWithPhotographsOfAnotherScene) {
    const ScratchFolder folder;
    SilentProgress progress;
    synthesize_into(folder.path(), description_of(kBall), 1, progress);
    synthesize_into(folder.path(), description_of(kBall), 1, progress);
    const SceneDescription fewer = description_of(with(kBall, "count = 3", "count = 2"));
    try {
        synthesize_into(folder.path(), fewer, 1, progress);
        FAIL() << "left a photograph of another scene among its own";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-SYNTH-FOLDER");
        EXPECT_THAT(error.what(), HasSubstr("IMG_0003.png"));
    }
}

TEST(Synthesize, WhereNothingIsSeenDepthIsZero) {
    SilentProgress progress;
    const SyntheticCapture ball = synthesize(description_of(kBall), 1, progress);
    EXPECT_EQ(ball.depths[1](0, 0), 0.0f);
    EXPECT_EQ(ball.photographs[1](0, 0), Rgb8{});
    EXPECT_GT(ball.depths[1](16, 12), 2.9f);
    EXPECT_LT(ball.depths[1](16, 12), 3.1f);
}

TEST(Synthesize, RefusesACameraInsideABody) {
    const SceneDescription description =
        description_of(with(kBall, "distance = 4", "distance = 0.5"));
    try {
        (void)exact_capture(description);
        FAIL() << "accepted a camera inside the ball";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-SYNTH-INSIDE");
        EXPECT_THAT(error.what(), HasSubstr("IMG_0001.png"));
    }
}

}  // namespace
}  // namespace lumi
