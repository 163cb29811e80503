#include "render/painters/grid_painter.h"

#include <cstdint>

#include "render/gl/to_glm.h"
#include "render/shaders/shader_sources.h"

namespace lumi {
namespace {

/// Appends the sides of a polygon whose corners are numbered from `first`.
void append_sides(std::uint32_t first, std::uint32_t corners, std::vector<std::uint32_t>& ends) {
    for (std::uint32_t i = 0; i < corners; ++i)
        ends.insert(ends.end(), {first + i, first + (i + 1) % corners});
}

}  // namespace

void GridPainter::draw(const BlendTriangles& triangles, const Eye& eye) {
    std::vector<float> pixels;
    for (const BlendVertex& vertex : triangles.vertices)
        pixels.insert(pixels.end(), vertex.pixel.begin(), vertex.pixel.end());
    std::vector<std::uint32_t> ends;
    for (std::size_t i = 0; i < triangles.indices.size(); i += 3) {
        for (std::size_t k = 0; k < 3; ++k)
            ends.insert(ends.end(), {triangles.indices[i + k], triangles.indices[i + (k + 1) % 3]});
    }
    draw_lines(pixels, ends, eye);
}

void GridPainter::draw(const std::vector<FacePolygon>& polygons, const Eye& eye) {
    std::vector<float> pixels;
    std::vector<std::uint32_t> ends;
    for (const FacePolygon& polygon : polygons) {
        append_sides(static_cast<std::uint32_t>(pixels.size() / 2),
                     static_cast<std::uint32_t>(polygon.corners_px.size()), ends);
        for (const Eigen::Vector2d& corner : polygon.corners_px) {
            pixels.push_back(static_cast<float>(corner.x()));
            pixels.push_back(static_cast<float>(corner.y()));
        }
    }
    draw_lines(pixels, ends, eye);
}

void GridPainter::draw_lines(const std::vector<float>& pixels,
                             const std::vector<std::uint32_t>& ends, const Eye& eye) {
    if (!program_) {
        program_.emplace("grid", std::vector<std::string_view>{shader_source("grid")});
        lines_ = VertexBuffer({{0, 2}});
    }
    program_->use();
    program_->set("clip_from_eye_pixel",
                  to_glm(clip_from_pixel(eye.camera.width_px, eye.camera.height_px, 1.0)));
    lines_.upload(pixels, ends);
    lines_.draw_lines(ends.size());
}

}  // namespace lumi
