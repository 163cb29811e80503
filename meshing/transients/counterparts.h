#pragma once

#include <vector>

#include "meshing/transients/known_view.h"

namespace lumi {

/// The colours of the pixels in which a view differs from what others agree upon.
struct PatchColors {
    GrayImage is_near;  ///< 255 where such pixels lie in the window around a pixel.
    ColorImage color;   ///< Their mean.
};

/// Windows are a fiftieth of the picture wide: leaves show other sides to other views.
[[nodiscard]] PatchColors patch_colors(GrayImage unlike, const ColorImage& picture);

/// Looks for what a view shows in the photographs beside it, wherever along the ray it may stand.
class Counterparts {
 public:
    /// All must outlive it.
    Counterparts(const std::vector<KnownView>& views, const std::vector<PatchColors>& patches,
                 const std::vector<Witness>& witnesses, int view_index);

    /// Whether one inverse depth, from infinity to twice the nearest that the view knows, brings
    /// the pixel upon its like in half of the six nearest photographs that have it in their frame,
    /// and in two at least.
    [[nodiscard]] bool has(int x, int y) const;

 private:
    [[nodiscard]] bool has_at(int x, int y, double inverse_depth) const;

    const std::vector<PatchColors>& patches_;
    const std::vector<Witness>& witnesses_;
    const KnownView& own_;
    const PatchColors& own_patches_;
    double nearest_ = 0.0;  ///< Inverse depth.
};

}  // namespace lumi
