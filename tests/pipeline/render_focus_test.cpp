// Frames that are sharp at one distance: a focal plane that moves or stands, and an aperture.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "calib/pictures/image_io.h"
#include "tests/pipeline/box_line.h"
#include "tests/pipeline/built_program.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;

class RenderFocus : public BoxLine {
 protected:
    void SetUp() override {
        configure("");
        static_cast<void>(build());
        views_ = Json::parse(lumi("--json inspect " + quoted(package())).out).at("views");
    }

    [[nodiscard]] std::string name(std::size_t view) const {
        return views_.at(view).at("name").get<std::string>();
    }

    [[nodiscard]] Outcome draw(std::size_t view, const std::string& options) const {
        return lumi("--json render " + quoted(package()) +
                    " --mode lightfield --size 96x64 --view " + name(view) + " --out " +
                    quoted(out()) + " " + options);
    }

    [[nodiscard]] ColorImage drawn(std::size_t view, const std::string& options) const {
        const Outcome outcome = draw(view, options);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.talk;
        return read_color_image(out());
    }

    [[nodiscard]] std::filesystem::path out() const { return workspace() / "focus.png"; }

    Json views_;
};

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
    EXPECT_THAT(outcome.out + outcome.talk, HasSubstr("E-VIEW-NAME"));
}

}  // namespace
}  // namespace lumi
