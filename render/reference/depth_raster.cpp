#include "render/reference/depth_raster.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "calib/capture/inverse_depth_warp.h"

namespace lumi {
namespace {

constexpr double kRounding = 1e-12;

/// A triangle in homogeneous pixels of the eye; columns are corners.
struct EyeTriangle {
    Eigen::Matrix3d corners;
    Eigen::Vector3d inverse_depths_in_view;
    DepthKind kind = DepthKind::kSeen;
};

struct PixelBox {
    int begin_x, begin_y, end_x, end_y;
};

/// Pixels whose centres can lie in the triangle; the whole picture when it reaches behind the eye.
PixelBox box_of(const EyeTriangle& triangle, const Camera& camera) {
    if (triangle.corners.row(2).minCoeff() <= 0) return {0, 0, camera.width_px, camera.height_px};
    const Eigen::Array3d x = triangle.corners.row(0).array() / triangle.corners.row(2).array();
    const Eigen::Array3d y = triangle.corners.row(1).array() / triangle.corners.row(2).array();
    const auto clamped = [](double value, int size) {
        return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(size)));
    };
    return {clamped(std::floor(x.minCoeff()), camera.width_px),
            clamped(std::floor(y.minCoeff()), camera.height_px),
            clamped(std::ceil(x.maxCoeff()), camera.width_px),
            clamped(std::ceil(y.maxCoeff()), camera.height_px)};
}

/// Homogeneous rasterisation (Olano, Greer 1997): a pixel (x, y, 1) is the sum of the corners times
/// b; it is inside, and in front of the eye, when no b is negative, and b interpolates what is
/// affine on the surface.
void draw(const EyeTriangle& triangle, const Camera& camera, double max_inverse_depth,
          Image<EyeDepth>& drawn, Image<double>& nearest_stretched) {
    // Corners turn left in the view's picture, whose y axis points down: seen from the front the
    // determinant is negative.
    if (triangle.corners.determinant() >= 0) return;
    const Eigen::Matrix3d b_from_pixel = triangle.corners.inverse();
    const PixelBox box = box_of(triangle, camera);
    for (int y = box.begin_y; y < box.end_y; ++y) {
        for (int x = box.begin_x; x < box.end_x; ++x) {
            const Eigen::Vector3d b = b_from_pixel * Eigen::Vector3d(x + 0.5, y + 0.5, 1);
            // Pixels on a side that two triangles share are of both: rounding leaves none to
            // neither.
            if (b.minCoeff() < -kRounding * b.cwiseAbs().maxCoeff()) continue;
            const double inverse_depth = b.dot(triangle.inverse_depths_in_view);
            if (inverse_depth > max_inverse_depth) continue;
            if (triangle.kind == DepthKind::kStretched)
                nearest_stretched(x, y) = std::max(nearest_stretched(x, y), inverse_depth);
            EyeDepth& known = drawn(x, y);
            const bool wins = !known.is_known() || triangle.kind < known.kind ||
                              (triangle.kind == known.kind && inverse_depth > known.inverse_depth);
            if (wins) known = {inverse_depth, triangle.kind};
        }
    }
}

}  // namespace

Image<EyeDepth> rasterise(const DepthMesh& mesh, const LumigraphView& view, const Eye& eye,
                          double max_inverse_depth, double agreeing_inverse_depth) {
    const InverseDepthWarp eye_from_view = warp_from(view).to(eye);
    Image<EyeDepth> drawn(eye.camera.width_px, eye.camera.height_px);
    Image<double> nearest_stretched(eye.camera.width_px, eye.camera.height_px);
    for (std::size_t kind = 0; kind < static_cast<std::size_t>(kDepthKinds); ++kind) {
        for (std::size_t i = mesh.kind_begin[kind]; i < mesh.kind_begin[kind + 1]; i += 3) {
            EyeTriangle triangle;
            triangle.kind = static_cast<DepthKind>(kind);
            for (Eigen::Index corner = 0; corner < 3; ++corner) {
                const Eigen::Vector3d vertex =
                    mesh.vertices[mesh.indices[i + static_cast<std::size_t>(corner)]]
                        .cast<double>();
                triangle.inverse_depths_in_view[corner] = vertex.z();
                triangle.corners.col(corner) =
                    eye_from_view.homogeneous_at(vertex.head<2>(), vertex.z());
            }
            draw(triangle, eye.camera, max_inverse_depth, drawn, nearest_stretched);
        }
    }
    for (int y = 0; y < drawn.height(); ++y) {
        for (int x = 0; x < drawn.width(); ++x) {
            EyeDepth& depth = drawn(x, y);
            depth.is_behind_tear =
                depth.is_known() && depth.kind == DepthKind::kSeen &&
                nearest_stretched(x, y) - depth.inverse_depth > agreeing_inverse_depth;
        }
    }
    return drawn;
}

}  // namespace lumi
