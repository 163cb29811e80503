#include "calib/capture/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/calib3d.hpp>

#include "calib/work/error.h"

namespace lumi {
namespace {

std::vector<Camera> one_of_each_model() {
    return {{640, 480, LensModel::kSimplePinhole, {500, 320, 240}},
            {640, 480, LensModel::kPinhole, {500, 510, 321, 239}},
            {640, 480, LensModel::kSimpleRadial, {500, 321, 239, -0.12}},
            {640, 480, LensModel::kRadial, {500, 321, 239, -0.1, 0.03}},
            {640, 480, LensModel::kOpenCv, {500, 510, 321, 239, -0.1, 0.03, 0.002, -0.001}},
            {640, 480, LensModel::kOpenCvFisheye, {300, 310, 321, 239, 0.02, -0.01, 0.003, -0.001}},
            {640,
             480,
             LensModel::kFullOpenCv,
             {500, 510, 321, 239, -0.1, 0.03, 0.002, -0.001, 0.01, 0.02, 0.01, 0.005}}};
}

std::vector<Eigen::Vector2d> pixel_grid(const Camera& camera) {
    std::vector<Eigen::Vector2d> pixels;
    for (int y = 0; y <= 6; ++y) {
        for (int x = 0; x <= 8; ++x) {
            pixels.emplace_back(x * camera.width_px / 8.0, y * camera.height_px / 6.0);
        }
    }
    return pixels;
}

TEST(Camera, ProjectInvertsUnprojectForEveryModel) {
    for (const Camera& camera : one_of_each_model()) {
        for (const Eigen::Vector2d& pixel : pixel_grid(camera)) {
            const auto again = project(camera, 3.0 * unproject(camera, pixel));
            ASSERT_TRUE(again.has_value());
            EXPECT_LT((*again - pixel).norm(), 1e-8)
                << name_of(camera.model) << " at " << pixel.transpose();
        }
    }
}

TEST(Camera, PinholeIsTheTextbookFormula) {
    const Camera camera{640, 480, LensModel::kPinhole, {500, 510, 321, 239}};
    const auto pixel = project(camera, {0.2, -0.1, 2.0});
    ASSERT_TRUE(pixel.has_value());
    EXPECT_DOUBLE_EQ(pixel->x(), 500 * 0.1 + 321);
    EXPECT_DOUBLE_EQ(pixel->y(), 510 * -0.05 + 239);
}

TEST(Camera, DistortionAgreesWithOpenCv) {
    const std::vector<cv::Point3d> points{{0.3, 0.2, 1.0}, {-0.5, 0.4, 1.2}, {0.1, -0.6, 2.0}};
    const cv::Vec3d zero(0, 0, 0);
    for (const Camera& camera : one_of_each_model()) {
        if (camera.parameters.size() < 8) continue;
        const auto& p = camera.parameters;
        const cv::Matx33d calibration(p[0], 0, p[2], 0, p[1], p[3], 0, 0, 1);
        const std::vector<double> distortion(p.begin() + 4, p.end());
        std::vector<cv::Point2d> expected;
        if (camera.model == LensModel::kOpenCvFisheye) {
            cv::fisheye::projectPoints(points, expected, zero, zero, calibration, distortion);
        } else {
            cv::projectPoints(points, zero, zero, calibration, distortion, expected);
        }
        for (std::size_t i = 0; i < points.size(); ++i) {
            const auto pixel = project(camera, {points[i].x, points[i].y, points[i].z});
            ASSERT_TRUE(pixel.has_value());
            EXPECT_NEAR(pixel->x(), expected[i].x, 1e-9) << name_of(camera.model);
            EXPECT_NEAR(pixel->y(), expected[i].y, 1e-9) << name_of(camera.model);
        }
    }
}

TEST(Camera, SeesNothingBehindIt) {
    for (const Camera& camera : one_of_each_model()) {
        EXPECT_FALSE(project(camera, {0.1, 0.1, -1.0}).has_value());
        EXPECT_FALSE(project(camera, {0.1, 0.1, 0.0}).has_value());
        EXPECT_FALSE(project(camera, {0.1, 0.1, std::nan("")}).has_value());
    }
}

TEST(Camera, AResizedLensSeesThePointAtTheScaledPixel) {
    const Eigen::Vector3d point(0.31, -0.22, 1.1);
    for (const Camera& camera : one_of_each_model()) {
        const Camera half = resized(camera, 320, 240);
        const Eigen::Vector2d expected = 0.5 * project(camera, point).value();
        EXPECT_LT((project(half, point).value() - expected).norm(), 1e-12) << name_of(camera.model);
        EXPECT_EQ(resized(half, 640, 480), camera);
    }
}

TEST(Camera, IsPinholeOnlyWithoutDistortion) {
    for (Camera camera : one_of_each_model()) {
        const bool has_no_distortion =
            camera.model == LensModel::kSimplePinhole || camera.model == LensModel::kPinhole;
        EXPECT_EQ(is_pinhole(camera), has_no_distortion) << name_of(camera.model);
        const std::size_t first =
            camera.model == LensModel::kSimpleRadial || camera.model == LensModel::kRadial ? 3 : 4;
        for (std::size_t i = first; i < camera.parameters.size(); ++i) camera.parameters[i] = 0;
        // An equidistant lens bends lines even with all coefficients zero.
        EXPECT_EQ(is_pinhole(camera), camera.model != LensModel::kOpenCvFisheye);
    }
}

TEST(Camera, ModelNamesAndIdsAreColmaps) {
    EXPECT_EQ(name_of(LensModel::kOpenCvFisheye), "OPENCV_FISHEYE");
    EXPECT_EQ(lens_model_named("FULL_OPENCV"), LensModel::kFullOpenCv);
    EXPECT_FALSE(lens_model_named("THIN_PRISM_FISHEYE").has_value());
    EXPECT_FALSE(is_lens_model(10));
    EXPECT_FALSE(is_lens_model(-1));
    for (const Camera& camera : one_of_each_model()) {
        EXPECT_EQ(lens_model_named(name_of(camera.model)), camera.model);
        EXPECT_EQ(parameter_count(camera.model), camera.parameters.size());
        EXPECT_TRUE(is_lens_model(static_cast<int>(camera.model)));
    }
}

TEST(Camera, RefusesImpossibleLenses) {
    const Camera good = pinhole_camera(640, 480, 500);
    EXPECT_NO_THROW(validate(good, "good"));
    std::vector<Camera> bad(5, good);
    bad[0].width_px = 0;
    bad[1].height_px = -480;
    bad[2].parameters[0] = 0;
    bad[3].parameters[2] = std::nan("");
    bad[4].parameters.pop_back();
    for (const Camera& camera : bad) EXPECT_THROW(validate(camera, "bad"), Error);
}

}  // namespace
}  // namespace lumi
