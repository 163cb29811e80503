#include "calib/pictures/png_codec.h"

#include <algorithm>
#include <limits>
#include <new>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <string>

#include "calib/opencv/cv_matrix.h"
#include "calib/pictures/before_black.h"
#include "calib/pictures/color_tags.h"
#include "calib/pictures/image_format.h"
#include "calib/pictures/srgb_conversion.h"
#include "calib/work/error.h"

namespace lumi {
namespace {

cv::Mat decode(std::span<const std::uint8_t> bytes, int flags, std::size_t max_pixels,
               const std::filesystem::path& path) {
    if (image_format_of(bytes) != ImageFormat::kPng) {
        throw Error(ErrorKind::kBadInput, "E-IMAGE-FORMAT", path.string() + ": not a PNG picture",
                    "save the picture as PNG");
    }
    if (bytes.size() > std::numeric_limits<int>::max()) {
        throw Error(ErrorKind::kBadInput, "E-IMAGE-TOOBIG",
                    path.string() + ": expected at most 2 GiB in one PNG",
                    "scale the picture down first");
    }
    check_image_size(check_png(bytes, path), max_pixels, path);
    // OpenCV reads from the memory and never writes to it.
    const cv::Mat encoded(1, static_cast<int>(bytes.size()), CV_8UC1,
                          const_cast<std::uint8_t*>(bytes.data()));
    cv::Mat decoded;
    try {
        decoded = cv::imdecode(encoded, flags | cv::IMREAD_IGNORE_ORIENTATION);
    } catch (const cv::Exception& exception) {
        if (exception.code == cv::Error::StsNoMem) throw std::bad_alloc();
        refuse_truncated_image(path, exception.what());
    }
    if (decoded.empty()) refuse_truncated_image(path, "the PNG cannot be decoded");
    return decoded;
}

/// Red first, as seen before black. `Sample`: of the pixel, and of the matrix.
template <class Pixel, class Sample>
Image<Pixel> rgb_of(const cv::Mat& decoded, GrayImage& shown) {
    cv::Mat rgb;
    if (decoded.channels() == 4) {
        cv::cvtColor(decoded, rgb, cv::COLOR_BGRA2RGBA);
        return before_black<Pixel, Sample>({rgb.ptr<Sample>(), 4 * rgb.total()},
                                           {.width_px = rgb.cols,
                                            .height_px = rgb.rows,
                                            .channels = 4,
                                            .alpha_channel = 3,
                                            .is_premultiplied = false},
                                           shown);
    }
    cv::cvtColor(decoded, rgb, decoded.channels() == 1 ? cv::COLOR_GRAY2RGB : cv::COLOR_BGR2RGB);
    return image_of<Pixel>(rgb);
}

/// By the colour type in the header, which OpenCV does not tell.
bool is_grey_png(std::span<const std::uint8_t> bytes) {
    constexpr std::size_t kColorType = 25;
    constexpr std::uint8_t kGrey = 0;
    constexpr std::uint8_t kGreyWithAlpha = 4;
    return bytes[kColorType] == kGrey || bytes[kColorType] == kGreyWithAlpha;
}

template <class Pixel>
Image<Pixel> decode_gray(std::span<const std::uint8_t> bytes, std::size_t max_pixels,
                         const std::filesystem::path& path, int opencv_type) {
    const cv::Mat decoded = decode(bytes, cv::IMREAD_UNCHANGED, max_pixels, path);
    if (decoded.type() != opencv_type) {
        throw Error(ErrorKind::kBadInput, "E-IMAGE-FORMAT",
                    path.string() + ": expected one grey channel of " +
                        std::to_string(8 * sizeof(Pixel)) + " bits",
                    "save the picture with one grey channel of that depth");
    }
    return image_of<Pixel>(decoded);
}

Bytes encode(const cv::Mat& matrix, const std::filesystem::path& path) {
    // Level 1 is five times faster than the default and costs a few per cent of the size.
    Bytes bytes;
    if (!cv::imencode(".png", matrix, bytes, {cv::IMWRITE_PNG_COMPRESSION, 1}) || bytes.empty()) {
        throw Error(ErrorKind::kResources, "E-IMAGE-ENCODE", path.string() + ": cannot be encoded",
                    "free some memory and try again");
    }
    return bytes;
}

}  // namespace

Bytes encode_png(const ColorImage& image, const std::filesystem::path& path) {
    cv::Mat bgr;
    cv::cvtColor(matrix_of(image, CV_8UC3), bgr, cv::COLOR_RGB2BGR);
    return encode(bgr, path);
}

Bytes encode_png(const GrayImage& image, const std::filesystem::path& path) {
    return encode(matrix_of(image, CV_8UC1), path);
}

Bytes encode_png(const Image<std::uint16_t>& image, const std::filesystem::path& path) {
    return encode(matrix_of(image, CV_16UC1), path);
}

StoredPicture decode_png(std::span<const std::uint8_t> bytes, std::size_t max_pixels,
                         const std::filesystem::path& path) {
    const cv::Mat decoded = decode(bytes, cv::IMREAD_UNCHANGED, max_pixels, path);
    StoredPicture stored;
    if (decoded.depth() == CV_16U) {
        stored.raster = rgb_of<Rgb16, std::uint16_t>(decoded, stored.shown);
    } else {
        stored.raster = rgb_of<Rgb8, std::uint8_t>(decoded, stored.shown);
    }
    stored.is_grey = is_grey_png(bytes);
    stored.tags = png_color_tags(bytes);
    refuse_pq(stored.tags, path);
    return stored;
}

ColorImage decode_color_png(std::span<const std::uint8_t> bytes, std::size_t max_pixels,
                            const std::filesystem::path& path) {
    return srgb_of(decode_png(bytes, max_pixels, path)).picture;
}

GrayImage decode_gray_png(std::span<const std::uint8_t> bytes, std::size_t max_pixels,
                          const std::filesystem::path& path) {
    return decode_gray<std::uint8_t>(bytes, max_pixels, path, CV_8UC1);
}

Image<std::uint16_t> decode_gray16_png(std::span<const std::uint8_t> bytes, std::size_t max_pixels,
                                       const std::filesystem::path& path) {
    return decode_gray<std::uint16_t>(bytes, max_pixels, path, CV_16UC1);
}

}  // namespace lumi
