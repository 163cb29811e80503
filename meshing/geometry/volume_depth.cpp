#include "meshing/geometry/volume_depth.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "calib/work/error.h"

namespace lumi {
namespace {

using CellBox = Eigen::AlignedBox3i;

CellBox box_of_solid_cells(const BinaryVolume& volume) {
    CellBox box;
    std::size_t at = 0;
    for (int z = 0; z < volume.size.z(); ++z) {
        for (int y = 0; y < volume.size.y(); ++y) {
            for (int x = 0; x < volume.size.x(); ++x, ++at) {
                if (volume.solid[at]) box.extend(Eigen::Vector3i(x, y, z));
            }
        }
    }
    return box;
}

struct GridRay {
    Eigen::Vector3d origin;
    Eigen::Vector3d direction;
};

/// Where the ray is in the box: from `enters` to `leaves`, in its direction's lengths.
struct Stretch {
    double enters = 0.0;
    double leaves = std::numeric_limits<double>::infinity();
};

std::optional<Stretch> in_box(const GridRay& ray, const CellBox& box) {
    Stretch stretch;
    for (int axis = 0; axis < 3; ++axis) {
        const double low = box.min()[axis] - ray.origin[axis];
        const double high = box.max()[axis] + 1 - ray.origin[axis];
        if (ray.direction[axis] == 0) {
            if (low > 0 || high <= 0) return std::nullopt;
            continue;
        }
        const double a = low / ray.direction[axis];
        const double b = high / ray.direction[axis];
        stretch.enters = std::max(stretch.enters, std::min(a, b));
        stretch.leaves = std::min(stretch.leaves, std::max(a, b));
    }
    if (stretch.enters >= stretch.leaves) return std::nullopt;
    return stretch;
}

/// How far along the ray the first solid cell begins.
std::optional<double> first_solid(const BinaryVolume& volume, const CellBox& box,
                                  const GridRay& ray) {
    const auto stretch = in_box(ray, box);
    if (!stretch) return std::nullopt;
    const Eigen::Vector3d start = ray.origin + stretch->enters * ray.direction;
    Eigen::Vector3i cell;
    Eigen::Vector3i step;
    Eigen::Vector3d next;  // Where the ray crosses into the next cell along each axis.
    Eigen::Vector3d stride;
    for (int axis = 0; axis < 3; ++axis) {
        const double direction = ray.direction[axis];
        cell[axis] =
            std::clamp(static_cast<int>(std::floor(start[axis])), box.min()[axis], box.max()[axis]);
        step[axis] = direction > 0 ? 1 : -1;
        stride[axis] = direction == 0 ? 0.0 : std::abs(1.0 / direction);
        next[axis] = direction == 0
                         ? std::numeric_limits<double>::infinity()
                         : (cell[axis] + (direction > 0 ? 1 : 0) - ray.origin[axis]) / direction;
    }
    double at = stretch->enters;
    while (!volume.is_solid(cell)) {
        int axis = next.x() < next.y() ? 0 : 1;
        if (next.z() < next[axis]) axis = 2;
        at = next[axis];
        cell[axis] += step[axis];
        if (cell[axis] < box.min()[axis] || cell[axis] > box.max()[axis]) return std::nullopt;
        next[axis] += stride[axis];
    }
    return at;
}

void require_outside(const BinaryVolume& volume, const CellBox& box,
                     const Eigen::Vector3d& centre_in_grid, const std::string& view_name) {
    const Eigen::Vector3i cell = centre_in_grid.array().floor().max(-1e9).min(1e9).cast<int>();
    if (!box.contains(cell) || !volume.is_solid(cell)) return;
    throw Error(ErrorKind::kBadInput, "E-VOLUME-INSIDE",
                "the camera of " + view_name + " stands in a solid cell of the volume",
                "bring the volume into the world of the poses: axes, origin, unit of length");
}

}  // namespace

VolumeCaster::VolumeCaster(BinaryVolume volume)
    : volume_(std::move(volume)), solid_cells_(box_of_solid_cells(volume_)) {}

DepthMap VolumeCaster::depth(const DepthView& view) const {
    DepthMap map{FloatImage(view.camera.width_px, view.camera.height_px),
                 GrayImage(view.camera.width_px, view.camera.height_px)};
    const Eigen::Affine3d grid_from_world = volume_.world_from_grid.inverse();
    const Eigen::Vector3d centre = grid_from_world * centre_in_world(view.cam_from_world);
    require_outside(volume_, solid_cells_, centre, view.name);
    const Eigen::Matrix3d grid_from_cam =
        grid_from_world.linear() * view.cam_from_world.rotation.inverse().toRotationMatrix();
    for (int y = 0; y < view.camera.height_px; ++y) {
        for (int x = 0; x < view.camera.width_px; ++x) {
            Eigen::Vector3d ray_in_cam = unproject(view.camera, {x + 0.5, y + 0.5});
            ray_in_cam /= ray_in_cam.z();  // Lengths along the ray are depths.
            const auto depth =
                first_solid(volume_, solid_cells_, {centre, grid_from_cam * ray_in_cam});
            if (!depth || *depth <= 0) continue;
            map.inverse_depth(x, y) = static_cast<float>(1.0 / *depth);
            map.confidence(x, y) = kKnown;
        }
    }
    return map;
}

}  // namespace lumi
