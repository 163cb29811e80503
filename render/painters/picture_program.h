#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "render/frame/frame.h"
#include "render/gl/program.h"
#include "render/uploaded/uploaded_lumigraph.h"

namespace lumi {

/// A program in several versions, for the picture and for debug pictures, of one sample a pixel and
/// of four, so that none pays for the others. Each is compiled when it is first used.
class PictureProgram {
 public:
    /// `sources` follow shaders/photographs.glsl; see Program.
    PictureProgram(std::string name, std::vector<std::string_view> sources,
                   std::vector<std::string> definitions = {});

    /// Puts the version that `options` ask for in use and sets what all programs share: the
    /// photographs on unit 0 and their mip level, clip_from_eye_pixel, and how debug pictures are
    /// shaded. The photographs must be prepared for the frame (UploadedLumigraph::prepare).
    const Program& use(const UploadedLumigraph& uploaded, const Eye& eye,
                       const RenderOptions& options);

 private:
    std::string name_;
    std::vector<std::string_view> sources_;
    std::vector<std::string> definitions_;
    /// First of one sample a pixel, then of four; in each the picture, then debug pictures; of each
    /// first with photographs at their finest, then at a mip level.
    std::array<std::array<std::array<std::optional<Program>, 2>, 2>, 2> versions_;
};

}  // namespace lumi
