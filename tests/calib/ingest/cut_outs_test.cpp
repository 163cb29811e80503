#include "calib/ingest/cut_outs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
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

/// Before nothing: a disc with this middle.
void write_disc(const std::filesystem::path& path, int width, int height, double middle_x,
                double middle_y, double radius) {
    GrayImage alpha(width, height, 0);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            if (std::hypot(x - middle_x, y - middle_y) < radius) alpha(x, y) = 255;
        }
    }
    write_cut_out_png(path, wavy_picture(width, height, middle_x + width), alpha);
}

bool are_cut_out(const ScratchFolder& scratch) {
    SilentProgress progress;
    const IngestResult result = ingest(scratch / "photos", {}, scratch / "copies", 2, progress);
    EXPECT_GT(result.photographs.size(), 1U);
    return !cut_out_folder(scratch / "copies").empty();
}

TEST(CutOuts, OfEachSizeTheOutlinesAreCompared) {
    const ScratchFolder scratch;
    // Cropped to the subject: no two of one size.
    for (int i = 0; i < 4; ++i) {
        write_disc(scratch / ("photos/" + std::to_string(i) + ".png"), kWidth + 8 * i,
                   kHeight + 8 * i, 50 + 20 * i, 60, 40);
    }
    EXPECT_TRUE(are_cut_out(scratch));
    // One upright, the others not, and their outlines differ.
    const ScratchFolder upright;
    write_disc(upright / "photos/0.png", kHeight, kWidth, 60, 80, 70);
    for (int i = 1; i < 4; ++i) {
        write_disc(upright / ("photos/" + std::to_string(i) + ".png"), kWidth, kHeight, 40 + 20 * i,
                   60, 40);
    }
    EXPECT_TRUE(are_cut_out(upright));
}

/// No two of one size, and the same share hidden in each.
TEST(CutOuts, PhotographsThatWereCroppedToRoundSubjectsKeepThem) {
    const ScratchFolder cropped;
    const ScratchFolder straightened;
    for (int i = 0; i < 8; ++i) {
        const int width = kWidth + 6 * i;
        const int height = kHeight + 10 * i;
        GrayImage ellipse(width, height, 0);
        GrayImage rim(width, height, 255);
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                if (std::hypot((x + 0.5) / width - 0.5, (y + 0.5) / height - 0.5) < 0.5)
                    ellipse(x, y) = 255;
                if (y < 4) rim(x, y) = 0;
            }
        }
        const std::string name = "photos/" + std::to_string(i) + ".png";
        write_cut_out_png(cropped / name, wavy_picture(width, height, 7.0 * i), ellipse);
        write_cut_out_png(straightened / name, wavy_picture(width, height, 7.0 * i), rim);
    }
    EXPECT_TRUE(are_cut_out(cropped));
    EXPECT_FALSE(are_cut_out(straightened));
}

/// Programs may fit each picture that they straighten for itself.
TEST(CutOuts, ARimOfPhotographsOfSizesOfTheirOwnIsNoOutline) {
    const ScratchFolder scratch;
    for (int i = 0; i < 6; ++i) {
        const int width = kWidth + 6 * i;
        const int height = kHeight + 10 * i;
        GrayImage alpha(width, height, 0);
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const double across = 2 * (x + 0.5) / width - 1;
                const double down = 2 * (y + 0.5) / height - 1;
                // A pincushion: a sixth of the picture is hidden, mostly along its sides' middles.
                if (std::abs(across) < 0.85 + 0.15 * down * down &&
                    std::abs(down) < 0.9 + 0.1 * across * across)
                    alpha(x, y) = 255;
            }
        }
        write_cut_out_png(scratch / ("photos/" + std::to_string(i) + ".png"),
                          wavy_picture(width, height, 7.0 * i), alpha);
    }
    EXPECT_FALSE(are_cut_out(scratch));
}

TEST(CutOuts, OneAmongOpaquePhotographsIsOne) {
    const ScratchFolder scratch;
    write_disc(scratch / "photos/0.png", kWidth, kHeight, 80, 60, 60);
    for (int i = 1; i < 4; ++i) {
        write_png(scratch / ("photos/" + std::to_string(i) + ".png"),
                  wavy_picture(kWidth, kHeight, 9 * i));
    }
    EXPECT_TRUE(are_cut_out(scratch));
}

TEST(CutOuts, ARoundSubjectWhoseOutlineHardlyMovesIsOne) {
    const ScratchFolder scratch;
    for (int i = 0; i < 6; ++i) {
        write_disc(scratch / ("photos/" + std::to_string(i) + ".png"), kWidth, kHeight,
                   80 + 0.5 * i, 60, 40);
    }
    EXPECT_TRUE(are_cut_out(scratch));
}

TEST(CutOuts, WhatIsHiddenInTheMiddleIsNoRimThatStraighteningLeft) {
    const ScratchFolder scratch;
    for (int i = 0; i < 4; ++i) {
        GrayImage alpha(kWidth, kHeight, 255);
        for (int y = 50; y < 70; ++y) std::fill_n(alpha.row(y) + 70, 20, std::uint8_t{0});
        write_cut_out_png(scratch / ("photos/" + std::to_string(i) + ".png"),
                          wavy_picture(kWidth, kHeight, 9 * i), alpha);
    }
    EXPECT_TRUE(are_cut_out(scratch));
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
