#include "pipeline/stress/run_stress.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "pipeline/evaluate/evaluation_file.h"
#include "pipeline/protocol/view_subset.h"
#include "pipeline/report/stress_charts.h"
#include "pipeline/stress/seeded_normal.h"
#include "pipeline/stress/stress_files.h"
#include "pipeline/stress/stress_subject.h"
#include "render/depth_mesh/view_depth_mesh.h"
#include "render/lumigraph/even_exposure.h"
#include "render/lumigraph/manifest.h"
#include "render/lumigraph/package.h"
#include "render/renderer/offscreen_renderer.h"
#include "render/transfer/view_geometry.h"
#include "tests/calib/scratch_folder.h"
#include "tests/truth/textured_box_scene.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

class Stress : public testing::Test {
 protected:
    static void SetUpTestSuite() { scene_ = new SyntheticCapture(textured_box_scene()); }
    static void TearDownTestSuite() { delete scene_; }
    static Lumigraph lumigraph() {
        return exact_lumigraph(*scene_, textured_box_camera_mesh(scene_->capture));
    }
    static SyntheticCapture* scene_;
};

SyntheticCapture* Stress::scene_ = nullptr;

StressOptions options_from(const std::string& toml) {
    return read_stress_options(ConfigSection::from_text(toml, "test.toml"));
}

TEST(SeededNormal, HasMeanNoneAndDeviationOne) {
    const SeededNormal random(3);
    double sum = 0.0;
    double squares = 0.0;
    constexpr int kCount = 20000;
    for (int i = 0; i < kCount; ++i) {
        const double value = random.value(static_cast<std::uint64_t>(i), 5);
        sum += value;
        squares += value * value;
    }
    EXPECT_NEAR(sum / kCount, 0.0, 4.0 / std::sqrt(kCount));
    EXPECT_NEAR(squares / kCount, 1.0, 0.05);
}

TEST_F(Stress, TurningAndMovingLeaveTheOtherPartOfThePoseAlone) {
    const Lumigraph before = lumigraph();
    const Lumigraph turned = with_turned_poses(before, 1.0, 1);
    const Lumigraph moved = with_moved_poses(before, 5.0, 1);
    for (std::size_t i = 0; i < before.views.size(); ++i) {
        const Rigid3& pose = before.views[i].cam_from_world;
        EXPECT_LT((centre_in_world(pose) - centre_in_world(turned.views[i].cam_from_world)).norm(),
                  1e-9);
        EXPECT_GT(pose.rotation.angularDistance(turned.views[i].cam_from_world.rotation), 1e-5);
        EXPECT_LT(pose.rotation.angularDistance(moved.views[i].cam_from_world.rotation), 1e-9);
    }
}

TEST_F(Stress, TheCameraMeshGoesWithTheCameras) {
    const Lumigraph moved = with_moved_poses(lumigraph(), 20.0, 1);
    for (const CameraMesh::Vertex& vertex : moved.mesh.vertices) {
        const LumigraphView& view = moved.views[static_cast<std::size_t>(vertex.view_index)];
        EXPECT_LT((vertex.position_in_world - centre_in_world(view.cam_from_world)).norm(), 1e-9);
    }
}

TEST_F(Stress, ErrorsOfDifferentStrengthAreTheSameErrorScaled) {
    const Lumigraph before = lumigraph();
    const auto shift = [&](double percent, std::size_t i) -> Eigen::Vector3d {
        return centre_in_world(with_moved_poses(before, percent, 9).views[i].cam_from_world) -
               centre_in_world(before.views[i].cam_from_world);
    };
    EXPECT_LT((3.0 * shift(2.0, 4) - shift(6.0, 4)).norm(), 1e-9);
}

TEST_F(Stress, NoDepthMeshOutlivesTheDepthThatItFollows) {
    Lumigraph whole = lumigraph();
    SilentProgress progress;
    make_depth_meshes(whole, 1, progress);
    ASSERT_TRUE(whole.views[0].depth_mesh);
    const Lumigraph noisy = with_noisy_depth(whole, 20.0, 1);
    const double disparity_px = max_disparity_px(view_geometries(noisy)[0]);
    EXPECT_NE(depth_mesh_of(noisy.views[0], disparity_px, {})->vertices,
              whole.views[0].depth_mesh->vertices);
    EXPECT_TRUE(with_other_exposure(whole, 0.5, 1).views[0].depth_mesh);
}

TEST_F(Stress, FocalLengthGrowsByTheStatedShare) {
    const Lumigraph before = lumigraph();
    const Lumigraph after = with_longer_focal_length(before, 5.0, 1);
    EXPECT_NEAR(focal_length_px(after.views[2].camera).x(),
                1.05 * focal_length_px(before.views[2].camera).x(), 1e-9);
}

