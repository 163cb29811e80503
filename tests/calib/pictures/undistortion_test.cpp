#include "calib/pictures/undistortion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "calib/pictures/image_io.h"
#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "tests/calib/scratch_folder.h"
#include "tests/calib/synthetic_capture.h"

namespace lumi {
namespace {

constexpr int kWidth = 320;
constexpr int kHeight = 240;

/// A smooth world at infinity: its colour depends on the direction alone.
Rgb8 world_color(const Eigen::Vector3d& ray) {
    const auto wave = [](double phase) {
        return static_cast<std::uint8_t>(std::lround(128 + 100 * std::sin(phase)));
    };
    return {wave(9 * ray.x()), wave(9 * ray.y()), wave(5 * (ray.x() + ray.y()))};
}

ColorImage photograph_of_world(const Camera& camera) {
    ColorImage picture(camera.width_px, camera.height_px);
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            picture(x, y) = world_color(unproject(camera, {x + 0.5, y + 0.5}));
        }
    }
    return picture;
}

struct Undistorted {
    PosedPhotographs result;
    ColorImage first_picture;
};

Undistorted undistorted(const Capture& capture, const ScratchFolder& scratch, int threads = 2) {
    std::vector<std::filesystem::path> paths;
    for (std::size_t i = 0; i < capture.views.size(); ++i) {
        paths.push_back(scratch / ("copies/00000" + std::to_string(i + 1) + ".png"));
        write_png(paths.back(), photograph_of_world(camera_of(capture, capture.views[i])));
    }
    SilentProgress progress;
    Undistorted answer;
    answer.result = undistort(capture, paths, scratch / "straight", threads, progress);
    answer.first_picture = read_color_image(answer.result.picture_paths[0]);
    return answer;
}

std::vector<Camera> lenses() {
    return {
        {kWidth, kHeight, LensModel::kSimpleRadial, {260, 160, 120, -0.15}},
        {kWidth, kHeight, LensModel::kSimpleRadial, {260, 160, 120, 0.2}},
        {kWidth, kHeight, LensModel::kRadial, {260, 157, 124, -0.2, 0.08}},
        {kWidth, kHeight, LensModel::kOpenCv, {260, 265, 165, 118, 0.1, -0.3, 0.004, -0.003}},
        {kWidth, kHeight, LensModel::kOpenCvFisheye, {220, 220, 160, 120, 0.02, 0.0, 0.0, 0.0}}};
}

TEST(Undistortion, GivesThePictureThatAPinholeCameraWouldHaveTaken) {
    for (const Camera& lens : lenses()) {
        const ScratchFolder scratch;
        const auto [result, picture] = undistorted(synthetic_capture(lens, 1, 0), scratch);
        const Camera& pinhole = result.capture.cameras[0];
        EXPECT_EQ(pinhole.model, LensModel::kPinhole);
        ASSERT_EQ(picture.width(), kWidth);
        ASSERT_EQ(picture.height(), kHeight);
        const ColorImage expected = photograph_of_world(pinhole);
        int largest = 0;
        for (std::size_t i = 0; i < picture.pixels().size(); ++i) {
            const Rgb8& p = picture.pixels()[i];
            const Rgb8& q = expected.pixels()[i];
            largest =
                std::max({largest, std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)});
        }
        // Sources are rounded to 8 bits and bicubic positions to 1/32 pixel; a black border or a
        // shift by half a pixel would be far beyond.
        EXPECT_LE(largest, 3) << name_of(lens.model);
    }
}

TEST(Undistortion, EveryPixelComesFromThePhotographAndTheFrameCouldNotBeWider) {
    for (const Camera& lens : lenses()) {
        const ScratchFolder scratch;
        const Camera pinhole =
            undistorted(synthetic_capture(lens, 1, 0), scratch).result.capture.cameras[0];
        const auto outside_px = [&](const Camera& straight) {
            double farthest = 0;
            for (int y = 0; y <= kHeight; ++y) {
                for (int x = 0; x <= kWidth; ++x) {
                    if (x > 0 && x < kWidth && y > 0 && y < kHeight) continue;
                    const auto pixel =
                        project(lens, unproject(straight, {double(x), double(y)})).value();
                    farthest = std::max({farthest, -pixel.x(), -pixel.y(), pixel.x() - kWidth,
                                         pixel.y() - kHeight});
                }
            }
            return farthest;
        };
        EXPECT_LT(outside_px(pinhole), 0.05) << name_of(lens.model);
        Camera wider = pinhole;
        wider.parameters[0] *= 0.99;
        wider.parameters[1] *= 0.99;
        EXPECT_GT(outside_px(wider), 0.5) << name_of(lens.model);
    }
}

