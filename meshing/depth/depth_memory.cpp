#include "meshing/depth/depth_memory.h"

#include <algorithm>
#include <numeric>

#include "calib/work/error.h"
#include "calib/work/process_memory.h"
#include "meshing/matching/sweep_search.h"

namespace lumi {
namespace {

// Bytes for each pixel of a depth map.
constexpr double kPicture = 3;
constexpr double kMap = 5;  // Inverse depth and confidence.
// How far each pixel is from what is known, and what others tell of it: five bytes in views
// that are continued, about half.
constexpr double kDistance = 2.5;
// What other views claim and deny of pixels that are unknown, and what comes of it; later the
// surroundings, three times as large, or the smoother's arrays; and a copy of the map, with how far
// each pixel is from what is known, while the recession is asked for.
constexpr double kFilling = 76;

// A view that is matched takes its pictures, and so much for each plane that a pixel is compared
// at, as far as the sweep may.
constexpr double kPictures = 37;
constexpr double kPlanes = 52;
constexpr double kPlane = 3;
// Planes, costs and packed neighbours of PatchMatch, which begins when the sweep's pictures are
// gone.
constexpr double kRefining = 52;
constexpr double kPair = 60;  // Two rectified pictures, and what OpenCV matches them in.

bool refines(const std::string& model) {
    return model == "refined_sweep" || model == "patch_match" || model == "auto";
}

double matching_of(double pixels, const std::string& model) {
    const auto allowed = static_cast<double>(sweep_cells_allowed(static_cast<std::size_t>(pixels)));
    const double cells = kPlane * std::min(allowed, kPlanes * pixels);
    if (model == "sweep") return kPictures * pixels + cells;
    if (refines(model)) return std::max(kPictures, kRefining) * pixels + cells;
    if (model == "pair_stereo") return kPair * pixels;
    return 0;
}

/// While photographs are predicted at half their size: up to four of them, each from its
/// neighbours and what these are compared with.
struct Trials {
    double kept = 0;     ///< Bytes, with the scene.
    double matched = 0;  ///< On top of it, for each view that is matched.
};

Trials trials_of(double pixels, double largest, std::size_t views, int max_neighbours) {
    constexpr double kPhotographs = 4;
    constexpr double kOfEachView = kPicture + 2 * kMap;
    constexpr double kHalfSize = 0.25;
    const double trial = kHalfSize * largest;
    // Neighbours have neighbours in common.
    const double members =
        std::min(static_cast<double>(views), 0.5 * max_neighbours * (max_neighbours + 1));
    return {kPicture * pixels + kPhotographs * members * kOfEachView * trial,
            matching_of(trial, "patch_match")};
}

}  // namespace

DepthMemory predicted_depth_memory(const std::vector<std::uint64_t>& map_pixels,
                                   const std::string& model, int threads, std::uint64_t budget,
                                   std::uint64_t in_use, int max_neighbours) {
    const auto pixels = static_cast<double>(
        std::accumulate(map_pixels.begin(), map_pixels.end(), std::uint64_t{0}));
    const double largest =
        map_pixels.empty()
            ? 0
            : static_cast<double>(*std::max_element(map_pixels.begin(), map_pixels.end()));
    const double while_matching = (kPicture + (refines(model) ? 2 : 1) * kMap) * pixels;
    const double while_filling = (kPicture + 2 * kMap + kDistance) * pixels;
    // What was estimated first, refined, and confirmed.
    const double while_confirming = (kPicture + (refines(model) ? 3 : 2) * kMap) * pixels;
    const double left = static_cast<double>(budget) - static_cast<double>(in_use);
    const int most =
        std::min(threads, static_cast<int>(std::max<std::size_t>(1, map_pixels.size())));
    const double matching = matching_of(largest, model);
    DepthMemory memory;
    memory.in_use = in_use;
    memory.views_matched = pieces_within(left, while_matching, matching, most);
    memory.views_filled = pieces_within(left, while_filling, kFilling * largest, most);
    memory.matching = static_cast<std::uint64_t>(while_matching + memory.views_matched * matching);
    memory.finishing = static_cast<std::uint64_t>(
        std::max(while_confirming, while_filling + memory.views_filled * kFilling * largest));
    if (model == "auto") {
        const Trials trials = trials_of(pixels, largest, map_pixels.size(), max_neighbours);
        memory.views_tried =
            pieces_within(left, trials.kept, trials.matched, std::min(most, max_neighbours));
        memory.choosing =
            static_cast<std::uint64_t>(trials.kept + memory.views_tried * trials.matched);
    }
    return memory;
}

DepthMemory predicted_memory_of_choice(const DepthMemory& before,
                                       const std::vector<std::uint64_t>& map_pixels,
                                       const std::string& chosen, bool predicted_photographs,
                                       int threads, std::uint64_t budget) {
    constexpr int kTriesNone = 1;  // A model that is named.
    DepthMemory memory =
        predicted_depth_memory(map_pixels, chosen, threads, budget, before.in_use, kTriesNone);
    if (predicted_photographs) memory.choosing = before.choosing;
    return memory;
}

void require_memory(const DepthMemory& predicted, std::uint64_t available) {
    const std::uint64_t wanted = predicted.peak() - predicted.in_use;
    if (wanted <= available) return;
    const auto mebibytes = [](std::uint64_t bytes) { return std::to_string(bytes >> 20) + " MiB"; };
    throw Error(ErrorKind::kResources, "E-DEPTH-MEMORY",
                "depth maps of this size take about " + mebibytes(wanted) +
                    " of memory, and the machine has " + mebibytes(available) + " left",
                "make them smaller with max_width_px under [depth]");
}

}  // namespace lumi
