#pragma once

#include <filesystem>
#include <vector>

#include "calib/capture/capture.h"

namespace lumi {

/// Gives each point the mean colour of the pixels it was seen at; one that was seen beside the
/// pictures only keeps its own. `picture_paths` has one picture per view.
void color_points(Capture& capture, const std::vector<std::filesystem::path>& picture_paths,
                  int threads);

}  // namespace lumi
