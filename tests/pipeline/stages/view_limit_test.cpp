#include "pipeline/stages/view_limit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "calib/pictures/srgb_curve.h"
#include "tests/calib/scratch_folder.h"
#include "tests/pipeline/studio.h"

namespace lumi {
namespace {

constexpr int kBoardViews = 9;

constexpr double kLess = 0.5;

/// Makes a photograph one that was taken with half of the light, and evens that out.
void take_with_less_light(LumigraphView& view) {
    const auto darkened = [](std::uint8_t value) {
        return static_cast<std::uint8_t>(
            std::lround(255 * srgb_of_light(kLess * light_of_srgb(value / 255.0))));
    };
    for (Rgb8& pixel : view.photograph.pixels())
        pixel = {darkened(pixel.r), darkened(pixel.g), darkened(pixel.b)};
    view.exposure_gain = {1 / kLess, 1 / kLess, 1 / kLess};
}

/// What is left of the board's views when so many are wanted.
std::vector<LumigraphView> kept_of(Lumigraph lumigraph, const Capture& capture,
                                   const ViewExposures& exposures, int max_views) {
    const ScratchFolder scratch;
    PackSources sources;
    sources.photographs.capture = capture;
    sources.photographs.picture_paths.resize(capture.views.size());
    sources.options.max_views = max_views;
    const PackageExtras extras;
    SilentProgress progress;
    const std::filesystem::path folder = scratch / "pack";
    ViewLimit limit(sources, extras, exposures, folder, 1, progress);
    limit.keep_to_count(lumigraph);
    return lumigraph.views;
}

std::vector<std::string> names_of(const std::vector<LumigraphView>& views) {
    std::vector<std::string> names;
    for (const LumigraphView& view : views) names.push_back(view.name);
    return names;
}

TEST(ViewLimit, EvensTheExposuresOfWhatIsKeptAmongItself) {
    const Studio board = before_a_board(kBoardViews, 0.5);
    const std::vector<std::string> kept =
        names_of(kept_of(board.lumigraph, board.capture, {}, kBoardViews - 4));
    ASSERT_EQ(kept.size(), kBoardViews - 4U);
    // One that leaves was darker than all others.
    Lumigraph lumigraph = board.lumigraph;
    ViewExposures exposures;
    bool is_dark_found = false;
    for (const LumigraphView& view : lumigraph.views) {
        const bool is_kept = std::count(kept.begin(), kept.end(), view.name) > 0;
        const double gain = is_kept || is_dark_found ? 1.0 : 1 / kLess;
        is_dark_found = is_dark_found || !is_kept;
        exposures.gain_of_view[view.name] = {gain, gain, gain};
    }
    even_among_neighbours(exposures, lumigraph);
    const auto is_dimmed = [](const LumigraphView& view) { return view.exposure_gain[1] < 0.99; };
    EXPECT_TRUE(std::any_of(lumigraph.views.begin(), lumigraph.views.end(), is_dimmed));
    const auto views = kept_of(lumigraph, board.capture, exposures, kBoardViews - 4);
    std::size_t evened = 0;
    for (const LumigraphView& view : views) {
        if (exposures.gain_of_view.at(view.name)[1] != 1.0) continue;
        ++evened;
        for (const double gain : view.exposure_gain) EXPECT_NEAR(gain, 1.0, 1e-12) << view.name;
    }
    EXPECT_EQ(evened, kBoardViews - 4U);
}

TEST(ViewLimit, MissesNoPhotographLessForHowItWasExposed) {
    const Studio board = before_a_board(kBoardViews, 0.5);
    const std::vector<std::string> kept =
        names_of(kept_of(board.lumigraph, board.capture, {}, kBoardViews - 4));
    for (std::size_t dark = 0; dark < board.lumigraph.views.size(); ++dark) {
        Lumigraph with_dark = board.lumigraph;
        take_with_less_light(with_dark.views[dark]);
        EXPECT_EQ(names_of(kept_of(with_dark, board.capture, {}, kBoardViews - 4)), kept)
            << with_dark.views[dark].name;
    }
}

}  // namespace
}  // namespace lumi
