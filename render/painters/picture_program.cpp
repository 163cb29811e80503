#include "render/painters/picture_program.h"

#include <string>
#include <utility>

#include "render/gl/to_glm.h"
#include "render/shaders/shader_sources.h"

namespace lumi {
namespace {

std::string definition(const char* name, DebugPicture picture) {
    return std::string(name) + ' ' + std::to_string(static_cast<int>(picture));
}

}  // namespace

PictureProgram::PictureProgram(std::string name, std::vector<std::string_view> sources,
                               std::vector<std::string> definitions)
    : name_(std::move(name)), sources_(std::move(sources)), definitions_(std::move(definitions)) {
    sources_.insert(sources_.begin(), shader_source("photographs"));
}

const Program& PictureProgram::use(const UploadedLumigraph& uploaded, const Eye& eye,
                                   const RenderOptions& options) {
    const bool is_debug = options.debug_picture != DebugPicture::kNone &&
                          options.debug_picture != DebugPicture::kGrid;
    const double lod = uploaded.lod_of(eye, options);
    std::optional<Program>& program =
        versions_[options.supersample ? 1 : 0][is_debug ? 1 : 0][lod > 0 ? 1 : 0];
    if (!program) {
        std::vector<std::string> definitions = definitions_;
        if (is_debug)
            definitions.insert(definitions.end(),
                               {"DEBUG_PICTURE", definition("SHOW_WEIGHTS", DebugPicture::kWeights),
                                definition("SHOW_FACES", DebugPicture::kFaces),
                                definition("SHOW_DEPTH", DebugPicture::kDepth),
                                definition("SHOW_CONFIDENCE", DebugPicture::kConfidence)});
        if (options.supersample) definitions.emplace_back("FOUR_SAMPLES");
        if (lod > 0) definitions.emplace_back("MIP_LEVELS");
        program.emplace(name_, sources_, definitions);
    }
    program->use();
    if (lod > 0) {
        uploaded.photographs.bind_mip_levels(0);
        program->set("photograph_lod", static_cast<float>(lod));
    } else {
        uploaded.photographs.bind(0);
    }
    program->set("photographs", 0);
    program->set("photograph_layers_per_pixel",
                 glm::vec2(1.0F / static_cast<float>(uploaded.photographs.width_px()),
                           1.0F / static_cast<float>(uploaded.photographs.height_px())));
    program->set("clip_from_eye_pixel",
                 to_glm(clip_from_pixel(eye.camera.width_px, eye.camera.height_px, 1.0)));
    if (is_debug) {
        program->set("debug_picture", static_cast<int>(options.debug_picture));
        const InverseDepthRange scene = scene_inverse_depths(uploaded.layout);
        program->set("inverse_depth_range", to_glm(Eigen::Vector2d(scene.far, scene.near)));
    }
    return *program;
}

}  // namespace lumi
