#include "calib/capture/png_codec.h"

#include <algorithm>
#include <limits>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <string>

#include "calib/capture/image_format.h"
#include "calib/opencv/cv_matrix.h"
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
        refuse_truncated_image(path, exception.what());
    }
    if (decoded.empty()) refuse_truncated_image(path, "the PNG cannot be decoded");
    return decoded;
}

/// What a picture with an alpha channel, 8 or 16 bits deep, shows before black; blue first.
cv::Mat before_black(const cv::Mat& transparent) {
    constexpr double k8BitsOf16 = 1.0 / 257.0;
    cv::Mat picture;
    transparent.convertTo(picture, CV_8U, transparent.depth() == CV_16U ? k8BitsOf16 : 1.0);
    cv::Mat bgr(picture.size(), CV_8UC3);
    constexpr int kOpaque = 255;
    for (int y = 0; y < picture.rows; ++y) {
        for (int x = 0; x < picture.cols; ++x) {
            const auto& pixel = picture.at<cv::Vec4b>(y, x);
            for (int channel = 0; channel < 3; ++channel) {
                const int shown = (pixel[channel] * pixel[3] + kOpaque / 2) / kOpaque;
                bgr.at<cv::Vec3b>(y, x)[channel] = static_cast<std::uint8_t>(shown);
            }
        }
    }
    return bgr;
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

ColorImage decode_color_png(std::span<const std::uint8_t> bytes, std::size_t max_pixels,
                            const std::filesystem::path& path) {
    cv::Mat bgr = decode(bytes, cv::IMREAD_UNCHANGED, max_pixels, path);
    if (bgr.channels() == 4) {
        bgr = before_black(bgr);
    } else if (bgr.type() != CV_8UC3) {
        bgr = decode(bytes, cv::IMREAD_COLOR, max_pixels, path);
    }
    cv::Mat rgb;
    cv::cvtColor(bgr, rgb, cv::COLOR_BGR2RGB);
    return image_of<Rgb8>(rgb);
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
