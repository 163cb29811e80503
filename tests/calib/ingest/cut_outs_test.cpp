#include "calib/ingest/cut_outs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "calib/pictures/drawn_mask.h"
#include "calib/pictures/image_io.h"
#include "tests/calib/cut_out_pictures.h"
#include "tests/calib/scratch_folder.h"
#include "tests/calib/test_pictures.h"

namespace lumi {
namespace {

constexpr int kWidth = 160;
constexpr int kHeight = 120;

/// As many rows from the top as are black across their whole width.
int black_rows(const GrayImage& mask) {
    int rows = 0;
    while (rows < mask.height() && std::all_of(mask.row(rows), mask.row(rows) + mask.width(),
                                               [](auto p) { return p == 0; }))
        ++rows;
    return rows;
}

TEST(CutOuts, MasksLieBesideTheCopiesAsIfTheyHadBeenDrawn) {
    const ScratchFolder scratch;
    write_cut_out_png(scratch / "photos/a.png", wavy_picture(kWidth, kHeight), 60);
    write_cut_out_png(scratch / "photos/more/a.png", wavy_picture(kWidth, kHeight, 9), 30);
    write_jpeg(scratch / "photos/a.jpg", wavy_picture(kWidth, kHeight, 18), 95);  // Not cut out.
    SilentProgress progress;
    const IngestOptions half_size{.max_width_px = kWidth / 2, .min_width_px = 32};
    const IngestResult result =
        ingest(scratch / "photos", half_size, scratch / "copies", 2, progress);
    ASSERT_EQ(result.photographs.size(), 3U);
    const std::filesystem::path folder = cut_out_folder(scratch / "copies");
    const auto rows_of = [&](const std::string& name) {
        return black_rows(drawn_mask(name, kWidth / 2, kHeight / 2, folder));
    };
    EXPECT_EQ(rows_of("a.png"), 30);
    EXPECT_EQ(rows_of("more/a.png"), 15);
    EXPECT_EQ(rows_of("a.jpg"), 0);
}

TEST(CutOuts, AreForgottenWithThePhotographsThatHadThem) {
    const ScratchFolder scratch;
    write_cut_out_png(scratch / "photos/a.png", wavy_picture(kWidth, kHeight), 60);
    write_cut_out_png(scratch / "photos/b.png", wavy_picture(kWidth, kHeight, 9), 30);
    write_cut_out_png(scratch / "photos/same.png", wavy_picture(kWidth, kHeight), 60);
    SilentProgress progress;
    const IngestResult first = ingest(scratch / "photos", {}, scratch / "copies", 2, progress);
    ASSERT_EQ(first.photographs.size(), 2U);
    const std::filesystem::path folder = cut_out_folder(scratch / "copies");
    EXPECT_FALSE(mask_file_of("a.png", folder).empty());
    EXPECT_TRUE(mask_file_of("same.png", folder).empty()) << "left out";
    for (const char* name : {"a.png", "b.png", "same.png"})
        write_png(scratch / "photos" / name,
                  wavy_picture(kWidth, kHeight, name[0] == 'a' ? 27 : 36));
    static_cast<void>(ingest(scratch / "photos", {}, scratch / "copies", 2, progress));
    EXPECT_TRUE(cut_out_folder(scratch / "copies").empty());
}

TEST(CutOuts, WhatAllHideAlikeIsNoOutline) {
    const ScratchFolder scratch;
    for (int i = 0; i < 5; ++i)
        write_cut_out_png(scratch / ("photos/" + std::to_string(i) + ".png"),
                          wavy_picture(kWidth, kHeight, 9 * i), i == 0 ? 19 : 20);
    SilentProgress progress;
    const IngestResult result = ingest(scratch / "photos", {}, scratch / "copies", 2, progress);
    EXPECT_EQ(result.photographs.size(), 5U);
    EXPECT_TRUE(cut_out_folder(scratch / "copies").empty());
}

TEST(CutOuts, WhatIsHiddenInAllPhotographsIsNoBar) {
    for (const bool is_cut_out : {true, false}) {
        const ScratchFolder scratch;
        for (int i = 0; i < 12; ++i) {
            ColorImage picture = wavy_picture(kWidth, kHeight, 7 * i);
            for (int y = 0; y < 20; ++y) std::fill_n(picture.row(y), kWidth, Rgb8{});
            const auto path = scratch / ("photos/" + std::to_string(100 + i) + ".png");
            write_cut_out_png(path, picture, is_cut_out ? 20 + 4 * (i % 5) : 0);
        }
        SilentProgress progress;
        const IngestResult result = ingest(scratch / "photos", {}, scratch / "copies", 2, progress);
        ASSERT_EQ(result.photographs.size(), 12U);
        for (const Photograph& photograph : result.photographs)
            EXPECT_EQ(photograph.height_px == kHeight, is_cut_out) << photograph.height_px;
    }
}

}  // namespace
}  // namespace lumi
