#include "pipeline/synth/photographer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace lumi {
namespace {

constexpr int kNothing = -1;
/// Below this cosine between ray and normal a pixel's stretch over the surface is not followed.
constexpr double kLeastSlant = 0.06;

/// What one ray meets.
struct Sample {
    double inverse_depth = 0.0;
    SurfacePlace place{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), kNothing};
    Illumination illumination;
};

/// Also true where both show nothing.
bool show_one_surface(const Sample& a, const Sample& b) {
    if (a.place.body_index != b.place.body_index) return false;
    if (a.place.body_index == kNothing) return true;
    if (a.place.normal.dot(b.place.normal) < 0.9) return false;
    const double depth_step = std::abs(a.inverse_depth - b.inverse_depth);
    return depth_step <= 0.02 * std::max(a.inverse_depth, b.inverse_depth);
}

/// The samples of the pixels around one, itself first.
class Neighbourhood {
 public:
    Neighbourhood(const Image<Sample>& samples, int x, int y) {
        samples_[count_++] = &samples(x, y);
        for (int dy = -1; dy <= 1; ++dy) {
            for (int dx = -1; dx <= 1; ++dx) {
                if ((dx == 0 && dy == 0) || !samples.contains(x + dx, y + dy)) continue;
                samples_[count_++] = &samples(x + dx, y + dy);
            }
        }
    }
    [[nodiscard]] std::span<const Sample* const> all() const { return {samples_.data(), count_}; }

 private:
    std::array<const Sample*, 9> samples_{};
    std::size_t count_ = 0;
};

/// A square of pixels, and the bodies that it may show.
struct Tile {
    static constexpr int kSize = 16;
    std::vector<int> body_indices;
};

/// A pixel seen at a slant covers more of the surface one way than the other; the geometric mean of
/// the two balances blur against aliasing.
double footprint_of(double pixel_width, const SurfacePlace& place, const Ray& ray) {
    return pixel_width / std::sqrt(std::max(-place.normal.dot(ray.direction), kLeastSlant));
}

/// The mean of `light_at(pixel)` over the samples of a pixel. Clamped as a sensor is, lest a
/// highlight outshine the whole pixel.
template <class LightAt>
LinearColor mean_over_grid(int x, int y, int count, const LightAt& light_at) {
    LinearColor sum = LinearColor::Zero();
    for (int row = 0; row < count; ++row) {
        for (int column = 0; column < count; ++column) {
            const Eigen::Vector2d pixel(x + (column + 0.5) / count, y + (row + 0.5) / count);
            sum += light_at(pixel).cwiseMin(1.0f);
        }
    }
    return sum / static_cast<float>(count * count);
}

/// One picture in the making.
class Shot {
 public:
    Shot(const Scene& scene, const Camera& camera, const Rigid3& cam_from_world,
         const SamplingOptions& options);
    [[nodiscard]] ExactPicture picture() const;

 private:
    [[nodiscard]] PixelRay ray_at(const Eigen::Vector2d& pixel) const {
        return ray_through(camera_, world_from_cam_, pixel);
    }
    [[nodiscard]] const Tile& tile_of(int x, int y) const {
        return tiles_(x / Tile::kSize, y / Tile::kSize);
    }
    [[nodiscard]] Tile tile_at(int column, int row) const;
    /// What a ray meets; its illumination is left open.
    [[nodiscard]] Sample met_by(const PixelRay& through, const Tile& tile) const;
    [[nodiscard]] LinearColor light_along(const Ray& ray, const SurfacePlace& place,
                                          const Illumination& illumination, double width_px) const;
    /// The mean over a pixel that shows several surfaces: every ray is followed.
    [[nodiscard]] LinearColor mean_of_rays(int x, int y, const Neighbourhood& around) const;
    /// The mean over a pixel that shows one surface, which is flat within a pixel.
    [[nodiscard]] LinearColor mean_of_texture(int x, int y) const;
    [[nodiscard]] LinearColor mean_over_pixel(int x, int y) const;

    const Scene& scene_;
    const Camera& camera_;
    Rigid3 world_from_cam_;
    SamplingOptions options_;
    double pixel_angle_;
    Image<Tile> tiles_;
    Image<Sample> centres_;  ///< Of the pixels.
};

Shot::Shot(const Scene& scene, const Camera& camera, const Rigid3& cam_from_world,
           const SamplingOptions& options)
    : scene_(scene),
      camera_(camera),
      world_from_cam_(inverse(cam_from_world)),
      options_(options),
      pixel_angle_(1.0 / focal_length_px(camera).minCoeff()),
      tiles_((camera.width_px + Tile::kSize - 1) / Tile::kSize,
             (camera.height_px + Tile::kSize - 1) / Tile::kSize),
      centres_(camera.width_px, camera.height_px) {
    for (int row = 0; row < tiles_.height(); ++row) {
        for (int column = 0; column < tiles_.width(); ++column) {
            tiles_(column, row) = tile_at(column, row);
        }
    }
    for (int y = 0; y < camera.height_px; ++y) {
        for (int x = 0; x < camera.width_px; ++x) {
            Sample& centre = centres_(x, y);
            centre = met_by(ray_at({x + 0.5, y + 0.5}), tile_of(x, y));
            if (centre.place.body_index == kNothing) continue;
            centre.illumination = illumination_at(scene_, centre.place);
        }
    }
}

