#include "meshing/selection/thumbnail_prediction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "calib/capture/inverse_depth_warp.h"
#include "calib/capture/nearest_byte.h"
#include "calib/pictures/image_io.h"
#include "calib/work/median.h"
#include "meshing/warp/parallax.h"

namespace lumi {
namespace {

constexpr double kPixels = 4800;
constexpr double kMaxDifference = 80.0;
constexpr double kSameSurfacePx = 2.0;
constexpr double kLeastWeight = 1e-3;
constexpr double kLeastMeanSquare = 0.5;

Eigen::Vector3d steps_of(const Rgb8& color) {
    return {static_cast<double>(color.r), static_cast<double>(color.g),
            static_cast<double>(color.b)};
}

/// Bilinear; empty outside of the outermost centres of pixels.
std::optional<Rgb8> color_at(const ColorImage& image, const Eigen::Vector2d& pixel) {
    const double u = pixel.x() - 0.5;
    const double v = pixel.y() - 0.5;
    if (!(u >= 0 && v >= 0 && u <= image.width() - 1 && v <= image.height() - 1))
        return std::nullopt;
    const int x = std::min(static_cast<int>(u), image.width() - 2);
    const int y = std::min(static_cast<int>(v), image.height() - 2);
    const double right = u - x;
    const double down = v - y;
    const Eigen::Vector3d color =
        (1 - down) * ((1 - right) * steps_of(image(x, y)) + right * steps_of(image(x + 1, y))) +
        down * ((1 - right) * steps_of(image(x, y + 1)) + right * steps_of(image(x + 1, y + 1)));
    return Rgb8{nearest_byte(color.x()), nearest_byte(color.y()), nearest_byte(color.z())};
}

/// Onto the four pixels around, so that a surface seen from farther off has no gaps.
void splat(FloatImage& nearest, const Eigen::Vector2d& place, float inverse_depth) {
    const int left = static_cast<int>(std::floor(place.x() - 0.5));
    const int top = static_cast<int>(std::floor(place.y() - 0.5));
    for (int i = 0; i < 4; ++i) {
        const int x = left + i % 2;
        const int y = top + i / 2;
        if (nearest.contains(x, y)) nearest(x, y) = std::max(nearest(x, y), inverse_depth);
    }
}

double thumbnail_scale(const Camera& camera) {
    const double pixels = 1.0 * camera.width_px * camera.height_px;
    return std::min(1.0, std::sqrt(kPixels / pixels));
}

/// The camera of a thumbnail.
Camera at_thumbnail_size(const Camera& camera) {
    const double scale = thumbnail_scale(camera);
    return resized(camera, std::max(2, static_cast<int>(std::lround(scale * camera.width_px))),
                   std::max(2, static_cast<int>(std::lround(scale * camera.height_px))));
}

/// The median over the views of what `kSameSurfacePx` pixels of its thumbnail are worth, seen from
/// the nearest other camera that has parallax; infinite when all stand on one spot.
double inverse_depth_of_same_surface(const std::vector<PicturedView>& views) {
    std::vector<Eigen::Vector3d> centres;
    for (const PicturedView& view : views) centres.push_back(centre_in_world(view.cam_from_world));
    std::vector<double> steps;
    for (const PicturedView& view : views) {
        const double nearest = nearest_baseline(centre_in_world(view.cam_from_world), centres);
        if (nearest <= 0) continue;
        const double scale = thumbnail_scale(view.camera);
        steps.push_back(kSameSurfacePx / (scale * nearest * focal_length_px(view.camera).x()));
    }
    return median_of(std::move(steps), std::numeric_limits<double>::infinity());
}

}  // namespace

ColorImage thumbnail_of(const ColorImage& photograph, const Camera& camera) {
    const Camera small = at_thumbnail_size(camera);
    return resized(photograph, small.width_px, small.height_px);
}

ThumbnailPrediction::ThumbnailPrediction(const std::vector<PicturedView>& views) {
    for (const PicturedView& view : views) thumbnails_.push_back(thumbnail_of(view));
    same_surface_ = inverse_depth_of_same_surface(views);
}

ThumbnailPrediction::Thumbnail ThumbnailPrediction::thumbnail_of(const PicturedView& view) {
    const Camera camera = at_thumbnail_size(view.camera);
    const int width = camera.width_px;
    const int height = camera.height_px;
    Thumbnail thumbnail{camera, view.cam_from_world,
                        lumi::thumbnail_of(*view.photograph, view.camera),
                        FloatImage(width, height, -1.0F)};
    const FloatImage& inverse_depth = view.depth->inverse_depth;
    if (inverse_depth.empty()) return thumbnail;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            thumbnail.inverse_depth(x, y) =
                inverse_depth((2 * x + 1) * inverse_depth.width() / (2 * width),
                              (2 * y + 1) * inverse_depth.height() / (2 * height));
        }
    }
    return thumbnail;
}

