#include "calib/pictures/drawn_mask.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <system_error>

#include "calib/pictures/image_io.h"
#include "calib/work/error.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

/// A picture of any channels that is grey; what is transparent is black.
GrayImage read_gray_picture(const fs::path& path) {
    constexpr int kGrayWithin = 8;  // 8-bit levels: profiles are converted with rounding.
    const ColorImage colors = read_color_image(path);
    GrayImage gray(colors.width(), colors.height());
    for (std::size_t i = 0; i < gray.pixels().size(); ++i) {
        const auto [low, high] =
            std::minmax({colors.pixels()[i].r, colors.pixels()[i].g, colors.pixels()[i].b});
        if (high - low > kGrayWithin) {
            throw Error(ErrorKind::kBadInput, "E-MASK-COLOR",
                        path.string() + ": a mask is black and white, and this has colours",
                        "paint white what counts, and black what does not");
        }
        gray.pixels()[i] = colors.pixels()[i].g;
    }
    return gray;
}

}  // namespace

fs::path mask_file_of(const std::string& name, const fs::path& folder) {
    fs::path appended = folder / name;
    appended += ".png";
    std::error_code ignored;  // With its ending a name may be longer than any file's.
    // First: x.jpg and x.png have a stem in common.
    if (fs::is_regular_file(appended, ignored)) return appended;
    fs::path by_stem = folder / name;
    by_stem.replace_extension(".png");
    return fs::is_regular_file(by_stem, ignored) ? by_stem : fs::path();
}

void expect_own_masks(const std::vector<std::string>& names, const fs::path& folder) {
    std::map<fs::path, std::string> photograph_of;
    for (const std::string& name : names) {
        const fs::path file = mask_file_of(name, folder);
        if (file.empty()) continue;
        const auto [other, is_own] = photograph_of.emplace(file, name);
        if (is_own) continue;
        throw Error(ErrorKind::kBadInput, "E-MASK-SHARED",
                    file.string() + " may be the mask of " + other->second + " or of " + name,
                    "name masks like " + other->second + ".png");
    }
}

GrayImage read_drawn_mask(const std::string& name, int width_px, int height_px,
                          const fs::path& folder) {
    const fs::path path = mask_file_of(name, folder);
    if (path.empty()) {
        throw Error(ErrorKind::kBadInput, "E-MASK-MISSING",
                    folder.string() + ": no mask for photograph " + name,
                    "name masks like their photographs, with .png as extension");
    }
    GrayImage mask = read_gray_picture(path);
    const double stretch = static_cast<double>(mask.width()) * height_px /
                           (static_cast<double>(mask.height()) * width_px);
    if (std::abs(stretch - 1) >
        1.0 / std::min({mask.width(), mask.height(), width_px, height_px})) {
        throw Error(ErrorKind::kBadInput, "E-MASK-SIZE",
                    path.string() + ": " + std::to_string(mask.width()) + "x" +
                        std::to_string(mask.height()) + " has not the shape of its photograph",
                    "draw masks over the whole photograph, as it is stored");
    }
    for (std::uint8_t& pixel : mask.pixels()) pixel = pixel < 128 ? 0 : 255;
    if (std::none_of(mask.pixels().begin(), mask.pixels().end(), [](auto p) { return p != 0; })) {
        throw Error(ErrorKind::kBadInput, "E-MASK-EMPTY", path.string() + ": no pixel is white",
                    "paint white what counts, or leave this photograph out");
    }
    return mask;
}

GrayImage drawn_mask(const std::string& name, int width_px, int height_px, const fs::path& folder) {
    const GrayImage drawn = read_drawn_mask(name, width_px, height_px, folder);
    GrayImage mask(width_px, height_px);
    for (int y = 0; y < height_px; ++y) {
        const auto source_y = static_cast<int>((y + 0.5) * drawn.height() / height_px);
        for (int x = 0; x < width_px; ++x) {
            const auto source_x = static_cast<int>((x + 0.5) * drawn.width() / width_px);
            mask(x, y) = drawn(source_x, source_y);
        }
    }
    return mask;
}

}  // namespace lumi
