#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace lumi {

/// 8-bit sRGB, as in files.
struct Rgb8 {
    std::uint8_t r = 0;
    std::uint8_t g = 0;
    std::uint8_t b = 0;
    friend bool operator==(const Rgb8&, const Rgb8&) = default;
};

/// A row-major raster without padding; (0, 0) is the top-left pixel.
template <class Pixel>
class Image {
 public:
    Image() = default;
    Image(int width, int height, Pixel fill = {})
        : width_(width),
          height_(height),
          pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), fill) {}

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    [[nodiscard]] bool empty() const { return pixels_.empty(); }
    [[nodiscard]] bool contains(int x, int y) const {
        return x >= 0 && y >= 0 && x < width_ && y < height_;
    }

    [[nodiscard]] Pixel& operator()(int x, int y) { return pixels_[index(x, y)]; }
    [[nodiscard]] const Pixel& operator()(int x, int y) const { return pixels_[index(x, y)]; }
    [[nodiscard]] Pixel* row(int y) { return pixels_.data() + index(0, y); }
    [[nodiscard]] const Pixel* row(int y) const { return pixels_.data() + index(0, y); }

    [[nodiscard]] std::vector<Pixel>& pixels() { return pixels_; }
    [[nodiscard]] const std::vector<Pixel>& pixels() const { return pixels_; }

    friend bool operator==(const Image&, const Image&) = default;

 private:
    [[nodiscard]] std::size_t index(int x, int y) const {
        assert(x >= 0 && y >= 0 && x < width_ && y < height_);
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
               static_cast<std::size_t>(x);
    }

    int width_ = 0;
    int height_ = 0;
    std::vector<Pixel> pixels_;
};

using ColorImage = Image<Rgb8>;
using GrayImage = Image<std::uint8_t>;
using FloatImage = Image<float>;

}  // namespace lumi
