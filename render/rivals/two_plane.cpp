#include "render/rivals/two_plane.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace lumi {
namespace {

/// A plane's frame: x and y along it, z towards the scene.
struct PlaneFrame {
    Eigen::Matrix3d plane_from_world;
    Eigen::Vector3d scene_centre_in_world;
};

/// The pictures of a plane's eye points: what they show of the parallel plane through the scene's
/// centre, around it.
struct SharedRectangle {
    Eigen::Vector2d half_size;
    int width_px = 0;
    int height_px = 0;
};

/// As large, and with as many pixels.
SharedRectangle as_square(const SharedRectangle& rectangle) {
    const double half = std::sqrt(rectangle.half_size.x() * rectangle.half_size.y());
    const auto side_px = static_cast<int>(
        std::lround(std::sqrt(static_cast<double>(rectangle.width_px) * rectangle.height_px)));
    return {{half, half}, side_px, side_px};
}

/// The view through `eye_in_world` whose picture is the rectangle.
Eye sheared_view(const PlaneFrame& plane, const Eigen::Vector3d& eye_in_world,
                 const SharedRectangle& picture) {
    const Eigen::Vector3d to_centre =
        plane.plane_from_world * (plane.scene_centre_in_world - eye_in_world);
    const Eigen::Vector2d half_px(0.5 * picture.width_px, 0.5 * picture.height_px);
    const Eigen::Vector2d focal_px = to_centre.z() * half_px.cwiseQuotient(picture.half_size);
    const Eigen::Vector2d centre_px =
        half_px - focal_px.cwiseProduct(to_centre.head<2>()) / to_centre.z();
    Camera camera = pinhole_camera(picture.width_px, picture.height_px, focal_px.x());
    camera.parameters = {focal_px.x(), focal_px.y(), centre_px.x(), centre_px.y()};
    Rigid3 cam_from_world;
    cam_from_world.rotation = Eigen::Quaterniond(plane.plane_from_world);
    cam_from_world.translation = -(cam_from_world.rotation * eye_in_world);
    return {camera, cam_from_world};
}

std::vector<Eigen::Vector3d> centres_of(const Lumigraph& source) {
    std::vector<Eigen::Vector3d> centres;
    for (const LumigraphView& view : source.views)
        centres.push_back(centre_in_world(view.cam_from_world));
    return centres;
}

/// Less than this of an axis across another is none.
constexpr double kNoDirection = 1e-3;

/// The plane across the mean of the cameras' axes, with their mean down; cameras all around the
/// axis have none, of which the first's counts.
PlaneFrame plane_of(const Lumigraph& source) {
    Eigen::Vector3d axis = Eigen::Vector3d::Zero();
    Eigen::Vector3d down = Eigen::Vector3d::Zero();
    for (const LumigraphView& view : source.views) {
        axis += view.cam_from_world.rotation.conjugate() * Eigen::Vector3d::UnitZ();
        down += view.cam_from_world.rotation.conjugate() * Eigen::Vector3d::UnitY();
    }
    axis.normalize();
    if (axis.cross(down).norm() < kNoDirection * static_cast<double>(source.views.size()))
        down = source.views.front().cam_from_world.rotation.conjugate() * Eigen::Vector3d::UnitY();
    return {rotation_with_axis(axis, down), source.mesh.scene_centre_in_world};
}

Eigen::AlignedBox3d extent_on(const PlaneFrame& plane,
                              const std::vector<Eigen::Vector3d>& centres_in_world) {
    Eigen::AlignedBox3d extent;
    for (const Eigen::Vector3d& centre : centres_in_world)
        extent.extend((plane.plane_from_world * centre).eval());
    return extent;
}

/// Two triangles a square; seen from outside they turn counter-clockwise.
void append_square(CameraMesh& mesh, int a, int b, int c, int d) {
    for (CameraMesh::Face face : {CameraMesh::Face{a, b, c}, CameraMesh::Face{a, c, d}}) {
        const auto at = [&](std::size_t i) {
            return mesh.vertices[static_cast<std::size_t>(face[i])].position_in_world;
        };
        const Eigen::Vector3d normal = (at(1) - at(0)).cross(at(2) - at(0));
        if (normal.dot(at(0) - mesh.scene_centre_in_world) < 0) std::swap(face[1], face[2]);
        mesh.faces.push_back(face);
    }
}

}  // namespace

