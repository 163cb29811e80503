#include "calib/pictures/image_io.h"

#include <opencv2/imgproc.hpp>

#include "calib/opencv/cv_matrix.h"
#include "calib/pictures/heif_decoder.h"
#include "calib/pictures/image_format.h"
#include "calib/pictures/jpeg_decoder.h"
#include "calib/pictures/png_codec.h"
#include "calib/pictures/srgb_conversion.h"
#include "calib/pictures/tiff_io.h"
#include "calib/pictures/webp_decoder.h"
#include "calib/work/error.h"
#include "calib/work/whole_file.h"

namespace lumi {
namespace {

ImageFormat format_or_refuse(const Bytes& bytes, const std::filesystem::path& path) {
    const auto format = image_format_of(bytes);
    if (!format) {
        throw Error(ErrorKind::kBadInput, "E-IMAGE-FORMAT",
                    path.string() + ": not a picture as " + std::string(kImageFormats),
                    "export the picture as JPEG, PNG or TIFF");
    }
    return *format;
}

constexpr std::size_t kMaxPixels = std::size_t{1} << 28;

}  // namespace

SrgbPicture read_srgb_picture(const std::filesystem::path& path, std::size_t max_pixels) {
    const Bytes bytes = read_whole_file(path);
    switch (format_or_refuse(bytes, path)) {
        case ImageFormat::kJpeg:
            return srgb_of(decode_jpeg(bytes, max_pixels, path));
        case ImageFormat::kPng:
            return srgb_of(decode_png(bytes, max_pixels, path));
        case ImageFormat::kTiff:
            return srgb_of(read_stored_tiff(path, max_pixels));
        case ImageFormat::kHeif:
            return srgb_of(decode_heif(bytes, max_pixels, path));
        case ImageFormat::kWebp:
            return srgb_of(decode_webp(bytes, max_pixels, path));
    }
    return {};
}

ColorImage read_color_image(const std::filesystem::path& path, std::size_t max_pixels) {
    return read_srgb_picture(path, max_pixels).picture;
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
        case ImageFormat::kHeif:
            return heif_size(bytes, path);
        case ImageFormat::kWebp:
            return webp_size(bytes, path);
    }
    return {};
}

void write_png(const std::filesystem::path& path, const ColorImage& image) {
    write_whole_file(path, encode_png(image, path));
}

void write_png(const std::filesystem::path& path, const GrayImage& image) {
    write_whole_file(path, encode_png(image, path));
}

void write_png(const std::filesystem::path& path, const Image<std::uint16_t>& image) {
    write_whole_file(path, encode_png(image, path));
}

GrayImage read_gray_png(const std::filesystem::path& path) {
    return decode_gray_png(read_whole_file(path), kMaxPixels, path);
}

Image<std::uint16_t> read_gray16_png(const std::filesystem::path& path) {
    return decode_gray16_png(read_whole_file(path), kMaxPixels, path);
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
