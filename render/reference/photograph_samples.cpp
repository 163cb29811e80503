#include "render/reference/photograph_samples.h"

#include <utility>

#include "render/transfer/sampling.h"
#include "render/uploaded/photograph_layer.h"
#include "render/uploaded/photograph_lod.h"

namespace lumi {
namespace {

/// What a pixel counts that counts as much as any.
constexpr std::uint8_t kAll = 255;

}  // namespace

PhotographSamples::PhotographSamples(const Lumigraph& lumigraph, const Eye& eye,
                                     std::vector<GrayImage> opacities)
    : lumigraph_(lumigraph),
      opacities_(std::move(opacities)),
      lod_(photograph_lod(lumigraph, eye)) {
    if (lod_ > 0) make_mip_levels();
}

Eigen::Vector3d PhotographSamples::color(int view_index, const Eigen::Vector2d& pixel) const {
    if (lod_ > 0) return at_mip_level(view_index, pixel).head<3>();
    return bilinear(lumigraph_.views[static_cast<std::size_t>(view_index)].photograph, pixel);
}

double PhotographSamples::opacity(int view_index, const Eigen::Vector2d& pixel) const {
    if (lod_ > 0) return at_mip_level(view_index, pixel)[3];
    if (opacities_.empty()) return kAll;
    return bilinear_to_zero(opacities_[static_cast<std::size_t>(view_index)], pixel);
}

/// Of layers as large as the largest photograph, as they are uploaded.
void PhotographSamples::make_mip_levels() {
    Eigen::Vector2i size(1, 1);
    for (const LumigraphView& view : lumigraph_.views)
        size = size.cwiseMax(Eigen::Vector2i(view.photograph.width(), view.photograph.height()));
    size += Eigen::Vector2i::Constant(2 * kGutter_px);
    layer_size_px_ = size.cast<double>();
    for (std::size_t i = 0; i < lumigraph_.views.size(); ++i) {
        const ColorImage& photograph = lumigraph_.views[i].photograph;
        const GrayImage opacity = opacities_.empty()
                                      ? GrayImage(photograph.width(), photograph.height(), kAll)
                                      : opacities_[i];
        mip_levels_.emplace_back(photograph_layer(photograph, opacity, size.x(), size.y()),
                                 size.x(), size.y());
    }
}

Eigen::Vector4d PhotographSamples::at_mip_level(int view_index,
                                                const Eigen::Vector2d& pixel) const {
    const Eigen::Vector2d texel = pixel + Eigen::Vector2d::Constant(kGutter_px);
    return mip_levels_[static_cast<std::size_t>(view_index)].at(texel.cwiseQuotient(layer_size_px_),
                                                                lod_);
}

}  // namespace lumi
