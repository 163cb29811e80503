#include "calib/capture/colmap_model.h"

#include <gmock/gmock.h>

#include <cstring>

#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "tests/calib/scratch_folder.h"
#include "tests/calib/synthetic_capture.h"

namespace lumi {
namespace {

using ::testing::AnyOf;
using ::testing::HasSubstr;

Capture small_capture(int views = 3, int points = 5) {
    const Camera camera{640, 480, LensModel::kSimpleRadial, {500.1, 320.3, 239.7, -0.0123}};
    Capture capture = synthetic_capture(camera, views, points);
    capture.cameras.push_back({320, 200, LensModel::kPinhole, {1.0 / 3, 510, 160, 100}});
    capture.views.back().camera_index = 1;
    return capture;
}

void expect_equal_to_the_bit(const Capture& a, const Capture& b) {
    EXPECT_EQ(a.cameras, b.cameras);
    ASSERT_EQ(a.views.size(), b.views.size());
    for (std::size_t i = 0; i < a.views.size(); ++i) {
        EXPECT_EQ(a.views[i].name, b.views[i].name);
        EXPECT_EQ(a.views[i].camera_index, b.views[i].camera_index);
        EXPECT_EQ(a.views[i].cam_from_world.rotation.coeffs(),
                  b.views[i].cam_from_world.rotation.coeffs());
        EXPECT_EQ(a.views[i].cam_from_world.translation, b.views[i].cam_from_world.translation);
    }
    ASSERT_EQ(a.points.size(), b.points.size());
    for (std::size_t i = 0; i < a.points.size(); ++i) {
        EXPECT_EQ(a.points[i].position_in_world, b.points[i].position_in_world);
        EXPECT_EQ(a.points[i].color, b.points[i].color);
        EXPECT_EQ(a.points[i].error_px, b.points[i].error_px);
        ASSERT_EQ(a.points[i].track.size(), b.points[i].track.size());
        for (std::size_t k = 0; k < a.points[i].track.size(); ++k) {
            EXPECT_EQ(a.points[i].track[k].view_index, b.points[i].track[k].view_index);
            EXPECT_EQ(a.points[i].track[k].pixel, b.points[i].track[k].pixel);
        }
    }
}

std::string code_of_reading(const std::filesystem::path& folder) {
    try {
        static_cast<void>(read_colmap_model(folder));
    } catch (const Error& error) {
        return error.code();
    }
    return "none";
}

TEST(ColmapModel, BothFormsKeepEveryBit) {
    const ScratchFolder scratch;
    const Capture capture = small_capture();
    write_colmap_model_binary(capture, scratch / "binary");
    write_colmap_model_text(capture, scratch / "text");
    expect_equal_to_the_bit(read_colmap_model(scratch / "binary"), capture);
    expect_equal_to_the_bit(read_colmap_model(scratch / "text"), capture);
}

TEST(ColmapModel, TextMayBeginWithAByteOrderMark) {
    const ScratchFolder scratch;
    const Capture capture = small_capture();
    write_colmap_model_text(capture, scratch.path());
    for (const char* name : {"cameras.txt", "images.txt", "points3D.txt"})
        write_whole_text(scratch / name, "\xEF\xBB\xBF" + read_whole_text(scratch / name));
    expect_equal_to_the_bit(read_colmap_model(scratch.path()), capture);
}

TEST(ColmapModel, KeepsNamesWithBlanksFoldersAndUnicode) {
    const ScratchFolder scratch;
    Capture capture = small_capture(4);
    capture.views[0].name = "a b/my photo (1).jpg";
    capture.views[1].name = "c/two  blanks.jpg";
    capture.views[2].name = "ünï-日本.jpg";
    capture.views[3].name = "ü#hash.jpg";
    std::sort(capture.views.begin(), capture.views.end(),
              [](const View& a, const View& b) { return a.name < b.name; });
    write_colmap_model_binary(capture, scratch / "binary");
    write_colmap_model_text(capture, scratch / "text");
    expect_equal_to_the_bit(read_colmap_model(scratch / "binary"), capture);
    expect_equal_to_the_bit(read_colmap_model(scratch / "text"), capture);
}

TEST(ColmapModel, TextRefusesToWriteANameThatItCannotCarry) {
    const ScratchFolder scratch;
    Capture capture = small_capture(1);
    for (const std::string name : {"line\nbreak.jpg", " leading.jpg", "trailing ", "tab\t"}) {
        capture.views[0].name = name;
        EXPECT_THROW(write_colmap_model_text(capture, scratch / "text"), Error) << name;
        write_colmap_model_binary(capture, scratch / "binary");
        EXPECT_EQ(read_colmap_model(scratch / "binary").views[0].name, name);
    }
}

TEST(ColmapModel, ReadsTextAsColmapWritesIt) {
    const ScratchFolder scratch;
    scratch.put_text("cameras.txt",
                     "# Camera list\n# Number of cameras: 1\n7 PINHOLE 640 480 500 500 320 240\n");
    // An image without keypoints has an empty second line; six digits leave the norm of a
    // quaternion off by rounding; a keypoint without a point has -1; lines may end in CR LF.
    scratch.put_text("images.txt",
                     "# Image list\r\n"
                     "12 0.998750 0.049979 0 0 1 2 3 7 b.jpg\r\n"
                     "\r\n"
                     "3 1 0 0 0 0 0 0 7 a.jpg\n"
                     "10.5 20.5 -1 30.25 40.75 99\n");
    scratch.put_text("points3D.txt", "# Points\n99 0.1 0.2 5 10 20 30 0.5 3 1\n");
    const Capture capture = read_colmap_model(scratch.path());
    ASSERT_EQ(capture.views.size(), 2U);
    EXPECT_EQ(capture.views[0].name, "a.jpg");
    EXPECT_EQ(capture.views[1].name, "b.jpg");
    EXPECT_NEAR(capture.views[1].cam_from_world.rotation.norm(), 1.0, 1e-15);
    ASSERT_EQ(capture.points.size(), 1U);
    ASSERT_EQ(capture.points[0].track.size(), 1U);
    EXPECT_EQ(capture.points[0].track[0].view_index, 0);
    EXPECT_EQ(capture.points[0].track[0].pixel, Eigen::Vector2d(30.25, 40.75));
}

TEST(ColmapModel, PointsMayBeMissing) {
    const ScratchFolder scratch;
    write_colmap_model_binary(small_capture(), scratch.path());
    std::filesystem::remove(scratch / "points3D.bin");
    EXPECT_EQ(read_colmap_model(scratch.path()).views.size(), 3U);
    EXPECT_TRUE(read_colmap_model(scratch.path()).points.empty());
}

TEST(ColmapModel, RefusesEveryTruncationOfABinaryFile) {
    const ScratchFolder scratch;
    write_colmap_model_binary(small_capture(2, 2), scratch.path());
    for (const std::string file : {"cameras.bin", "images.bin", "points3D.bin"}) {
        const Bytes whole = read_whole_file(scratch / file);
        ASSERT_GT(whole.size(), 8U);
        for (std::size_t length = 0; length < whole.size(); ++length) {
            scratch.put(file, std::span(whole).first(length));
            EXPECT_EQ(code_of_reading(scratch.path()), "E-COLMAP-MODEL") << file << " " << length;
        }
        scratch.put(file, whole);
    }
    EXPECT_EQ(code_of_reading(scratch.path()), "none");
}

TEST(ColmapModel, RefusesBytesAfterTheLastRecord) {
    const ScratchFolder scratch;
    write_colmap_model_binary(small_capture(), scratch.path());
    for (const std::string file : {"cameras.bin", "images.bin", "points3D.bin"}) {
        const Bytes whole = read_whole_file(scratch / file);
        Bytes longer = whole;
        longer.push_back(0);
        scratch.put(file, longer);
        EXPECT_EQ(code_of_reading(scratch.path()), "E-COLMAP-MODEL") << file;
        scratch.put(file, whole);
    }
}

TEST(ColmapModel, RefusesHugeCountsBeforeTakingMemory) {
    const ScratchFolder scratch;
    write_colmap_model_binary(small_capture(1, 1), scratch.path());
    for (const std::string file : {"cameras.bin", "images.bin", "points3D.bin"}) {
        const Bytes whole = read_whole_file(scratch / file);
        // Every run of eight bytes is tried as a count: that covers records, keypoints and tracks.
        for (std::size_t offset = 0; offset + 8 <= whole.size(); ++offset) {
            Bytes huge = whole;
            constexpr std::uint64_t kCount = std::uint64_t{1} << 62;
            std::memcpy(&huge[offset], &kCount, 8);
            scratch.put(file, huge);
            EXPECT_THAT(code_of_reading(scratch.path()),
                        AnyOf("E-COLMAP-MODEL", "E-CAPTURE-INVALID", "E-CAMERA-INVALID", "none"))
                << file << " at " << offset;
            if (offset == 0) {
                EXPECT_EQ(code_of_reading(scratch.path()), "E-COLMAP-MODEL");
            }
        }
        scratch.put(file, whole);
    }
}

TEST(ColmapModel, RefusesNumbersThatAreNotFinite) {
    const ScratchFolder scratch;
    const Capture good = small_capture();
    const auto code_of = [&](const Capture& capture) {
        write_colmap_model_binary(capture, scratch / "binary");
        return code_of_reading(scratch / "binary");
    };
    const double nan = std::nan("");
    Capture capture = good;
    EXPECT_EQ(code_of(capture), "none");
    capture.cameras[0].parameters[0] = nan;
    EXPECT_EQ(code_of(capture), "E-CAMERA-INVALID");
    capture = good;
    capture.views[0].cam_from_world.translation.x() = nan;
    EXPECT_EQ(code_of(capture), "E-CAPTURE-INVALID");
    capture = good;
    capture.views[0].cam_from_world.rotation.x() = nan;
    EXPECT_EQ(code_of(capture), "E-CAPTURE-INVALID");
    capture = good;
    capture.points[0].position_in_world.z() = nan;
    EXPECT_EQ(code_of(capture), "E-CAPTURE-INVALID");
    write_colmap_model_text(good, scratch / "text");
    std::string cameras = read_whole_text(scratch / "text/cameras.txt");
    cameras.replace(cameras.find("500.1"), 5, "nan");
    write_whole_text(scratch / "text/cameras.txt", cameras);
    EXPECT_EQ(code_of_reading(scratch / "text"), "E-COLMAP-MODEL");
}

TEST(ColmapModel, RefusesTextWithLineAndReason) {
    const ScratchFolder scratch;
    const auto refusal = [&](const std::string& cameras, const std::string& images) -> std::string {
        scratch.put_text("cameras.txt", cameras);
        scratch.put_text("images.txt", images);
        try {
            static_cast<void>(read_colmap_model(scratch.path()));
        } catch (const Error& error) {
            return error.what();
        }
        return "none";
    };
    const std::string camera = "1 PINHOLE 640 480 500 500 320 240\n";
    const std::string image = "1 1 0 0 0 0 0 0 1 a.jpg\n\n";
    EXPECT_EQ(refusal(camera, image), "none");
    EXPECT_THAT(refusal("# c\n1 MAGIC 640 480 500\n", image), HasSubstr("cameras.txt:2"));
    EXPECT_THAT(refusal(camera + camera, image), HasSubstr("cameras.txt:2"));
    EXPECT_THAT(refusal("1 PINHOLE 640 480 500\n", image), HasSubstr("camera 1"));
    EXPECT_THAT(refusal(camera, "1 1 0 0 0 0 0 x 1 a.jpg\n\n"), HasSubstr("images.txt:1"));
    EXPECT_THAT(refusal(camera, "1 1 0 0 0 0 0 0 2 a.jpg\n\n"), HasSubstr("camera 2"));
    EXPECT_THAT(refusal(camera, "1 2 0 0 0 0 0 0 1 a.jpg\n\n"), HasSubstr("a.jpg"));
    EXPECT_THAT(refusal(camera, image + "2 1 0 0 0 0 0 0 1 a.jpg\n\n"), HasSubstr("a.jpg"));
    EXPECT_THAT(refusal(camera, "1 1 0 0 0 0 0 0 1 a.jpg\n1 2\n"), HasSubstr("images.txt:2"));
}

TEST(ColmapModel, ALensOfColmapThatLumiLacksIsNamedWithAWayOut) {
    const ScratchFolder scratch;
    const auto expect_named = [](const std::filesystem::path& folder) {
        try {
            static_cast<void>(read_colmap_model(folder));
            FAIL() << "nothing thrown";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), "E-COLMAP-LENS");
            EXPECT_THAT(error.what(), AllOf(HasSubstr("cameras."), HasSubstr("camera 1 "),
                                            HasSubstr(" RADIAL_FISHEYE")));
            EXPECT_THAT(error.advice(),
                        AllOf(HasSubstr("colmap image_undistorter"), HasSubstr("OPENCV_FISHEYE")));
        }
    };
    write_colmap_model_text(small_capture(1, 1), scratch / "text");
    write_whole_text(scratch / "text/cameras.txt", "1 RADIAL_FISHEYE 640 480 500 320 240 0.1 0\n");
    expect_named(scratch / "text");
    write_colmap_model_binary(small_capture(1, 1), scratch / "binary");
    Bytes cameras = read_whole_file(scratch / "binary/cameras.bin");
    cameras.at(8 + 4) = 9;  // The model of the first, behind the count and its id.
    write_whole_file(scratch / "binary/cameras.bin", cameras);
    expect_named(scratch / "binary");
}