TwoPlaneOptions with_even_grid(const Lumigraph& source, std::size_t pictures,
                               TwoPlaneOptions options) {
    const Eigen::Vector3d size = extent_on(plane_of(source), centres_of(source)).sizes();
    const double least_size = 1e-9 * size.maxCoeff();
    const double width = std::max(least_size, size.x());
    const double height = std::max(least_size, size.y());
    const auto wanted = std::max(4.0, static_cast<double>(pictures));
    double least = std::numeric_limits<double>::infinity();
    for (int columns = 2; 2 * columns <= wanted; ++columns) {
        const int rows = std::max(2, static_cast<int>(std::lround(wanted / columns)));
        const double unevenness = std::abs(std::log(width / (columns - 1) / (height / (rows - 1))));
        const double cost = unevenness + std::abs(std::log(columns * rows / wanted));
        if (cost >= least) continue;
        least = cost;
        options.columns = columns;
        options.rows = rows;
    }
    return options;
}

LightFieldLayout two_plane_slab(const Lumigraph& source, const TwoPlaneOptions& options) {
    const std::vector<Eigen::Vector3d> centres = centres_of(source);
    const PlaneFrame plane = plane_of(source);
    const Eigen::AlignedBox3d extent = extent_on(plane, centres);
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& centre : centres)
        mean += plane.plane_from_world * centre / static_cast<double>(centres.size());
    LightFieldLayout layout;
    layout.mesh.construction = MeshConstruction::kOpen;
    layout.mesh.scene_centre_in_world = plane.scene_centre_in_world;
    const SharedRectangle picture{seen_half_size(source), options.width_px, options.height_px};
    for (int row = 0; row < options.rows; ++row) {
        for (int column = 0; column < options.columns; ++column) {
            const Eigen::Vector3d share(static_cast<double>(column) / (options.columns - 1),
                                        static_cast<double>(row) / (options.rows - 1), 0);
            Eigen::Vector3d at = extent.min() + share.cwiseProduct(extent.sizes());
            at.z() = mean.z();
            const Eigen::Vector3d eye_in_world = plane.plane_from_world.transpose() * at;
            layout.mesh.vertices.push_back(
                {eye_in_world, static_cast<int>(layout.mesh.vertices.size())});
            layout.eyes.push_back(sheared_view(plane, eye_in_world, picture));
            if (row == 0 || column == 0) continue;
            const int here = static_cast<int>(layout.mesh.vertices.size()) - 1;
            append_square(layout.mesh, here, here - 1, here - 1 - options.columns,
                          here - options.columns);
        }
    }
    const Rigid3& cam_from_world = layout.eyes.front().cam_from_world;
    layout.shared_plane = {.depth = (cam_from_world * plane.scene_centre_in_world).z(),
                           .cam_from_world = cam_from_world};
    return layout;
}

LightFieldLayout two_plane_cube(const Lumigraph& source, const TwoPlaneOptions& options) {
    LightFieldLayout layout;
    layout.mesh.construction = MeshConstruction::kClosed;
    const Eigen::Vector3d centre = source.mesh.scene_centre_in_world;
    layout.mesh.scene_centre_in_world = centre;
    double distance = 0;
    for (const Eigen::Vector3d& at : centres_of(source))
        distance += (at - centre).norm() / static_cast<double>(source.views.size());
    const SharedRectangle picture =
        as_square({seen_half_size(source), options.width_px, options.height_px});
    const int last = options.columns - 1;
    for (int side = 0; side < 6; ++side) {
        const int axis = side / 2;
        const double sign = side % 2 == 0 ? 1 : -1;
        const Eigen::Vector3d outwards = sign * Eigen::Vector3d::Unit(axis);
        const Eigen::Vector3d u = Eigen::Vector3d::Unit((axis + 1) % 3);
        const Eigen::Vector3d v = Eigen::Vector3d::Unit((axis + 2) % 3);
        const PlaneFrame plane{rotation_with_axis(-outwards, v), centre};
        const auto first = static_cast<int>(layout.mesh.vertices.size());
        for (int row = 0; row <= last; ++row) {
            for (int column = 0; column <= last; ++column) {
                // The mean distance lies between that of the sides and that of the corners.
                const Eigen::Vector3d at = centre + 0.75 * distance *
                                                        (outwards + (2.0 * column / last - 1) * u +
                                                         (2.0 * row / last - 1) * v);
                layout.mesh.vertices.push_back({at, static_cast<int>(layout.mesh.vertices.size())});
                layout.eyes.push_back(sheared_view(plane, at, picture));
                if (row == 0 || column == 0) continue;
                const int here = first + row * options.columns + column;
                append_square(layout.mesh, here, here - 1, here - 1 - options.columns,
                              here - options.columns);
            }
        }
    }
    return layout;
}

}  // namespace lumi
