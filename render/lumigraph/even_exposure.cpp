#include "render/lumigraph/even_exposure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "calib/capture/light_left.h"
#include "calib/pictures/srgb_curve.h"
#include "calib/work/parallel_for.h"

namespace lumi {
namespace {

constexpr double kShoulder = 0.9;  // Of the encoded range.
/// Of the logarithm of light: a fifth of an 8-bit step of white.
constexpr double kGainStep = 1.0 / 512;

double between(double value, double from, double to, double first, double last) {
    return first + (last - first) * (value - from) / (to - from);
}

/// With 1/gain it is the inverse.
double evened(double encoded, double gain) {
    const double dark_shoulder = srgb_of_light(std::min(gain, 1 / gain) * light_of_srgb(kShoulder));
    const double from = gain < 1 ? kShoulder : dark_shoulder;
    const double to = gain < 1 ? dark_shoulder : kShoulder;
    return encoded <= from ? srgb_of_light(gain * light_of_srgb(encoded))
                           : between(encoded, from, 1, to, 1);
}

using ByteTable = std::array<std::uint8_t, 256>;

ByteTable evened_bytes(double gain) {
    ByteTable table{};
    for (std::size_t i = 0; i < table.size(); ++i) {
        table[i] = static_cast<std::uint8_t>(
            std::lround(255.0 * evened(static_cast<double>(i) / 255.0, gain)));
    }
    return table;
}

/// What becomes of the bytes of red, green and blue, in rings about the optical axis that differ by
/// a step.
class RingTables {
 public:
    using Tables = std::array<ByteTable, 3>;

    /// Light is multiplied by `gains`, and by exp(growth tan^2 a) more at an angle a to the axis;
    /// tangents must be finite.
    RingTables(const ExposureGain& gains, double growth, double farthest_squared_tangent)
        : rings_per_squared_tangent_(std::abs(growth) / kGainStep) {
        const auto last = static_cast<int>(rings_per_squared_tangent_ * farthest_squared_tangent);
        for (int ring = 0; ring <= last + 1; ++ring) {
            const double more = std::exp(std::copysign(ring * kGainStep, growth));
            rings_.push_back({evened_bytes(more * gains[0]), evened_bytes(more * gains[1]),
                              evened_bytes(more * gains[2])});
        }
    }
    [[nodiscard]] const Tables& at(double squared_tangent) const {
        return rings_[static_cast<std::size_t>(rings_per_squared_tangent_ * squared_tangent + 0.5)];
    }

 private:
    double rings_per_squared_tangent_;
    std::vector<Tables> rings_;
};

/// Of the pixels in the row, or the column, through the principal point: for pinholes the sum of
/// both is that of a pixel.
std::vector<double> squared_tangents(const Camera& camera, const Eigen::Vector2d& along) {
    const Eigen::Vector2d across = Eigen::Vector2d::Ones() - along;
    const Eigen::Vector2d start = across.cwiseProduct(principal_point_px(camera)) + 0.5 * along;
    const double count = along.dot(Eigen::Vector2d(camera.width_px, camera.height_px));
    std::vector<double> tangents;
    for (int i = 0; i < count; ++i) tangents.push_back(squared_tangent(camera, start + i * along));
    return tangents;
}

double largest_of(const std::vector<double>& numbers) {
    return *std::max_element(numbers.begin(), numbers.end());
}

/// `growth` as RingTables have it.
ColorImage multiplied(ColorImage picture, const Camera& camera, const ExposureGain& gains,
                      double growth) {
    const std::vector<double> of_columns = squared_tangents(camera, Eigen::Vector2d::UnitX());
    const std::vector<double> of_rows = squared_tangents(camera, Eigen::Vector2d::UnitY());
    const RingTables rings(gains, growth, largest_of(of_columns) + largest_of(of_rows));
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const auto& [red, green, blue] = rings.at(of_columns[static_cast<std::size_t>(x)] +
                                                      of_rows[static_cast<std::size_t>(y)]);
            Rgb8& pixel = picture(x, y);
            pixel = {red[pixel.r], green[pixel.g], blue[pixel.b]};
        }
    }
    return picture;
}

/// The photograph is the view's.
ColorImage evened_by_view(ColorImage photograph, const LumigraphView& view, double light_falloff) {
    if (view.exposure_gain == kNoExposureGain && light_falloff == 0) return photograph;
    return multiplied(std::move(photograph), view.camera, view.exposure_gain, -light_falloff);
}

}  // namespace

ColorImage evened_photograph(const LumigraphView& view, double light_falloff) {
    return evened_by_view(view.photograph, view, light_falloff);
}

void even_exposures(Lumigraph& lumigraph) {
    parallel_for(static_cast<int>(lumigraph.views.size()), 0, [&](int i) {
        LumigraphView& view = lumigraph.views[static_cast<std::size_t>(i)];
        view.photograph = evened_by_view(std::move(view.photograph), view, lumigraph.light_falloff);
        view.exposure_gain = kNoExposureGain;
    });
    lumigraph.evened_falloff += lumigraph.light_falloff;
    lumigraph.light_falloff = 0;
}

ColorImage darkened_by_lens(ColorImage picture, const Camera& camera, double falloff) {
    if (falloff == 0) return picture;
    return multiplied(std::move(picture), camera, kNoExposureGain, falloff);
}

ColorImage without_falloff(ColorImage photograph, const Camera& camera, double falloff) {
    return darkened_by_lens(std::move(photograph), camera, -falloff);
}

}  // namespace lumi
