#pragma once

#include <cstddef>
#include <vector>

#include "calib/capture/image.h"
#include "render/gl/object_name.h"

namespace lumi {

void delete_texture(unsigned name);

/// What a texel of a texture array holds.
enum class TexelFormat {
    kColor,       ///< RGBA8, as it is stored: no sRGB decoding.
    kFloat,       ///< One 32-bit float, for sampling only.
    kFourFloats,  ///< For sampling only.
    kDepth,       ///< 32-bit float depth, to draw into and to read back in a shader.
};

enum class TexelFilter { kNearest, kLinear };

/// A stack of rasters of one size; smaller ones lie at the top left of their layer.
class TextureArray {
 public:
    TextureArray() = default;
    /// Throws Error (E-GL-LIMIT) where this GL holds no such array, or has no memory for it. Takes
    /// pending GL errors.
    TextureArray(TexelFormat format, TexelFilter filter, int width_px, int height_px, int layers);

    /// Row 0 of the image is row 0 of the layer. The image must fit.
    void upload(int layer, const ColorImage& image);
    /// All texels of a layer, four bytes each.
    void upload_rgba(int layer, const std::vector<unsigned char>& rgba);
    void upload(int layer, const FloatImage& image);
    /// All texels of all layers, of the format kFourFloats.
    void upload(const std::vector<float>& texels);
    void bind(unsigned unit) const;
    /// Makes all mip levels, unless they are there: for colours that are looked up at a level
    /// (textureLod) and are not changed any more. Along the borders of each level alpha is set to
    /// 0, so that lookups beyond a layer find 0 also where coarse levels have no gutter.
    ///
    /// Not amid a drawing: it draws itself. All colours are written to and the scissor test is off
    /// afterwards. Throws Error (E-GL-LIMIT) where the driver has no memory for them. Takes pending
    /// GL errors.
    void make_mip_levels();
    /// Binds with all mip levels, which must have been made.
    void bind_mip_levels(unsigned unit) const;

    [[nodiscard]] unsigned name() const { return name_.get(); }
    [[nodiscard]] int width_px() const { return width_px_; }
    [[nodiscard]] int height_px() const { return height_px_; }
    [[nodiscard]] int layers() const { return layers_; }
    /// The size of its finest level.
    [[nodiscard]] std::size_t bytes() const;

 private:
    void clear_borders_of_mip_levels() const;

    ObjectName<delete_texture> name_;
    int width_px_ = 0;
    int height_px_ = 0;
    int layers_ = 0;
    TexelFormat format_ = TexelFormat::kColor;
    TexelFilter filter_ = TexelFilter::kNearest;
    bool has_mip_levels_ = false;
};

}  // namespace lumi