Tile Shot::tile_at(int column, int row) const {
    const Eigen::Vector2d corner(column * Tile::kSize, row * Tile::kSize);
    const Ray axis = ray_at(corner + Eigen::Vector2d::Constant(0.5 * Tile::kSize)).ray;
    double least_cosine = 1.0;
    for (const Eigen::Vector2d& share : {Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 0),
                                         Eigen::Vector2d(0, 1), Eigen::Vector2d(1, 1)}) {
        const Ray ray = ray_at(corner + Tile::kSize * share).ray;
        least_cosine = std::min(least_cosine, ray.direction.dot(axis.direction));
    }
    // A lens may bend the tile's sides outwards a little.
    constexpr double kBend = 1.1;
    return {bodies_in_cone(scene_, axis, kBend * std::acos(least_cosine))};
}

Sample Shot::met_by(const PixelRay& through, const Tile& tile) const {
    const auto hit = first_hit(scene_, through.ray, tile.body_indices);
    if (!hit) return {};
    const Body& body = scene_.bodies[static_cast<std::size_t>(hit->body_index)];
    const Eigen::Vector3d point = through.ray.at(hit->distance);
    return {1.0 / (hit->distance * through.depth_per_distance),
            {point, body.normal_at(point), hit->body_index},
            {}};
}

LinearColor Shot::light_along(const Ray& ray, const SurfacePlace& place,
                              const Illumination& illumination, double width_px) const {
    const double distance = (place.point_in_world - ray.origin).norm();
    return light_towards_eye(scene_, place, illumination, -ray.direction,
                             footprint_of(width_px * pixel_angle_ * distance, place, ray));
}

LinearColor Shot::mean_of_rays(int x, int y, const Neighbourhood& around) const {
    const int count = options_.samples_per_edge;
    return mean_over_grid(x, y, count, [&](const Eigen::Vector2d& pixel) -> LinearColor {
        const PixelRay through = ray_at(pixel);
        Sample sample = met_by(through, tile_of(x, y));
        if (sample.place.body_index == kNothing) return LinearColor::Zero();
        // Illumination is smooth: that of a neighbour on the same surface serves.
        const auto alike = std::find_if(
            around.all().begin(), around.all().end(),
            [&](const Sample* neighbour) { return show_one_surface(sample, *neighbour); });
        sample.illumination = alike != around.all().end() ? (*alike)->illumination
                                                          : illumination_at(scene_, sample.place);
        return light_along(through.ray, sample.place, sample.illumination, 1.0 / count);
    });
}

LinearColor Shot::mean_of_texture(int x, int y) const {
    const int count = options_.samples_per_texture;
    const Sample& centre = centres_(x, y);
    const SurfacePlace& tangent = centre.place;
    return mean_over_grid(x, y, count, [&](const Eigen::Vector2d& pixel) {
        const Ray ray = ray_at(pixel).ray;
        const double distance = tangent.normal.dot(tangent.point_in_world - ray.origin) /
                                tangent.normal.dot(ray.direction);
        const SurfacePlace place{ray.at(distance), tangent.normal, tangent.body_index};
        return light_along(ray, place, centre.illumination, 1.0 / count);
    });
}

LinearColor Shot::mean_over_pixel(int x, int y) const {
    const Sample& centre = centres_(x, y);
    const Neighbourhood around(centres_, x, y);
    const bool shows_one_surface =
        std::all_of(around.all().begin(), around.all().end(),
                    [&](const Sample* other) { return show_one_surface(centre, *other); });
    if (!shows_one_surface) return mean_of_rays(x, y, around);
    if (centre.place.body_index == kNothing) return LinearColor::Zero();
    // Almost edge on, a surface is not flat within a pixel.
    const Eigen::Vector3d towards_eye =
        (world_from_cam_.translation - centre.place.point_in_world).normalized();
    if (centre.place.normal.dot(towards_eye) < kLeastSlant) return mean_of_rays(x, y, around);
    return mean_of_texture(x, y);
}

ExactPicture Shot::picture() const {
    ExactPicture picture{
        Image<LinearColor>(camera_.width_px, camera_.height_px, LinearColor::Zero()),
        FloatImage(camera_.width_px, camera_.height_px)};
    for (int y = 0; y < camera_.height_px; ++y) {
        for (int x = 0; x < camera_.width_px; ++x) {
            picture.light(x, y) = mean_over_pixel(x, y);
            const Sample& centre = centres_(x, y);
            if (centre.place.body_index == kNothing) continue;
            picture.depth(x, y) = static_cast<float>(1.0 / centre.inverse_depth);
        }
    }
    return picture;
}

}  // namespace

PixelRay ray_through(const Camera& camera, const Rigid3& world_from_cam,
                     const Eigen::Vector2d& pixel) {
    const Eigen::Vector3d at_depth_one = unproject(camera, pixel);
    const double length = at_depth_one.norm();
    return {{world_from_cam.translation, world_from_cam.rotation * (at_depth_one / length)},
            1.0 / length};
}

ExactPicture photograph(const Scene& scene, const Camera& camera, const Rigid3& cam_from_world,
                        const SamplingOptions& options) {
    return Shot(scene, camera, cam_from_world, options).picture();
}

}  // namespace lumi