TEST_F(Stress, OneStopMoreDoublesLinearLight) {
    Lumigraph grey = lumigraph();
    for (LumigraphView& view : grey.views) {
        for (Rgb8& pixel : view.photograph.pixels()) pixel = {100, 100, 100};
    }
    const double ev = SeededNormal(4).value(0, 0);
    const Lumigraph after = with_other_exposure(grey, 1.0, 4);
    const auto linear = [](double value) { return std::pow((value / 255 + 0.055) / 1.055, 2.4); };
    EXPECT_NEAR(linear(after.views[0].photograph(0, 0).g), linear(100) * std::exp2(ev), 0.004);
}

TEST_F(Stress, DroppingMoreDropsTheSameViewsAndMore) {
    const Lumigraph before = lumigraph();
    const auto names = [&](double percent) {
        std::set<std::string> left;
        for (const LumigraphView& view : with_views_dropped(before, percent, 2, {}).views) {
            left.insert(view.name);
        }
        return left;
    };
    const std::set<std::string> many = names(20.0);
    const std::set<std::string> few = names(60.0);
    EXPECT_EQ(many.size(), 7U);
    EXPECT_EQ(few.size(), 4U);
    EXPECT_TRUE(std::includes(many.begin(), many.end(), few.begin(), few.end()));
    EXPECT_EQ(names(100.0).size(), 1U);
}

/// One that nothing but options would build of cameras before a box.
const CameraMeshOptions kOnlyWhenAsked{.construction = "nearest"};

TEST_F(Stress, TheCameraMeshOverFewerViewsIsBuiltAsItWas) {
    const Lumigraph before = lumigraph();
    EXPECT_NE(with_views_dropped(before, 20.0, 2, {}).mesh.construction,
              MeshConstruction::kNearest);
    EXPECT_EQ(with_views_dropped(before, 20.0, 2, kOnlyWhenAsked).mesh.construction,
              MeshConstruction::kNearest);
}

TEST_F(Stress, APackageTellsHowItsCameraMeshIsBuilt) {
    const ScratchFolder scratch;
    const fs::path package = scratch / "box.lumi";
    PackageExtras extras;
    extras.resolved_config_toml = "[mesh]\nconstruction = \"nearest\"\n";
    write_package(package, lumigraph(), extras);
    const StressSubject subject = subject_of_package(package);
    EXPECT_EQ(subject.mesh_options.construction, kOnlyWhenAsked.construction);
    EXPECT_EQ(subject.lumigraph.mesh.construction, MeshConstruction::kNearest);
}

TEST(StressFiles, ChartsOfOtherRunsAndOtherPackagesAreNotTheseOnes) {
    const ScratchFolder scratch;
    const WorkspaceLayout workspace(scratch.path(), "box");
    const fs::path stress = workspace.folder() / "stress";
    write_whole_text(workspace.package_folder() / kManifestName, "the package");
    write_whole_text(stress / "depth_percent.svg", "of a run before");
    EXPECT_TRUE(stress_charts_of(workspace).empty());
    StressResult result;
    result.package_sha256 = package_sha256(workspace);
    result.curves = {{"blur_px", RenderMode::kPerPixel, {0, 1}, {30, 29}, {}}};
    EXPECT_EQ(words_of_perturbation("pose_rotation_deg"), "rotation of the poses (degrees)");
    write_stress_files(stress, result, SilentProgress());
    const std::map<std::string, fs::path> charts = stress_charts_of(workspace);
    ASSERT_EQ(charts.size(), 1U);
    EXPECT_EQ(charts.at("blur_px"), stress / "blur_px.svg");
    write_whole_text(workspace.package_folder() / kManifestName, "another package");
    EXPECT_TRUE(stress_charts_of(workspace).empty());
    write_whole_text(stress / "stress.json", "{\"curves\": 3}");
    EXPECT_TRUE(stress_charts_of(workspace).empty());
}

TEST(StressFiles, NothingVouchesForChartsOfARunThatWasStopped) {
    const ScratchFolder scratch;
    StressResult result;
    result.curves = {{"blur_px", RenderMode::kPerPixel, {0, 1}, {30, 29}, {}}};
    write_stress_files(scratch.path(), result, SilentProgress());
    ASSERT_TRUE(fs::exists(scratch / "stress.json"));
    SilentProgress stopped;
    stopped.interrupt();
    EXPECT_THROW(write_stress_files(scratch.path(), result, stopped), Error);
    EXPECT_FALSE(fs::exists(scratch / "stress.json"));
}

