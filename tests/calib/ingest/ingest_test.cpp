#include "calib/ingest/ingest.h"

#include <gmock/gmock.h>

#include <fstream>

#include "calib/ingest/made_by_lumi.h"
#include "calib/ingest/photograph_folder.h"
#include "calib/pictures/image_io.h"
#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "tests/calib/scratch_folder.h"
#include "tests/calib/test_pictures.h"

namespace lumi {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

IngestResult ingested(const ScratchFolder& scratch, const IngestOptions& options = {},
                      int threads = 2) {
    SilentProgress progress;
    return ingest(scratch / "photos", options, scratch / "copies", threads, progress);
}

std::vector<std::string> names(const IngestResult& result) {
    std::vector<std::string> list;
    for (const Photograph& photograph : result.photographs) list.push_back(photograph.name);
    return list;
}

std::map<std::string, std::string> codes(const IngestResult& result) {
    std::map<std::string, std::string> by_name;
    for (const LeftOut& left_out : result.left_out) by_name[left_out.name] = left_out.code;
    return by_name;
}

std::string code_of_refusal(const ScratchFolder& scratch, const IngestOptions& options = {}) {
    try {
        static_cast<void>(ingested(scratch, options));
    } catch (const Error& error) {
        return error.code();
    }
    return "none";
}

TEST(Ingest, CopiesHoldTheDecodedPixelsOfPhotographsThatFit) {
    const ScratchFolder scratch;
    const ColorImage first = wavy_picture(160, 120);
    const ColorImage second = wavy_picture(160, 120, 9);
    write_png(scratch / "photos/b.png", second);
    write_png(scratch / "photos/a.png", first);
    const IngestResult result = ingested(scratch);
    ASSERT_THAT(names(result), ElementsAre("a.png", "b.png"));
    EXPECT_EQ(read_color_image(result.photographs[0].picture_path), first);
    EXPECT_EQ(read_color_image(result.photographs[1].picture_path), second);
    EXPECT_EQ(result.photographs[0].picture_path, scratch / "copies/000001.png");
    EXPECT_EQ(result.photographs[1].picture_path, scratch / "copies/000002.png");
}

TEST(Ingest, KeepsNamesWithBlanksUnicodeShellCharactersAndFolders) {
    const ScratchFolder scratch;
    const std::vector<std::string> list{"$(x) `y`.png", "a b/ünï-日本.png", "a b/çedilla (1).PNG",
                                        "line\nbreak.png", "no_extension"};
    for (std::size_t i = 0; i < list.size(); ++i) {
        write_png(scratch / ("photos/" + list[i]), wavy_picture(100, 80, 7.0 * double(i)));
    }
    const IngestResult result = ingested(scratch);
    std::vector<std::string> sorted = list;
    std::sort(sorted.begin(), sorted.end());
    EXPECT_EQ(names(result), sorted);
    EXPECT_THAT(result.left_out, IsEmpty());
}

TEST(Ingest, NamesFilesWhoseNamesNoReportCouldHold) {
    const ScratchFolder scratch;
    write_png(scratch / "photos/1.png", wavy_picture(100, 80));
    write_png(scratch / "photos/2.png", wavy_picture(100, 80, 11));
    write_png(scratch / "photos/latin1 \xfc.png", wavy_picture(100, 80, 22));
    write_png(scratch / "photos/overlong \xe0\x80\xae.png", wavy_picture(100, 80, 33));
    write_png(scratch / "photos/caf\xe9/3.png", wavy_picture(100, 80, 44));
    write_whole_text(scratch / "photos/empty \xe9.jpg", "");
    write_whole_text(scratch / "photos/other \xe9.jxl", "\xff\x0a");
    const IngestResult result = ingested(scratch);
    EXPECT_THAT(names(result), ElementsAre("1.png", "2.png"));
    const std::map<std::string, std::string> expected{
        {"latin1 \\xfc.png", "E-INGEST-NAME"},
        {"overlong \\xe0\\x80\\xae.png", "E-INGEST-NAME"},
        {"caf\\xe9/3.png", "E-INGEST-NAME"},
        {"empty \\xe9.jpg", "E-INGEST-UNREADABLE"},
        {"other \\xe9.jxl", "E-INGEST-FORMAT"}};
    EXPECT_EQ(codes(result), expected);
}

TEST(Ingest, FollowsLinksToFilesAndNamesThoseThatLeadNowhere) {
    const ScratchFolder scratch;
    write_png(scratch / "elsewhere.png", wavy_picture(100, 80));
    write_png(scratch / "photos/here.png", wavy_picture(100, 80, 11));
    std::filesystem::create_symlink(scratch / "elsewhere.png", scratch / "photos/link.png");
    std::filesystem::create_symlink(scratch / "gone.png", scratch / "photos/broken.png");
    std::filesystem::create_directory_symlink(scratch / "photos", scratch / "photos/loop");
    const IngestResult result = ingested(scratch);
    EXPECT_THAT(names(result), ElementsAre("here.png", "link.png"));
    EXPECT_EQ(codes(result).at("broken.png"), "E-INGEST-UNREADABLE");
}

TEST(Ingest, FollowsLinksToFoldersOnceAndInNoCircle) {
    const ScratchFolder scratch;
    write_png(scratch / "real/1.png", wavy_picture(100, 80));
    write_png(scratch / "real/deep/2.png", wavy_picture(100, 80, 11));
    write_png(scratch / "photos/sub/3.png", wavy_picture(100, 80, 23));
    std::filesystem::create_directory_symlink(scratch / "real", scratch / "photos/more");
    std::filesystem::create_directory_symlink(scratch / "photos/sub", scratch / "photos/again");
    std::filesystem::create_directory_symlink(scratch / "real", scratch / "real/deep/loop");
    const IngestResult result = ingested(scratch);
    EXPECT_THAT(names(result), ElementsAre("more/1.png", "more/deep/2.png", "sub/3.png"));
    EXPECT_THAT(result.left_out, IsEmpty());
}

TEST(Ingest, LeavesOutFoldersThatHoldSomethingElse) {
    const ScratchFolder scratch;
    write_png(scratch / "photos/1.png", wavy_picture(100, 80));
    write_png(scratch / "photos/2.png", wavy_picture(100, 80, 11));
    write_png(scratch / "photos/masks/1.png", wavy_picture(100, 80, 23));
    const IngestResult result =
        ingested(scratch, {.other_folders = {scratch / "photos/./masks", scratch / "photos"}});
    EXPECT_THAT(names(result), ElementsAre("1.png", "2.png"));
    EXPECT_EQ(codes(result), (std::map<std::string, std::string>{{"masks", "E-INGEST-OWN"}}));
}

TEST(Ingest, PassesOverWhatIsNoPictureAndNamesWhatClaimsToBeOne) {
    const ScratchFolder scratch;
    write_png(scratch / "photos/1.png", wavy_picture(100, 80));
    write_png(scratch / "photos/2.png", wavy_picture(100, 80, 11));
    write_png(scratch / "photos/.hidden.png", wavy_picture(100, 80, 22));
    write_whole_text(scratch / "photos/notes.txt", "a note");
    write_whole_text(scratch / "photos/0000.jpg.camera", "1 0 0");
    write_whole_text(scratch / "photos/intrinsic.yaml", "k: 1");
    write_whole_text(scratch / "photos/text.jpg", "not a picture");
    write_whole_text(scratch / "photos/empty.jpg", "");
    write_whole_text(scratch / "photos/phone.heic", "....ftypheic");
    write_whole_text(scratch / "photos/other.jxl", "\xff\x0a");
    write_whole_text(scratch / "photos/raw.NEF", std::string("MM\0*\0\0\0\x8", 8));
    write_float_tiff(scratch / "photos/raw.3FR", FloatImage(100, 80, 0.5F));  // A thumbnail.
    write_float_tiff(scratch / "photos/raw.iiq", FloatImage(100, 80, 0.6F));
    const IngestResult result = ingested(scratch);
    EXPECT_THAT(names(result), ElementsAre("1.png", "2.png"));
    const std::map<std::string, std::string> expected{
        {"text.jpg", "E-INGEST-UNREADABLE"},  {"empty.jpg", "E-INGEST-UNREADABLE"},
        {"phone.heic", "E-INGEST-TRUNCATED"}, {"other.jxl", "E-INGEST-FORMAT"},
        {"raw.NEF", "E-INGEST-FORMAT"},       {"raw.3FR", "E-INGEST-FORMAT"},
        {"raw.iiq", "E-INGEST-FORMAT"}};
    EXPECT_EQ(codes(result), expected);
}

TEST(Ingest, TellsFormatsByTheirContent) {
    const ScratchFolder scratch;
    write_jpeg(scratch / "photos/1.png", wavy_picture(100, 80), 95);
    write_png(scratch / "photos/2.jpg", wavy_picture(100, 80, 11));
    EXPECT_THAT(names(ingested(scratch)), ElementsAre("1.png", "2.jpg"));
}

TEST(Ingest, NamesEveryTruncatedPhotograph) {
    const ScratchFolder scratch;
    write_png(scratch / "photos/ok1.png", wavy_picture(100, 80));
    write_png(scratch / "photos/ok2.png", wavy_picture(100, 80, 11));
    write_jpeg(scratch / "whole.jpg", wavy_picture(300, 200, 3), 90);
    write_png(scratch / "whole.png", wavy_picture(300, 200, 3));
    std::size_t truncated = 0;
    for (const std::string ending : {".jpg", ".png"}) {
        const Bytes whole = read_whole_file(scratch / ("whole" + ending));
        for (const double share : {0.01, 0.1, 0.5, 0.9, 0.99}) {
            const Bytes part(whole.begin(),
                             whole.begin() + std::ptrdiff_t(share * double(whole.size())));
            write_whole_file(scratch / ("photos/" + std::to_string(share) + ending), part);
            ++truncated;
        }
    }
    const IngestResult result = ingested(scratch);
    EXPECT_THAT(names(result), ElementsAre("ok1.png", "ok2.png"));
    ASSERT_EQ(result.left_out.size(), truncated);
    for (const LeftOut& left_out : result.left_out) {
        EXPECT_EQ(left_out.code, "E-INGEST-TRUNCATED") << left_out.name;
    }
}

TEST(Ingest, LeavesOutTheSamePictureUnderAnotherName) {
    const ScratchFolder scratch;
    write_png(scratch / "photos/1.png", wavy_picture(160, 120));
    write_png(scratch / "photos/2.png", wavy_picture(160, 120, 11));
    write_png(scratch / "photos/3 (copy of 1).png", wavy_picture(160, 120));
    const IngestResult result = ingested(scratch);
    EXPECT_THAT(names(result), ElementsAre("1.png", "2.png"));
    ASSERT_EQ(result.left_out.size(), 1U);
    EXPECT_EQ(result.left_out[0].code, "E-INGEST-DUPLICATE");
    EXPECT_THAT(result.left_out[0].reason, HasSubstr("1.png"));
}

TEST(Ingest, KeepsOfEqualPicturesTheOneThatIsNamedLikeTheOthers) {
    const ScratchFolder scratch;
    for (int i = 0; i < 3; ++i)
        write_png(scratch / ("photos/m0" + std::to_string(i) + ".png"),
                  wavy_picture(160, 120, 11 * i));
    write_png(scratch / "photos/copy.png", wavy_picture(160, 120));
    const IngestResult result = ingested(scratch);
    EXPECT_THAT(names(result), ElementsAre("m00.png", "m01.png", "m02.png"));
    ASSERT_EQ(result.left_out.size(), 1U);
    EXPECT_EQ(result.left_out[0].name, "copy.png");
    EXPECT_THAT(result.left_out[0].reason, HasSubstr("m00.png"));
}

TEST(Ingest, LeavesOutASecondShotFromTheSamePlaceButNotOneFromFourPixelsBeside) {
    const ScratchFolder scratch;
    const ColorImage scene = wavy_picture(1024, 768);
    write_png(scratch / "photos/1.png", with_noise(scene, 4, 1));
    write_png(scratch / "photos/2 same place.png", with_noise(scene, 4, 2));
    write_png(scratch / "photos/3 moved.png", with_noise(wavy_picture(1024, 768, 4), 4, 3));
    const IngestResult result = ingested(scratch);
    EXPECT_THAT(names(result), ElementsAre("1.png", "3 moved.png"));
    EXPECT_EQ(codes(result).at("2 same place.png"), "E-INGEST-DUPLICATE");
}

TEST(Ingest, ScalesTheLongerSideDownAndNeverUp) {
    const ScratchFolder scratch;
    write_png(scratch / "photos/landscape.png", wavy_picture(600, 400));
    write_png(scratch / "photos/portrait.png", wavy_picture(400, 600));
    write_png(scratch / "photos/small.png", wavy_picture(200, 150));
    const IngestResult result = ingested(scratch, {.max_width_px = 300});
    const auto sizes = [&](std::size_t i) {
        const Photograph& p = result.photographs[i];
        const ColorImage copy = read_color_image(p.picture_path);
        EXPECT_EQ(copy.width(), p.width_px);
        EXPECT_EQ(copy.height(), p.height_px);
        return std::vector<int>{p.width_px, p.height_px, p.original_width_px, p.original_height_px};
    };
    ASSERT_EQ(result.photographs.size(), 3U);
    EXPECT_THAT(sizes(0), ElementsAre(300, 200, 600, 400));
    EXPECT_THAT(sizes(1), ElementsAre(200, 300, 400, 600));
    EXPECT_THAT(sizes(2), ElementsAre(200, 150, 200, 150));
}

TEST(Ingest, GivesTheSameBytesForAnyNumberOfThreads) {
    const ScratchFolder scratch;
    for (int i = 0; i < 9; ++i) {
        write_jpeg(scratch / ("photos/" + std::to_string(i) + ".jpg"),
                   wavy_picture(320, 240, 7 * i), 90);
    }
    write_whole_text(scratch / "photos/5b.jpg", "damaged");
    const auto copies = [&](int threads) {
        const IngestResult result = ingested(scratch, {.max_width_px = 200}, threads);
        std::vector<std::pair<std::string, Bytes>> files;
        for (const Photograph& photograph : result.photographs) {
            files.emplace_back(photograph.name, read_whole_file(photograph.picture_path));
        }
        return files;
    };
    const auto one = copies(1);
    ASSERT_EQ(one.size(), 9U);
    EXPECT_EQ(one, copies(2));
    EXPECT_EQ(one, copies(7));
}

TEST(Ingest, RemovesCopiesOfAnEarlierRunAndNothingElse) {
    const ScratchFolder scratch;
    for (int i = 0; i < 4; ++i) {
        write_png(scratch / ("photos/" + std::to_string(i) + ".png"), wavy_picture(100, 80, 9 * i));
    }
    ASSERT_EQ(ingested(scratch).photographs.size(), 4U);
    write_whole_text(scratch / "copies/mine.txt", "kept");
    std::filesystem::remove(scratch / "photos/1.png");
    ASSERT_EQ(ingested(scratch).photographs.size(), 3U);
    EXPECT_TRUE(std::filesystem::exists(scratch / "copies/000003.png"));
    EXPECT_FALSE(std::filesystem::exists(scratch / "copies/000004.png"));
    EXPECT_TRUE(std::filesystem::exists(scratch / "copies/mine.txt"));
}

TEST(Ingest, PassesOverItsOwnWorkingFolderInsideThePhotographs) {
    const ScratchFolder scratch;
    write_png(scratch / "1.png", wavy_picture(100, 80));
    write_png(scratch / "2.png", wavy_picture(100, 80, 11));
    SilentProgress progress;
    for (int run = 0; run < 2; ++run) {
        const IngestResult result =
            ingest(scratch.path(), {}, scratch / "work/scene/copies", 1, progress);
        EXPECT_THAT(names(result), ElementsAre("1.png", "2.png"));
    }
}

TEST(Ingest, TakesPhotographsThatLieBesideItsWorkingFolder) {
    const ScratchFolder scratch;
    write_png(scratch / "left/1.png", wavy_picture(100, 80));
    write_png(scratch / "left/work/2.png", wavy_picture(100, 80, 11));
    write_png(scratch / "right/3.png", wavy_picture(100, 80, 23));
    const std::filesystem::path workspace = scratch / "left/work/scene";
    write_whole_text(workspace / "config.toml", "");
    write_whole_text(workspace / "stages.json", "");
    write_png(workspace / "poses/4.png", wavy_picture(100, 80, 36));
    // Of other captures, made from the same folder.
    write_whole_text(scratch / "left/work/other/config.toml", "");
    write_whole_text(scratch / "left/work/other/stages.json", "");
    SilentProgress progress;
    for (int run = 0; run < 2; ++run) {
        const IngestResult result = ingest(scratch.path(), {}, workspace / "ingest", 1, progress);
        EXPECT_THAT(names(result), ElementsAre("left/1.png", "left/work/2.png", "right/3.png"));
        EXPECT_THAT(result.left_out, IsEmpty());
    }
}

TEST(Ingest, PassesOverWhatLumiMarkedAsItsOwn) {
    const ScratchFolder scratch;
    write_png(scratch / "1.png", wavy_picture(100, 80));
    write_png(scratch / "2.png", wavy_picture(100, 80, 11));
    const std::filesystem::path chart = scratch / "work/scene-chart";
    mark_as_made_by_lumi(chart);
    write_png(chart / "store-0/3.png", wavy_picture(100, 80, 23));
    SilentProgress progress;
    for (const std::filesystem::path& copies :
         {scratch / "work/scene/ingest", chart / "variants/one/ingest"}) {
        const IngestResult result = ingest(scratch.path(), {}, copies, 1, progress);
        EXPECT_THAT(names(result), ElementsAre("1.png", "2.png")) << copies;
    }
}

TEST(Ingest, AWorkspaceThatIsNoneYetIsPassedOverAsItWillBe) {
    const ScratchFolder scratch;
    write_png(scratch / "1.png", wavy_picture(100, 80));
    write_png(scratch / "2.png", wavy_picture(100, 80, 11));
    write_whole_text(scratch / "work/other/config.toml", "");
    write_whole_text(scratch / "work/other/stages.json", "");
    write_png(scratch / "work/scene/doctor/3.png", wavy_picture(100, 80, 23));
    SilentProgress progress;
    const IngestResult result = ingest(scratch.path(), {.workspace = scratch / "work/scene"},
                                       scratch / "work/scene/doctor/.copies", 1, progress);
    EXPECT_THAT(names(result), ElementsAre("1.png", "2.png"));
    EXPECT_THAT(result.left_out, IsEmpty());
}

TEST(Ingest, RefusesTooFewPhotographsAndSaysWhatWasWrongWithTheOthers) {
    const ScratchFolder scratch;
    write_png(scratch / "photos/1.png", wavy_picture(100, 80));
    write_whole_text(scratch / "photos/damaged.jpg", "");
    try {
        static_cast<void>(ingested(scratch));
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-INGEST-TOOFEW");
        EXPECT_EQ(error.exit_code(), 3);
        EXPECT_THAT(error.what(), HasSubstr("damaged.jpg"));
    }
}

TEST(Ingest, RefusesAFolderThatIsNotThere) {
    const ScratchFolder scratch;
    EXPECT_EQ(code_of_refusal(scratch), "E-INGEST-NOFOLDER");
}

TEST(Ingest, AFileIsNotCalledAFolderThatIsNotThere) {
    const ScratchFolder scratch;
    write_whole_text(scratch / "board.png", "");
    try {
        static_cast<void>(list_photographs(scratch / "board.png", {}, {}));
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-INGEST-NOFOLDER");
        EXPECT_THAT(error.what(), HasSubstr("is a file, expected a folder of photographs"));
        EXPECT_THAT(error.advice(), testing::Not(HasSubstr("video")));
    }
}

TEST(Ingest, StopsWhenAsked) {
    const ScratchFolder scratch;
    write_png(scratch / "photos/1.png", wavy_picture(100, 80));
    SilentProgress progress;
    progress.interrupt();
    EXPECT_THROW(static_cast<void>(ingest(scratch / "photos", {}, scratch / "copies", 1, progress)),
                 Error);
}

TEST(IngestOptions, RefusesValuesOutOfRangeWithTheirLine) {
    const auto refusal = [](const std::string& line) -> std::string {
        const ConfigSection file = ConfigSection::from_text("[capture]\n" + line, "c.toml");
        try {
            static_cast<void>(read_ingest_options(file.section("capture")));
        } catch (const Error& error) {
            return error.what();
        }
        return "none";
    };
    EXPECT_EQ(refusal("max_width_px = 800"), "none");
    for (const std::string line : {"max_width_px = -1", "min_width_px = 0", "max_width_px = 30",
                                   "min_photographs = 0", "video_fps = 0.0"}) {
        EXPECT_THAT(refusal(line), HasSubstr("c.toml:2")) << line;
    }
    EXPECT_THROW(validate(IngestOptions{.video_fps = std::nan("")}), Error);
}

}  // namespace
}  // namespace lumi
