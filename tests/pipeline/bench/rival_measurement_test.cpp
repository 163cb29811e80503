#include "pipeline/bench/rival_measurement.h"

#include <gtest/gtest.h>

#include "pipeline/evaluate/image_metrics.h"
#include "render/surroundings/surroundings.h"

namespace lumi {
namespace {

class RivalMeasurementOfCoke : public testing::Test {
 protected:
    static RivalCapture capture() {
        SilentProgress progress;
        return rival_capture("coke", {.size_px = 64, .held_out = 2, .path_frames = 0}, progress);
    }
};

TEST_F(RivalMeasurementOfCoke, OfFramesThatAreNotCoveredIsNoPartOfTheMean) {
    const RivalCapture coke = capture();
    RivalMeasurement measurement(coke);
    int frame = 0;
    // Every frame is black; of the second nothing is covered.
    const RivalFigures figures = measurement.measured({"black", "", 1, true}, [&](const Eye& eye) {
        Frame black = empty_frame(eye.camera);
        if (frame++ == 0) black.coverage = GrayImage(64, 64, 255);
        return black;
    });
    const ColorImage black(64, 64);
    EXPECT_EQ(figures.covered_frames, 1);
    EXPECT_DOUBLE_EQ(figures.psnr_covered_db.value(), psnr_db(black, coke.held_out[0].picture));
    EXPECT_DOUBLE_EQ(figures.coverage, 0.5);
    EXPECT_FALSE(figures.frames[1].psnr_covered_db.has_value());
    // Where nothing is covered the frame has its surroundings; as it is drawn it is black.
    EXPECT_DOUBLE_EQ(figures.frames[1].psnr_db,
                     psnr_db(surroundings_picture(coke.lumigraph, coke.held_out[1].eye),
                             coke.held_out[1].picture));
    EXPECT_DOUBLE_EQ(figures.frames[1].psnr_as_drawn_db, psnr_db(black, coke.held_out[1].picture));
}

TEST_F(RivalMeasurementOfCoke, WrongSurfacesAreAShareOfWhatIsCovered) {
    const RivalCapture coke = capture();
    RivalMeasurement measurement(coke);
    // Everything is white: how much of it is wrong does not depend on how much is left out.
    const auto measured = [&](const std::string& method, int covered_columns) {
        return measurement.measured({method, "", 1, true}, [&](const Eye& eye) {
            Frame white = empty_frame(eye.camera);
            for (Rgb8& pixel : white.color.pixels()) pixel = {255, 255, 255};
            for (int y = 0; y < 64; ++y)
                for (int x = 0; x < covered_columns; ++x) white.coverage(x, y) = 255;
            return white;
        });
    };
    const RivalFigures all = measured("all", 64);
    const RivalFigures half = measured("half", 32);
    EXPECT_GT(all.wrong_layer_share.value(), 0.1);
    EXPECT_GT(half.wrong_layer_share.value(), 0.7 * all.wrong_layer_share.value());
    EXPECT_GT(half.avoidable_wrong_layer_share.value(),
              0.7 * all.avoidable_wrong_layer_share.value());
    EXPECT_FALSE(measured("none", 0).wrong_layer_share.has_value());
}

TEST_F(RivalMeasurementOfCoke, EyesOffTheCamerasAreATenthNearerAndFartherAndMeetTheTruth) {
    const RivalCapture coke = capture();
    ASSERT_EQ(coke.off_cameras.size(), 2 * coke.held_out.size());
    for (std::size_t i = 0; i < coke.off_cameras.size(); ++i) {
        const Eye& eye = coke.off_cameras[i].eye;
        const Eye& photographer = coke.held_out[i / 2].eye;
        const Eigen::Vector3d centre = coke.lumigraph.mesh.scene_centre_in_world;
        const double z = (photographer.cam_from_world * centre).z();
        EXPECT_NEAR((eye.cam_from_world * centre).z() / z, i % 2 == 0 ? 0.9 : 1.1, 0.01);
        EXPECT_EQ(coke.off_cameras[i].picture,
                  true_picture("coke", {.size_px = 64, .held_out = 2, .path_frames = 0}, eye));
    }
}

TEST_F(RivalMeasurementOfCoke, OfEyesOffTheCamerasIsOnTheirOwnCommonPixels) {
    const RivalCapture coke = capture();
    RivalMeasurement measurement(coke);
    // All is true on the left, which alone the first covers, and black on the right, which the
    // second covers, too; at held-out places nothing is.
    const auto measured = [&](const std::string& method, int covered_columns) {
        std::size_t drawn = 0;
        return measurement.measured({method, "", 1, true}, [&](const Eye& eye) {
            Frame frame = empty_frame(eye.camera);
            if (drawn++ < coke.held_out.size()) return frame;
            const TrueFrame& truth = coke.off_cameras[drawn - 1 - coke.held_out.size()];
            for (int y = 0; y < 64; ++y)
                for (int x = 0; x < covered_columns; ++x) {
                    if (x < 32) frame.color(x, y) = truth.picture(x, y);
                    frame.coverage(x, y) = 255;
                }
            return frame;
        });
    };
    std::vector<RivalFigures> rivals{measured("left", 32), measured("all", 64)};
    measurement.measure_common_pixels(rivals);
    const ColorImage truth(8, 8);
    const double exact_db = psnr_db(truth, truth);
    for (const RivalFigures& rival : rivals) {
        EXPECT_FALSE(rival.psnr_common_db.has_value()) << rival.method;
        EXPECT_EQ(rival.off_cameras.psnr_common_db, exact_db) << rival.method;
    }
    EXPECT_EQ(rivals[0].off_cameras.psnr_covered_db, exact_db);
    EXPECT_LT(rivals[1].off_cameras.psnr_covered_db.value(), 20);
    EXPECT_DOUBLE_EQ(rivals[0].off_cameras.coverage, 0.5);
    EXPECT_DOUBLE_EQ(rivals[1].off_cameras.coverage, 1.0);
    EXPECT_DOUBLE_EQ(measurement.off_cameras_common_share(), 0.5);
}

TEST_F(RivalMeasurementOfCoke, HasDepthMeshesBeforeAnythingIsTimed) {
    for (const LumigraphView& view : capture().lumigraph.views) EXPECT_NE(view.depth_mesh, nullptr);
}

}  // namespace
}  // namespace lumi
