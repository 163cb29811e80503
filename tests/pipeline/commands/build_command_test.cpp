#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include "calib/pictures/image_io.h"
#include "calib/work/whole_file.h"
#include "tests/pipeline/box_line.h"
#include "tests/pipeline/built_program.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using testing::HasSubstr;

class BuildCommand : public BoxLine {};

TEST_F(BuildCommand, RunsWhatHasToBeRunAndNoMore) {
    configure("");
    EXPECT_EQ(build("mesh"), "rrr");
    EXPECT_EQ(build(), "uuurr");
    EXPECT_EQ(build(), "uuuuu");

    const std::string narrow = std::string(kSparseDepth) + "max_width_px = 100\n";
    configure("", narrow);
    EXPECT_EQ(build(), "uuurr");
    configure("[evaluate]\nhold_out = [\"IMG_0005.png\"]\n", narrow);
    EXPECT_EQ(build(), "uurrr");

    for (const auto& entry : fs::recursive_directory_iterator(scene_->path())) {
        fs::last_write_time(entry.path(), fs::file_time_type::clock::now());
    }
    EXPECT_EQ(build(), "uuuuu");
}

TEST_F(BuildCommand, MakesHarmedFilesAgain) {
    configure("");
    static_cast<void>(build());
    const fs::path harmed = workspace() / "depth" / "IMG_0002.inverse_depth.tif";
    const std::string before = read_whole_text(harmed);
    write_whole_text(harmed, "harmed");
    EXPECT_EQ(build(), "uuuru");  // The same depth as before: what was packed can stay.
    EXPECT_EQ(read_whole_text(harmed), before);
    fs::remove(package() / "lumigraph.json");
    EXPECT_EQ(build(), "uuuur");
}

TEST_F(BuildCommand, AStageWhoseMarkerIsRemovedRunsAgain) {
    configure("");
    ASSERT_EQ(build(), "rrrrr");
    fs::remove(workspace() / "ingest" / "done.json");
    EXPECT_EQ(build(), "ruuuu");
    EXPECT_EQ(build(), "uuuuu");
}

TEST_F(BuildCommand, AStageWhoseMarkerIsRemovedRunsAgainAlsoAfterARunThatFailed) {
    configure("");
    ASSERT_EQ(build(), "rrrrr");
    fs::remove(workspace() / "depth" / "done.json");
    configure("[evaluate]\nhold_out = [\"no.png\"]\n");
    const Outcome failed =
        lumi("build " + quoted(config_path()) + " --workspace " + quoted(workspace()));
    EXPECT_THAT(failed.talk, HasSubstr("error E-EVAL-NAME"));
    configure("");
    EXPECT_EQ(build(), "uuuru");
}

TEST_F(BuildCommand, WhatIsAskedOfDrawingReachesThePackage) {
    for (const std::string answer : {"yes", "no"}) {
        const bool is_yes = answer == "yes";
        const int depth_views = is_yes ? 3 : 4;
        const double block_px = is_yes ? 1.5 : 1.25;
        const double error_px = is_yes ? 2.5 : 1.5;
        const double tolerance_px = is_yes ? 4.5 : 2.25;
        const double noisy_px = is_yes ? 0.5 : 0.75;
        configure("", kSparseDepth,
                  "[render]\ndepth_views = " + std::to_string(depth_views) +
                      "\ndepth_block_px = " + std::to_string(block_px) + "\nfill_holes = \"" +
                      answer + "\"\ncheck_guesses = \"" + answer + "\"\ndraw_thin = \"" + answer +
                      "\"\ntriangle_error_px = " + std::to_string(error_px) +
                      "\nocclusion_tolerance_px = " + std::to_string(tolerance_px) +
                      "\nnoisy_depth_error_px = " + std::to_string(noisy_px) + "\n");
        static_cast<void>(build());
        const Json inspected = Json::parse(lumi("inspect --json " + quoted(package())).out);
        EXPECT_EQ(inspected.at("depth_views"), depth_views);
        EXPECT_EQ(inspected.at("depth_block_px"), block_px);
        EXPECT_EQ(inspected.at("fills_holes"), is_yes);
        EXPECT_EQ(inspected.at("checks_guesses"), is_yes);
        EXPECT_EQ(inspected.at("draws_thin"), is_yes);
        EXPECT_EQ(inspected.at("triangle_error_px"), error_px);
        EXPECT_EQ(inspected.at("occlusion_tolerance_px"), tolerance_px);
        EXPECT_EQ(inspected.at("noisy_depth_error_px"), noisy_px);
    }
}

