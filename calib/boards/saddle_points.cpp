#include "calib/boards/saddle_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "calib/opencv/opencv_picture.h"

namespace lumi {
namespace {

struct Offset {
    int x;
    int y;
};
/// Sixteen pixels on a circle of radius 5, in order of their angle.
constexpr std::array<Offset, 16> kRing{{{5, 0},
                                        {5, 2},
                                        {4, 4},
                                        {2, 5},
                                        {0, 5},
                                        {-2, 5},
                                        {-4, 4},
                                        {-5, 2},
                                        {-5, 0},
                                        {-5, -2},
                                        {-4, -4},
                                        {-2, -5},
                                        {0, -5},
                                        {2, -5},
                                        {4, -4},
                                        {5, -2}}};
constexpr int kRadius = 5;

using Ring = std::array<int, 16>;

Ring ring_at(const cv::Mat& picture, int x, int y) {
    Ring ring{};
    for (std::size_t n = 0; n < kRing.size(); ++n) {
        ring[n] = picture.ptr<std::uint8_t>(y + kRing[n].y)[x + kRing[n].x];
    }
    return ring;
}

/// Large where opposite samples agree and those at right angles differ.
int response_of(const Ring& ring, int centre_times_5) {
    int sum_response = 0;
    int difference_response = 0;
    int sum = 0;
    for (std::size_t n = 0; n < 4; ++n) {
        sum_response += std::abs(ring[n] + ring[n + 8] - ring[n + 4] - ring[n + 12]);
    }
    for (std::size_t n = 0; n < 8; ++n) difference_response += std::abs(ring[n] - ring[n + 8]);
    for (const int value : ring) sum += value;
    const int mean_response = std::abs(sum * 5 - centre_times_5 * 16) / 5;
    return sum_response - difference_response - mean_response;
}

int centre_times_5(const cv::Mat& picture, int x, int y) {
    const auto* row = picture.ptr<std::uint8_t>(y);
    return row[x] + row[x - 1] + row[x + 1] + picture.ptr<std::uint8_t>(y - 1)[x] +
           picture.ptr<std::uint8_t>(y + 1)[x];
}

cv::Mat response_map(const cv::Mat& picture) {
    cv::Mat map = cv::Mat::zeros(picture.size(), CV_16SC1);
    for (int y = kRadius; y < picture.rows - kRadius; ++y) {
        auto* out = map.ptr<std::int16_t>(y);
        std::array<const std::uint8_t*, 16> samples{};
        for (std::size_t n = 0; n < kRing.size(); ++n) {
            samples[n] = picture.ptr<std::uint8_t>(y + kRing[n].y) + kRing[n].x;
        }
        for (int x = kRadius; x < picture.cols - kRadius; ++x) {
            // The two largest terms first: almost no pixel goes on.
            const int first =
                std::abs(samples[0][x] + samples[8][x] - samples[4][x] - samples[12][x]);
            const int second =
                std::abs(samples[2][x] + samples[10][x] - samples[6][x] - samples[14][x]);
            constexpr int kLeastOfTwo = 10;
            if (first + second < kLeastOfTwo) continue;
            const int response = response_of(ring_at(picture, x, y), centre_times_5(picture, x, y));
            if (response > 0) out[x] = static_cast<std::int16_t>(std::min(response, 32767));
        }
    }
    return map;
}

/// A saddle has exactly four changes between bright and dark around it, and responds with most of
/// what its contrast allows.
std::optional<SaddlePoint> saddle_at(const cv::Mat& picture, int x, int y, int response) {
    const Ring ring = ring_at(picture, x, y);
    const auto [darkest, brightest] = std::minmax_element(ring.begin(), ring.end());
    const int contrast = *brightest - *darkest;
    constexpr int kLeastContrast = 8;
    constexpr double kLeastShareOfContrast = 1.2;
    if (contrast < kLeastContrast || response < kLeastShareOfContrast * contrast) {
        return std::nullopt;
    }
    const double middle = 0.5 * (*brightest + *darkest);
    int changes = 0;
    double cosine = 0;
    double sine = 0;
    for (std::size_t n = 0; n < ring.size(); ++n) {
        const bool is_bright = ring[n] > middle;
        if (is_bright != (ring[(n + 1) % ring.size()] > middle)) ++changes;
        const double twice_angle = 2 * std::atan2(kRing[n].y, kRing[n].x);
        cosine += (ring[n] - middle) * std::cos(twice_angle);
        sine += (ring[n] - middle) * std::sin(twice_angle);
    }
    const double length = std::hypot(cosine, sine);
    if (changes != 4 || !(length > 0)) return std::nullopt;
    return SaddlePoint{from_opencv({static_cast<float>(x), static_cast<float>(y)}),
                       {cosine / length, sine / length},
                       static_cast<double>(contrast),
                       static_cast<double>(response)};
}

bool is_largest_around(const cv::Mat& map, int x, int y) {
    constexpr int kReach = 3;
    const std::int16_t value = map.ptr<std::int16_t>(y)[x];
    for (int dy = -kReach; dy <= kReach; ++dy) {
        const auto* row = map.ptr<std::int16_t>(y + dy);
        for (int dx = -kReach; dx <= kReach; ++dx) {
            const bool is_before = dy < 0 || (dy == 0 && dx < 0);
            if (is_before ? row[x + dx] >= value : row[x + dx] > value) return false;
        }
    }
    return true;
}

}  // namespace

std::vector<SaddlePoint> detect_saddle_points(const GrayImage& picture, std::size_t max_points) {
    std::vector<SaddlePoint> points;
    if (picture.width() <= 2 * kRadius || picture.height() <= 2 * kRadius) return points;
    cv::Mat smooth;
    cv::GaussianBlur(opencv_view(picture), smooth, {}, 0.8);
    const cv::Mat map = response_map(smooth);
    for (int y = kRadius; y < map.rows - kRadius; ++y) {
        for (int x = kRadius; x < map.cols - kRadius; ++x) {
            const int response = map.ptr<std::int16_t>(y)[x];
            if (response <= 0 || !is_largest_around(map, x, y)) continue;
            if (const auto saddle = saddle_at(smooth, x, y, response)) points.push_back(*saddle);
        }
    }
    std::stable_sort(points.begin(), points.end(),
                     [](const auto& a, const auto& b) { return a.response > b.response; });
    if (points.size() > max_points) points.resize(max_points);
    return points;
}

}  // namespace lumi
