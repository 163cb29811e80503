#include "tests/meshing/depth/raycast_scene.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "calib/pictures/image_io.h"

namespace lumi {
namespace {

/// A hash of a lattice corner, 0 to 1.
double corner_value(int x, int y, int z, unsigned seed) {
    std::uint32_t h = seed;
    for (const int coordinate : {x, y, z}) {
        h = (h ^ static_cast<std::uint32_t>(coordinate)) * 0x9E3779B1U;
        h ^= h >> 15;
    }
    h *= 0x85EBCA77U;
    return static_cast<double>(h >> 8) / static_cast<double>(1U << 24);
}

double value_noise(const Eigen::Vector3d& point, unsigned seed) {
    const Eigen::Vector3d cell = point.array().floor();
    const Eigen::Vector3d t = point - cell;
    const Eigen::Vector3i corner = cell.cast<int>();
    double sum = 0;
    for (int i = 0; i < 8; ++i) {
        const Eigen::Vector3i d(i & 1, (i >> 1) & 1, i >> 2);
        double weight = 1;
        for (int axis = 0; axis < 3; ++axis) weight *= d[axis] == 1 ? t[axis] : 1 - t[axis];
        const Eigen::Vector3i c = corner + d;
        sum += weight * corner_value(c.x(), c.y(), c.z(), seed);
    }
    return sum;
}

struct Hit {
    double depth = std::numeric_limits<double>::infinity();
    double gray = 0;
};

Hit first_hit(const std::vector<TexturedPlane>& planes, const Eigen::Vector3d& eye,
              const Eigen::Vector3d& direction) {
    Hit nearest;
    for (const TexturedPlane& plane : planes) {
        const double depth = plane.normal.dot(plane.point - eye) / plane.normal.dot(direction);
        if (!(depth > 0) || depth >= nearest.depth) continue;
        const Eigen::Vector3d point = eye + depth * direction;
        if (plane.covers(point)) nearest = {depth, plane.gray(point)};
    }
    return nearest;
}

}  // namespace

std::function<double(const Eigen::Vector3d&)> noise_texture(double detail, unsigned seed) {
    return [=](const Eigen::Vector3d& point) {
        const double noise = 0.5 * value_noise(point / detail, seed) +
                             0.3 * value_noise(point / (2.1 * detail), seed + 1) +
                             0.2 * value_noise(point / (5.3 * detail), seed + 2);
        return 40 + 175 * noise;
    };
}

Raycast raycast(const std::vector<TexturedPlane>& planes, const Camera& camera,
                const Rigid3& cam_from_world) {
    const Rigid3 world_from_cam = inverse(cam_from_world);
    const auto hit_at = [&](double x, double y) {
        const Eigen::Vector3d direction =
            world_from_cam.rotation * unproject(camera, Eigen::Vector2d(x, y));
        return first_hit(planes, world_from_cam.translation, direction);
    };
    Raycast result{ColorImage(camera.width_px, camera.height_px),
                   FloatImage(camera.width_px, camera.height_px)};
    for (int y = 0; y < camera.height_px; ++y) {
        for (int x = 0; x < camera.width_px; ++x) {
            result.inverse_depth(x, y) = static_cast<float>(1.0 / hit_at(x + 0.5, y + 0.5).depth);
            double gray = 0;
            for (const double dx : {0.25, 0.75}) {
                for (const double dy : {0.25, 0.75}) gray += 0.25 * hit_at(x + dx, y + dy).gray;
            }
            const auto value = static_cast<std::uint8_t>(std::lround(gray));
            result.photograph(x, y) = {value, value, value};
        }
    }
    return result;
}

Camera small_camera() { return pinhole_camera(240, 180, 220.0); }

Rigid3 looking_ahead_from(const Eigen::Vector3d& centre) {
    return {Eigen::Quaterniond::Identity(), -centre};
}

std::vector<Eigen::Vector3d> cross_of_centres(double baseline) {
    return {{0, 0, 0}, {-baseline, 0, 0}, {baseline, 0, 0}, {0, -baseline, 0}, {0, baseline, 0}};
}

KnownDepthScene known_depth_scene(const std::vector<TexturedPlane>& planes,
                                  const std::vector<Eigen::Vector3d>& centres,
                                  const InverseDepthRange& range) {
    KnownDepthScene known;
    double longest = 0;
    for (std::size_t i = 0; i < centres.size(); ++i) {
        DepthView view;
        view.name = "view" + std::to_string(i) + ".png";
        view.camera = small_camera();
        view.cam_from_world = looking_ahead_from(centres[i]);
        Raycast seen = raycast(planes, view.camera, view.cam_from_world);
        view.photograph = std::move(seen.photograph);
        view.range = range;
        for (std::size_t j = 0; j < centres.size(); ++j) {
            if (j != i) view.neighbours.push_back(static_cast<int>(j));
        }
        known.scene.views.push_back(std::move(view));
        known.inverse_depths.push_back(std::move(seen.inverse_depth));
        longest = std::max(longest, (centres[i] - centres[0]).norm());
    }
    for (DepthView& view : known.scene.views) {
        view.disparity_px_per_inverse_depth = focal_length_px(view.camera).x() * longest;
    }
    return known;
}

PosedPhotographs written(const KnownDepthScene& known, const std::filesystem::path& folder) {
    PosedPhotographs photographs;
    photographs.capture.cameras.push_back(small_camera());
    for (const DepthView& view : known.scene.views) {
        photographs.capture.views.push_back({view.name, 0, view.cam_from_world});
        photographs.picture_paths.push_back(folder / view.name);
        write_png(photographs.picture_paths.back(), view.photograph);
    }
    return photographs;
}

FloatImage errors_px(const DepthMap& map, const FloatImage& truth, const DepthView& view) {
    FloatImage errors(truth.width(), truth.height());
    for (std::size_t i = 0; i < truth.pixels().size(); ++i) {
        errors.pixels()[i] = std::abs(map.inverse_depth.pixels()[i] - truth.pixels()[i]) *
                             static_cast<float>(view.disparity_px_per_inverse_depth);
    }
    return errors;
}

}  // namespace lumi
