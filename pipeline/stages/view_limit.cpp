#include "pipeline/stages/view_limit.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <string>
#include <vector>

#include "calib/work/error.h"
#include "pipeline/stages/chosen_views.h"
#include "pipeline/workspace/folder_size.h"
#include "render/depth_mesh/view_depth_mesh.h"

namespace lumi {

namespace fs = std::filesystem;

ViewLimit::ViewLimit(const PackSources& sources, const PackageExtras& extras,
                     const ViewExposures& exposures, const fs::path& folder, int threads,
                     Progress& progress)
    : sources_(sources),
      extras_(extras),
      exposures_(exposures),
      folder_(folder),
      threads_(threads),
      progress_(progress) {}

void ViewLimit::keep_to_count(Lumigraph& lumigraph) {
    const int wanted = wanted_views(lumigraph);
    if (wanted < static_cast<int>(lumigraph.views.size())) reduce(lumigraph, wanted);
}

/// As many views as a package of the wished size holds: it is written aside and weighed until it
/// fits.
void ViewLimit::keep_to_size(Lumigraph& lumigraph) {
    if (sources_.options.max_mib <= 0) return;
    const fs::path aside = folder_ / "weighed.lumi";
    for (;;) {
        make_depth_meshes(lumigraph, threads_, progress_);
        write_package(aside, lumigraph, extras_, {.max_decoded_bytes = UINT64_MAX});
        const double mib = folder_mib(aside);
        fs::remove_all(aside);
        if (mib <= sources_.options.max_mib) return;
        const auto count = static_cast<int>(lumigraph.views.size());
        if (count <= 1) {
            throw Error(ErrorKind::kUsage, "E-PACK-MIB",
                        "[package] max_mib: not even one view fits",
                        "allow more, or make pictures smaller with [capture] max_width_px");
        }
        const auto fitting = static_cast<int>(count * sources_.options.max_mib / mib);
        reduce(lumigraph, std::clamp(fitting, 1, count - 1));
    }
}

/// The views that the options ask for, before any limit of size.
int ViewLimit::wanted_views(const Lumigraph& lumigraph) const {
    int wanted = static_cast<int>(lumigraph.views.size());
    if (sources_.options.fewest_views && sources_.sufficient_views) {
        wanted = sources_.sufficient_views(lumigraph, sources_.photographs.capture);
    }
    if (sources_.options.max_views > 0) wanted = std::min(wanted, sources_.options.max_views);
    return wanted;
}

void ViewLimit::reduce(Lumigraph& lumigraph, int views) {
    if (names_by_worth_.empty()) rank(lumigraph);
    const std::set<std::string> kept(names_by_worth_.begin(), names_by_worth_.begin() + views);
    std::vector<int> chosen;
    for (std::size_t i = 0; i < lumigraph.views.size(); ++i) {
        if (kept.count(lumigraph.views[i].name) > 0) chosen.push_back(static_cast<int>(i));
    }
    lumigraph = lumigraph_of_views(lumigraph, capture_of(lumigraph, sources_.photographs), chosen,
                                   sources_.mesh_options);
    even_among_neighbours(exposures_, lumigraph);
}

/// Once, of all views that are there the first time.
void ViewLimit::rank(const Lumigraph& lumigraph) {
    std::vector<int> all(lumigraph.views.size());
    std::iota(all.begin(), all.end(), 0);
    const Capture capture = capture_of(lumigraph, sources_.photographs);
    for (const int view : views_by_worth(lumigraph, capture, all, threads_, progress_)) {
        names_by_worth_.push_back(lumigraph.views[static_cast<std::size_t>(view)].name);
    }
}

}  // namespace lumi