TEST(ColmapModel, RefusesTracksThatLeadNowhere) {
    const ScratchFolder scratch;
    write_colmap_model_text(small_capture(2, 1), scratch.path());
    for (const std::string track : {"9 0", "1 5", "1"}) {
        scratch.put_text("points3D.txt", "1 0 0 0 1 2 3 0.5 " + track + "\n");
        EXPECT_EQ(code_of_reading(scratch.path()), "E-COLMAP-MODEL") << track;
    }
}

TEST(ColmapModel, RefusesAFolderWithoutAModel) {
    const ScratchFolder scratch;
    EXPECT_EQ(code_of_reading(scratch.path()), "E-COLMAP-MODEL");
    EXPECT_EQ(code_of_reading(scratch / "nowhere"), "E-COLMAP-MODEL");
}

TEST(ColmapModel, ColmapReadsWhatIsWrittenAndIsReadBack) {
    if (std::system("colmap help >/dev/null 2>&1") != 0) GTEST_SKIP() << "colmap is not installed";
    const ScratchFolder scratch;
    const Capture capture = small_capture();
    write_colmap_model_binary(capture, scratch / "binary");
    std::filesystem::create_directories(scratch / "text");
    const auto convert = [&](const std::string& from, const std::string& to,
                             const std::string& type) {
        std::filesystem::create_directories(scratch / to);
        const std::string command = "colmap model_converter --input_path '" +
                                    (scratch / from).string() + "' --output_path '" +
                                    (scratch / to).string() + "' --output_type " + type +
                                    " >/dev/null 2>&1";
        ASSERT_EQ(std::system(command.c_str()), 0);
    };
    convert("binary", "again", "BIN");
    expect_equal_to_the_bit(read_colmap_model(scratch / "again"), capture);
    convert("binary", "text", "TXT");
    const Capture text = read_colmap_model(scratch / "text");
    ASSERT_EQ(text.views.size(), capture.views.size());
    EXPECT_EQ(text.views[1].name, "view 001.jpg");
    EXPECT_LT(
        (text.views[1].cam_from_world.translation - capture.views[1].cam_from_world.translation)
            .norm(),
        1e-12);
}

}  // namespace
}  // namespace lumi
