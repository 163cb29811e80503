#include "calib/capture/image_io.h"

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "calib/capture/image_format.h"
#include "calib/capture/jpeg_decoder.h"
#include "calib/capture/tiff_io.h"
#include "calib/work/error.h"
#include "calib/work/whole_file.h"

namespace lumi {
namespace {

ImageFormat format_or_refuse(const Bytes& bytes, const std::filesystem::path& path) {
    const auto format = image_format_of(bytes);
    if (!format) {
        throw Error(ErrorKind::kBadInput, "E-IMAGE-FORMAT",
                    path.string() + ": not a JPEG, PNG or TIFF picture",
                    "export the picture as JPEG, PNG or TIFF");
    }
    return *format;
}

cv::Mat decode_png(const Bytes& bytes, int flags, std::size_t max_pixels,
                   const std::filesystem::path& path) {
    check_image_size(check_png(bytes, path), max_pixels, path);
    cv::Mat decoded;
    try {
        decoded = cv::imdecode(bytes, flags | cv::IMREAD_IGNORE_ORIENTATION);
    } catch (const cv::Exception& exception) {
        refuse_truncated_image(path, exception.what());
    }
    if (decoded.empty()) refuse_truncated_image(path, "the PNG cannot be decoded");
    return decoded;
}

template <class Pixel>
Image<Pixel> image_of(const cv::Mat& matrix) {
    Image<Pixel> image(matrix.cols, matrix.rows);
    for (int y = 0; y < matrix.rows; ++y) {
        const auto* row = matrix.ptr<Pixel>(y);
        std::copy(row, row + matrix.cols, image.row(y));
    }
    return image;
}

/// A view of the pixels for OpenCV, which only reads them.
template <class Pixel>
cv::Mat matrix_of(const Image<Pixel>& image, int type) {
    return {image.height(), image.width(), type, const_cast<Pixel*>(image.row(0))};
}

ColorImage rgb_from_bgr(const cv::Mat& bgr) {
    cv::Mat rgb;
    cv::cvtColor(bgr, rgb, cv::COLOR_BGR2RGB);
    return image_of<Rgb8>(rgb);
}

void write_png_matrix(const std::filesystem::path& path, const cv::Mat& matrix) {
    // Level 1 is five times faster than the default and costs a few per cent of the size.
    Bytes bytes;
    if (!cv::imencode(".png", matrix, bytes, {cv::IMWRITE_PNG_COMPRESSION, 1}) || bytes.empty()) {
        throw Error(ErrorKind::kResources, "E-IMAGE-ENCODE", path.string() + ": cannot be encoded",
                    "free some memory and try again");
    }
    write_whole_file(path, bytes);
}

template <class Pixel>
Image<Pixel> read_gray(const std::filesystem::path& path, int opencv_type) {
    const Bytes bytes = read_whole_file(path);
    if (image_format_of(bytes) != ImageFormat::kPng) {
        throw Error(ErrorKind::kBadInput, "E-IMAGE-FORMAT", path.string() + ": not a PNG picture",
                    "make the package again");
    }
    const cv::Mat decoded = decode_png(bytes, cv::IMREAD_UNCHANGED, std::size_t{1} << 28, path);
    if (decoded.type() != opencv_type) {
        throw Error(ErrorKind::kBadInput, "E-IMAGE-FORMAT",
                    path.string() + ": expected one grey channel of " +
                        std::to_string(8 * sizeof(Pixel)) + " bits",
                    "make the package again");
    }
    return image_of<Pixel>(decoded);
}

}  // namespace

ColorImage read_color_image(const std::filesystem::path& path, std::size_t max_pixels) {
    const Bytes bytes = read_whole_file(path);
    switch (format_or_refuse(bytes, path)) {
        case ImageFormat::kJpeg:
            return decode_jpeg(bytes, max_pixels, path);
        case ImageFormat::kPng:
            return rgb_from_bgr(decode_png(bytes, cv::IMREAD_COLOR, max_pixels, path));
        case ImageFormat::kTiff:
            return read_color_tiff(path, max_pixels);
    }
    return {};
}

ImageSize read_image_size(const std::filesystem::path& path) {
    const Bytes bytes = read_whole_file(path);
    switch (format_or_refuse(bytes, path)) {
        case ImageFormat::kJpeg:
            return jpeg_size(bytes, path);
        case ImageFormat::kPng:
            return check_png(bytes, path);
        case ImageFormat::kTiff:
            return tiff_size(path);
    }
    return {};
}

void write_png(const std::filesystem::path& path, const ColorImage& image) {
    cv::Mat bgr;
    cv::cvtColor(matrix_of(image, CV_8UC3), bgr, cv::COLOR_RGB2BGR);
    write_png_matrix(path, bgr);
}

void write_png(const std::filesystem::path& path, const GrayImage& image) {
    write_png_matrix(path, matrix_of(image, CV_8UC1));
}

void write_png(const std::filesystem::path& path, const Image<std::uint16_t>& image) {
    write_png_matrix(path, matrix_of(image, CV_16UC1));
}

GrayImage read_gray_png(const std::filesystem::path& path) {
    return read_gray<std::uint8_t>(path, CV_8UC1);
}

Image<std::uint16_t> read_gray16_png(const std::filesystem::path& path) {
    return read_gray<std::uint16_t>(path, CV_16UC1);
}

void write_jpeg(const std::filesystem::path& path, const ColorImage& image, int quality) {
    write_whole_file(path, encode_jpeg(image, quality));
}

ColorImage resized(const ColorImage& image, int width_px, int height_px) {
    const bool smaller = width_px < image.width() || height_px < image.height();
    cv::Mat result;
    cv::resize(matrix_of(image, CV_8UC3), result, {width_px, height_px}, 0, 0,
               smaller ? cv::INTER_AREA : cv::INTER_CUBIC);
    return image_of<Rgb8>(result);
}

}  // namespace lumi
