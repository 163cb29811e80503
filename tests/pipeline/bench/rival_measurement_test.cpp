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

TEST_F(RivalMeasurementOfCoke, HasDepthMeshesBeforeAnythingIsTimed) {
    for (const LumigraphView& view : capture().lumigraph.views) EXPECT_NE(view.depth_mesh, nullptr);
}

}  // namespace
}  // namespace lumi
