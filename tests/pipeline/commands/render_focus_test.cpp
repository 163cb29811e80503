// Frames that are sharp at one distance: a focal plane that moves or stands, and an aperture.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "calib/pictures/image_io.h"
#include "calib/work/whole_file.h"
#include "render/lumigraph/package.h"
#include "tests/pipeline/box_line.h"
#include "tests/pipeline/built_program.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;
using testing::AllOf;
using testing::HasSubstr;

class RenderFocus : public BoxLine {
 protected:
    void SetUp() override {
        configure("[evaluate]\nhold_out = [\"IMG_0005.png\"]\n");
        static_cast<void>(build());
        views_ = Json::parse(lumi("--json inspect " + quoted(package())).out).at("views");
    }

    [[nodiscard]] std::string name(std::size_t view) const {
        return views_.at(view).at("name").get<std::string>();
    }

    [[nodiscard]] Outcome draw_in_any_mode(const std::filesystem::path& package,
                                           const std::string& options) const {
        return lumi("--json render " + quoted(package) + " --size 96x64 --out " + quoted(out()) +
                    " " + options);
    }

    [[nodiscard]] Outcome draw(std::size_t view, const std::string& options) const {
        return draw_in_any_mode(package(),
                                "--mode lightfield --view " + name(view) + " " + options);
    }

    [[nodiscard]] ColorImage drawn(std::size_t view, const std::string& options) const {
        const Outcome outcome = draw(view, options);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.talk;
        return read_color_image(out());
    }

    /// The same package without depth.
    [[nodiscard]] std::filesystem::path depthless_package() const {
        Lumigraph lumigraph = read_package(package());
        for (LumigraphView& view : lumigraph.views) {
            view.depth = {};
            view.depth_mesh.reset();
        }
        std::filesystem::path folder = scratch_ / "depthless.lumi";
        write_package(folder, lumigraph, {});
        return folder;
    }

    [[nodiscard]] std::filesystem::path out() const { return workspace() / "focus.png"; }

    Json views_;
};

TEST_F(RenderFocus, IsRefusedWhereNothingWouldComeOfIt) {
    for (const char* options : {"--focal-depth 2", "--mode adaptive --focal-depth 2",
                                "--aperture 0.5", "--mode heigl --aperture 0.5"}) {
        const Outcome outcome =
            draw_in_any_mode(package(), "--view " + name(1) + " " + std::string(options));
        EXPECT_EQ(outcome.exit_code, 2) << options;
        EXPECT_THAT(outcome.talk, HasSubstr("E-RENDER-FOCAL")) << options;
    }
}

TEST_F(RenderFocus, IsOfTheLightFieldThatAPackageWithoutDepthIsDrawnAs) {
    const std::filesystem::path depthless = depthless_package();
    for (const char* options : {"--focal-depth 2", "--aperture 0.5 --focal-depth 2"}) {
        const std::string at_view = "--view " + name(1) + " " + std::string(options);
        const Outcome usual = draw_in_any_mode(depthless, at_view);
        EXPECT_EQ(usual.exit_code, 0) << usual.talk;
        const ColorImage picture = read_color_image(out());
        EXPECT_EQ(draw_in_any_mode(depthless, "--mode lightfield " + at_view).exit_code, 0);
        EXPECT_EQ(read_color_image(out()), picture);
    }
    EXPECT_THAT(draw_in_any_mode(depthless, "--mode heigl --aperture 0.5 --view " + name(1)).talk,
                HasSubstr("E-RENDER-FOCAL"));
}

TEST_F(RenderFocus, AnApertureRefusesTheFadeThatAnEyesFileAsksFor) {
    const std::filesystem::path file = scratch_ / "eye.json";
    write_whole_text(file, R"({"camera": {"model": "PINHOLE", "width_px": 64, "height_px": 48,
                                          "parameters": [60, 60, 32, 24]},
                               "cam_from_world": {"rotation_wxyz": [1, 0, 0, 0],
                                                  "translation": [0, 0, 0]},
                               "fade_beyond_capture": true})");
    const std::string through_aperture =
        "--mode lightfield --aperture 0.5 --eye " + quoted(file) + " ";
    const Outcome outcome = draw_in_any_mode(package(), through_aperture);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.talk, AllOf(HasSubstr("E-RENDER-FOCAL"), HasSubstr("--no-fade")));
    EXPECT_EQ(draw_in_any_mode(package(), through_aperture + "--no-fade").exit_code, 0);
}

TEST_F(RenderFocus, APlaneStandsBeforeAPhotographThatWasHeldOutToo) {
    const std::string before_held_out = "--focal-depth 3 --focal-view IMG_0005.png";
    EXPECT_NE(drawn(1, before_held_out), drawn(1, "--focal-depth 3"));
    const auto at_held_out = [&](const std::string& options) {
        const Outcome outcome =
            draw_in_any_mode(package(), "--mode lightfield --view IMG_0005.png " + options);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.talk;
        return read_color_image(out());
    };
    EXPECT_EQ(at_held_out(before_held_out), at_held_out("--focal-depth 3"));
}

TEST_F(RenderFocus, AFixedPlaneIsThatOfTheEyeWhereItsCameraStandsAndElsewhereAnother) {
    EXPECT_EQ(drawn(1, "--focal-depth 3 --focal-view " + name(1)), drawn(1, "--focal-depth 3"));
    EXPECT_NE(drawn(0, "--focal-depth 3 --focal-view " + name(1)), drawn(0, "--focal-depth 3"));
}

TEST_F(RenderFocus, AnApertureBlursAndSaysWhatDrew) {
    const ColorImage sharp = drawn(1, "--focal-depth 3");
    const Outcome outcome = draw(1, "--focal-depth 3 --aperture 2");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.talk;
    EXPECT_EQ(Json::parse(outcome.out).at("renderer"), "synthetic aperture");
    EXPECT_NE(read_color_image(out()), sharp);
}

TEST_F(RenderFocus, AFocalViewThatIsNoPhotographIsNamed) {
    const Outcome outcome = draw(1, "--focal-depth 3 --focal-view nobody.jpg");
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.out + outcome.talk, HasSubstr("E-RENDER-VIEW"));
}

}  // namespace
}  // namespace lumi
