#include "calib/ingest/color_notes.h"

#include <gmock/gmock.h>

#include "calib/ingest/ingest.h"
#include "calib/pictures/image_io.h"
#include "calib/pictures/lost_color.h"
#include "tests/calib/color_profiles.h"
#include "tests/calib/cut_out_pictures.h"
#include "tests/calib/scratch_folder.h"
#include "tests/calib/test_pictures.h"

namespace lumi {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Bytes bytes_of_jpeg(const ScratchFolder& scratch, double shift_px) {
    write_jpeg(scratch / "some.jpg", wavy_picture(160, 120, shift_px), 95);
    return read_whole_file(scratch / "some.jpg");
}

TEST(ColorNotes, SayFromWhatPhotographsWereConverted) {
    const ScratchFolder scratch;
    std::filesystem::create_directories(scratch / "photos");
    for (int i = 0; i < 3; ++i) {
        scratch.put("photos/" + std::to_string(i) + ".jpg",
                    jpeg_with_profile(bytes_of_jpeg(scratch, 9 * i), display_p3_profile()));
    }
    scratch.put("photos/plain.jpg", bytes_of_jpeg(scratch, 36));
    scratch.put("photos/broken.jpg", jpeg_with_profile(bytes_of_jpeg(scratch, 45), Bytes(200, 1)));
    SilentProgress progress;
    const IngestResult result = ingest(scratch / "photos", {}, scratch / "copies", 3, progress);
    EXPECT_THAT(result.color_notes,
                ElementsAre("3 photographs were converted from Display P3 to sRGB",
                            "1 photograph was taken as sRGB, for the embedded colour profile is "
                            "damaged (E-INGEST-PROFILE): broken.jpg"));
    ASSERT_EQ(result.photographs.size(), 5U);
    for (const Photograph& photograph : result.photographs) {
        EXPECT_EQ(read_color_image(photograph.picture_path),
                  read_color_image(scratch / ("photos/" + photograph.name)))
            << "features, package and evaluation all see the copy";
    }
}

TEST(ColorNotes, NothingIsSaidOfOrdinaryPhotographs) {
    const ScratchFolder scratch;
    write_png(scratch / "photos/a.png", wavy_picture(160, 120));
    write_png(scratch / "photos/b.png", wavy_picture(160, 120, 9));
    SilentProgress progress;
    EXPECT_THAT(ingest(scratch / "photos", {}, scratch / "copies", 2, progress).color_notes,
                IsEmpty());
}

TEST(ColorNotes, SayWhatIsCutOffAndWhatAlphaHides) {
    const ScratchFolder scratch;
    FloatImage light(160, 120, 0.25F);
    for (int x = 0; x < 160; ++x) light(x, 0) = light(x, 1) = light(x, 2) = 2.0F;
    std::filesystem::create_directories(scratch / "photos");
    write_float_tiff(scratch / "photos/light.tif", light);
    write_cut_out_png(scratch / "photos/half.png", wavy_picture(160, 120), 60);
    write_cut_out_png(scratch / "photos/quarter.png", wavy_picture(160, 120, 9), 30);
    write_cut_out_png(scratch / "photos/nothing.png", wavy_picture(160, 120, 18), 120);
    SilentProgress progress;
    const IngestResult result = ingest(scratch / "photos", {}, scratch / "copies", 2, progress);
    EXPECT_THAT(
        result.color_notes,
        ElementsAre("1 photograph was converted from linear light to sRGB",
                    "1 photograph is brighter than white (1.0) in places and cut off there: up to "
                    "2.5 % of the pixels, in light.tif",
                    HasSubstr("2 photographs are cut out by an alpha channel, and black where it "
                              "hides them: up to 50 % of the pixels, in half.png"),
                    HasSubstr("1 photograph is black and white, the others have colours: "
                              "light.tif")));
    ASSERT_EQ(result.left_out.size(), 1U);
    EXPECT_EQ(result.left_out[0].name, "nothing.png");
    EXPECT_EQ(result.left_out[0].code, "E-INGEST-HIDDEN");
}

TEST(ColorNotes, NameTheBlackAndWhiteAmongColoredPhotographsAndTheOtherWayRound) {
    const ScratchFolder scratch;
    for (int i = 0; i < 5; ++i) {
        const std::string name = std::to_string(i) + ".png";
        const ColorImage picture = wavy_picture(160, 120, 9 * i);
        write_png(scratch / ("one/" + name), i == 2 ? without_color(picture) : picture);
        write_png(scratch / ("four/" + name), i == 2 ? picture : without_color(picture));
        write_png(scratch / ("all/" + name), without_color(picture));
    }
    SilentProgress progress;
    const auto notes_of = [&](const char* folder) {
        return ingest(scratch / folder, {}, scratch / "copies", 2, progress).color_notes;
    };
    EXPECT_THAT(notes_of("one"), ElementsAre(HasSubstr("1 photograph is black and white, the "
                                                       "others have colours: 2.png")));
    EXPECT_THAT(notes_of("four"), ElementsAre(HasSubstr("1 photograph has colours, the others are "
                                                        "black and white: 2.png")));
    EXPECT_THAT(notes_of("all"), IsEmpty());
}

}  // namespace
}  // namespace lumi
