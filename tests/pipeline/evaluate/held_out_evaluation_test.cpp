#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "calib/pictures/image_io.h"
#include "calib/work/whole_file.h"
#include "meshing/surface/nearest_cameras.h"
#include "pipeline/evaluate/evaluation.h"
#include "pipeline/evaluate/evaluation_comparison.h"
#include "pipeline/evaluate/evaluation_file.h"
#include "pipeline/evaluate/filled_alike.h"
#include "pipeline/evaluate/ghost_energy.h"
#include "pipeline/evaluate/image_metrics.h"
#include "render/lumigraph/even_exposure.h"
#include "render/surroundings/surroundings.h"
#include "tests/calib/scratch_folder.h"
#include "tests/truth/textured_box_scene.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;

/// The textured box from a grid of 3 x 3 cameras, the middle one held out: what is drawn from is
/// the other eight.
class HeldOutEvaluation : public testing::Test {
 protected:
    static void SetUpTestSuite() { scene_ = new SyntheticCapture(textured_box_scene()); }
    static void TearDownTestSuite() { delete scene_; }

    static CameraMesh mesh() { return textured_box_camera_mesh(scene_->capture); }
    static Eye eye_of(int view) {
        const View& held = scene_->capture.views[static_cast<std::size_t>(view)];
        return {camera_of(scene_->capture, held), held.cam_from_world};
    }
    /// Held-out photographs as files.
    static PosedPhotographs posed(const ScratchFolder& scratch, const std::vector<int>& views) {
        PosedPhotographs photographs;
        photographs.capture.cameras = scene_->capture.cameras;
        for (const int view : views) {
            photographs.capture.views.push_back(
                scene_->capture.views[static_cast<std::size_t>(view)]);
            photographs.picture_paths.push_back(scratch / (std::to_string(view) + ".png"));
            write_png(photographs.picture_paths.back(),
                      scene_->photographs[static_cast<std::size_t>(view)]);
        }
        return photographs;
    }

    static SyntheticCapture* scene_;
};

SyntheticCapture* HeldOutEvaluation::scene_ = nullptr;

TEST_F(HeldOutEvaluation, CamerasOfAFaceAreInDifferentClasses) {
    const CameraMesh grid = mesh();
    const std::vector<int> classes = camera_classes(grid, 9, {});
    for (const CameraMesh::Face& face : grid.faces) {
        const auto class_at = [&](int corner) {
            const auto vertex = static_cast<std::size_t>(face[static_cast<std::size_t>(corner)]);
            return classes[static_cast<std::size_t>(grid.vertices[vertex].view_index)];
        };
        EXPECT_NE(class_at(0), class_at(1));
        EXPECT_NE(class_at(1), class_at(2));
        EXPECT_NE(class_at(2), class_at(0));
    }
    EXPECT_LE(*std::max_element(classes.begin(), classes.end()), 4);
}

TEST_F(HeldOutEvaluation, GhostEnergyIsNothingWhereCamerasAgree) {
    Lumigraph lumigraph = exact_lumigraph(*scene_, mesh());
    for (LumigraphView& view : lumigraph.views) {
        for (Rgb8& pixel : view.photograph.pixels()) pixel = {120, 80, 40};
    }
    Eye eye = eye_of(textured_box_view(1, 1));
    eye.cam_from_world.translation.x() += 0.1;
    SilentProgress progress;
    const FloatImage energy =
        ghost_energies(lumigraph, {eye}, RenderMode::kLightField, progress).at(0);
    const float largest = *std::max_element(energy.pixels().begin(), energy.pixels().end());
    // Half a step of rounding in the luma of a camera that weighs a sixteenth, and in its weight.
    EXPECT_LT(largest, 16.0F);
}

