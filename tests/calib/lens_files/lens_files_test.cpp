#include "calib/lens_files/lens_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

using testing::HasSubstr;

std::vector<Camera> lenses() {
    return {
        {640, 480, LensModel::kSimplePinhole, {560.123456789, 322.1, 237.7}},
        {640, 480, LensModel::kPinhole, {560.1, 561.2, 322.1, 237.7}},
        {640, 480, LensModel::kSimpleRadial, {560.1, 322.1, 237.7, -0.12}},
        {640, 480, LensModel::kRadial, {560.1, 322.1, 237.7, -0.12, 1e-9}},
        {640, 480, LensModel::kOpenCv, {560.1, 561.2, 322.1, 237.7, -0.1, 0.02, 1e-4, -2e-4}},
        {640, 480, LensModel::kOpenCvFisheye, {260.1, 261.2, 322.1, 237.7, 0.1, 0.02, 1e-4, 0}},
        {640,
         480,
         LensModel::kFullOpenCv,
         {560.1, 561.2, 322.1, 237.7, -0.1, 0.02, 1e-4, -2e-4, 0.3, 0.4, 0.5, 0.6}},
    };
}

void expect_same(const Camera& a, const Camera& b) {
    EXPECT_EQ(name_of(a.model), name_of(b.model));
    EXPECT_EQ(a.width_px, b.width_px);
    EXPECT_EQ(a.height_px, b.height_px);
    ASSERT_EQ(a.parameters.size(), b.parameters.size());
    for (std::size_t index = 0; index < a.parameters.size(); ++index) {
        EXPECT_NEAR(a.parameters[index], b.parameters[index], 1e-12 * 640) << index;
    }
}

TEST(LensFiles, EveryFormatIsReadBack) {
    const ScratchFolder folder;
    int round_trips = 0;
    for (const LensFormat format : kLensFormats) {
        const std::filesystem::path path = folder / std::string(usual_file_name(format));
        for (const Camera& lens : lenses()) {
            if (format == LensFormat::kKalibr && lens.model == LensModel::kFullOpenCv) continue;
            write_lens_file(path, lens, format, {"RMS 0.1 px", "f = 560 +- 1"});
            expect_same(read_lens_file(path), lens);
            ++round_trips;
        }
    }
    EXPECT_EQ(round_trips, 34);
}

TEST(LensFiles, AnEditorOfWindowsMayHaveSavedThem) {
    const ScratchFolder folder;
    const Camera lens = lenses()[4];
    for (const LensFormat format : kLensFormats) {
        std::string text = "\xef\xbb\xbf";
        for (const char letter : lens_text(lens, format, {"a remark"})) {
            if (letter == '\n') text += '\r';
            text += letter;
        }
        const auto path = folder / std::string(usual_file_name(format));
        write_whole_text(path, text);
        SCOPED_TRACE(name_of(format));
        expect_same(read_lens_file(path), lens);
    }
}

TEST(LensFiles, TomlAndColmapKeepEveryBit) {
    const ScratchFolder folder;
    for (const Camera& lens : lenses()) {
        for (const LensFormat format : {LensFormat::kToml, LensFormat::kColmap}) {
            const std::filesystem::path path = folder / std::string(usual_file_name(format));
            write_lens_file(path, lens, format);
            EXPECT_EQ(read_lens_file(path), lens);
        }
    }
}

TEST(LensFiles, HalfAPixelLiesBetweenOursAndOpenCvsPrincipalPoint) {
    const Camera lens{640, 480, LensModel::kSimplePinhole, {560, 320, 240}};
    EXPECT_THAT(lens_text(lens, LensFormat::kOpenCv), HasSubstr("560.0, 0.0, 319.5"));
    EXPECT_THAT(lens_text(lens, LensFormat::kKalibr), HasSubstr("[560.0, 560.0, 319.5, 239.5]"));
    EXPECT_THAT(lens_text(lens, LensFormat::kRos), HasSubstr("560.0, 0.0, 319.5"));
    EXPECT_THAT(lens_text(lens, LensFormat::kColmap),
                HasSubstr("1 SIMPLE_PINHOLE 640 480 560.0 320.0"));
}

TEST(LensFiles, KalibrHasNoWordsForARationalLens) {
    try {
        (void)lens_text(lenses().back(), LensFormat::kKalibr);
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-LENS-FORMAT");
    }
}

