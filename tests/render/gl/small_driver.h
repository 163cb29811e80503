#pragma once

namespace lumi {

/// For as long as it lives, OpenGL says that it holds textures and rasters of so many pixels a side
/// and texture arrays of so many layers, and refuses larger ones as drivers do (GL_INVALID_VALUE).
/// One at a time.
class SmallDriver {
 public:
    SmallDriver(int most_side_px, int most_layers);
    ~SmallDriver();
    SmallDriver(const SmallDriver&) = delete;
    SmallDriver& operator=(const SmallDriver&) = delete;

    /// How often it was asked for more than it holds, since it came.
    [[nodiscard]] static int refused();
};

}  // namespace lumi
