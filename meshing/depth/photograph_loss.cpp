#include "meshing/depth/photograph_loss.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "calib/capture/gray.h"
#include "calib/capture/inverse_depth_warp.h"
#include "meshing/selection/one_standard_error.h"

namespace lumi {
namespace {

constexpr int kTile = 32;
constexpr int kStride = 2;  // Every fourth pixel says enough.
constexpr int kMinPixelsOfTile = 64;
constexpr std::size_t kMinTiles = 30;
constexpr double kMaxDifference = 80.0;

double bilinear(const GrayImage& gray, double u, double v) {
    const int x = static_cast<int>(u);
    const int y = static_cast<int>(v);
    const double right = u - x;
    const double down = v - y;
    const double upper = gray(x, y) * (1 - right) + gray(x + 1, y) * right;
    const double lower = gray(x, y + 1) * (1 - right) + gray(x + 1, y + 1) * right;
    return upper * (1 - down) + lower * down;
}

/// Where a pixel of one view lies in another.
struct Place {
    double u = 0.0;  ///< 0 is the centre of the first pixel.
    double v = 0.0;
    double inverse_depth = 0.0;  ///< There.
};
std::optional<Place> place_of(const InverseDepthWarp& warp, int x, int y, double inverse_depth,
                              const Camera& there) {
    const auto at = warp.at({x + 0.5, y + 0.5}, inverse_depth);
    if (!at) return std::nullopt;
    const Place place{at->pixel.x() - 0.5, at->pixel.y() - 0.5, at->inverse_depth};
    const bool is_inside = place.u >= 0 && place.v >= 0 && place.u < there.width_px - 1 &&
                           place.v < there.height_px - 1;
    return is_inside ? std::optional(place) : std::nullopt;
}

/// What one view says of the photograph.
class Prediction {
 public:
    Prediction(const PredictingView& from, const DepthView& photograph)
        : gray_(gray_of(from.view->photograph)),
          back_(warp_from(photograph).to(*from.view)),
          camera_(from.view->camera),
          weight_(1.0 / std::max(kLeastDistance, distance(*from.view, photograph))),
          nearest_(photograph.camera.width_px, photograph.camera.height_px, kNothing) {
        const InverseDepthWarp there = warp_from(*from.view).to(photograph);
        for (int y = 0; y < gray_.height(); ++y) {
            for (int x = 0; x < gray_.width(); ++x) {
                const auto inverse_depth = static_cast<double>((*from.inverse_depth)(x, y));
                const auto place = place_of(there, x, y, inverse_depth, photograph.camera);
                if (place) splat(*place);
            }
        }
    }

    /// Inverse depth of the nearest surface before a pixel of the photograph; kNothing: none.
    [[nodiscard]] float nearest(int x, int y) const { return nearest_(x, y); }

    /// Grey level of that surface.
    [[nodiscard]] std::optional<double> gray(int x, int y) const {
        const auto place = place_of(back_, x, y, static_cast<double>(nearest_(x, y)), camera_);
        if (!place) return std::nullopt;
        return bilinear(gray_, place->u, place->v);
    }

    /// Of what it says: views near the photograph show surfaces as it does.
    [[nodiscard]] double weight() const { return weight_; }

    static constexpr float kNothing = -1.0F;

 private:
    static constexpr double kLeastDistance = 1e-12;

    [[nodiscard]] static double distance(const DepthView& a, const DepthView& b) {
        return (centre_in_world(a.cam_from_world) - centre_in_world(b.cam_from_world)).norm();
    }

    /// Onto the four pixels around, so that a surface seen from farther off has no gaps.
    void splat(const Place& place) {
        for (int i = 0; i < 4; ++i) {
            float& nearest =
                nearest_(static_cast<int>(place.u) + i % 2, static_cast<int>(place.v) + i / 2);
            nearest = std::max(nearest, static_cast<float>(place.inverse_depth));
        }
    }