TEST(LensFiles, FilesOfTheOtherProgramsAreRead) {
    const ScratchFolder folder;
    // As cv::FileStorage of OpenCV's calibration sample writes it.
    folder.put_text("opencv.yml",
                    "%YAML:1.0\n---\ncalibration_time: \"now\"\nimage_width: 640\n"
                    "image_height: 480\nflags: 0\nfisheye_model: 0\n"
                    "camera_matrix: !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n"
                    "   data: [ 5.3e+02, 0., 3.4e+02, 0., 5.3e+02,\n       2.3e+02, 0., 0., 1. ]\n"
                    "distortion_coefficients: !!opencv-matrix\n   rows: 5\n   cols: 1\n   dt: d\n"
                    "   data: [ -2.8e-01, 9.0e-02, 1.2e-03, -5.0e-04, 0. ]\n");
    expect_same(
        read_lens_file(folder / "opencv.yml"),
        {640, 480, LensModel::kOpenCv, {530, 530, 340.5, 230.5, -0.28, 0.09, 1.2e-3, -5e-4}});
    folder.put_text("camchain-x.yaml",
                    "cam0:\n  cam_overlaps: []\n  camera_model: pinhole\n"
                    "  distortion_coeffs: [-0.1, 0.01, 0.001, 0.002]\n"
                    "  distortion_model: equidistant\n  intrinsics: [260.0, 261.0, 320.0, 240.0]\n"
                    "  resolution: [640, 480]\n  rostopic: /cam0/image_raw\n");
    expect_same(
        read_lens_file(folder / "camchain-x.yaml"),
        {640, 480, LensModel::kOpenCvFisheye, {260, 261, 320.5, 240.5, -0.1, 0.01, 0.001, 0.002}});
    folder.put_text("ost.yaml",
                    "image_width: 640\nimage_height: 480\ncamera_name: narrow_stereo\n"
                    "camera_matrix:\n  rows: 3\n  cols: 3\n"
                    "  data: [430.2, 0, 306.7, 0, 430.5, 227.2, 0, 0, 1]\n"
                    "distortion_model: plumb_bob\ndistortion_coefficients:\n  rows: 1\n  cols: 5\n"
                    "  data: [-0.33, 0.11, -0.0004, 0.0002, 0]\n");
    expect_same(
        read_lens_file(folder / "ost.yaml"),
        {640, 480, LensModel::kOpenCv, {430.2, 430.5, 307.2, 227.7, -0.33, 0.11, -0.0004, 0.0002}});
    folder.put_text("intrinsic.yaml",
                    "# Pinhole camera model\npinhole:\n  fx: 701.5\n  fy: 698.5\n  cx: 308.25\n"
                    "  cy: 246.5\n  width: 640\n  height: 480\n  skew: 0.0\n"
                    "model: pinhole_radial_tangential\nradial_tangential:\n  radial:\n  - -0.25\n"
                    "  - 0.1\n  t1: 0.0\n  t2: 0.0\n");
    expect_same(read_lens_file(folder / "intrinsic.yaml"),
                {640, 480, LensModel::kOpenCv, {701.5, 698.5, 308.75, 247, -0.25, 0.1, 0, 0}});
}

/// Code of the error that a file ends in; "" when it is read.
std::string code_of(const ScratchFolder& folder, const std::string& name, const std::string& text) {
    folder.put_text(name, text);
    try {
        (void)read_lens_file(folder / name);
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr(name));
        EXPECT_FALSE(error.advice().empty());
        return error.code();
    }
    return "";
}

TEST(LensFiles, EveryTruncationIsRefusedOrHarmless) {
    const ScratchFolder folder;
    const Camera lens = lenses()[4];
    int refused = 0;
    for (const LensFormat format : kLensFormats) {
        const std::string text = lens_text(lens, format);
        const std::string name(usual_file_name(format));
        for (std::size_t length = 0; length + 1 < text.size(); length += 3) {
            folder.put_text(name, text.substr(0, length));
            try {
                const Camera read = read_lens_file(folder / name);
                EXPECT_EQ(read.parameters.size(), parameter_count(read.model));
            } catch (const Error& error) {
                ++refused;
            }
        }
    }
    EXPECT_GT(refused, 300);
}

