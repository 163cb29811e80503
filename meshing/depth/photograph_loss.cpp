#include "meshing/depth/photograph_loss.h"

#include <algorithm>
#include <cmath>

#include "calib/capture/gray.h"
#include "meshing/depth/inverse_depth_warp.h"

namespace lumi {
namespace {

constexpr int kTile = 32;
constexpr int kStride = 2;  // Every fourth pixel says enough.
constexpr int kMinPixelsOfTile = 64;
constexpr std::size_t kMinTiles = 30;
constexpr double kMaxDifference = 80.0;

/// A pixel of the view and what the other photograph shows there.
struct PixelPair {
    std::size_t tile = 0;
    double own = 0.0;
    double other = 0.0;
};

double bilinear(const GrayImage& gray, double u, double v) {
    const int x = static_cast<int>(u);
    const int y = static_cast<int>(v);
    const double right = u - x;
    const double down = v - y;
    const double upper = gray(x, y) * (1 - right) + gray(x + 1, y) * right;
    const double lower = gray(x, y + 1) * (1 - right) + gray(x + 1, y + 1) * right;
    return upper * (1 - down) + lower * down;
}

std::vector<PixelPair> pairs_of(const DepthView& view, const FloatImage& inverse_depth,
                                const DepthView& other, int tiles_across) {
    const InverseDepthWarp warp =
        warp_b_from_a(view.camera, view.cam_from_world, other.camera, other.cam_from_world);
    const GrayImage own = gray_of(view.photograph);
    const GrayImage there = gray_of(other.photograph);
    std::vector<PixelPair> pairs;
    for (int y = 0; y < own.height(); y += kStride) {
        for (int x = 0; x < own.width(); x += kStride) {
            const Eigen::Vector3d p =
                warp(Eigen::Vector2d(x + 0.5, y + 0.5), static_cast<double>(inverse_depth(x, y)));
            if (p.z() <= 0) continue;
            const double u = p.x() / p.z() - 0.5;
            const double v = p.y() / p.z() - 0.5;
            const bool is_inside =
                u >= 0 && v >= 0 && u < there.width() - 1 && v < there.height() - 1;
            if (!is_inside) continue;
            const auto tile = static_cast<std::size_t>(y / kTile * tiles_across + x / kTile);
            pairs.push_back({tile, static_cast<double>(own(x, y)), bilinear(there, u, v)});
        }
    }
    return pairs;
}

}  // namespace

std::vector<double> photograph_loss(const DepthView& view, const FloatImage& inverse_depth,
                                    const DepthView& other) {
    const int across = (view.camera.width_px + kTile - 1) / kTile;
    const int down = (view.camera.height_px + kTile - 1) / kTile;
    const std::vector<PixelPair> pairs = pairs_of(view, inverse_depth, other, across);
    double own = 0;
    double there = 0;
    for (const PixelPair& pair : pairs) {
        own += pair.own;
        there += pair.other;
    }
    const double gain = own > 0 && there > 0 ? own / there : 1.0;
    std::vector<double> sums(static_cast<std::size_t>(across * down), 0.0);
    std::vector<int> counts(sums.size(), 0);
    for (const PixelPair& pair : pairs) {
        const double difference = std::min(kMaxDifference, std::abs(pair.own - gain * pair.other));
        sums[pair.tile] += difference * difference;
        ++counts[pair.tile];
    }
    for (std::size_t i = 0; i < sums.size(); ++i) {
        sums[i] = counts[i] < kMinPixelsOfTile ? kTileUnseen : sums[i] / counts[i];
    }
    return sums;
}

bool is_clearly_closer(const std::vector<double>& next, const std::vector<double>& current) {
    constexpr double kLeastGain = 0.02;
    std::vector<double> gains;
    double current_sum = 0;
    for (std::size_t i = 0; i < std::min(next.size(), current.size()); ++i) {
        if (next[i] < 0 || current[i] < 0) continue;
        gains.push_back(current[i] - next[i]);
        current_sum += current[i];
    }
    if (gains.size() < kMinTiles) return false;
    const auto count = static_cast<double>(gains.size());
    double mean = 0;
    for (const double gain : gains) mean += gain / count;
    double squares = 0;
    for (const double gain : gains) squares += (gain - mean) * (gain - mean);
    return mean > std::sqrt(squares / (count * (count - 1))) &&
           mean > kLeastGain * current_sum / count;
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
