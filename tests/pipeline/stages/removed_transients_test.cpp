#include "pipeline/stages/removed_transients.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "calib/pictures/image_io.h"
#include "tests/calib/noted_progress.h"
#include "tests/calib/scratch_folder.h"
#include "tests/pipeline/studio.h"

namespace lumi {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

/// A board from nine places, the third photograph of it through something that stood in the way.
Lumigraph board_behind_a_visitor() {
    Lumigraph lumigraph = before_a_board(9, 0.5).lumigraph;
    LumigraphView& view = lumigraph.views[2];
    const int width = view.photograph.width();
    const int height = view.photograph.height();
    for (int y = height * 2 / 5; y < height * 3 / 5; ++y) {
        for (int x = width * 2 / 5; x < width * 3 / 5; ++x) view.photograph(x, y) = {255, 0, 255};
    }
    return lumigraph;
}

/// Of all channels, where the visitor stood.
double mean_difference_behind_it(const ColorImage& picture, const ColorImage& truth) {
    double sum = 0;
    int count = 0;
    for (int y = truth.height() * 2 / 5; y < truth.height() * 3 / 5; ++y) {
        for (int x = truth.width() * 2 / 5; x < truth.width() * 3 / 5; ++x) {
            const Rgb8& a = picture(x, y);
            const Rgb8& b = truth(x, y);
            for (const int difference : {a.r - b.r, a.g - b.g, a.b - b.b})
                sum += std::abs(difference);
            count += 3;
        }
    }
    return sum / count;
}

TEST(RemovedTransients, AreNotedAndShownAndLeaveThePackage) {
    const ScratchFolder scratch;
    const std::filesystem::path folder = scratch / "pack";
    std::filesystem::create_directories(folder);
    Lumigraph lumigraph = board_behind_a_visitor();
    const std::string name = lumigraph.views[2].name;
    NotedProgress progress;
    const auto list = remove_transients(lumigraph, folder, 2, 2048, progress);
    ASSERT_EQ(list.size(), 1U);
    EXPECT_EQ(list[0].at("name"), name);
    // A fifth of its width and height, and a rim of a pixel or two of a small picture.
    EXPECT_NEAR(list[0].at("share").get<double>(), 0.055, 0.02);
    EXPECT_THAT(progress.notes, Contains(HasSubstr("in 1 of 9 photographs, up to")));
    EXPECT_THAT(progress.notes, Contains(HasSubstr("keep_transients = true leaves it in")));
    // What the board shows there, as sharp as three photographs between their pixels tell.
    const ColorImage& painted = lumigraph.views[2].photograph;
    const ColorImage truth = before_a_board(9, 0.5).lumigraph.views[2].photograph;
    EXPECT_LT(mean_difference_behind_it(painted, truth), 5);
    const ColorImage both =
        read_color_image(folder / kTransientFolder / list[0].at("picture").get<std::string>());
    ASSERT_EQ(both.width(), 2 * painted.width()) << "small enough to be shown as it is";
    const int x = painted.width() / 2;
    const int y = painted.height() / 2;
    EXPECT_EQ(both(x, y), (Rgb8{255, 0, 255}));
    EXPECT_EQ(both(painted.width() + x, y), painted(x, y));
}

TEST(RemovedTransients, WriteAndSayNothingWhereThereAreNone) {
    const ScratchFolder scratch;
    const std::filesystem::path folder = scratch / "pack";
    std::filesystem::create_directories(folder);
    Lumigraph lumigraph = before_a_board(9, 0.5).lumigraph;
    const std::vector<LumigraphView> before = lumigraph.views;
    NotedProgress progress;
    EXPECT_TRUE(remove_transients(lumigraph, folder, 2, 2048, progress).empty());
    EXPECT_THAT(progress.notes, IsEmpty());
    EXPECT_TRUE(std::filesystem::is_empty(folder));
    for (std::size_t i = 0; i < before.size(); ++i) {
        EXPECT_EQ(lumigraph.views[i].photograph, before[i].photograph);
    }
}

}  // namespace
}  // namespace lumi