TEST(Undistortion, TracksMoveWithThePictures) {
    for (const Camera& lens : lenses()) {
        const ScratchFolder scratch;
        const Capture capture = undistorted(synthetic_capture(lens, 3, 10), scratch).result.capture;
        std::size_t observations = 0;
        for (const ScenePoint& point : capture.points) {
            for (const Observation& observation : point.track) {
                const View& view = capture.views[static_cast<std::size_t>(observation.view_index)];
                const auto pixel = project(camera_of(capture, view),
                                           view.cam_from_world * point.position_in_world);
                ASSERT_TRUE(pixel.has_value());
                EXPECT_LT((*pixel - observation.pixel).norm(), 1e-6) << name_of(lens.model);
                ++observations;
            }
        }
        EXPECT_GT(observations, 10U);
    }
}

TEST(Undistortion, LeavesPhotographsOfAPinholeAlone) {
    const ScratchFolder scratch;
    const Camera lens{kWidth, kHeight, LensModel::kSimpleRadial, {260, 160, 120, 0.0}};
    const auto [result, picture] = undistorted(synthetic_capture(lens, 1, 0), scratch);
    EXPECT_EQ(result.picture_paths[0], scratch / "copies/000001.png");
    EXPECT_EQ(result.capture.cameras[0],
              (Camera{kWidth, kHeight, LensModel::kPinhole, {260, 260, 160, 120}}));
    EXPECT_FALSE(std::filesystem::exists(scratch / "straight"));
}

TEST(Undistortion, GivesTheSameBytesForAnyNumberOfThreads) {
    const ScratchFolder scratch;
    const Capture capture = synthetic_capture(lenses()[0], 5, 0);
    const auto bytes = [&](int threads) {
        std::vector<Bytes> files;
        for (const auto& path : undistorted(capture, scratch, threads).result.picture_paths) {
            files.push_back(read_whole_file(path));
        }
        return files;
    };
    EXPECT_EQ(bytes(1), bytes(4));
}

TEST(Undistortion, RefusesALensThatFoldsWithinThePicture) {
    const ScratchFolder scratch;
    // r (1 - 2 r^2) turns back at r = 0.41, long before the corner at 0.77.
    const Camera lens{kWidth, kHeight, LensModel::kSimpleRadial, {260, 160, 120, -2.0}};
    try {
        static_cast<void>(undistorted(synthetic_capture(lens, 1, 0), scratch));
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-LENS-FOLDS");
    }
}

TEST(Undistortion, CutsAStraightPictureOutOfACircularFisheye) {
    // A circle of 80 degrees off the axis in a square picture: its corners are behind the camera.
    const Camera lens{240, 240, LensModel::kOpenCvFisheye, {86, 86, 120, 120, 0, 0, 0, 0}};
    const ScratchFolder scratch;
    ColorImage circle(240, 240);
    for (int y = 0; y < 240; ++y)
        for (int x = 0; x < 240; ++x)
            if (std::hypot(x + 0.5 - 120, y + 0.5 - 120) < 120) circle(x, y) = {200, 100, 50};
    write_png(scratch / "circle.png", circle);
    SilentProgress progress;
    const PosedPhotographs straight = undistort(
        synthetic_capture(lens, 1, 0), {scratch / "circle.png"}, scratch / "straight", 1, progress);
    EXPECT_EQ(straight.capture.cameras[0],
              (Camera{240, 240, LensModel::kPinhole, {43, 43, 120, 120}}));
    const ColorImage picture = read_color_image(straight.picture_paths[0]);
    for (const Rgb8& pixel : picture.pixels())
        ASSERT_EQ(pixel, (Rgb8{200, 100, 50})) << "nothing of the black around it";
}

TEST(Undistortion, RefusesAFisheyeThatFoldsBeforeItsCorners) {
    const Camera lens{240, 240, LensModel::kOpenCvFisheye, {86, 86, 120, 120, -0.5, 0, 0, 0}};
    const ScratchFolder scratch;
    write_png(scratch / "square.png", ColorImage(240, 240));
    SilentProgress progress;
    EXPECT_THROW(
        static_cast<void>(undistort(synthetic_capture(lens, 1, 0), {scratch / "square.png"},
                                    scratch / "straight", 1, progress)),
        Error);
}

TEST(Undistortion, RefusesAPictureOfAnotherSizeThanItsCamera) {
    const ScratchFolder scratch;
    const Capture capture = synthetic_capture(lenses()[0], 1, 0);
    write_png(scratch / "small.png", ColorImage(100, 80));
    SilentProgress progress;
    EXPECT_THROW(static_cast<void>(undistort(capture, {scratch / "small.png"}, scratch / "straight",
                                             1, progress)),
                 Error);
}

}  // namespace
}  // namespace lumi