TEST(LensFiles, WhatContradictsItselfIsRefused) {
    const ScratchFolder folder;
    const std::string k = "camera_matrix: {rows: 3, cols: 3, data: [5, 0, 3, 0, 5, 2, 0, 0, 1]}\n";
    const std::string size = "image_width: 6\nimage_height: 4\n";
    const std::string none = "distortion_coefficients: {rows: 0, cols: 0, data: []}\n";
    EXPECT_EQ(code_of(folder, "a.yaml", size + k + none), "");
    EXPECT_EQ(code_of(folder, "a.yaml", k + none), "E-LENS-FILE");
    EXPECT_EQ(code_of(folder, "a.yaml", "image_width: 0\nimage_height: 4\n" + k + none),
              "E-CAMERA-INVALID");
    EXPECT_EQ(code_of(folder, "a.yaml", "image_width: 6.5\nimage_height: 4\n" + k + none),
              "E-LENS-FILE");
    for (const std::string data :
         {"[5, 1, 3, 0, 5, 2, 0, 0, 1]", "[5, 0, 3, 0, 5, 2, 0, 0, 2]", "[5, 0, 3, 0, 5, 2, 0, 0]",
          "[5, 0, .nan, 0, 5, 2, 0, 0, 1]", "[x, 0, 3, 0, 5, 2, 0, 0, 1]", "7"}) {
        EXPECT_EQ(code_of(folder, "a.yaml",
                          size + "camera_matrix: {rows: 3, cols: 3, data: " + data + "}\n" + none),
                  "E-LENS-FILE")
            << data;
    }
    const auto with = [&](const std::string& distortion) { return size + k + distortion; };
    EXPECT_EQ(code_of(folder, "a.yaml",
                      with("distortion_coefficients: {rows: 1, cols: 3, data: [1, 2, 3]}\n")),
              "E-LENS-FILE");
    EXPECT_EQ(code_of(folder, "a.yaml", with("distortion_model: unheard_of\n" + none)),
              "E-LENS-FILE");
    EXPECT_EQ(code_of(folder, "a.yaml", "- a\n- list\n"), "E-LENS-FILE");
    EXPECT_EQ(code_of(folder, "a.yaml", "a: [1, 2\n"), "E-LENS-FILE");
    EXPECT_EQ(code_of(folder, "a.yaml", ""), "E-LENS-FILE");
    EXPECT_EQ(code_of(folder, "a.yaml", "cam0: {camera_model: omni}\n"), "E-LENS-FILE");
    EXPECT_EQ(code_of(folder, "a.yaml", "cam0: {camera_model: pinhole}\ncam1: {}\n"),
              "E-LENS-FILE");
    const auto kalibr = [&](const std::string& resolution, const std::string& distortion) {
        return code_of(folder, "a.yaml",
                       "cam0: {camera_model: pinhole, intrinsics: [5, 5, 3, 2], resolution: [" +
                           resolution + "]" + distortion + "}\n");
    };
    EXPECT_EQ(kalibr("6, 4", ""), "");
    EXPECT_EQ(kalibr("6, 4", ", distortion_model: none, distortion_coeffs: [0, 0, 0, 0]"), "");
    for (const std::string resolution : {"6.7, 4", "6, 1e12", "6, .inf", "6", "6, 4, 3"}) {
        EXPECT_EQ(kalibr(resolution, ""), "E-LENS-FILE") << resolution;
    }
    EXPECT_EQ(kalibr("6, 4", ", distortion_coeffs: [0.1, 0, 0, 0]"), "E-LENS-FILE");
    EXPECT_EQ(kalibr("6, 4", ", distortion_model: none, distortion_coeffs: [0, 0, 0, 0.1]"),
              "E-LENS-FILE");
    EXPECT_EQ(code_of(folder, "cameras.txt", "# nothing\n"), "E-LENS-FILE");
    EXPECT_EQ(code_of(folder, "cameras.txt", "1 PINHOLE 6 4 5 5 3\n"), "E-CAMERA-INVALID");
    EXPECT_EQ(code_of(folder, "cameras.txt", "1 THIN_PRISM 6 4 5 5 3 2\n"), "E-LENS-FILE");
    EXPECT_EQ(code_of(folder, "cameras.txt", "1 PINHOLE 6 4 5 nan 3 2\n"), "E-LENS-FILE");
    EXPECT_EQ(code_of(folder, "cameras.txt", "1 PINHOLE 6 4 5 5 3 2\n2 PINHOLE 6 4 5 5 3 2\n"),
              "E-LENS-FILE");
    EXPECT_EQ(code_of(folder, "lens.json", "{}"), "E-LENS-FILE");
    EXPECT_EQ(code_of(folder, "lens.toml", "model = \"PINHOLE\"\nwidth_px = 6\n"),
              "E-CONFIG-VALUE");
}

}  // namespace
}  // namespace lumi
