#include "render/uploaded/photograph_layer.h"

#include <algorithm>

namespace lumi {

std::vector<unsigned char> photograph_layer(const ColorImage& photograph, const GrayImage& opacity,
                                            int layer_width_px, int layer_height_px) {
    std::vector<unsigned char> rgba(4 * static_cast<std::size_t>(layer_width_px) *
                                    static_cast<std::size_t>(layer_height_px));
    unsigned char* texel = rgba.data();
    for (int y = -kGutter_px; y < layer_height_px - kGutter_px; ++y) {
        for (int x = -kGutter_px; x < layer_width_px - kGutter_px; ++x, texel += 4) {
            const int column = std::clamp(x, 0, photograph.width() - 1);
            const int row = std::clamp(y, 0, photograph.height() - 1);
            const Rgb8& pixel = photograph(column, row);
            texel[0] = pixel.r;
            texel[1] = pixel.g;
            texel[2] = pixel.b;
            texel[3] = photograph.contains(x, y) ? opacity(x, y) : 0;
        }
    }
    return rgba;
}

}  // namespace lumi
