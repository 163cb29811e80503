#include "pipeline/evaluate/kept_back_photographs.h"

#include <gtest/gtest.h>

#include <vector>

#include "pipeline/evaluate/kept_back_rounds.h"
#include "tests/pipeline/studio.h"

namespace lumi {
namespace {

TEST(KeptBackPhotographs, AreDrawnAsFromALumigraphOfTheOthersMadeAnew) {
    const RenderOptions options{.mode = RenderMode::kAdaptive};
    Studio studio = from_all_around(kBodiesInTheWay, 20);
    studio.find_points();
    const Lumigraph lumigraph = with_camera_mesh(studio);
    SilentProgress progress;
    KeptBackPhotographs photographs(lumigraph, studio.capture, {}, progress);
    for (const double error_px : {kTriangleError_px, 4.0}) {
        DrawingChoices drawing = lumigraph.drawing;
        drawing.triangle_error_px = error_px;
        DrawnPictures anew;
        const std::size_t asked =
            visit_kept_back(lumigraph, studio.capture, {}, "", progress,
                            [&](Lumigraph& others, const std::vector<PicturedEye>& pictures) {
                                others.drawing = drawing;
                                OffscreenRenderer renderer(others);
                                for (const PicturedEye& picture : pictures)
                                    draw_picture(renderer, picture, options, anew);
                            });
        EXPECT_EQ(photographs.count(), asked);
        const DrawnPictures drawn = photographs.draw(drawing, options);
        EXPECT_EQ(drawn.losses_db, anew.losses_db);
        EXPECT_EQ(drawn.triangles, anew.triangles);
    }
}

TEST(KeptBackPhotographs, AreNoneOfFewViews) {
    Studio studio = before_a_board(7, 0.1);
    studio.find_points();
    const Lumigraph lumigraph = with_camera_mesh(studio);
    SilentProgress progress;
    KeptBackPhotographs photographs(lumigraph, studio.capture, {}, progress);
    EXPECT_EQ(photographs.count(), 0U);
    EXPECT_TRUE(photographs.draw(lumigraph.drawing, {}).losses_db.empty());
}

}  // namespace
}  // namespace lumi
