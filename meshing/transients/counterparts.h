#pragma once

#include <vector>

#include "meshing/transients/known_view.h"

namespace lumi {

/// The colours of the pixels in which a view differs from what others agree upon.
struct PatchColors {
    GrayImage has_unlike;  ///< 255 where such pixels lie in the window around a pixel.
    ColorImage color;      ///< Their mean.
};

/// Windows are a fiftieth of the picture wide: leaves show other sides to other views.
[[nodiscard]] PatchColors patch_colors(GrayImage unlike, const ColorImage& picture);

/// Looks for what a view shows in the photographs beside it, wherever along the ray it may stand.
class Counterparts {
 public:
    /// All must outlive it.
    Counterparts(const std::vector<KnownView>& views, const std::vector<PatchColors>& patches,
                 const std::vector<Witness>& witnesses, int view_index);

    /// Whether what the view shows of a pixel may stand still. At some inverse depth, from infinity
    /// to where it would move by half of the picture, as many of the six nearest photographs show
    /// its like as show something else, and two at least. Or, before what lies `behind` the pixel
    /// and up to the nearest that the view knows, hardly any shows something else: they show
    /// its like, or something before it, or do not have it in their frame.
    [[nodiscard]] bool has(int x, int y, double behind) const;

 private:
    [[nodiscard]] bool has_at(int x, int y, double inverse_depth, bool may_be_unseen) const;

    const std::vector<KnownView>& views_;
    const std::vector<PatchColors>& patches_;
    const std::vector<Witness>& witnesses_;
    const KnownView& own_;
    const PatchColors& own_patches_;
    double nearest_known_ = 0.0;  ///< Inverse depth.
};

}  // namespace lumi