TEST_F(BuildCommand, HeldOutViewsAreInThePosesAndInNothingElse) {
    configure("[evaluate]\nhold_out_every = 4\n");  // 1, 5 and 9 of nine.
    static_cast<void>(build());
    const Json inspected = Json::parse(lumi("inspect --json " + quoted(package())).out);
    EXPECT_EQ(inspected.at("views").size(), 6U);
    const Json stages = Json::parse(read_whole_text(workspace() / "stages.json")).at("stages");
    EXPECT_EQ(stages.at(1).at("evidence").at("photographs_registered"), 9);
    EXPECT_EQ(stages.at(2).at("evidence").at("cameras_total"), 6);
    EXPECT_EQ(stages.at(3).at("evidence").at("views").size(), 6U);
}

/// Every file of a package with its content.
std::map<std::string, std::string> files_of(const fs::path& package) {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(package)) {
        if (!entry.is_regular_file()) continue;
        files[entry.path().lexically_relative(package).string()] = read_whole_text(entry.path());
    }
    return files;
}

/// Depth and drawing as they are by default, on small maps.
constexpr const char* kNarrowDepth = "[depth]\nmax_width_px = 80\n";

TEST_F(BuildCommand, PixelsOfHeldOutViewsChangeNoByteOfThePackage) {
    const fs::path photos = scratch_ / "photos";
    fs::copy(scene_->path() / "photos", photos);
    write_whole_text(config_path(),
                     "name = \"box\"\n[capture]\nphotos = \"" + photos.string() +
                         "\"\nimport = \"" + (scene_->path() / "truth" / "sparse").string() +
                         "\"\n[evaluate]\nhold_out = [\"IMG_0005.png\"]\n" + kNarrowDepth);
    EXPECT_EQ(build(), "rrrrr");
    const auto before = files_of(package());

    ColorImage noise = read_color_image(photos / "IMG_0005.png");
    std::uint32_t state = 1;
    for (Rgb8& pixel : noise.pixels()) {
        state = state * 1664525U + 1013904223U;
        pixel = {static_cast<std::uint8_t>(state >> 24U), static_cast<std::uint8_t>(state >> 16U),
                 static_cast<std::uint8_t>(state >> 8U)};
    }
    write_png(photos / "IMG_0005.png", noise);
    EXPECT_EQ(build().substr(0, 1), "r");  // The photograph was read anew.
    EXPECT_EQ(files_of(package()), before);
}

TEST_F(BuildCommand, FoldersOfOneNameDoNotTakeEachOthersPlace) {
    const auto build_folder = [&](const fs::path& folder) {
        return lumi("ingest " + quoted(folder), "cd " + quoted(scratch_.path()) + " &&");
    };
    for (const char* parent : {"a", "b"}) fs::create_directory(scratch_ / parent);
    fs::copy(scene_->path() / "photos", scratch_ / "a/photos", fs::copy_options::recursive);
    fs::copy(scene_->path() / "photos", scratch_ / "b/photos", fs::copy_options::recursive);
    fs::remove(scratch_ / "b/photos/IMG_0009.png");
    EXPECT_EQ(build_folder(scratch_ / "a/photos").exit_code, 0);
    const Outcome refused = build_folder(scratch_ / "b/photos");
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.talk, HasSubstr("E-WORKSPACE-OTHER"));
    EXPECT_EQ(build_folder(scratch_ / "a/photos").exit_code, 0);

    // What a workspace was made with makes it again, from wherever.
    EXPECT_EQ(build_folder(scratch_ / "work/photos/config.toml").exit_code, 0);
    // Nor are results photographs.
    fs::rename(scratch_ / "work", scratch_ / "a/photos/work");
    EXPECT_EQ(build_folder(scratch_ / "a/photos").exit_code, 0);
    const Json stages =
        Json::parse(read_whole_text(scratch_ / "work" / "photos" / "stages.json")).at("stages");
    EXPECT_EQ(stages.at(0).at("evidence").at("photographs"), 9);
}

