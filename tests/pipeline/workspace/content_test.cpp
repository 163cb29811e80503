#include "pipeline/workspace/content.h"

#include <gtest/gtest.h>

#include "calib/ingest/made_by_lumi.h"
#include "calib/pictures/image_io.h"
#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

TEST(Content, ALinkToItselfIsNoFileAndNoReasonToEnd) {
    const ScratchFolder scratch;
    write_whole_text(scratch / "a.txt", "a");
    fs::create_symlink("loop.jpg", scratch / "loop.jpg");
    const std::vector<ContentEntry> content = content_of(scratch.path(), 1);
    ASSERT_EQ(content.size(), 1U);
    EXPECT_EQ(content[0].name, "a.txt");
}

/// Two photographs, and a workspace among them.
class ContentOfPhotographs : public testing::Test {
 protected:
    ContentOfPhotographs() {
        fs::create_directories(photos_ / "more");
        write_png(photos_ / "b.png", ColorImage(20, 10));
        write_png(photos_ / "more" / "a.png", ColorImage(20, 10));
    }
    [[nodiscard]] std::string hash() const {
        return sha256_of_content(content_of_photographs(photos_, working_folder_, {}, 2));
    }

    ScratchFolder scratch_;
    fs::path photos_ = scratch_ / "photos";
    fs::path working_folder_ = photos_ / "work" / "photos" / "ingest";
};

TEST_F(ContentOfPhotographs, IsOfPhotographsAlone) {
    const std::vector<ContentEntry> content =
        content_of_photographs(photos_, working_folder_, {}, 2);
    ASSERT_EQ(content.size(), 2U);
    EXPECT_EQ(content[0].name, "b.png");
    EXPECT_EQ(content[1].name, "more/a.png");
}

TEST_F(ContentOfPhotographs, WhatIngestPassesOverMayComeAndGo) {
    const std::string before = hash();
    write_whole_text(photos_ / "notes.txt", "a text");
    EXPECT_EQ(hash(), before);
    write_png(working_folder_ / "000001.png", ColorImage(20, 10));
    EXPECT_EQ(hash(), before);
    // As large as nothing that is read whole could be; it takes no room on the disk.
    write_whole_text(photos_ / "clip.mp4", "clip");
    fs::resize_file(photos_ / "clip.mp4", std::uintmax_t{5} << 30);
    EXPECT_EQ(hash(), before);
}

TEST_F(ContentOfPhotographs, WhatLumiMadeMayComeAndGo) {
    const std::string before = hash();
    mark_as_made_by_lumi(photos_ / "frames");
    write_png(photos_ / "frames" / "frame-000001.png", ColorImage(20, 10));
    EXPECT_EQ(hash(), before);
    write_png(photos_ / "more" / "x.lumi" / "views" / "000001.png", ColorImage(20, 10));
    EXPECT_EQ(hash(), before);
}

TEST_F(ContentOfPhotographs, WhatIngestTellsOfCounts) {
    const std::string before = hash();
    fs::create_symlink("loop.jpg", photos_ / "loop.jpg");
    const std::string with_loop = hash();
    EXPECT_NE(with_loop, before);
    // It is left out for the same reason.
    fs::remove(photos_ / "loop.jpg");
    fs::create_symlink("nowhere.jpg", photos_ / "loop.jpg");
    EXPECT_EQ(hash(), with_loop);
    write_whole_text(photos_ / "c.heic", "a picture");
    const std::string with_both = hash();
    EXPECT_NE(with_both, with_loop);
    write_whole_text(photos_ / "c.heic", "another picture");
    EXPECT_EQ(hash(), with_both);
    write_png(photos_ / "b.png", ColorImage(21, 10));
    EXPECT_NE(hash(), with_both);
}

TEST_F(ContentOfPhotographs, OfAFolderThatHoldsTheWorkspaceTheRestCounts) {
    write_whole_text(scratch_ / "named" / "cameras.txt", "poses");
    write_whole_text(scratch_ / "named" / "work" / "scene" / "report.html", "a report");
    const auto content = [&] {
        return content_of(scratch_ / "named", 1, scratch_ / "named" / "work" / "scene");
    };
    ASSERT_EQ(content().size(), 1U);
    EXPECT_EQ(content().front().name, "cameras.txt");
    EXPECT_EQ(content_of(scratch_ / "named", 1).size(), 2U);
}

TEST_F(ContentOfPhotographs, AVideoIsItsFile) {
    write_whole_text(scratch_ / "walk.mp4", "a walk");
    EXPECT_EQ(content_of_photographs(scratch_ / "walk.mp4", working_folder_, {}, 1),
              content_of(scratch_ / "walk.mp4", 1));
    EXPECT_THROW(
        static_cast<void>(content_of_photographs(scratch_ / "none", working_folder_, {}, 1)),
        Error);
}

}  // namespace
}  // namespace lumi
