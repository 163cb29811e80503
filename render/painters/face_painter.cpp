#include "render/painters/face_painter.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "calib/capture/inverse_depth_warp.h"

namespace lumi {
namespace {

/// The attributes of shaders/face.glsl.
const std::vector<VertexAttribute> kFaceVertex{{0, 2},  {1, 4},  {2, 3}, {3, 3}, {4, 3},
                                               {5, 4},  {6, 4},  {7, 4}, {8, 4}, {9, 4},
                                               {10, 4}, {11, 4}, {12, 3}};

/// What one corner of a face needs to know of its view, for one eye.
struct ViewForEye {
    InverseDepthWarp view_from_eye;
    double disparity_px = 0.0;
};

void append(std::vector<float>& vertices, double value) {
    vertices.push_back(static_cast<float>(value));
}

template <class Vector>
void append_all(std::vector<float>& vertices, const Vector& vector) {
    for (Eigen::Index i = 0; i < vector.size(); ++i) append(vertices, vector[i]);
}

std::vector<ViewForEye> views_for_eye(const UploadedLumigraph& uploaded, const Eye& eye) {
    const Eigen::Vector3d eye_in_world = centre_in_world(eye.cam_from_world);
    std::vector<ViewForEye> views;
    for (std::size_t i = 0; i < uploaded.layout.views.size(); ++i) {
        const LumigraphView& view = uploaded.layout.views[i];
        views.push_back(
            {warp_from(eye).to(view),
             disparity_px_per_inverse_depth(uploaded.searched_views.geometries[i], eye_in_world)});
    }
    return views;
}

/// Writes vertices in the order of kFaceVertex.
class VertexWriter {
 public:
    VertexWriter(const UploadedLumigraph& uploaded, const Eye& eye, const Eigen::Vector3d& plane)
        : uploaded_(uploaded), views_(views_for_eye(uploaded, eye)), plane_(plane) {}

    void append_vertex(std::vector<float>& vertices, const FacePolygon& polygon,
                       const Eigen::Vector2d& pixel) const {
        const Eigen::Vector3d homogeneous = pixel.homogeneous();
        append_all(vertices, pixel);
        for (const Eigen::Vector3d& line : polygon.side_lines)
            append(vertices, line.dot(homogeneous));
        append(vertices, plane_.dot(homogeneous));
        for (const int view : polygon.view_indices)
            append_all(vertices, (of(view).view_from_eye.infinite_homography * homogeneous).eval());
        for (const int view : polygon.view_indices) {
            append_all(vertices, of(view).view_from_eye.epipole);
            append(vertices, view);
        }
        for (const int view : polygon.view_indices) append_sizes(vertices, view);
        for (const int view : polygon.view_indices) append(vertices, of(view).disparity_px);
        append(vertices, polygon.face_index);
        for (const float beyond : polygon.beyond_border) vertices.push_back(beyond);
    }

 private:
    [[nodiscard]] const ViewForEye& of(int view) const {
        return views_[static_cast<std::size_t>(view)];
    }

    void append_sizes(std::vector<float>& vertices, int view) const {
        const auto index = static_cast<std::size_t>(view);
        const Camera& camera = uploaded_.layout.views[index].camera;
        append(vertices, camera.width_px);
        append(vertices, camera.height_px);
        append(vertices,
               static_cast<double>(uploaded_.depth_sizes_px[index].x()) / camera.width_px);
        append(vertices,
               static_cast<double>(uploaded_.depth_sizes_px[index].y()) / camera.height_px);
    }

    const UploadedLumigraph& uploaded_;
    std::vector<ViewForEye> views_;
    Eigen::Vector3d plane_;
};

}  // namespace

void set_fade(const Program& program, bool is_shell) {
    program.set("is_shell", is_shell ? 1.0F : 0.0F);
    program.set("faded_share", static_cast<float>(is_shell ? kShellFadedShare : kSkirtFadedShare));
}

FacePainter::FacePainter(const UploadedLumigraph& uploaded)
    : uploaded_(uploaded), polygons_(kFaceVertex) {}

void FacePainter::upload(const std::vector<FacePolygon>& polygons, const Eye& eye,
                         const Eigen::Vector3d& plane) {
    const VertexWriter writer(uploaded_, eye, plane);
    std::vector<float> vertices;
    std::vector<std::uint32_t> indices;
    std::uint32_t count = 0;
    uploaded_polygons_.clear();
    for (const FacePolygon& polygon : polygons) {
        const auto corners = static_cast<std::uint32_t>(polygon.corners_px.size());
        for (const Eigen::Vector2d& corner : polygon.corners_px)
            writer.append_vertex(vertices, polygon, corner);
        const std::size_t first_index = indices.size();
        for (std::uint32_t i = 1; i + 1 < corners; ++i)
            indices.insert(indices.end(), {count, count + i, count + i + 1});
        count += corners;
        uploaded_polygons_.push_back(
            {polygon.view_indices, first_index, indices.size() - first_index});
    }
    polygons_.upload(vertices, indices);
}

std::size_t FacePainter::draw() const {
    return draw_if([](const std::array<int, 3>&) { return true; });
}

bool FacePainter::has_any(const IsWanted& is_wanted) const {
    return std::any_of(
        uploaded_polygons_.begin(), uploaded_polygons_.end(),
        [&](const UploadedPolygon& polygon) { return is_wanted(polygon.view_indices); });
}

std::size_t FacePainter::draw_if(const IsWanted& is_wanted) const {
    std::size_t drawn = 0;
    std::size_t first = 0;
    std::size_t count = 0;
    const auto draw_run = [&] {
        if (count > 0) polygons_.draw(first, count);
        drawn += count;
        count = 0;
    };
    for (const UploadedPolygon& polygon : uploaded_polygons_) {
        if (!is_wanted(polygon.view_indices)) {
            draw_run();
            continue;
        }
        if (count == 0) first = polygon.first_index;
        count += polygon.index_count;
    }
    draw_run();
    return drawn / 3;
}

}  // namespace lumi
