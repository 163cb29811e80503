#include "calib/ingest/exif.h"

#include <OpenImageIO/imageio.h>
#include <OpenImageIO/tiffutils.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "calib/pictures/heif_decoder.h"
#include "calib/pictures/webp_decoder.h"
#include "calib/work/printable.h"
#include "calib/work/whole_file.h"

namespace lumi {
namespace {

/// What OpenImageIO finds in the header.
OIIO::ImageSpec header_of(const std::filesystem::path& path, const char* reader) {
    const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::create(reader);
    OIIO::ImageSpec spec;
    if (input && !input->open(path.string(), spec)) {
        static_cast<void>(input->geterror());  // An unread error is printed at exit.
        spec = {};
    }
    return spec;
}

OIIO::ImageSpec parsed(const Bytes& exif) {
    OIIO::ImageSpec spec;
    if (!exif.empty()) OIIO::decode_exif(OIIO::cspan<std::uint8_t>(exif), spec);
    return spec;
}

OIIO::ImageSpec exif_of(const std::filesystem::path& path, ImageFormat format) {
    switch (format) {
        case ImageFormat::kJpeg:
            return header_of(path, "jpeg");
        case ImageFormat::kPng:
            return header_of(path, "png");
        case ImageFormat::kTiff:
            return header_of(path, "tiff");
        case ImageFormat::kHeif:  // OpenImageIO would decode the picture, too.
            return parsed(heif_exif(read_whole_file(path)));
        case ImageFormat::kWebp:  // It passes over EXIF there.
            return parsed(webp_exif(read_whole_file(path)));
    }
    return {};
}

std::optional<double> positive(double value) {
    if (!std::isfinite(value) || value <= 0) return std::nullopt;
    return value;
}

/// Cameras pad these fields with blanks or zeros, and write names in encodings of their own.
std::string trimmed(std::string text) {
    text.erase(std::find(text.begin(), text.end(), '\0'), text.end());
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first == std::string::npos) return "";
    return printable(text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1));
}

std::optional<double> pixels_per_mm(const OIIO::ImageSpec& spec) {
    constexpr int kCentimetres = 3;
    constexpr int kInches = 2;
    const int unit = spec.get_int_attribute("Exif:FocalPlaneResolutionUnit", kInches);
    const auto per_unit =
        positive(double{spec.get_float_attribute("Exif:FocalPlaneXResolution", 0.0F)});
    if (!per_unit || (unit != kInches && unit != kCentimetres)) return std::nullopt;
    return *per_unit / (unit == kInches ? 25.4 : 10.0);
}

double diagonal(ImageSize size) {
    return std::hypot(static_cast<double>(size.width_px), static_cast<double>(size.height_px));
}

double aspect_ratio(ImageSize size) {
    return static_cast<double>(std::max(size.width_px, size.height_px)) /
           std::min(size.width_px, size.height_px);
}

bool is_size_as_shot_told(const ExifFacts& exif) {
    return exif.size_as_shot.width_px > 0 && exif.size_as_shot.height_px > 0;
}

/// Whether the raster has another shape than it was shot with.
bool is_cropped(const ExifFacts& exif, ImageSize size) {
    constexpr double kAspectTolerance = 0.01;
    return is_size_as_shot_told(exif) &&
           std::abs(aspect_ratio(size) / aspect_ratio(exif.size_as_shot) - 1) > kAspectTolerance;
}

}  // namespace

ExifFacts read_exif(const std::filesystem::path& path, ImageFormat format) {
    ExifFacts exif;
    const OIIO::ImageSpec spec = exif_of(path, format);
    const int orientation = spec.get_int_attribute("Orientation", 1);
    if (orientation >= 1 && orientation <= 8) exif.orientation = orientation;
    exif.make = trimmed(spec.get_string_attribute("Make"));
    exif.model = trimmed(spec.get_string_attribute("Model"));
    exif.focal_length_mm = positive(double{spec.get_float_attribute("Exif:FocalLength", 0.0F)});
    exif.focal_length_35mm_equivalent_mm =
        positive(spec.get_int_attribute("Exif:FocalLengthIn35mmFilm", 0));
    exif.focal_plane_pixels_per_mm = pixels_per_mm(spec);
    exif.size_as_shot = {spec.get_int_attribute("Exif:PixelXDimension", 0),
                         spec.get_int_attribute("Exif:PixelYDimension", 0)};
    return exif;
}

std::optional<double> focal_length_px_of(const ExifFacts& exif, ImageSize size) {
    if (is_cropped(exif, size)) return std::nullopt;
    std::optional<double> focal_length_px;
    if (exif.focal_length_35mm_equivalent_mm) {
        constexpr double kFilmDiagonalMm = 43.2666153056;  // Of 36 mm x 24 mm.
        focal_length_px = *exif.focal_length_35mm_equivalent_mm * diagonal(size) / kFilmDiagonalMm;
    } else if (exif.focal_length_mm && exif.focal_plane_pixels_per_mm &&
               is_size_as_shot_told(exif)) {
        const double scale_since_shot = diagonal(size) / diagonal(exif.size_as_shot);
        focal_length_px =
            *exif.focal_length_mm * *exif.focal_plane_pixels_per_mm * scale_since_shot;
    }
    // From an 8 mm fisheye to an 800 mm telephoto lens on 35 mm film, and some room.
    constexpr double kMinDiagonals = 0.15;
    constexpr double kMaxDiagonals = 25.0;
    if (!focal_length_px || *focal_length_px < kMinDiagonals * diagonal(size) ||
        *focal_length_px > kMaxDiagonals * diagonal(size)) {
        return std::nullopt;
    }
    return focal_length_px;
}

std::string camera_key_of(const ExifFacts& exif, ImageSize size) {
    std::string key = std::to_string(size.width_px) + "x" + std::to_string(size.height_px);
    if (!exif.make.empty()) key += " " + exif.make;
    if (!exif.model.empty()) key += " " + exif.model;
    const auto add_length = [&](const char* format, const std::optional<double>& length_mm) {
        if (!length_mm) return;
        char text[40];
        std::snprintf(text, sizeof(text), format, *length_mm);
        key += text;
    };
    add_length(" %.4g mm", exif.focal_length_mm);
    // The crop of a digital zoom shows in the equivalent alone.
    add_length(" (%.4g mm)", exif.focal_length_35mm_equivalent_mm);
    return key;
}

}  // namespace lumi
