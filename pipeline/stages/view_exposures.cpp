#include "pipeline/stages/view_exposures.h"

#include <vector>

#include "meshing/exposure/exposure_ratios.h"
#include "meshing/exposure/gains_among_neighbours.h"
#include "meshing/exposure/light_falloff.h"
#include "meshing/exposure/shared_tiles.h"
#include "pipeline/stages/chosen_views.h"
#include "pipeline/text/number_text.h"

namespace lumi {
namespace {

/// Says what is evened out, if anything is.
void note_exposures(const Lumigraph& lumigraph, const ExposureGains& found, Progress& progress) {
    if (lumigraph.light_falloff != 0)
        progress.note("pack: the lens took up to " +
                      number_text(100 * (1 - lumigraph.light_left_in_corners()), 0) +
                      " % of the light from the corners of photographs, which is evened out");
    if (found.model != ExposureModel::kNone)
        progress.note("pack: photographs are exposed differently, by up to " +
                      number_text(found.largest_stops, 2) +
                      " stops, which is evened out between neighbours");
}

}  // namespace

ViewExposures find_exposures(Lumigraph& lumigraph, int threads, Progress& progress) {
    progress.begin("comparing exposures", 0);
    const std::vector<PicturedView> pictured = pictured_views(lumigraph);
    const std::vector<SharedTiles> shared = shared_tiles(pictured, threads, progress);
    lumigraph.light_falloff = light_falloff(pictured, shared);
    ViewExposures exposures;
    exposures.found = exposure_gains(static_cast<int>(lumigraph.views.size()),
                                     exposure_ratios(shared, lumigraph.light_falloff));
    note_exposures(lumigraph, exposures.found, progress);
    if (exposures.found.model == ExposureModel::kNone) return exposures;
    for (std::size_t i = 0; i < lumigraph.views.size(); ++i) {
        exposures.gain_of_view[lumigraph.views[i].name] = exposures.found.gains[i];
        if (exposures.found.tell_white_balance[i] == 0)
            exposures.without_white_balance.insert(lumigraph.views[i].name);
    }
    return exposures;
}

void even_among_neighbours(const ViewExposures& exposures, Lumigraph& lumigraph) {
    if (exposures.gain_of_view.empty()) return;
    std::vector<ExposureGain> gains;
    std::vector<char> tell_white_balance;
    std::vector<Eigen::Vector3d> centres_in_world;
    for (const LumigraphView& view : lumigraph.views) {
        gains.push_back(exposures.gain_of_view.at(view.name));
        tell_white_balance.push_back(exposures.without_white_balance.contains(view.name) ? 0 : 1);
        centres_in_world.push_back(centre_in_world(view.cam_from_world));
    }
    gains = gains_among_neighbours(gains, tell_white_balance, centres_in_world);
    for (std::size_t i = 0; i < gains.size(); ++i) lumigraph.views[i].exposure_gain = gains[i];
}

}  // namespace lumi
