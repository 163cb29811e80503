#include "render/modes/light_field.h"

#include "render/shaders/shader_sources.h"

namespace lumi {

LightField::LightField(const UploadedLumigraph& uploaded)
    : faces_(uploaded),
      program_("light_field", {shader_source("face"), shader_source("light_field")}) {}

void LightField::draw(const Eye& eye, const RenderOptions& options, const Viewport&) {
    program_.use();
    faces_.draw(eye, options, program_);
}

}  // namespace lumi
