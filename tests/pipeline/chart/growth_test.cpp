#include "pipeline/chart/growth.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "calib/pictures/image_io.h"
#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::SizeIs;

/// Growth that is measured by a program in lumi's place.
class Growing : public testing::Test {
 protected:
    Growing() {
        write_png(scratch_ / "photos" / "1.png", ColorImage(4, 4));
        write_png(scratch_ / "photos" / "2.png", ColorImage(4, 4));
        write_whole_text(scratch_ / "photos" / "readme.txt", "no photograph");
    }
    GrowthResult measure(const std::string& more, const fs::path& program) {
        write_whole_text(scratch_ / "cat.toml", "[capture]\nphotos = \"photos\"\n" + more);
        const ConfigDocument document = ConfigDocument::open(scratch_ / "cat.toml");
        SilentProgress progress;
        return measure_growth(document, read_growth_plan(document), program, folder_, 1, progress);
    }
    /// A program that leaves what a stage leaves, but for the workspace whose name has `failing`.
    [[nodiscard]] fs::path stand_in(const std::string& failing) const {
        const fs::path script = scratch_ / "lumi.sh";
        write_whole_text(script,
                         "#!/bin/sh\n"
                         "case \"$5\" in *" +
                             failing +
                             "*) exit 3;; esac\n"
                             "mkdir -p \"$5/ingest\"\n"
                             "echo '{\"stages\": []}' > \"$5/stages.json\"\n"
                             "echo '{\"photographs\": [], \"left_out\": []}' >"
                             " \"$5/ingest/photographs.json\"\n");
        fs::permissions(script, fs::perms::owner_all);
        return script;
    }

    ScratchFolder scratch_;
    fs::path folder_ = scratch_ / "growth";
};

TEST_F(Growing, EndsWithTheFirstFailureWhenNothingCouldBeMeasured) {
    for (const char* plan : {"photographs = [1, 2]\n", "max_width_px = [100]\n"}) {
        try {
            static_cast<void>(measure(std::string("[growth]\n") + plan, "/bin/false"));
            FAIL() << "growth was measured by a program that does nothing";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), "E-GROWTH-STAGE");
            EXPECT_THAT(error.what(), HasSubstr("the stage ingest failed"));
        }
    }
}

TEST_F(Growing, ReplacesNoFileThatItDidNotMake) {
    write_whole_text(folder_ / "photos-1" / "own.jpg", "the user's own");
    EXPECT_THROW(static_cast<void>(measure("[growth]\nphotographs = [1]\n", "/bin/false")), Error);
    EXPECT_EQ(read_whole_text(folder_ / "photos-1" / "own.jpg"), "the user's own");
}

TEST_F(Growing, LeavesAllThatStandsBesideSuchAFile) {
    const fs::path folder = folder_ / "photos-1";
    write_whole_text(folder / "own.jpg", "the user's own");
    constexpr int kLinks = 20;
    for (int i = 0; i < kLinks; ++i) {
        fs::create_symlink(scratch_ / "photos" / "1.png", folder / (std::to_string(i) + ".png"));
    }
    EXPECT_THROW(static_cast<void>(measure("[growth]\nphotographs = [1]\n", "/bin/false")), Error);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), kLinks + 1);
}

TEST_F(Growing, IsMeasuredOnTheFirstPhotographsInOrderOfName) {
    fs::create_directories(folder_ / "photos-1");
    fs::create_symlink(scratch_ / "photos" / "2.png", folder_ / "photos-1" / "of a run before.png");
    static_cast<void>(measure("[growth]\nphotographs = [1, 2, 3]\n", stand_in("nothing")));
    const auto links_in = [&](const std::string& name) {
        std::map<std::string, fs::path> links;
        for (const auto& entry : fs::directory_iterator(folder_ / name))
            links[entry.path().filename().string()] = fs::read_symlink(entry.path());
        return links;
    };
    const std::map<std::string, fs::path> first{{"1.png", scratch_ / "photos" / "1.png"}};
    std::map<std::string, fs::path> both = first;
    both["2.png"] = scratch_ / "photos" / "2.png";
    EXPECT_EQ(links_in("photos-1"), first);
    EXPECT_EQ(links_in("photos-2"), both);
    EXPECT_EQ(links_in("photos-3"), both) << "there are no more";
}

TEST_F(Growing, ASizeThatFailsIsToldBesideTheOthers) {
    const GrowthResult result =
        measure("[growth]\nphotographs = [1, 2]\n", stand_in("photographs-2"));
    EXPECT_THAT(result.by_photographs, SizeIs(5));
    ASSERT_THAT(result.failures, SizeIs(1));
    EXPECT_THAT(result.failures.front(), HasSubstr("2 photographs: E-GROWTH-STAGE"));
}

TEST_F(Growing, ASizeThatTheFileSystemRefusesIsToldBesideTheOthers) {
    write_whole_text(folder_ / "photos-2", "a file where a folder is to be");
    const GrowthResult result = measure("[growth]\nphotographs = [1, 2]\n", stand_in("nothing"));
    EXPECT_THAT(result.by_photographs, SizeIs(5));
    ASSERT_THAT(result.failures, SizeIs(1));
    EXPECT_THAT(result.failures.front(), HasSubstr("2 photographs: E-FILE-SYSTEM"));
}

TEST_F(Growing, IsToldOfEveryFileWhereItLies) {
    static_cast<void>(
        measure("import = \"poses\"\n[poses]\nmasks = \"poses masks\"\n[depth]\nmasks = \"masks\"\n"
                "import_mesh = \"m.ply\"\n[growth]\nphotographs = [1]\nmax_width_px = [100]\n",
                stand_in("nothing")));
    for (const char* name : {"photographs-1.toml", "width-100.toml"}) {
        const BuildConfig config = load_build_config(folder_ / name);
        EXPECT_EQ(config.imported_poses, scratch_ / "poses");
        EXPECT_EQ(config.poses.mask_folder, scratch_ / "poses masks");
        EXPECT_EQ(config.depth.mask_folder, scratch_ / "masks");
        EXPECT_EQ(config.depth.import_mesh, scratch_ / "m.ply");
        EXPECT_EQ(config.name, "cat");
    }
    EXPECT_EQ(load_build_config(folder_ / "photographs-1.toml").photographs_or_video,
              folder_ / "photos-1");
    EXPECT_EQ(load_build_config(folder_ / "width-100.toml").photographs_or_video,
              scratch_ / "photos");
    EXPECT_EQ(load_build_config(folder_ / "width-100.toml").ingest.max_width_px, 100);
}

}  // namespace
}  // namespace lumi