ThumbnailPrediction::Carried ThumbnailPrediction::carry(const Thumbnail& from,
                                                        const Thumbnail& to) const {
    const int width = to.camera.width_px;
    const int height = to.camera.height_px;
    Carried result{FloatImage(width, height, -1.0F), ColorImage(width, height)};
    const InverseDepthWarp there = warp_from(from).to(to);
    for (int y = 0; y < from.camera.height_px; ++y) {
        for (int x = 0; x < from.camera.width_px; ++x) {
            const auto inverse_depth = static_cast<double>(from.inverse_depth(x, y));
            if (inverse_depth < 0) continue;
            const auto at = there.at({x + 0.5, y + 0.5}, inverse_depth);
            // Far outside, pixels could not even be counted.
            if (!at || at->pixel.cwiseAbs().maxCoeff() > 1e6) continue;
            splat(result.inverse_depth, at->pixel, static_cast<float>(at->inverse_depth));
        }
    }
    const InverseDepthWarp back = warp_from(to).to(from);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            float& inverse_depth = result.inverse_depth(x, y);
            if (inverse_depth < 0) continue;
            const auto at = back.at({x + 0.5, y + 0.5}, static_cast<double>(inverse_depth));
            const auto color = at ? color_at(from.photograph, at->pixel) : std::nullopt;
            if (color) {
                result.color(x, y) = *color;
            } else {
                inverse_depth = -1.0F;
            }
        }
    }
    return result;
}

const ThumbnailPrediction::Carried& ThumbnailPrediction::carried(int from, int to) {
    const auto found = carried_.find({from, to});
    if (found != carried_.end()) return found->second;
    return carried_
        .emplace(std::pair(from, to), carry(thumbnails_[static_cast<std::size_t>(from)],
                                            thumbnails_[static_cast<std::size_t>(to)]))
        .first->second;
}

double ThumbnailPrediction::loss_db(int view, const EnclosingViews& from) {
    std::vector<const Carried*> sources;
    for (const int source : from.views) sources.push_back(&carried(source, view));
    const ColorImage& truth = thumbnails_[static_cast<std::size_t>(view)].photograph;
    const auto same_surface = static_cast<float>(same_surface_);
    double squares = 0;
    for (std::size_t i = 0; i < truth.pixels().size(); ++i) {
        float nearest = -1.0F;
        for (const Carried* source : sources) {
            nearest = std::max(nearest, source->inverse_depth.pixels()[i]);
        }
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        double weights = 0;
        for (std::size_t k = 0; k < sources.size(); ++k) {
            const float inverse_depth = sources[k]->inverse_depth.pixels()[i];
            if (inverse_depth < 0 || nearest - inverse_depth > same_surface) continue;
            const double weight = std::max(from.weights[k], kLeastWeight);
            sum += weight * steps_of(sources[k]->color.pixels()[i]);
            weights += weight;
        }
        if (!(weights > 0)) {
            squares += 3 * kMaxDifference * kMaxDifference;
            continue;
        }
        const Eigen::Array3d difference = (sum / weights - steps_of(truth.pixels()[i])).array();
        squares += difference.square().min(kMaxDifference * kMaxDifference).sum();
    }
    const double mean = squares / (3.0 * static_cast<double>(truth.pixels().size()));
    return 10 * std::log10(std::max(mean, kLeastMeanSquare));
}

void ThumbnailPrediction::forget(int view) {
    const auto first = carried_.lower_bound({view, std::numeric_limits<int>::min()});
    carried_.erase(first, carried_.lower_bound({view + 1, std::numeric_limits<int>::min()}));
}

}  // namespace lumi
