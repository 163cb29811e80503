#pragma once

#include "render/gl/program.h"
#include "render/modes/drawing_mode.h"
#include "render/modes/face_painter.h"

namespace lumi {

/// The paper without geometry (sections 3 and 4): each face of the camera mesh blends its three
/// photographs, looked up where the ray meets the scene plane (scene_plane.h).
class LightField : public DrawingMode {
 public:
    explicit LightField(const UploadedLumigraph& uploaded);
    void draw(const Eye& eye, const RenderOptions& options, const Viewport& viewport) override;

 private:
    FacePainter faces_;
    Program program_;
};

}  // namespace lumi
