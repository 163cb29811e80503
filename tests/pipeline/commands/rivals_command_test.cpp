// Methods of others on a package, measured and looked at, and the pages that tell of them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include "tests/pipeline/drawn_package.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using testing::HasSubstr;

class RivalsOfPackage : public DrawnPackage {
 protected:
    /// Of the held-out photograph's place.
    [[nodiscard]] Outcome draw(const std::string& options,
                               const std::string& file = "x.png") const {
        return lumi("--json render " + package() + " --view IMG_0005.png " + options + " --out " +
                    quoted(scratch_ / file));
    }
};

TEST_F(RivalsOfPackage, AreMeasuredBesideLumisModesAndDrawnAlike) {
    const Outcome outcome =
        lumi("--json evaluate " + quoted(workspace()) + " --mode adaptive --rivals");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.talk;
    const Json evaluation = Json::parse(outcome.out);
    EXPECT_GT(evaluation.at("mean").at("cpu_ms").get<double>(), 0.0);
    for (const char* mode : {"heigl", "paper2001", "lightfield"})
        EXPECT_TRUE(evaluation.at("modes").contains(mode)) << mode;
    const Json& rivals = evaluation.at("rivals");
    for (const char* method : {"unstructured lumigraph", "view-dependent texture",
                               "forward warping", "two-plane lightfield", "two-plane adaptive"}) {
        EXPECT_GT(rivals.at("methods").at(method).at("mean").at("psnr_db").get<double>(), 10.0)
            << method;
    }
    EXPECT_TRUE(rivals.at("left_out").contains("spherical"));
    // Modes and methods on the same pixels.
    const Json& common = rivals.at("common_pixels");
    EXPECT_GT(common.at("share").get<double>(), 0.2);
    for (const char* method : {"adaptive", "heigl", "forward warping", "unstructured lumigraph"})
        EXPECT_GT(common.at("psnr_db").at(method).get<double>(), 10.0) << method;
    EXPECT_TRUE(fs::exists(workspace() / "evaluation" / "IMG_0005.unstructured-lumigraph.png"));
    // A frame of one's own is the frame that was measured.
    for (const char* method :
         {"unstructured lumigraph", "view-dependent texture", "forward warping",
          "dynamically reparameterized", "two-plane adaptive"}) {
        std::string rival = method;
        rival = rival.starts_with("two-plane") ? "two-plane" : rival;
        std::replace(rival.begin(), rival.end(), ' ', '-');
        const Outcome drawn = draw("--difference --rival " + rival);
        ASSERT_EQ(drawn.exit_code, 0) << drawn.talk;
        EXPECT_NEAR(Json::parse(drawn.out).at("frames").at(0).at("psnr_db").get<double>(),
                    rivals.at("methods").at(method).at("mean").at("psnr_db").get<double>(), 1e-9)
            << method;
    }
    const std::string report = read_whole_text(workspace() / "report.html");
    EXPECT_THAT(report, HasSubstr("forward warping"));
    EXPECT_THAT(report, HasSubstr("Not drawn: spherical."));
    EXPECT_EQ(lumi("evaluate " + quoted(workspace()) + " --leave-one-out --rivals").exit_code, 2);
}

TEST_F(RivalsOfPackage, NamesThatAreNoneSayWhatIs) {
    const auto refused = [&](const std::string& options) {
        const Outcome outcome = draw(options);
        EXPECT_EQ(outcome.exit_code, 2) << options;
        return outcome.talk;
    };
    EXPECT_THAT(refused("--mode two-plane"), HasSubstr("lumi render --rival two-plane"));
    EXPECT_THAT(refused("--mode 'forward warping'"), HasSubstr("--rival forward-warping"));
    EXPECT_THAT(refused("--rival heigl"), HasSubstr("use --mode heigl"));
    EXPECT_THAT(refused("--rival none"), HasSubstr("view-dependent-texture"));
    EXPECT_THAT(refused("--rival spherical"), HasSubstr("all around"));
    EXPECT_THAT(refused("--rival forward-warping --mode adaptive"), HasSubstr("E-RENDER-RIVAL"));
    for (const char* unused : {"--debug depth", "--fade", "--reference", "--min-triangle 6"})
        static_cast<void>(refused("--rival two-plane " + std::string(unused)));
}

TEST_F(RivalsOfPackage, AreDrawnFromAllPlacesBesideLumisFrames) {
    const auto draw_all = [&](const std::string& options) {
        return lumi("render " + package() + " --all-views --size 40x30 " + options + " --out " +
                    quoted(scratch_.path()));
    };
    EXPECT_EQ(draw_all("--mode lightfield").exit_code, 0);
    EXPECT_EQ(draw_all("--rival two-plane --mode lightfield").exit_code, 0);
    EXPECT_EQ(draw_all("--rival forward-warping").exit_code, 0);
    for (const char* kind : {"lightfield", "two-plane-lightfield", "forward-warping"})
        EXPECT_EQ(read_color_image(scratch_ / ("IMG_0001." + std::string(kind) + ".png")).width(),
                  40)
            << kind;
}

TEST_F(RivalsOfPackage, AGalleryTellsOfEveryModeThatWasMeasured) {
    ASSERT_EQ(lumi("evaluate " + quoted(workspace()) +
                   " --mode perpixel,adaptive,paper2001 --no-ghost-energy")
                  .exit_code,
              0);
    ASSERT_EQ(
        lumi("gallery " + quoted(workspace()) + " --out " + quoted(scratch_.path())).exit_code, 0);
    std::istringstream page(read_whole_text(scratch_ / "gallery.md"));
    std::vector<std::string> rows;
    for (std::string line; std::getline(page, line);)
        if (line.starts_with("| ")) rows.push_back(line);
    ASSERT_EQ(rows.size(), 4U);
    for (const std::string& row : rows) {
        EXPECT_EQ(std::count(row.begin(), row.end(), '|'),
                  std::count(rows[0].begin(), rows[0].end(), '|'))
            << row;
        EXPECT_EQ(row.find("| - |"), std::string::npos) << row;
    }
}

}  // namespace
}  // namespace lumi
