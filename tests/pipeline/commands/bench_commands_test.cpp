#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "calib/work/whole_file.h"
#include "tests/calib/scratch_folder.h"
#include "tests/pipeline/built_program.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;

TEST(BenchCommands, DepthIsAskedForItsStabilityOrOnWorkspaces) {
    const ScratchFolder scratch;
    const std::string out = " --out " + quoted(scratch / "stability");
    EXPECT_EQ(lumi("bench-depth" + out).exit_code, 2);
    EXPECT_EQ(lumi("bench-depth --stability work/some" + out).exit_code, 2);
    EXPECT_EQ(lumi("bench-depth --stability --hazard boredom" + out).exit_code, 2);
    const Outcome outcome = lumi(
        "bench-depth --json --stability --quick --hazard noise --model plane --model plane" + out);
    ASSERT_EQ(outcome.exit_code, 0);
    const Json json = Json::parse(outcome.out);
    ASSERT_EQ(json.at("rows").size(), 3U);
    ASSERT_EQ(json.at("rows").at(0).at("rungs").size(), 1U) << "what is named twice is asked once";
    EXPECT_EQ(json.at("rows").at(0).at("rungs").at(0).at("model"), "plane");
    EXPECT_EQ(json, Json::parse(read_whole_text(scratch / "stability" / "stability.json")));
    EXPECT_TRUE(std::filesystem::exists(scratch / "stability" / "stability.csv"));
    EXPECT_TRUE(std::filesystem::exists(scratch / "stability" / "stability-noise.svg"));
}

TEST(BenchCommands, MeasuresTheRivalsOnAPaperScene) {
    const ScratchFolder scratch;
    const Outcome outcome = lumi(
        "bench-rivals --json --scene coke --size 64 --frames 2 --held-out 2 --flicker-frames 2 "
        "--out " +
        quoted(scratch.path()));
    ASSERT_EQ(outcome.exit_code, 0) << outcome.talk;
    const Json scene = Json::parse(outcome.out).at("scenes").at(0);
    EXPECT_EQ(scene.at("photographs"), 33);
    std::map<std::string, double> covered_db;
    for (const Json& rival : scene.at("rivals"))
        covered_db.try_emplace(rival.at("method"), rival.at("psnr_covered_db"));
    for (const char* method :
         {"lightfield", "heigl", "adaptive", "paper2001", "two-plane lightfield",
          "unstructured lumigraph", "view-dependent texture", "forward warping"})
        EXPECT_GT(covered_db[method], 10.0) << method;
    // What depth is worth, and what resampling costs.
    EXPECT_GT(covered_db["perpixel"], covered_db["lightfield"] + 3);
    EXPECT_GT(covered_db["adaptive"], covered_db["two-plane adaptive"]);
    // All on the same pixels, each frame by itself.
    const auto common = scene.at("common_share").get<double>();
    EXPECT_GT(common, 0.3);
    for (const Json& rival : scene.at("rivals")) {
        const auto method = rival.at("method").get<std::string>();
        ASSERT_EQ(rival.at("frames").size(), 2U) << method;
        EXPECT_NEAR(rival.at("psnr_common_db").get<double>(),
                    (rival.at("frames").at(0).at("psnr_common_db").get<double>() +
                     rival.at("frames").at(1).at("psnr_common_db").get<double>()) /
                        2,
                    1e-9)
            << method;
        if (method != "lightfield" && method != "heigl" && !method.ends_with(" lightfield")) {
            EXPECT_GE(rival.at("coverage").get<double>(), common) << method;
        }
        EXPECT_EQ(rival.at("resampling_cpu_s").is_null(), !method.starts_with("two-plane"));
        EXPECT_EQ(rival.at("depth_cpu_ms").is_null(),
                  method != "unstructured lumigraph" && method != "view-dependent texture");
    }
    std::map<std::string, double> off_cameras_db;
    for (const Json& rival : scene.at("rivals"))
        off_cameras_db.try_emplace(rival.at("method"), rival.at("psnr_off_cameras_common_db"));
    EXPECT_GT(off_cameras_db["perpixel"], off_cameras_db["lightfield"] + 3);
    const std::string csv = read_whole_text(scratch / "rivals.csv");
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'),
              static_cast<long>(1 + 3 * scene.at("rivals").size()));
    // Every method's pictures, as they were drawn.
    const std::string compare =
        "--json compare-pictures " + quoted(scratch / "coke/frame-2.photograph.png") + " ";
    for (const Json& rival : scene.at("rivals")) {
        if (rival.at("settings").get<std::string>().find_first_of("0123456789") !=
            std::string::npos)
            continue;
        std::string name =
            rival.at("method").get<std::string>() + " " + rival.at("settings").get<std::string>();
        name.erase(name.find_last_not_of(' ') + 1);
        std::replace(name.begin(), name.end(), ' ', '-');
        const Outcome compared =
            lumi(compare + quoted(scratch / ("coke/frame-2." + name + ".png")));
        ASSERT_EQ(compared.exit_code, 0) << compared.talk;
        EXPECT_NEAR(Json::parse(compared.out).at("psnr_db").get<double>(),
                    rival.at("frames").at(1).at("psnr_as_drawn_db").get<double>(), 1e-9)
            << name;
    }
    EXPECT_EQ(lumi("bench-rivals --scene pepsi").exit_code, 2);
}

TEST(BenchCommands, TellsMachinesWherePicturesOfCameraMeshesAre) {
    const ScratchFolder scratch;
    const Outcome drawn = lumi("bench-mesh --json --pictures " + quoted(scratch.path()));
    ASSERT_EQ(drawn.exit_code, 0) << drawn.talk;
    EXPECT_EQ(Json::parse(drawn.out).at("pictures"), scratch.path().string());
}

TEST(BenchCommands, MeasuresTheCameraMeshOverRandomCaptures) {
    const Outcome outcome = lumi("bench-mesh --json --captures 3 --rays 300 --most-cameras 1000");
    ASSERT_EQ(outcome.exit_code, 0) << outcome.talk;
    const Json result = Json::parse(outcome.out);
    EXPECT_EQ(result.at("cameras_kept"), result.at("cameras"));
    EXPECT_EQ(result.at("rays_with_one_face"), 300);
    ASSERT_EQ(result.at("weights").size(), 4U);
    EXPECT_LT(result.at("weights").at(0).at("largest_inconsistency").get<double>(), 1e-9);
    EXPECT_LT(result.at("weights").at(0).at("largest_jump").get<double>(), 1e-6);
    EXPECT_GT(result.at("weights").at(1).at("largest_inconsistency").get<double>(), 0.01);
    EXPECT_GT(result.at("weights").at(2).at("largest_inconsistency").get<double>(), 0.01);
    EXPECT_EQ(result.at("weights").at(0).at("inconsistency_shares").at(0), 1.0);
    EXPECT_EQ(result.at("weights").at(3).at("inconsistency_shares").size(),
              result.at("inconsistency_bin_ends").size());
}

}  // namespace
}  // namespace lumi