TEST_F(BuildCommand, ANamedFolderIsNotTakenFromAnotherCapture) {
    for (const char* parent : {"a", "b"})
        fs::copy(scene_->path() / "photos", scratch_ / parent, fs::copy_options::recursive);
    fs::remove(scratch_ / "b/IMG_0009.png");
    const std::string there = " --workspace " + quoted(workspace());
    EXPECT_EQ(lumi("ingest " + quoted(scratch_ / "a") + there).exit_code, 0);
    const std::string before = read_whole_text(workspace() / "config.toml");
    const Outcome refused = lumi("ingest " + quoted(scratch_ / "b") + there);
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.talk, HasSubstr("E-WORKSPACE-OTHER"));
    EXPECT_EQ(read_whole_text(workspace() / "config.toml"), before);
    EXPECT_EQ(lumi("ingest " + quoted(scratch_ / "a") + there).exit_code, 0);
}

TEST_F(BuildCommand, ACaptureThatMovedAndGrewGetsItsWorkspaceBackAsTheErrorSays) {
    fs::copy(scene_->path() / "photos", scratch_ / "a", fs::copy_options::recursive);
    const std::string there = " --workspace " + quoted(workspace());
    EXPECT_EQ(lumi("ingest " + quoted(scratch_ / "a") + there).exit_code, 0);
    fs::rename(scratch_ / "a", scratch_ / "moved");
    fs::remove(scratch_ / "moved/IMG_0009.png");
    const fs::path configuration = workspace() / "config.toml";
    const Outcome refused = lumi("ingest " + quoted(scratch_ / "moved") + there);
    EXPECT_THAT(refused.talk, HasSubstr("E-WORKSPACE-OTHER"));
    EXPECT_THAT(refused.talk, HasSubstr("write their new place into"));
    std::string text = read_whole_text(configuration);
    const std::string before = "photos = '" + (scratch_ / "a").string() + "'";
    const std::size_t place = text.find(before);
    ASSERT_NE(place, std::string::npos) << text;
    text.replace(place, before.size(), "photos = '" + (scratch_ / "moved").string() + "'");
    write_whole_text(configuration, text);
    EXPECT_EQ(lumi("ingest " + quoted(scratch_ / "moved") + there).exit_code, 0);
}

TEST_F(BuildCommand, ASlipInTheConfigurationOfAWorkspaceIsNoReasonToRefuse) {
    for (const char* parent : {"a", "b"})
        fs::copy(scene_->path() / "photos", scratch_ / parent, fs::copy_options::recursive);
    fs::remove(scratch_ / "b/IMG_0009.png");
    const std::string there = " --workspace " + quoted(workspace());
    EXPECT_EQ(lumi("ingest " + quoted(scratch_ / "a") + there).exit_code, 0);
    const fs::path configuration = workspace() / "config.toml";
    write_whole_text(configuration, read_whole_text(configuration) + "\n[a slip");
    EXPECT_THAT(lumi("ingest " + quoted(scratch_ / "b") + there).talk,
                HasSubstr("E-WORKSPACE-OTHER"));
    const Outcome again = lumi("ingest " + quoted(scratch_ / "a") + there);
    EXPECT_EQ(again.exit_code, 0) << again.talk;
}

TEST_F(BuildCommand, ANamedFolderIsThatOfItsCaptureThoughThisCannotBeReached) {
    for (const char* parent : {"a", "b"})
        fs::copy(scene_->path() / "photos", scratch_ / parent, fs::copy_options::recursive);
    fs::remove(scratch_ / "b/IMG_0009.png");
    const std::string there = " --workspace " + quoted(workspace());
    EXPECT_EQ(lumi("ingest " + quoted(scratch_ / "a") + there).exit_code, 0);
    fs::rename(scratch_ / "a", scratch_ / "unmounted");
    EXPECT_THAT(lumi("ingest " + quoted(scratch_ / "b") + there).talk,
                HasSubstr("E-WORKSPACE-OTHER"));
    EXPECT_EQ(lumi("ingest " + quoted(scratch_ / "unmounted") + there).exit_code, 0)
        << "the same photographs, moved";
}

