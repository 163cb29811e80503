#include "render/painters/hole_finder.h"

#include <epoxy/gl.h>

#include <utility>

#include "render/holes/hole_cells.h"
#include "render/shaders/shader_sources.h"

namespace lumi {
namespace {

Program hole_program(std::vector<std::string> definitions) {
    definitions.push_back("SAMPLES " + std::to_string(kHoleSamples));
    return {"holes",
            {shader_source("screen"), shader_source("agreed_depth"), shader_source("holes")},
            definitions};
}

}  // namespace

HoleFinder::HoleFinder(std::vector<std::string> layer_definitions)
    : program_(hole_program(std::move(layer_definitions))) {}

PictureCells HoleFinder::find(const TextureArray& layers, float agreeing_depth,
                              const DepthEye& depth_eye, const Camera& camera) {
    PictureCells cells(camera, kHoleCell_px);
    const FramebufferBindingKeeper keeper;
    framebuffer_.bind();
    if (columns_ != cells.columns() || rows_ != cells.rows())
        framebuffer_.attach_color(cells.columns(), cells.rows());
    columns_ = cells.columns();
    rows_ = cells.rows();
    glViewport(0, 0, columns_, rows_);
    program_.use();
    layers.bind(0);
    program_.set("depth_layers", 0);
    program_.set("agreeing_depth", agreeing_depth);
    program_.set("cell_px", static_cast<float>(kHoleCell_px));
    program_.set("picture_size", glm::vec2(camera.width_px, camera.height_px));
    program_.set("texels_per_pixel", static_cast<float>(depth_eye.texels_per_pixel));
    program_.set("texel_rows", static_cast<float>(depth_eye.eye.camera.height_px));
    screen_.draw();
    const std::vector<unsigned char> shares = framebuffer_.read_rgba_bottom_up(columns_, rows_);
    for (int row = 0; row < rows_; ++row)
        for (int column = 0; column < columns_; ++column)
            if (shares[4 * static_cast<std::size_t>(row * columns_ + column)] >=
                255 * kLeastHoleShare)
                cells.mark(column, row);
    return cells;
}

}  // namespace lumi
