#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "calib/work/progress.h"
#include "pipeline/stages/pack_stage.h"
#include "pipeline/stages/view_exposures.h"
#include "render/lumigraph/package.h"

namespace lumi {

/// Leaves views out of a Lumigraph, always those that are missed least, and evens the exposures of
/// the rest anew. What it is given must outlive it.
class ViewLimit {
 public:
    /// Packages are weighed in `folder`.
    ViewLimit(const PackSources& sources, const PackageExtras& extras,
              const ViewExposures& exposures, const std::filesystem::path& folder, int threads,
              Progress& progress);

    /// Until there are as few as the options want.
    void keep_to_count(Lumigraph& lumigraph);

    /// Until the package is as small as the options want. Views that are left have depth meshes
    /// then. Throws Error (E-PACK-MIB) when not even one view fits.
    void keep_to_size(Lumigraph& lumigraph);

 private:
    [[nodiscard]] int wanted_views(const Lumigraph& lumigraph) const;
    void reduce(Lumigraph& lumigraph, int views);
    void rank(const Lumigraph& lumigraph);

    const PackSources& sources_;
    const PackageExtras& extras_;
    const ViewExposures& exposures_;
    const std::filesystem::path& folder_;
    int threads_;
    Progress& progress_;
    std::vector<std::string> names_by_worth_;
};

}  // namespace lumi