TEST_F(BuildCommand, ARefusedAttemptHoldsNoName) {
    fs::create_directories(scratch_ / "a/photos");
    fs::create_directory(scratch_ / "b");
    fs::copy(scene_->path() / "photos/IMG_0001.png", scratch_ / "a/photos");
    fs::copy(scene_->path() / "photos", scratch_ / "b/photos", fs::copy_options::recursive);
    const std::string here = "cd " + quoted(scratch_.path()) + " &&";
    EXPECT_THAT(lumi("ingest a/photos", here).talk, HasSubstr("E-INGEST-TOOFEW"));
    EXPECT_EQ(lumi("ingest b/photos", here).exit_code, 0);
}

TEST_F(BuildCommand, AWorkspaceOfAnotherNameHasNoFinishedPackage) {
    configure("[evaluate]\nhold_out = [\"IMG_0005.png\"]\n");
    static_cast<void>(build());
    EXPECT_THAT(read_whole_text(workspace() / "report.html"),
                HasSubstr("<figcaption>IMG_0001.png</figcaption>"));
    fs::remove_all(package());
    const std::string out = " --out " + quoted(scratch_ / "out");
    for (const std::string& command : {std::string("evaluate "), "bench-depth" + out + " "}) {
        const Outcome outcome = lumi(command + quoted(workspace()));
        EXPECT_EQ(outcome.exit_code, 3) << command;
        EXPECT_THAT(outcome.talk, HasSubstr("E-EVAL-NOPACKAGE")) << command;
    }
}

TEST_F(BuildCommand, ConfigurationsOfOneNameDoNotTakeEachOthersPlace) {
    const auto ingest = [&](const std::string& parent) {
        return lumi("ingest " + quoted(scratch_ / parent / "lumi.toml"),
                    "cd " + quoted(scratch_.path()) + " &&");
    };
    for (const char* parent : {"a", "b"}) {
        fs::create_directory(scratch_ / parent);
        fs::copy(scene_->path() / "photos", scratch_ / parent / "p", fs::copy_options::recursive);
        write_whole_text(scratch_ / parent / "lumi.toml", "[capture]\nphotos = \"p\"\n");
    }
    EXPECT_EQ(ingest("a").exit_code, 0);
    EXPECT_EQ(ingest("b").exit_code, 0) << "copies elsewhere make the same";
    fs::remove(scratch_ / "b/p/IMG_0009.png");
    EXPECT_EQ(ingest("b").exit_code, 0) << "a folder may lose photographs";
    const Outcome refused = ingest("a");
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.talk, HasSubstr("E-WORKSPACE-OTHER"));
    EXPECT_THAT(refused.talk, HasSubstr((scratch_ / "b/p").string()));
    for (const std::string command : {"stress ", "doctor "}) {
        const Outcome other = lumi(command + quoted(scratch_ / "a/lumi.toml"),
                                   "cd " + quoted(scratch_.path()) + " &&");
        EXPECT_EQ(other.exit_code, 2) << command;
        EXPECT_THAT(other.talk, HasSubstr("E-WORKSPACE-OTHER")) << command;
    }
    // Where they were moved, there is nothing to take the place of.
    fs::rename(scratch_ / "b/p", scratch_ / "b/moved");
    write_whole_text(scratch_ / "b/lumi.toml", "[capture]\nphotos = \"moved\"\n");
    EXPECT_EQ(ingest("b").exit_code, 0);
    // Whoever names a folder says where.
    write_whole_text(scratch_ / "a/lumi.toml",
                     "workspace = \"../work/lumi\"\n[capture]\nphotos = \"p\"\n");
    EXPECT_EQ(ingest("a").exit_code, 0);
}

TEST_F(BuildCommand, WhatIsNamedAndMissingIsSaidBeforeAnythingIsDone) {
    const auto refusal = [&](const std::string& command) {
        const Outcome outcome =
            lumi(command + " " + quoted(config_path()) + " --workspace " + quoted(workspace()));
        EXPECT_EQ(outcome.exit_code, 3) << outcome.talk;
        EXPECT_THAT(outcome.talk, HasSubstr("error E-CONFIG-PATH"));
        EXPECT_FALSE(fs::exists(workspace() / "ingest"));
        return outcome.talk;
    };
    configure("", "[depth]\nimport_folder = \"nothing\"\n");
    EXPECT_THAT(refusal("build"), HasSubstr("`depth.import_folder`: no such folder: " +
                                            (scratch_ / "nothing").string()));
    EXPECT_THAT(refusal("doctor"), HasSubstr("`depth.import_folder`"));
    configure("[poses]\nmasks = \"gone\"\n");
    EXPECT_THAT(refusal("build"), HasSubstr("`poses.masks`: no such folder"));
    configure("", "[depth]\nimport_mesh = \".\"\n");
    EXPECT_THAT(refusal("build"), HasSubstr("`depth.import_mesh`: no such file"));
    // Depth maps may well be made from the poses that are found here.
    fs::create_directories(scratch_ / "empty");
    configure("", "[depth]\nimport_folder = \"empty\"\n");
    EXPECT_THAT(refusal("build"), HasSubstr("`depth.import_folder`: nothing is in "));
    configure("", "[depth]\nimport_folder = \"later\"\n");
    EXPECT_EQ(build("poses"), "rr");
}

