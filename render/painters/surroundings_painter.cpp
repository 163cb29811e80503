#include "render/painters/surroundings_painter.h"

#include <cstdint>
#include <string_view>
#include <vector>

#include "render/gl/to_glm.h"
#include "render/shaders/shader_sources.h"
#include "render/surroundings/surroundings.h"

namespace lumi {
namespace {

std::vector<float> vertices_of(const ColorGrid& grid) {
    std::vector<float> vertices;
    for (int row = 0; row <= grid.cells.rows(); ++row) {
        for (int column = 0; column <= grid.cells.columns(); ++column) {
            const Eigen::Vector3f& color = grid.corner(column, row);
            vertices.insert(vertices.end(), {static_cast<float>(column * grid.cells.cell_px()),
                                             static_cast<float>(row * grid.cells.cell_px()),
                                             color.x(), color.y(), color.z()});
        }
    }
    return vertices;
}

/// Two a cell, on either side of the diagonal from its top left.
std::vector<std::uint32_t> triangles_of(const ColorGrid& grid) {
    std::vector<std::uint32_t> indices;
    for (int row = 0; row < grid.cells.rows(); ++row) {
        for (int column = 0; column < grid.cells.columns(); ++column) {
            if (!grid.cells.is_marked(column, row)) continue;
            const auto start = static_cast<std::uint32_t>(grid.corner_index(column, row));
            const auto below = static_cast<std::uint32_t>(grid.corner_index(column, row + 1));
            indices.insert(indices.end(), {start, start + 1, below + 1, start, below + 1, below});
        }
    }
    return indices;
}

}  // namespace

void SurroundingsPainter::draw(const PictureCells& cells, const Eye& eye) {
    draw_with(in_pixels_, {}, cells, eye);
}

void SurroundingsPainter::draw_in_blocks(const PictureCells& cells, const Eye& eye) {
    draw_with(in_blocks_, {"BLOCKS"}, cells, eye);
}

void SurroundingsPainter::draw_with(std::optional<Program>& program,
                                    const std::vector<std::string>& definitions,
                                    const PictureCells& cells, const Eye& eye) {
    if (!cells.is_any_marked()) return;
    const ColorGrid colors =
        surrounding_colors(uploaded_.layout, uploaded_.small_photographs, eye, cells);
    if (!program) {
        const std::vector<std::string_view> sources{shader_source("drawn_pixels"),
                                                    shader_source("surroundings")};
        program.emplace("surroundings", sources, definitions);
    }
    if (!triangles_) triangles_.emplace(VertexBuffer({{0, 2}, {1, 3}}));
    program->use();
    program->set("clip_from_eye_pixel",
                 to_glm(clip_from_pixel(eye.camera.width_px, eye.camera.height_px, 1.0)));
    const std::vector<std::uint32_t> indices = triangles_of(colors);
    triangles_->upload(vertices_of(colors), indices);
    triangles_->draw(0, indices.size());
}

}  // namespace lumi