TEST_F(Stress, ViewsThatAreLeftHaveTheirMeshByWhatTheySeeAlone) {
    const std::vector<int> kept{0, 1, 2, 3, 5, 6, 7, 8};
    std::vector<CameraMesh> meshes;
    for (const std::uint8_t confidence : {std::uint8_t{0}, kFilledBeforeBackground}) {
        Lumigraph whole = lumigraph();
        for (LumigraphView& view : whole.views) {
            for (int y = 0; y < view.depth.confidence.height(); ++y) {
                for (int x = 0; x < view.depth.confidence.width() / 2; ++x) {
                    view.depth.inverse_depth(x, y) *= 4.0F;
                    view.depth.confidence(x, y) = confidence;
                }
            }
        }
        meshes.push_back(only_these_views(whole, kept, {}).mesh);
    }
    EXPECT_EQ(meshes[1].scene_centre_in_world, meshes[0].scene_centre_in_world);
    EXPECT_EQ(meshes[1].faces, meshes[0].faces);
}

TEST_F(Stress, EveryCurveStartsUnperturbedAndEndsLower) {
    const Lumigraph whole = lumigraph();
    const auto middle = static_cast<std::size_t>(textured_box_view(1, 1));
    std::vector<int> kept;
    for (int i = 0; i < 9; ++i) {
        if (static_cast<std::size_t>(i) != middle) kept.push_back(i);
    }
    const StressView view{whole.views[middle].name,
                          {whole.views[middle].camera, whole.views[middle].cam_from_world},
                          whole.views[middle].photograph};
    StressOptions options = options_from("modes = [\"perpixel\"]");
    for (Perturbation& one : options.perturbations) one.strengths = {one.strengths.back()};
    SilentProgress progress;
    const StressSubject eight{only_these_views(whole, kept, {}), {view}};
    const std::vector<StressCurve> curves = stress_curves(eight, options, progress);
    EXPECT_EQ(curves.size(), known_perturbations().size());
    for (const StressCurve& curve : curves) {
        EXPECT_EQ(curve.strengths.front(), 0.0);
        EXPECT_EQ(curve.psnr_db.front(), curves[0].psnr_db.front()) << curve.perturbation;
        EXPECT_LT(curve.psnr_db.back(), curve.psnr_db.front() - 1.0) << curve.perturbation;
    }
    const std::vector<StressCurve> again = stress_curves(eight, options, progress);
    for (std::size_t i = 0; i < curves.size(); ++i) EXPECT_EQ(again[i].psnr_db, curves[i].psnr_db);
}

TEST_F(Stress, APhotographIsComparedWithWhatItsLensWouldTake) {
    StressSubject subject{lumigraph(), {}};
    const Lumigraph& whole = subject.lumigraph;
    const Eye eye{whole.views[0].camera, whole.views[0].cam_from_world};
    subject.views = {{"held out", eye, OffscreenRenderer(whole).draw(eye, {}).color}};
    StressView& view = subject.views[0];
    constexpr double kFalloff = -1.5;
    view.photograph = darkened_by_lens(std::move(view.photograph), eye.camera, kFalloff);
    StressOptions options =
        options_from("modes = [\"perpixel\"]\nperturbations = [\"blur_px\"]\nblur_px = [1]\n");
    SilentProgress progress;
    EXPECT_LT(stress_curves(subject, options, progress)[0].psnr_db.front(), 30);
    view.falloff = kFalloff;
    EXPECT_GT(stress_curves(subject, options, progress)[0].psnr_db.front(), 90);
}

TEST(BreakingPoint, IsInterpolatedBetweenStrengths) {
    const StressCurve curve{"blur_px", RenderMode::kPerPixel, {0, 1, 2}, {30, 29, 25}, {}};
    EXPECT_NEAR(*breaking_point_of(curve, 3.0), 1.5, 1e-12);
    EXPECT_NEAR(*breaking_point_of(curve, 0.5), 0.5, 1e-12);
    EXPECT_FALSE(breaking_point_of(curve, 6.0).has_value());
}

TEST(StressOptions, AreReadStrictly) {
    const StressOptions options =
        options_from("seed = 7\nperturbations = [\"blur_px\"]\nblur_px = [1, 2.5]\n");
    EXPECT_EQ(options.seed, 7U);
    ASSERT_EQ(options.perturbations.size(), 1U);
    EXPECT_EQ(options.perturbations[0].strengths, (std::vector<double>{1.0, 2.5}));
    EXPECT_GE(options.modes.size(), 2U);
    for (const char* wrong :
         {"blur_px = [2, 1]", "blur_px = [0, 1]", "blur_px = []", "perturbations = [\"blurr\"]",
          "modes = [\"no\"]", "max_loss_db = 0", "blurr_px = [1]", "seed = -1"}) {
        EXPECT_THROW(static_cast<void>(options_from(wrong)), Error) << wrong;
    }
}

}  // namespace
}  // namespace lumi
