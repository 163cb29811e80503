#pragma once

#include <vector>

#include "render/gl/object_name.h"
#include "render/gl/texture.h"

namespace lumi {

void delete_framebuffer(unsigned name);
void delete_renderbuffer(unsigned name);

/// Somewhere to draw to that is not a window: one layer of a texture array, or an RGBA8 picture.
class Framebuffer {
 public:
    Framebuffer();

    /// Draws go to this depth layer, with no colour. Binds the framebuffer.
    void attach_depth_layer(const TextureArray& depth, int layer);
    /// Draws go to this colour layer, or to a mip level of it. Binds the framebuffer.
    void attach_color_layer(const TextureArray& color, int layer, int level = 0);
    /// Draws go to all layers at once, at most four: output k of a fragment to layer k. Binds the
    /// framebuffer.
    void attach_color_layers(const TextureArray& color);
    /// Draws go to an own RGBA8 raster of this size, which is new. Binds the framebuffer. Where it
    /// throws, draws go on to the raster that they went to. Throws Error (E-GL-LIMIT).
    void attach_color(int width_px, int height_px);
    void bind() const;

    /// The colour raster as rows from the bottom, four bytes a pixel. Throws nothing.
    [[nodiscard]] std::vector<unsigned char> read_rgba_bottom_up(int width_px, int height_px) const;
    /// Scales the colour raster to the window's framebuffer and binds that.
    void copy_to_window(int width_px, int height_px, int window_width_px,
                        int window_height_px) const;

 private:
    void attach_renderbuffer(unsigned name) const;
    void require_complete() const;  ///< Throws Error (E-GL-LIMIT).

    ObjectName<delete_framebuffer> name_;
    ObjectName<delete_renderbuffer> color_;
};

/// Binds the framebuffer that was bound before, when it goes.
class FramebufferBindingKeeper {
 public:
    FramebufferBindingKeeper();
    ~FramebufferBindingKeeper();
    FramebufferBindingKeeper(const FramebufferBindingKeeper&) = delete;
    FramebufferBindingKeeper& operator=(const FramebufferBindingKeeper&) = delete;

 private:
    int draw_name_ = 0;
    int read_name_ = 0;
};

}  // namespace lumi
