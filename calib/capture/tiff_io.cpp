#include "calib/capture/tiff_io.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <memory>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "calib/capture/image_format.h"
#include "calib/work/error.h"
#include "calib/work/whole_file.h"

namespace lumi {
namespace {

/// Opens by OpenImageIO's TIFF reader only, whatever the file is called.
std::unique_ptr<OIIO::ImageInput> open_tiff(const std::filesystem::path& path) {
    std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::create("tiff");
    OIIO::ImageSpec spec;
    if (!input || !input->open(path.string(), spec)) {
        refuse_truncated_image(path, input ? input->geterror() : OIIO::geterror());
    }
    return input;
}

ImageSize size_of(const OIIO::ImageSpec& spec) { return {spec.width, spec.height}; }

template <class Sample>
std::vector<Sample> read_samples(OIIO::ImageInput& input, OIIO::TypeDesc type,
                                 const std::filesystem::path& path) {
    const OIIO::ImageSpec& spec = input.spec();
    const auto channels = static_cast<std::size_t>(spec.nchannels);
    std::vector<Sample> samples(static_cast<std::size_t>(spec.width) *
                                static_cast<std::size_t>(spec.height) * channels);
    const bool read = input.read_image(0, 0, 0, spec.nchannels, type, samples.data());
    if (!read || input.has_error()) refuse_truncated_image(path, input.geterror());
    return samples;
}

}  // namespace

ImageSize tiff_size(const std::filesystem::path& path) { return size_of(open_tiff(path)->spec()); }

ColorImage read_color_tiff(const std::filesystem::path& path, std::size_t max_pixels) {
    const auto input = open_tiff(path);
    const ImageSize size = size_of(input->spec());
    check_image_size(size, max_pixels, path);
    constexpr int kMaxChannels = 4;
    const int channels = input->spec().nchannels;
    if (channels < 1 || channels > kMaxChannels || input->spec().depth > 1) {
        throw Error(ErrorKind::kBadInput, "E-IMAGE-FORMAT",
                    path.string() + ": expected grey or colour, found " + std::to_string(channels) +
                        " channels",
                    "export the picture as 8-bit RGB");
    }
    const auto samples = read_samples<std::uint8_t>(*input, OIIO::TypeDesc::UINT8, path);
    const std::size_t stride = static_cast<std::size_t>(channels);
    const std::size_t green = channels >= 3 ? 1 : 0;
    ColorImage image(size.width_px, size.height_px);
    for (std::size_t i = 0; i < image.pixels().size(); ++i) {
        const std::uint8_t* sample = &samples[i * stride];
        image.pixels()[i] = {sample[0], sample[green], sample[2 * green]};
    }
    return image;
}

void write_float_tiff(const std::filesystem::path& path, const FloatImage& image) {
    // OpenImageIO reports no error on some full disks, so the bytes are made in memory.
    const cv::Mat pixels(image.height(), image.width(), CV_32FC1, const_cast<float*>(image.row(0)));
    constexpr int kNoCompression = 1;
    Bytes bytes;
    if (!cv::imencode(".tiff", pixels, bytes, {cv::IMWRITE_TIFF_COMPRESSION, kNoCompression})) {
        throw Error(ErrorKind::kResources, "E-IMAGE-ENCODE", path.string() + ": cannot be encoded",
                    "free some memory and try again");
    }
    write_whole_file(path, bytes);
}

FloatImage read_float_tiff(const std::filesystem::path& path) {
    const auto input = open_tiff(path);
    const ImageSize size = size_of(input->spec());
    check_image_size(size, std::size_t{1} << 28, path);
    if (input->spec().nchannels != 1 || input->spec().format != OIIO::TypeDesc::FLOAT) {
        throw Error(ErrorKind::kBadInput, "E-IMAGE-FORMAT",
                    path.string() + ": expected one channel of 32-bit floats",
                    "write depth as a float TIFF, z along the optical axis, 0 where unknown");
    }
    FloatImage image(size.width_px, size.height_px);
    image.pixels() = read_samples<float>(*input, OIIO::TypeDesc::FLOAT, path);
    return image;
}

}  // namespace lumi