    GrayImage gray_;
    InverseDepthWarp back_;
    Camera camera_;
    double weight_;
    FloatImage nearest_;
};

/// A pixel of the photograph, and what is predicted there.
struct PixelPair {
    std::size_t tile = 0;
    double own = 0.0;
    double predicted = 0.0;
};

/// The surface that most of the views put before a pixel, those near the photograph counting more;
/// the nearest of equals. kNothing where none puts one.
float agreed_surface(const std::vector<Prediction>& predictions, int x, int y,
                     double same_surface) {
    float agreed = Prediction::kNothing;
    double most = 0;
    for (const Prediction& prediction : predictions) {
        const float candidate = prediction.nearest(x, y);
        if (candidate < 0) continue;
        double support = 0;
        for (const Prediction& other : predictions) {
            const float there = other.nearest(x, y);
            if (there < 0 || static_cast<double>(std::abs(there - candidate)) > same_surface) {
                continue;
            }
            support += other.weight();
        }
        if (support < most || (support == most && candidate < agreed)) continue;
        most = support;
        agreed = candidate;
    }
    return agreed;
}

std::optional<double> mean_gray(const std::vector<Prediction>& predictions, int x, int y,
                                double one_pixel) {
    constexpr double kSameSurfacePx = 2.0;
    const double same_surface = kSameSurfacePx * one_pixel;
    const float agreed = agreed_surface(predictions, x, y, same_surface);
    if (agreed < 0) return std::nullopt;
    double sum = 0;
    double weight = 0;
    for (const Prediction& prediction : predictions) {
        const float own = prediction.nearest(x, y);
        if (own < 0 || static_cast<double>(std::abs(own - agreed)) > same_surface) continue;
        const auto gray = prediction.gray(x, y);
        if (!gray) continue;
        sum += prediction.weight() * *gray;
        weight += prediction.weight();
    }
    return weight > 0 ? std::optional(sum / weight) : std::nullopt;
}

std::vector<PixelPair> pairs_of(const std::vector<PredictingView>& views,
                                const DepthView& photograph, int tiles_across) {
    std::vector<Prediction> predictions;
    for (const PredictingView& view : views) predictions.emplace_back(view, photograph);
    const GrayImage own = gray_of(photograph.photograph);
    const double one_pixel = 1.0 / photograph.disparity_px_per_inverse_depth;
    std::vector<PixelPair> pairs;
    for (int y = 0; y < own.height(); y += kStride) {
        for (int x = 0; x < own.width(); x += kStride) {
            const auto predicted = mean_gray(predictions, x, y, one_pixel);
            if (!predicted) continue;
            pairs.push_back({static_cast<std::size_t>(y / kTile * tiles_across + x / kTile),
                             static_cast<double>(own(x, y)), *predicted});
        }
    }
    return pairs;
}

}  // namespace

std::vector<double> photograph_loss(const std::vector<PredictingView>& views,
                                    const DepthView& photograph) {
    const int across = (photograph.camera.width_px + kTile - 1) / kTile;
    const int down = (photograph.camera.height_px + kTile - 1) / kTile;
    const std::vector<PixelPair> pairs = pairs_of(views, photograph, across);
    double own = 0;
    double predicted = 0;
    for (const PixelPair& pair : pairs) {
        own += pair.own;
        predicted += pair.predicted;
    }
    const double gain = own > 0 && predicted > 0 ? own / predicted : 1.0;
    std::vector<double> sums(static_cast<std::size_t>(across * down), 0.0);
    std::vector<int> counts(sums.size(), 0);
    for (const PixelPair& pair : pairs) {
        const double difference =
            std::min(kMaxDifference, std::abs(pair.own - gain * pair.predicted));
        sums[pair.tile] += difference * difference;
        ++counts[pair.tile];
    }
    for (std::size_t i = 0; i < sums.size(); ++i) {
        sums[i] = counts[i] < kMinPixelsOfTile ? kTileUnseen : sums[i] / counts[i];
    }
    return sums;
}

bool is_clearly_closer(const std::vector<double>& next, const std::vector<double>& current,
                       double standard_errors) {
    constexpr double kLeastGain_db = 0.1;
    constexpr double kRounding = 1.0;  // Of squared grey levels: less is no error.
    std::vector<double> next_db;
    std::vector<double> current_db;
    for (std::size_t i = 0; i < std::min(next.size(), current.size()); ++i) {
        if (next[i] < 0 || current[i] < 0) continue;
        next_db.push_back(10 * std::log10(next[i] + kRounding));
        current_db.push_back(10 * std::log10(current[i] + kRounding));
    }
    if (next_db.size() < kMinTiles) return false;
    const Excess gain = excess_over(current_db, next_db);
    return gain.mean > std::max(standard_errors * gain.standard_error, kLeastGain_db);
}

double rms_of(const std::vector<double>& tiles) {
    double sum = 0;
    int count = 0;
    for (const double tile : tiles) {
        if (tile < 0) continue;
        sum += tile;
        ++count;
    }
    return count == 0 ? 0.0 : std::sqrt(sum / count);
}

}  // namespace lumi