TEST_F(HeldOutEvaluation, GhostEnergyOfTwoConstantCamerasIsTheirVariance) {
    Lumigraph lumigraph = exact_lumigraph(*scene_, mesh());
    const auto bright = static_cast<std::size_t>(textured_box_view(1, 1));
    for (std::size_t i = 0; i < lumigraph.views.size(); ++i) {
        const std::uint8_t grey = i == bright ? 200 : 100;
        for (Rgb8& pixel : lumigraph.views[i].photograph.pixels()) pixel = {grey, grey, grey};
    }
    // Halfway to the next camera each of the two weighs one half: 100^2 / 4.
    Eye eye = eye_of(textured_box_view(1, 1));
    const Eigen::Vector3d halfway =
        0.5 * (centre_in_world(eye.cam_from_world) +
               centre_in_world(eye_of(textured_box_view(2, 1)).cam_from_world));
    eye.cam_from_world.translation = -(eye.cam_from_world.rotation * halfway);
    SilentProgress progress;
    FloatImage energy = ghost_energies(lumigraph, {eye}, RenderMode::kLightField, progress).at(0);
    std::vector<float>& values = energy.pixels();
    std::nth_element(values.begin(),
                     values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
    EXPECT_NEAR(values[values.size() / 2], 2500.0F, 100.0F);
    EXPECT_LE(*std::max_element(values.begin(), values.end()), 2700.0F);
}

TEST_F(HeldOutEvaluation, GhostsShowWhereDepthIsMissingAndForetellTheError) {
    const ScratchFolder scratch;
    const int middle = textured_box_view(1, 1);
    Lumigraph lumigraph = exact_lumigraph(*scene_, mesh());
    PosedPhotographs held_out = posed(scratch, {middle});
    // Between cameras, where three photographs are blended.
    held_out.capture.views[0].cam_from_world.translation.x() += 0.02;
    SilentProgress progress;
    const auto score_in = [&](RenderMode mode) {
        return evaluate_held_out(
                   lumigraph, held_out, {.modes = {mode}, .timed_frames = 1},
                   [](RenderMode, const JudgedView&) {}, progress)
            .modes.at(0);
    };
    const ModeScores with_depth = score_in(RenderMode::kPerPixel);
    const ModeScores without = score_in(RenderMode::kLightField);
    EXPECT_LT(*with_depth.views[0].ghost_energy, *without.views[0].ghost_energy);
    EXPECT_GT(*without.ghost_between_blocks, 0.0);
}

TEST_F(HeldOutEvaluation, TheMiddleIsInteriorAndOutsideTheGridIsBorder) {
    const CameraMesh grid = mesh();
    Eye eye = eye_of(textured_box_view(1, 1));
    eye.cam_from_world.translation.x() += 0.05;
    EXPECT_EQ(place_of_view(grid, eye.camera, eye.cam_from_world), ViewPlace::kInterior);
    eye.cam_from_world.translation.x() += 30.0;
    EXPECT_EQ(place_of_view(grid, eye.camera, eye.cam_from_world), ViewPlace::kBorder);
}

/// Five cameras half a unit behind each other.
CameraMesh without_faces() {
    CameraMesh mesh;
    mesh.construction = MeshConstruction::kNearest;
    for (int i = 0; i < 5; ++i)
        mesh.vertices.push_back({{0, 0, 0.5 * i}, i, false, Eigen::Vector3d::UnitZ()});
    return mesh;
}

TEST(ViewPlace, WithoutFacesIsInteriorAsNearAsCamerasStandToEachOther) {
    const Camera camera = pinhole_camera(64, 48, 50);
    for (const double z : {-0.4, 0.3, 2.4})
        EXPECT_EQ(
            place_of_view(without_faces(), camera, {Eigen::Quaterniond::Identity(), {0, 0, -z}}),
            ViewPlace::kInterior)
            << z;
    for (const double z : {-0.6, 2.6})
        EXPECT_EQ(
            place_of_view(without_faces(), camera, {Eigen::Quaterniond::Identity(), {0, 0, -z}}),
            ViewPlace::kBorder)
            << z;
}

TEST(GhostEnergy, SortsCamerasWithoutFacesByTheEyesTheyAreBlendedFor) {
    const Camera camera = pinhole_camera(64, 48, 50);
    std::vector<Eye> eyes;
    // Halfway between two cameras the third of three is about to be exchanged.
    for (const double z : {0.1, 0.9, 1.25})
        eyes.push_back({camera, {Eigen::Quaterniond::Identity(), {0, 0, -z}}});
    const std::vector<int> classes = camera_classes(without_faces(), 5, eyes);
    for (const Eye& eye : eyes) {
        for (const EyeBlend& blend : blends_of_eye(
                 without_faces(), centre_in_world(eye.cam_from_world), Eigen::Vector3d::UnitZ())) {
            std::set<int> of_blend;
            for (const int view : blend.weights.view_indices)
                of_blend.insert(classes[static_cast<std::size_t>(view)]);
            EXPECT_EQ(of_blend.size(), 3U);
        }
    }
}

TEST_F(HeldOutEvaluation, FiguresOfPicturesAreTheSameInEveryRun) {
    const ScratchFolder scratch;
    const Lumigraph lumigraph = exact_lumigraph(*scene_, mesh());
    const PosedPhotographs held_out = posed(scratch, {0, 4, 8});
    SilentProgress progress;
    const auto figures = [&] {
        Json json = evaluation_json(evaluate_held_out(
            lumigraph, held_out, {.timed_frames = 1}, [](RenderMode, const JudgedView&) {},
            progress));
        for (Json& view : json["views"]) {
            view.erase("ms");
            view.erase("cpu_ms");
            view.erase("ms_range");
        }
        return json["views"].dump();
    };
    EXPECT_EQ(figures(), figures());
}

TEST_F(HeldOutEvaluation, TheSubjectIsJudgedBesideTheFrameByItsOwnPixels) {
    const ScratchFolder scratch;
    const Lumigraph lumigraph = exact_lumigraph(*scene_, mesh());
    const PosedPhotographs held_out = posed(scratch, {textured_box_view(1, 1)});
    SilentProgress progress;
    Frame drawn;
    const auto keep_frame = [&](RenderMode, const JudgedView& view) { drawn = view.rendering; };
    EvaluationOptions options{
        .modes = {RenderMode::kPerPixel}, .ghost_energy = false, .timed_frames = 1};
    const ViewScore without =
        evaluate_held_out(lumigraph, held_out, options, keep_frame, progress).modes[0].views[0];
    EXPECT_FALSE(without.psnr_subject_db);
    EXPECT_FALSE(without.subject_share);

    // A "photograph" that differs from the frame by 5 levels in a quarter, and by 40 in the rest.
    const auto is_subject = [](int x, int y) { return x < 80 && y < 60; };
    ColorImage photograph = drawn.color;
    GrayImage subject(160, 120);
    std::size_t drawn_of_subject = 0;
    for (int y = 0; y < 120; ++y) {
        for (int x = 0; x < 160; ++x) {
            const int step = is_subject(x, y) ? 5 : 40;
            const auto moved = [&](std::uint8_t level) {
                return static_cast<std::uint8_t>(level > 128 ? level - step : level + step);
            };
            Rgb8& pixel = photograph(x, y);
            pixel = {moved(pixel.r), moved(pixel.g), moved(pixel.b)};
            subject(x, y) = is_subject(x, y) ? 255 : 0;
            if (is_subject(x, y) && drawn.coverage(x, y) != 0) ++drawn_of_subject;
        }
    }
    write_png(held_out.picture_paths[0], photograph);
    options.subject_from = "drawn masks";
    options.subject_mask = [&](const std::string&, const ColorImage&) { return subject; };
    const Evaluation evaluation =
        evaluate_held_out(lumigraph, held_out, options, keep_frame, progress);
    const ViewScore& score = evaluation.modes[0].views[0];
    const double peak = 255.0 * 255.0;
    EXPECT_NEAR(*score.psnr_subject_db, 10 * std::log10(peak / 25), 1e-9);
    EXPECT_NEAR(score.psnr_db, 10 * std::log10(peak / (0.25 * 25 + 0.75 * 1600)), 1e-9);
    EXPECT_DOUBLE_EQ(*score.subject_share, 0.25);
    EXPECT_DOUBLE_EQ(*score.subject_coverage, static_cast<double>(drawn_of_subject) / (80 * 60));
    const Json json = evaluation_json(evaluation);
    EXPECT_EQ(json.at("subject_from"), "drawn masks");
    EXPECT_EQ(json.at("mean").at("psnr_subject_db"), *score.psnr_subject_db);
    EXPECT_EQ(*mode_scores_from(RenderMode::kPerPixel, json).views[0].psnr_subject_db,
              *score.psnr_subject_db);
}

/// Every key that the schema requires of `value` is there, and every key there is in the schema.
void expect_conforms(const Json& value, const Json& node, const Json& root,
                     const std::string& where) {
    const Json& schema =
        node.contains("$ref")
            ? root.at(Json::json_pointer(node.at("$ref").get<std::string>().substr(1)))
            : node;
    if (value.is_null() && schema.value("type", Json()) == Json{"object", "null"}) return;
    for (const Json& key : schema.value("required", Json::array())) {
        EXPECT_TRUE(value.contains(key.get<std::string>())) << where << ": " << key;
    }
    if (value.is_object() && schema.contains("properties")) {
        for (const auto& [key, child] : value.items()) {
            if (where.starts_with("views") &&
                root["$defs"]["figures"]["properties"].contains(key)) {
                continue;  // A view has the figures, too.
            }
            ASSERT_TRUE(schema["properties"].contains(key)) << where << ": " << key;
            expect_conforms(child, schema["properties"][key], root, where + "." + key);
        }
    }
    if (value.is_array() && schema.contains("items")) {
        for (const Json& item : value) {
            expect_conforms(item, schema["items"], root, where.substr(where.rfind('.') + 1));
        }
    }
}

TEST_F(HeldOutEvaluation, TheFileConformsToItsSchema) {
    const ScratchFolder scratch;
    SilentProgress progress;
    const Json json = evaluation_json(evaluate_held_out(
        exact_lumigraph(*scene_, mesh()), posed(scratch, {0, 4}), {.timed_frames = 1},
        [](RenderMode, const JudgedView&) {}, progress));
    const Json schema = Json::parse(read_whole_text(std::string(LUMI_SOURCE_DIR) +
                                                    "/pipeline/evaluate/evaluation.schema.json"));
    EXPECT_EQ(json.at("schema_version"), schema.at("properties").at("schema_version").at("const"));
    expect_conforms(json, schema, schema, "");
}

const RivalScores* scores_of(const RivalEvaluation& rivals, const std::string& method) {
    const auto found =
        std::find_if(rivals.methods.begin(), rivals.methods.end(),
                     [&](const RivalScores& scores) { return scores.method == method; });
    return found == rivals.methods.end() ? nullptr : &*found;
}

TEST_F(HeldOutEvaluation, RivalsDrawTheSamePhotographsAndAreKept) {
    const ScratchFolder scratch;
    SilentProgress progress;
    const int middle = textured_box_view(1, 1);
    const std::set<std::string> with_depth{"unstructured lumigraph", "view-dependent texture",
                                           "forward warping"};
    std::set<std::string> kept;
    const RivalEvaluation rivals = evaluate_rivals(
        exact_lumigraph(*scene_, mesh()), posed(scratch, {middle}), {}, 1,
        [&](const ComparedMethod& method, const JudgedView& view) {
            kept.insert(method.name);
            // What is resampled covers no more than its pictures show.
            EXPECT_EQ(method.has_say, with_depth.contains(method.name)) << method.name;
            EXPECT_FALSE(view.rendering.statistics.are_triangles_kept) << method.name;
            EXPECT_EQ(view.rendering.color.width(), 160) << method.name;
        },
        progress);
    EXPECT_EQ(kept, (std::set<std::string>{"unstructured lumigraph", "view-dependent texture",
                                           "forward warping", "dynamically reparameterized",
                                           "two-plane lightfield", "two-plane adaptive"}));
    ASSERT_EQ(rivals.methods.size(), kept.size());
    for (const RivalScores& scores : rivals.methods) {
        ASSERT_EQ(scores.views.size(), 1U) << scores.method;
        EXPECT_GT(scores.views[0].cpu_ms, 0.0) << scores.method;
        EXPECT_EQ(scores.resampling_cpu_s > 0, scores.method.starts_with("two-plane"));
    }
    // A camera stands there: these blend its photograph alone, what is resampled has lost.
    for (const char* exact : {"unstructured lumigraph", "view-dependent texture"}) {
        EXPECT_GT(scores_of(rivals, exact)->views[0].psnr_db,
                  scores_of(rivals, "two-plane adaptive")->views[0].psnr_db + 3)
            << exact;
    }
    ASSERT_EQ(rivals.left_out.size(), 1U);
    EXPECT_EQ(rivals.left_out[0].method, "spherical");
}

/// A frame that nothing is drawn into, or all of the photograph.
JudgedView judged_frame(const PosedPhotographs& held_out, bool is_covered) {
    JudgedView view;
    view.score.name = held_out.capture.views[0].name;
    view.photograph = read_color_image(held_out.picture_paths[0]);
    view.rendering = empty_frame(camera_of(held_out.capture, held_out.capture.views[0]));
    if (!is_covered) return view;
    view.rendering.color = view.photograph;
    for (std::uint8_t& coverage : view.rendering.coverage.pixels()) coverage = 255;
    return view;
}

TEST_F(HeldOutEvaluation, WhatAMethodDoesNotCoverIsFilledBeforeItIsComparedWithOthers) {
    const ScratchFolder scratch;
    Lumigraph lumigraph = exact_lumigraph(*scene_, mesh());
    lumigraph.evened_falloff = 0.2;
    const int middle = textured_box_view(1, 1);
    const PosedPhotographs held_out = posed(scratch, {middle});
    FilledAlike filled_alike(lumigraph, held_out);
    filled_alike.add({.name = "perpixel", .has_say = true}, judged_frame(held_out, true));
    filled_alike.add({.name = "heigl", .has_say = false}, judged_frame(held_out, false));
    Evaluation evaluation;
    evaluation.modes = {{RenderMode::kPerPixel, {}, {}, {}}, {RenderMode::kHeigl, {}, {}, {}}};
    evaluation.rivals.emplace();
    const CommonPixelScores scores = filled_alike.scores_of(evaluation);
    EXPECT_EQ(scores.share, 1);
    ASSERT_EQ(scores.methods.size(), 2U);
    const Eye eye = eye_of(middle);
    EXPECT_EQ(scores.methods[1].psnr_db.value(),
              psnr_db(darkened_by_lens(surroundings_picture(lumigraph, eye), eye.camera, 0.2),
                      read_color_image(held_out.picture_paths[0])));
}

TEST_F(HeldOutEvaluation, FramesAreTimedAsOfAMovingEye) {
    const ScratchFolder scratch;
    SilentProgress progress;
    static_cast<void>(evaluate_held_out(
        exact_lumigraph(*scene_, mesh()), posed(scratch, {textured_box_view(1, 1)}),
        {.modes = {RenderMode::kAdaptive}, .ghost_energy = false, .timed_frames = 2},
        [](RenderMode, const JudgedView& view) {
            EXPECT_FALSE(view.rendering.statistics.are_triangles_kept);
        },
        progress));
}

TEST_F(HeldOutEvaluation, RivalsWithoutWhatTheyNeedAreLeftOutByName) {
    const ScratchFolder scratch;
    SilentProgress progress;
    Lumigraph lumigraph = exact_lumigraph(*scene_, mesh());
    for (LumigraphView& view : lumigraph.views) view.depth = {};
    const RivalEvaluation rivals = evaluate_rivals(
        lumigraph, posed(scratch, {0}), {}, 1, [](const ComparedMethod&, const JudgedView&) {},
        progress);
    std::map<std::string, std::string> reasons;
    for (const RivalLeftOut& rival : rivals.left_out) reasons[rival.method] = rival.reason;
    EXPECT_EQ(reasons.size(), 4U);
    EXPECT_NE(reasons["unstructured lumigraph"].find("depth"), std::string::npos);
    EXPECT_NE(scores_of(rivals, "two-plane lightfield"), nullptr);
}

TEST(EvaluationFile, OfRivalsConformsToItsSchemaAndIsCompared) {
    Evaluation evaluation;
    evaluation.modes = {{RenderMode::kPerPixel, {ViewScore{.name = "x"}}, {}, {}}};
    EXPECT_TRUE(evaluation_json(evaluation).at("rivals").is_null());
    evaluation.rivals = RivalEvaluation{{{"forward warping", {ViewScore{.name = "x"}}, 0.0}},
                                        {{"spherical", "not all around"}},
                                        CommonPixelScores{0.5, {{"perpixel", 30.0}, {"none", {}}}}};
    const Json json = evaluation_json(evaluation);
    const Json schema = Json::parse(read_whole_text(std::string(LUMI_SOURCE_DIR) +
                                                    "/pipeline/evaluate/evaluation.schema.json"));
    expect_conforms(json, schema, schema, "");
    EXPECT_EQ(json.at("rivals").at("left_out").at("spherical"), "not all around");
    EXPECT_EQ(json.at("rivals").at("common_pixels").at("psnr_db").at("perpixel"), 30.0);
    EXPECT_TRUE(json.at("rivals").at("common_pixels").at("psnr_db").at("none").is_null());
    const auto comparisons = compare_evaluations(json, json);
    ASSERT_EQ(comparisons.size(), 2U);
    EXPECT_EQ(comparisons[0].mode, "forward warping");
}

}  // namespace
}  // namespace lumi
