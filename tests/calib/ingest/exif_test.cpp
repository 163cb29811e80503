#include "calib/ingest/exif.h"

#include <OpenImageIO/imageio.h>
#include <OpenImageIO/tiffutils.h>
#include <gtest/gtest.h>

#include "calib/ingest/ingest.h"
#include "calib/pictures/image_io.h"
#include "tests/calib/heif_pictures.h"
#include "tests/calib/scratch_folder.h"
#include "tests/calib/test_pictures.h"
#include "tests/calib/webp_pictures.h"

namespace lumi {
namespace {

/// A JPEG as a camera writes it, with `describe` adding what stands beside the raster.
template <class Describe>
void write_camera_jpeg(const std::filesystem::path& path, const ColorImage& picture,
                       const Describe& describe) {
    OIIO::ImageSpec spec(picture.width(), picture.height(), 3, OIIO::TypeDesc::UINT8);
    describe(spec);
    std::filesystem::create_directories(path.parent_path());
    const auto output = OIIO::ImageOutput::create("jpeg");
    ASSERT_TRUE(output->open(path.string(), spec));
    ASSERT_TRUE(output->write_image(OIIO::TypeDesc::UINT8, picture.row(0)));
    ASSERT_TRUE(output->close());
}

TEST(Exif, KeepsTheOrientationAndNeverTurnsTheRaster) {
    const ScratchFolder scratch;
    for (int orientation = 1; orientation <= 8; ++orientation) {
        write_camera_jpeg(scratch / ("photos/" + std::to_string(orientation) + ".jpg"),
                          wavy_picture(160, 120, 9 * orientation), [&](OIIO::ImageSpec& spec) {
                              spec.attribute("Orientation", orientation);
                          });
    }
    SilentProgress progress;
    const IngestResult result = ingest(scratch / "photos", {}, scratch / "copies", 2, progress);
    ASSERT_EQ(result.photographs.size(), 8U);
    for (int orientation = 1; orientation <= 8; ++orientation) {
        const Photograph& photograph =
            result.photographs[static_cast<std::size_t>(orientation - 1)];
        EXPECT_EQ(photograph.exif_orientation, orientation);
        EXPECT_EQ(photograph.width_px, 160);
        EXPECT_EQ(photograph.height_px, 120);
        EXPECT_EQ(read_color_image(photograph.picture_path),
                  read_color_image(scratch / ("photos/" + photograph.name)));
    }
}

TEST(Exif, ReadsWhatTheCameraWrote) {
    const ScratchFolder scratch;
    write_camera_jpeg(scratch / "photo.jpg", wavy_picture(160, 120), [](OIIO::ImageSpec& spec) {
        spec.attribute("Make", "Maker  ");
        spec.attribute("Model", "One");
        spec.attribute("Exif:FocalLength", 4.25F);
        spec.attribute("Exif:FocalLengthIn35mmFilm", 26);
        spec.attribute("Exif:PixelXDimension", 1600);
        spec.attribute("Exif:PixelYDimension", 1200);
    });
    const ExifFacts exif = read_exif(scratch / "photo.jpg", ImageFormat::kJpeg);
    EXPECT_EQ(exif.make, "Maker");
    EXPECT_EQ(exif.model, "One");
    EXPECT_NEAR(exif.focal_length_mm.value(), 4.25, 1e-4);
    EXPECT_EQ(exif.focal_length_35mm_equivalent_mm, 26.0);
    EXPECT_EQ(camera_key_of(exif, {160, 120}), "160x120 Maker One 4.25 mm (26 mm)");
    // The 160 x 120 raster has a diagonal of exactly 200 pixels.
    EXPECT_NEAR(focal_length_px_of(exif, {160, 120}).value(), 26 * 200 / 43.2666, 1e-3);
}

TEST(Exif, NamesOfCamerasInOtherEncodingsCanBeReported) {
    const ScratchFolder scratch;
    write_camera_jpeg(scratch / "photo.jpg", wavy_picture(160, 120), [](OIIO::ImageSpec& spec) {
        spec.attribute("Make", "Maker");
        spec.attribute("Model", "Cam\xe9ra 5");
    });
    EXPECT_EQ(read_exif(scratch / "photo.jpg", ImageFormat::kJpeg).model, "Cam\\xe9ra 5");
}

TEST(Exif, HeifAndWebPSayAsMuchAsAJpeg) {
    const ScratchFolder scratch;
    OIIO::ImageSpec spec;
    spec.attribute("Make", "Maker");
    spec.attribute("Model", "One");
    spec.attribute("Orientation", 6);
    spec.attribute("Exif:FocalLength", 4.25F);
    spec.attribute("Exif:FocalLengthIn35mmFilm", 26);
    std::vector<char> encoded;
    OIIO::encode_exif(spec, encoded);
    const Bytes exif(encoded.begin(), encoded.end());
    const ColorImage picture = wavy_picture(160, 120);
    scratch.put("photo.heic", heif_of(picture, {.exif = exif}));
    scratch.put("photo.webp", webp_with(webp_of(picture), 160, 120, {}, exif));
    for (const auto& [name, format] : {std::pair("photo.heic", ImageFormat::kHeif),
                                       std::pair("photo.webp", ImageFormat::kWebp)}) {
        const ExifFacts facts = read_exif(scratch / name, format);
        EXPECT_EQ(facts.make, "Maker") << name;
        EXPECT_EQ(facts.model, "One") << name;
        EXPECT_EQ(facts.orientation, 6) << name;
        EXPECT_NEAR(facts.focal_length_mm.value_or(0), 4.25, 1e-6) << name;
        EXPECT_EQ(facts.focal_length_35mm_equivalent_mm.value_or(0), 26) << name;
    }
    scratch.put("bare.heic", heif_of(picture));
    scratch.put("bare.webp", webp_of(picture));
    EXPECT_EQ(read_exif(scratch / "bare.heic", ImageFormat::kHeif).make, "");
    EXPECT_EQ(read_exif(scratch / "bare.webp", ImageFormat::kWebp).make, "");
}

TEST(Exif, AFileWithoutItHasNoFocalLength) {
    const ScratchFolder scratch;
    write_jpeg(scratch / "plain.jpg", wavy_picture(160, 120), 90);
    const ExifFacts exif = read_exif(scratch / "plain.jpg", ImageFormat::kJpeg);
    EXPECT_EQ(exif.orientation, 1);
    EXPECT_FALSE(focal_length_px_of(exif, {160, 120}).has_value());
    EXPECT_EQ(camera_key_of(exif, {160, 120}), "160x120");
}

TEST(Exif, PhotographsOfAnotherZoomHaveAnotherKey) {
    ExifFacts wide;
    wide.make = "Maker";
    wide.model = "Zoom";
    wide.focal_length_mm = 18;
    ExifFacts tele = wide;
    tele.focal_length_mm = 55;
    EXPECT_NE(camera_key_of(wide, {160, 120}), camera_key_of(tele, {160, 120}));
    // A telephone's digital zoom changes the equivalent alone; some cameras write nothing else.
    ExifFacts digital = wide;
    wide.focal_length_35mm_equivalent_mm = 26;
    digital.focal_length_35mm_equivalent_mm = 52;
    EXPECT_NE(camera_key_of(wide, {160, 120}), camera_key_of(digital, {160, 120}));
    wide.focal_length_mm.reset();
    digital.focal_length_mm.reset();
    EXPECT_NE(camera_key_of(wide, {160, 120}), camera_key_of(digital, {160, 120}));
    EXPECT_NE(camera_key_of(wide, {160, 120}), camera_key_of(wide, {120, 160}));
}

TEST(Exif, FocalLengthFollowsThePixelPitchAndTheScaleSinceTheShot) {
    ExifFacts exif;
    exif.focal_length_mm = 50;
    exif.focal_plane_pixels_per_mm = 200;
    exif.size_as_shot = {4800, 3200};
    EXPECT_NEAR(focal_length_px_of(exif, {4800, 3200}).value(), 10000, 1e-9);
    EXPECT_NEAR(focal_length_px_of(exif, {1200, 800}).value(), 2500, 1e-9);
    EXPECT_NEAR(focal_length_px_of(exif, {800, 1200}).value(), 2500, 1e-9) << "turned";
}

TEST(Exif, APixelPitchSaysNothingOfARasterThatMayHaveBeenScaled) {
    ExifFacts exif;
    exif.focal_length_mm = 50;
    exif.focal_plane_pixels_per_mm = 200;
    EXPECT_FALSE(focal_length_px_of(exif, {4800, 3200}).has_value());
    exif.focal_length_35mm_equivalent_mm = 50;
    EXPECT_TRUE(focal_length_px_of(exif, {4800, 3200}).has_value()) << "whatever its scale";
}

TEST(Exif, ACroppedRasterOrAnImpossibleLensHasNoFocalLength) {
    ExifFacts exif;
    exif.focal_length_35mm_equivalent_mm = 50;
    exif.size_as_shot = {4000, 3000};
    EXPECT_TRUE(focal_length_px_of(exif, {1000, 750}).has_value());
    EXPECT_FALSE(focal_length_px_of(exif, {1000, 1000}).has_value());
    exif.focal_length_35mm_equivalent_mm = 1;
    EXPECT_FALSE(focal_length_px_of(exif, {1000, 750}).has_value());
    exif.focal_length_35mm_equivalent_mm = 65535;
    EXPECT_FALSE(focal_length_px_of(exif, {1000, 750}).has_value());
}

TEST(Exif, FocalLengthIsForTheWorkingCopy) {
    const ScratchFolder scratch;
    for (int i = 0; i < 2; ++i) {
        write_camera_jpeg(
            scratch / ("photos/" + std::to_string(i) + ".jpg"), wavy_picture(400, 300, 9 * i),
            [](OIIO::ImageSpec& spec) { spec.attribute("Exif:FocalLengthIn35mmFilm", 30); });
    }
    SilentProgress progress;
    const IngestResult result =
        ingest(scratch / "photos", {.max_width_px = 200}, scratch / "copies", 1, progress);
    // The working copy of 200 x 150 pixels has a diagonal of 250.
    EXPECT_NEAR(result.photographs.at(0).focal_length_px.value(), 30 * 250 / 43.2666, 1e-3);
}

}  // namespace
}  // namespace lumi
