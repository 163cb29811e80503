#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "calib/capture/colmap_model.h"
#include "calib/poses/registration.h"
#include "tests/pipeline/built_program.h"
#include "tests/truth/textured_box_scene.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using testing::HasSubstr;

/// Nine photographs of the textured box, and poses of as many as a test asks for.
class PartialBuild : public testing::Test {
 protected:
    PartialBuild() {
        SilentProgress progress;
        synthesize_into(scratch_.path(), textured_box_description(), 0, progress);
    }
    void place(std::size_t placed) const {
        const fs::path sparse = scratch_ / "truth" / "sparse";
        Capture capture = read_colmap_model(sparse);
        std::vector<char> is_dropped(capture.views.size(), 1);
        std::fill_n(is_dropped.begin(), placed, char{0});
        drop_views(capture, is_dropped);
        write_colmap_model_text(capture, sparse);
        write_whole_text(scratch_ / "box.toml",
                         "workspace = \"work\"\n[capture]\nphotos = \"photos\"\n"
                         "import = \"truth/sparse\"\n[depth]\nmodel = \"sparse\"\n");
    }
    [[nodiscard]] Outcome build(const std::string& command = "build") const {
        return lumi(command + " --json " + quoted(scratch_ / "box.toml"));
    }

    ScratchFolder scratch_;
};

TEST_F(PartialBuild, ManyMissingPhotographsArePartialAndThePackageIsThere) {
    place(7);
    const Outcome outcome = build();
    EXPECT_EQ(outcome.exit_code, 5) << outcome.talk;
    EXPECT_THAT(outcome.talk, HasSubstr("error E-BUILD-PARTIAL: only 7 of 9 photographs"));
    const Json result = Json::parse(outcome.out);
    EXPECT_EQ(result.at("stages").size(), 5U);
    EXPECT_EQ(result.at("error").at("exit_code"), 5);
    EXPECT_EQ(lumi("validate " + quoted(scratch_ / "work" / "box.lumi")).exit_code, 0);
    EXPECT_TRUE(fs::exists(scratch_ / "work" / "report.html"));

    EXPECT_EQ(build().exit_code, 5) << "what is up to date is no more than it was";
    EXPECT_EQ(build("poses").exit_code, 5);
    EXPECT_EQ(build("ingest").exit_code, 0) << "nothing was to be placed yet";
}

TEST_F(PartialBuild, OneMissingPhotographIsNoFailure) {
    place(8);
    EXPECT_EQ(build("poses").exit_code, 0);
}

TEST_F(PartialBuild, IsNamedAmongTheScenesOfADataset) {
    place(7);
    write_whole_text(scratch_ / "all.toml", "[[scene]]\nname = \"part\"\nconfig = \"box.toml\"\n");
    const Outcome outcome = lumi("build " + quoted(scratch_ / "all.toml") + " --workspace " +
                                 quoted(scratch_ / "datasets"));
    EXPECT_EQ(outcome.exit_code, 5) << outcome.talk;
    EXPECT_THAT(outcome.talk, HasSubstr("E-DATASET-PARTIAL"));
    EXPECT_THAT(outcome.talk, HasSubstr("part (7 of 9 photographs)"));
}

TEST_F(PartialBuild, IsToldThoughAWishIsMet) {
    place(7);
    write_whole_text(scratch_ / "box.toml",
                     read_whole_text(scratch_ / "box.toml") +
                         "[evaluate]\nhold_out = [\"IMG_0005.png\"]\n"
                         "[sweep]\nmodes = [\"lightfield\"]\ndepth.max_width_px = [80]\n");
    const Outcome outcome = lumi("build " + quoted(scratch_ / "box.toml") + " --target 1dB");
    EXPECT_EQ(outcome.exit_code, 5) << outcome.talk;
    EXPECT_THAT(outcome.talk, HasSubstr("error E-BUILD-PARTIAL: only 7 of 9 photographs"));
    EXPECT_TRUE(fs::exists(scratch_ / "work" / "report.html"));
}

}  // namespace
}  // namespace lumi
