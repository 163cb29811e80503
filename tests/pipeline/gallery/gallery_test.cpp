#include "pipeline/gallery/gallery.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "pipeline/evaluate/evaluation_file.h"
#include "pipeline/gallery/gallery_pictures.h"
#include "pipeline/workspace/json_file.h"
#include "render/renderer/offscreen_renderer.h"
#include "tests/calib/scratch_folder.h"
#include "tests/truth/textured_box_scene.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Photographs in a row, a unit apart.
Lumigraph row_of_views(int count) {
    Lumigraph lumigraph;
    for (int i = 0; i < count; ++i) {
        LumigraphView view;
        view.camera = {40, 30, LensModel::kPinhole, {50, 50, 20, 15}};
        view.cam_from_world = {Eigen::Quaterniond::Identity(), {-1.0 * i, 0, 0}};
        lumigraph.views.push_back(std::move(view));
    }
    return lumigraph;
}

TEST(Gallery, TheEyeOfItsMethodsStandsHalfwayBetweenTwoPhotographs) {
    for (const auto& [views, expected] :
         {std::pair(2, 0.5), std::pair(5, 1.5), std::pair(28, 13.5)}) {
        const Eye eye = eye_between_photographs(row_of_views(views), 80, 60);
        EXPECT_NEAR(centre_in_world(eye.cam_from_world).x(), expected, 1e-9) << views;
    }
    const Eye alone = eye_between_photographs(row_of_views(1), 80, 60);
    EXPECT_NEAR(centre_in_world(alone.cam_from_world).norm(), 0, 1e-9);
}

TEST(Gallery, TakesNoFileOfTheUsersForOneOfAGalleryBefore) {
    const ScratchFolder scratch;
    const WorkspaceLayout workspace(scratch / "work", "box");
    write_whole_text(workspace.package_folder() / "lumigraph.json", "{}");
    write_json_file(workspace.stage_folder("pack") / "pack.json", Json{{"held_out", Json::array()},
                                                                       {"pictures_sha256", ""},
                                                                       {"package_sha256", ""},
                                                                       {"depth_sha256", ""}});
    write_json_file(workspace.evaluation_folder() / kEvaluationName,
                    Json{{"schema_version", kEvaluationSchemaVersion},
                         {"package_sha256", package_sha256(workspace)},
                         {"pictures_sha256", ""},
                         {"depth_sha256", ""}});
    const fs::path out = scratch / "out";
    const auto code = [&] {
        SilentProgress progress;
        try {
            write_gallery(workspace, out, progress);
        } catch (const Error& error) {
            return error.code();
        } catch (const Json::exception&) {
            return std::string("it began");
        }
        return std::string();
    };
    for (const char* name : {"stress-poses.svg", "held-out.jpg", "gallery.md"}) {
        write_whole_text(out / name, "the user's own");
        EXPECT_EQ(code(), "E-OUT-EXISTS") << name;
        EXPECT_EQ(read_whole_text(out / name), "the user's own");
        fs::remove(out / name);
    }
    write_whole_text(out / "notes.txt", "the user's own");
    EXPECT_EQ(code(), "it began");
    write_whole_text(out / "stress-poses.svg", "of a gallery before");
    write_whole_text(out / "gallery.md", "# Gallery: box\n");
    EXPECT_EQ(code(), "it began");
    EXPECT_TRUE(fs::exists(out / "stress-poses.svg")) << "the page that shows it stands yet";
}

TEST(Gallery, TheTrianglesOfAdaptiveAreTheLastOfItsMethods) {
    const SyntheticCapture scene = textured_box_scene();
    const Lumigraph lumigraph = exact_lumigraph(scene, textured_box_camera_mesh(scene.capture));
    const ColorImage picture = methods_picture(lumigraph);
    const int width = (picture.width() - 4) / 2;
    const int height = (picture.height() - 2 * 4) / 3;
    ASSERT_EQ(height, width * 120 / 160);
    const ColorImage grid =
        OffscreenRenderer(lumigraph)
            .draw(eye_between_photographs(lumigraph, width, height),
                  {.mode = RenderMode::kAdaptive, .debug_picture = DebugPicture::kGrid})
            .color;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            ASSERT_EQ(picture(width + 4 + x, 2 * (height + 4) + y), grid(x, y)) << x << ", " << y;
}

}  // namespace
}  // namespace lumi
