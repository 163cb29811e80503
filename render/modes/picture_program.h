#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "render/gl/program.h"
#include "render/modes/frame.h"
#include "render/modes/uploaded_lumigraph.h"

namespace lumi {

/// A program in two versions, for the picture and for debug pictures, so that the picture does not
/// pay for the others. Both are compiled when they are first used.
class PictureProgram {
 public:
    /// `sources` follow shaders/photographs.glsl; see Program.
    PictureProgram(std::string name, std::vector<std::string_view> sources,
                   std::vector<std::string> definitions = {});

    /// Puts the version that `options` ask for in use and sets what all programs share: the
    /// photographs on unit 0, clip_from_eye_pixel, and how debug pictures are shaded.
    const Program& use(const UploadedLumigraph& uploaded, const Eye& eye,
                       const RenderOptions& options);

 private:
    std::string name_;
    std::vector<std::string_view> sources_;
    std::vector<std::string> definitions_;
    std::optional<Program> picture_;
    std::optional<Program> debug_;
};

}  // namespace lumi
