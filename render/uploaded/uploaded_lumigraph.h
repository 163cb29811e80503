#pragma once

#include <vector>

#include "render/depth_search/searched_views.h"
#include "render/frame/frame.h"
#include "render/gl/capabilities.h"
#include "render/gl/texture.h"
#include "render/lumigraph/lumigraph.h"
#include "render/surroundings/surroundings.h"
#include "render/uploaded/photograph_layer.h"

namespace lumi {

/// A Lumigraph whose pictures lie in GL textures: what every mode draws from.
struct UploadedLumigraph {
    /// Throws Error (E-GL-CONTEXT, E-GL-LIMIT).
    explicit UploadedLumigraph(const Lumigraph& lumigraph);

    Capabilities capabilities;
    /// The Lumigraph without its photographs: cameras, poses, depth, the camera mesh.
    Lumigraph layout;
    SearchedViews searched_views;
    /// One layer a view, kGutter_px from its top left; alpha is how much a pixel counts
    /// (photograph_opacity.h), 0 beyond the photograph.
    TextureArray photographs;
    TextureArray depth_maps;  ///< The same for inverse depth; empty when no view has depth.
    SmallPhotographs small_photographs;
    /// Sizes of the depth maps, (0, 0) without.
    std::vector<Eigen::Vector2i> depth_sizes_px;

    /// Takes these instead of the choices that it came with. Where this throws, nothing has
    /// changed.
    void choose(const DrawingChoices& drawing);

    /// The mip level at which a frame looks photographs up (photograph_lod.h).
    [[nodiscard]] double lod_of(const Eye& eye, const RenderOptions& options) const;
    /// Makes what a frame takes that others do not, before it is drawn: leaves GL's state as
    /// TextureArray::make_mip_levels does. Throws Error (E-GL-LIMIT).
    void prepare(const Eye& eye, const RenderOptions& options);
};

}  // namespace lumi
