#pragma once

#include <filesystem>

#include "calib/work/progress.h"
#include "pipeline/stages/pack_stage.h"
#include "render/lumigraph/package.h"

namespace lumi {

/// Leaves views out of a Lumigraph, always those that are missed least, until there are as few, and
/// the package is as small, as the options want. It is weighed in `folder`. Throws Error
/// (E-PACK-MIB) when not even one view fits.
void limit_views(Lumigraph& lumigraph, const PackSources& sources, const PackageExtras& extras,
                 const std::filesystem::path& folder, int threads, Progress& progress);

}  // namespace lumi
