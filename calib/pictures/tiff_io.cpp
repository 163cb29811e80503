#include "calib/pictures/tiff_io.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <memory>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <utility>

#include "calib/pictures/before_black.h"
#include "calib/pictures/image_format.h"
#include "calib/work/error.h"
#include "calib/work/whole_file.h"

namespace lumi {
namespace {

constexpr const char* kUnassociatedAlpha = "oiio:UnassociatedAlpha";
constexpr const char* kRawColor = "oiio:RawColor";

/// By what the decoder says, in the words of libtiff.
[[noreturn]] void refuse_tiff(const std::filesystem::path& path, const std::string& fault) {
    const auto says = [&](const char* words) { return fault.find(words) != std::string::npos; };
    if (says("Compression scheme") || says("compression support is not configured")) {
        refuse_unsupported_image(path, fault);
    }
    refuse_truncated_image(path, fault);
}

/// Opens by OpenImageIO's TIFF reader only, whatever the file is called. With `as_stored` (one of
/// OpenImageIO's) set, samples are handed out without what it names applied to them.
std::unique_ptr<OIIO::ImageInput> open_tiff(const std::filesystem::path& path,
                                            const char* as_stored = kUnassociatedAlpha) {
    std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::create("tiff");
    OIIO::ImageSpec spec;
    OIIO::ImageSpec wish;
    wish.attribute(as_stored, 1);
    if (!input || !input->open(path.string(), spec, wish)) {
        refuse_tiff(path, input ? input->geterror() : OIIO::geterror());
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
    if (!read || input.has_error()) refuse_tiff(path, input.geterror());
    return samples;
}

/// Floats as 16 bits, which hold light finely enough for 8-bit sRGB. Returns the share of pixels
/// that are brighter than 1, or no number.
double quantized(const std::vector<float>& samples, const SampleLayout& layout,
                 std::vector<std::uint16_t>& result) {
    constexpr float kWhite = 65535.0F;
    const auto stride = static_cast<std::size_t>(layout.channels);
    result.resize(samples.size());
    std::size_t clipped = 0;
    for (std::size_t i = 0; i < samples.size(); i += stride) {
        bool is_clipped = false;
        for (std::size_t channel = 0; channel < stride; ++channel) {
            const float value = samples[i + channel];
            is_clipped = is_clipped || !(value <= 1.0F);
            result[i + channel] = static_cast<std::uint16_t>(
                value > 0.0F ? std::min(value, 1.0F) * kWhite + 0.5F : 0.0F);
        }
        if (is_clipped) ++clipped;
    }
    return static_cast<double>(clipped) /
           static_cast<double>(std::max<std::size_t>(1, samples.size() / stride));
}

StoredPicture stored_rgb(OIIO::ImageInput& input, const std::filesystem::path& path) {
    const OIIO::ImageSpec& spec = input.spec();
    const SampleLayout layout{.width_px = spec.width,
                              .height_px = spec.height,
                              .channels = spec.nchannels,
                              .alpha_channel = spec.alpha_channel,
                              .is_premultiplied = spec.get_int_attribute(kUnassociatedAlpha) == 0};
    StoredPicture stored;
    stored.is_grey = spec.nchannels < 3;
    if (spec.format.basesize() == 1) {
        const auto samples = read_samples<std::uint8_t>(input, OIIO::TypeDesc::UINT8, path);
        stored.raster = before_black<Rgb8, std::uint8_t>(samples, layout, stored.shown);
        return stored;
    }
    std::vector<std::uint16_t> samples;
    if (spec.format.is_floating_point()) {
        stored.clipped_share =
            quantized(read_samples<float>(input, OIIO::TypeDesc::FLOAT, path), layout, samples);
        stored.tags.is_linear = spec.get_string_attribute("oiio:ColorSpace") != "sRGB";
    } else {
        samples = read_samples<std::uint16_t>(input, OIIO::TypeDesc::UINT16, path);
    }
    stored.raster = before_black<Rgb16, std::uint16_t>(samples, layout, stored.shown);
    return stored;
}

/// In a TIFF 0 is no ink.
StoredPicture stored_inks(OIIO::ImageInput& input, const std::filesystem::path& path) {
    const OIIO::ImageSpec& spec = input.spec();
    const auto samples = read_samples<std::uint8_t>(input, OIIO::TypeDesc::UINT8, path);
    Image<InvertedCmyk8> inks(spec.width, spec.height);
    const auto inverted = [](std::uint8_t ink) { return static_cast<std::uint8_t>(255 - ink); };
    for (std::size_t i = 0; i < inks.pixels().size(); ++i) {
        const std::uint8_t* sample = &samples[4 * i];
        inks.pixels()[i] = {inverted(sample[0]), inverted(sample[1]), inverted(sample[2]),
                            inverted(sample[3])};
    }
    StoredPicture stored;
    stored.raster = std::move(inks);
    return stored;
}

std::optional<Bytes> profile_in(const OIIO::ImageSpec& spec) {
    const OIIO::ParamValue* profile = spec.find_attribute("ICCProfile");
    if (profile == nullptr) return std::nullopt;
    const auto* bytes = static_cast<const std::uint8_t*>(profile->data());
    return Bytes(bytes, bytes + profile->datasize());
}

}  // namespace

ImageSize tiff_size(const std::filesystem::path& path) { return size_of(open_tiff(path)->spec()); }

StoredPicture read_stored_tiff(const std::filesystem::path& path, std::size_t max_pixels) {
    auto input = open_tiff(path);
    check_image_size(size_of(input->spec()), max_pixels, path);
    constexpr int kMaxChannels = 4;
    const int channels = input->spec().nchannels;
    if (channels < 1 || channels > kMaxChannels || input->spec().depth > 1) {
        throw Error(ErrorKind::kBadInput, "E-IMAGE-FORMAT",
                    path.string() + ": expected grey or colour, found " + std::to_string(channels) +
                        " channels",
                    "export the picture as 8-bit RGB");
    }
    const bool is_cmyk = input->spec().get_string_attribute("tiff:ColorSpace") == "CMYK";
    if (is_cmyk) input = open_tiff(path, kRawColor);
    StoredPicture stored = is_cmyk ? stored_inks(*input, path) : stored_rgb(*input, path);
    stored.tags.icc_profile = profile_in(input->spec());
    return stored;
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
