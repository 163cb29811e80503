#pragma once

#include <array>
#include <functional>
#include <vector>

#include "render/faces/face_polygons.h"
#include "render/gl/program.h"
#include "render/gl/vertex_buffer.h"
#include "render/uploaded/uploaded_lumigraph.h"

namespace lumi {

/// Sets how a program that is made from face.glsl with FADES fades: a shell (CameraMesh::shells),
/// or what lies beyond the border of the mesh.
void set_fade(const Program& program, bool is_shell);

/// Draws the faces of the camera mesh as polygons of the picture, with what shaders/face.glsl
/// needs of the three views of each.
class FacePainter {
 public:
    explicit FacePainter(const UploadedLumigraph& uploaded);

    /// Takes polygons (face_polygons.h) for the eye; `plane` stands for the scene where no depth is
    /// known (scene_plane.h).
    void upload(const std::vector<FacePolygon>& polygons, const Eye& eye,
                const Eigen::Vector3d& plane);
    /// Draws them in their order with the program in use, which is made from face.glsl. Returns the
    /// number of triangles.
    std::size_t draw() const;
    using IsWanted = std::function<bool(const std::array<int, 3>& view_indices)>;
    /// The same for those that look at the scene through such views.
    std::size_t draw_if(const IsWanted& is_wanted) const;
    [[nodiscard]] bool has_any(const IsWanted& is_wanted) const;

 private:
    struct UploadedPolygon {
        std::array<int, 3> view_indices{};
        std::size_t first_index = 0;
        std::size_t index_count = 0;
    };
    const UploadedLumigraph& uploaded_;
    VertexBuffer polygons_;
    std::vector<UploadedPolygon> uploaded_polygons_;
};

}  // namespace lumi
