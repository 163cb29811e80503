#include "render/surroundings/small_photographs.h"

#include <gtest/gtest.h>

#include "calib/pictures/image_io.h"
#include "tests/render/analytic_scene.h"

namespace lumi {
namespace {

constexpr Rgb8 kBackground{20, 40, 200};
constexpr Rgb8 kSubject{250, 180, 10};

/// A view of a subject within these columns and rows; what is around it is infinitely far.
LumigraphView view_of_subject(int left, int right, int top, int bottom) {
    LumigraphView view;
    view.camera = pinhole_camera(160, 120, 150);
    view.photograph = ColorImage(160, 120);
    view.depth.inverse_depth = FloatImage(80, 60);
    for (int y = 0; y < 120; ++y) {
        for (int x = 0; x < 160; ++x) {
            const bool is_subject = x >= left && x < right && y >= top && y < bottom;
            view.photograph(x, y) = is_subject ? kSubject : kBackground;
            view.depth.inverse_depth(x / 2, y / 2) = is_subject ? 0.5F : 0.0F;
        }
    }
    return view;
}

ColorImage small_of(const LumigraphView& view) {
    Lumigraph lumigraph;
    lumigraph.views.push_back(view);
    return small_photographs(lumigraph).of_views.front();
}

TEST(SmallPhotographs, OfASubjectThatStandsAloneAreItsBackground) {
    for (const LumigraphView& view :
         {view_of_subject(60, 100, 20, 100), view_of_subject(20, 140, 40, 120)}) {
        const ColorImage small = small_of(view);
        EXPECT_EQ(small.width(), 16);
        EXPECT_EQ(small.height(), 12);
        for (const Rgb8& pixel : small.pixels()) EXPECT_EQ(pixel, kBackground);
    }
}

TEST(SmallPhotographs, OfLandUnderASkyAreWhatIsSeen) {
    const LumigraphView view = view_of_subject(0, 160, 50, 120);
    EXPECT_EQ(small_of(view).pixels(), resized(view.photograph, 16, 12).pixels());
}

TEST(SmallPhotographs, WithoutDepthAreWhatIsSeen) {
    LumigraphView view = view_of_subject(60, 100, 20, 100);
    view.depth = {};
    EXPECT_EQ(small_of(view).pixels(), resized(view.photograph, 16, 12).pixels());
}

TEST(SmallPhotographs, GoOnBehindTheSubjectWithWhatIsNearest) {
    LumigraphView view = view_of_subject(50, 110, 0, 120);
    for (int y = 0; y < 120; ++y)
        for (int x = 110; x < 160; ++x) view.photograph(x, y) = {0, 90, 0};
    // The subject reaches over a fifth of the border.
    const ColorImage small = small_of(view);
    EXPECT_EQ(small(0, 6), kBackground);
    EXPECT_EQ(small(6, 6), kBackground);
    EXPECT_EQ(small(9, 6), (Rgb8{0, 90, 0}));
    EXPECT_EQ(small(15, 6), (Rgb8{0, 90, 0}));
}

}  // namespace
}  // namespace lumi
