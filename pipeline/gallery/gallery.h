#pragma once

#include <filesystem>

#include "calib/work/progress.h"
#include "pipeline/workspace/workspace.h"

namespace lumi {

/// Writes into `folder` what shows a reader what lumi makes, from a workspace that was evaluated:
/// held-out.jpg (a photograph that was not used, what is drawn from there, the error), methods.jpg
/// (one eye without depth, with it, the blending weights, inverse depth), the charts that lie in
/// the workspace and beside it as SVG, and gallery.md with these and their figures. Throws Error
/// (E-GALLERY-EVALUATION when it was not evaluated, E-OUT-EXISTS where files of these names stand
/// there that no gallery brought, E-PACKAGE-..., E-GL-...).
void write_gallery(const WorkspaceLayout& workspace, const std::filesystem::path& folder,
                   Progress& progress);

}  // namespace lumi