TEST_F(BuildCommand, PacksNoMoreViewsThanAreWanted) {
    const auto views_packed = [&] {
        return Json::parse(lumi("inspect --json " + quoted(package())).out).at("views").size();
    };
    configure("");
    EXPECT_EQ(build(), "rrrrr");
    EXPECT_EQ(views_packed(), 9U);
    std::uintmax_t bytes = 0;
    for (const auto& entry : fs::recursive_directory_iterator(package())) {
        if (entry.is_regular_file()) bytes += entry.file_size();
    }
    const double mib = static_cast<double>(bytes) / (1 << 20);
    EXPECT_EQ(Json::parse(lumi("inspect --json " + quoted(package())).out).at("mib"), mib);

    configure("[package]\nmax_views = 1\n");
    const Outcome one =
        lumi("build " + quoted(config_path()) + " --workspace " + quoted(workspace()));
    EXPECT_THAT(one.talk, HasSubstr("pack: of 9 views one is packed ([package])"));
    EXPECT_THAT(one.talk, HasSubstr("next: lumi view \"" + package().string() + "\" ("));
    EXPECT_THAT(one.talk, HasSubstr((workspace() / "report.html").string() + "\n"));
    configure("[package]\nmax_views = 5\n");
    EXPECT_EQ(build(), "uuuur");
    EXPECT_EQ(views_packed(), 5U);
    EXPECT_EQ(lumi("validate " + quoted(package())).exit_code, 0);

    configure("[package]\nmax_mib = " + std::to_string(0.6 * mib) + "\n");
    EXPECT_EQ(build(), "uuuur");
    EXPECT_GE(views_packed(), 3U);
    EXPECT_LE(views_packed(), 6U);

    configure("[package]\nmax_mib = 0.001\n");
    const Outcome outcome =
        lumi("build " + quoted(config_path()) + " --workspace " + quoted(workspace()));
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.talk, HasSubstr("error E-PACK-MIB"));
    EXPECT_GE(views_packed(), 3U);  // The former package stays.
}

TEST_F(BuildCommand, AFailureIsWrittenDownAndTheFormerPackageStays) {
    configure("");
    static_cast<void>(build());
    const std::string before = read_whole_text(package() / "lumigraph.json");
    configure("[evaluate]\nhold_out = [\"no.png\"]\n");
    const Outcome outcome =
        lumi("build " + quoted(config_path()) + " --workspace " + quoted(workspace()));
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.talk, HasSubstr("error E-EVAL-NAME"));
    const Json stages = Json::parse(read_whole_text(workspace() / "stages.json"));
    EXPECT_EQ(stages.at("failure").at("code"), "E-EVAL-NAME");
    EXPECT_THAT(read_whole_text(workspace() / "report.html"), HasSubstr("E-EVAL-NAME"));
    EXPECT_EQ(read_whole_text(package() / "lumigraph.json"), before);
}

TEST_F(BuildCommand, TheSameBytesForAnyNumberOfThreads) {
    configure("", kNarrowDepth, "");
    std::vector<std::string> manifests;
    for (const char* threads : {"1", "3"}) {
        const fs::path folder = scratch_ / threads;
        ASSERT_EQ(lumi("build " + quoted(config_path()) + " --workspace " + quoted(folder) +
                       " --threads " + threads)
                      .exit_code,
                  0);
        manifests.push_back(read_whole_text(folder / "box.lumi" / "lumigraph.json"));
    }
    EXPECT_EQ(manifests[0], manifests[1]);  // It has the checksum of every other file.
}

}  // namespace
}  // namespace lumi
