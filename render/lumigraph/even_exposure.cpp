#include "render/lumigraph/even_exposure.h"

#include <array>
#include <cmath>
#include <cstdint>

#include "calib/pictures/srgb_curve.h"
#include "calib/work/parallel_for.h"

namespace lumi {
namespace {

constexpr double kShoulder = 0.9;  // Of the encoded range.

double evened(double encoded, double gain) {
    const double multiplied = srgb_of_light(gain * light_of_srgb(encoded));
    if (gain >= 1 || encoded <= kShoulder) return multiplied;
    const double at_shoulder = srgb_of_light(gain * light_of_srgb(kShoulder));
    return at_shoulder + (1 - at_shoulder) * (encoded - kShoulder) / (1 - kShoulder);
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

}  // namespace

ColorImage evened_photograph(const LumigraphView& view) {
    ColorImage photograph = view.photograph;
    if (view.exposure_gain == kNoExposureGain) return photograph;
    const ByteTable red = evened_bytes(view.exposure_gain[0]);
    const ByteTable green = evened_bytes(view.exposure_gain[1]);
    const ByteTable blue = evened_bytes(view.exposure_gain[2]);
    for (Rgb8& pixel : photograph.pixels()) pixel = {red[pixel.r], green[pixel.g], blue[pixel.b]};
    return photograph;
}

void even_exposures(Lumigraph& lumigraph) {
    parallel_for(static_cast<int>(lumigraph.views.size()), 0, [&](int i) {
        LumigraphView& view = lumigraph.views[static_cast<std::size_t>(i)];
        if (view.exposure_gain == kNoExposureGain) return;
        view.photograph = evened_photograph(view);
        view.exposure_gain = kNoExposureGain;
    });
}

}  // namespace lumi
