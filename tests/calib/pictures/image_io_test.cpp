#include "calib/pictures/image_io.h"

#include <gmock/gmock.h>
#include <turbojpeg.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "tests/calib/scratch_folder.h"
#include "tests/calib/test_pictures.h"

namespace lumi {
namespace {

using ::testing::AnyOf;

/// The code with which a file of these bytes is refused; "none" when it is read.
std::string code_for(const Bytes& bytes, const ScratchFolder& scratch,
                     std::size_t max_pixels = std::size_t{1} << 28) {
    scratch.put("picture", bytes);
    try {
        static_cast<void>(read_color_image(scratch / "picture", max_pixels));
    } catch (const Error& error) {
        return error.code();
    }
    return "none";
}

Bytes encoded(const std::string& ending, const cv::Mat& pixels,
              const std::vector<int>& flags = {}) {
    Bytes bytes;
    cv::imencode(ending, pixels, bytes, flags);
    return bytes;
}

/// A picture in OpenCV's channel order.
cv::Mat test_matrix(int type) {
    cv::Mat pixels(24, 32, type);
    for (int y = 0; y < pixels.rows; ++y) {
        for (int x = 0; x < pixels.cols * pixels.channels(); ++x) {
            const int value = (x * 7 + y * 5) % 256;
            if (pixels.depth() == CV_8U) {
                pixels.ptr<std::uint8_t>(y)[x] = static_cast<std::uint8_t>(value);
            } else {
                pixels.ptr<std::uint16_t>(y)[x] = static_cast<std::uint16_t>(value * 257);
            }
        }
    }
    return pixels;
}

int largest_difference(const ColorImage& a, const ColorImage& b) {
    int largest = 0;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) {
        const Rgb8& p = a.pixels()[i];
        const Rgb8& q = b.pixels()[i];
        largest =
            std::max({largest, std::abs(p.r - q.r), std::abs(p.g - q.g), std::abs(p.b - q.b)});
    }
    return largest;
}

TEST(ImageIo, PngKeepsEveryPixel) {
    const ScratchFolder scratch;
    const ColorImage color = wavy_picture(33, 21);
    write_png(scratch / "color.png", color);
    EXPECT_EQ(read_color_image(scratch / "color.png"), color);
    EXPECT_EQ(read_image_size(scratch / "color.png").width_px, 33);
    EXPECT_EQ(read_image_size(scratch / "color.png").height_px, 21);
    GrayImage gray(9, 7);
    Image<std::uint16_t> deep(9, 7);
    for (std::size_t i = 0; i < gray.pixels().size(); ++i) {
        gray.pixels()[i] = static_cast<std::uint8_t>(4 * i);
        deep.pixels()[i] = static_cast<std::uint16_t>(1033 * i);
    }
    write_png(scratch / "gray.png", gray);
    write_png(scratch / "deep.png", deep);
    EXPECT_EQ(read_gray_png(scratch / "gray.png"), gray);
    EXPECT_EQ(read_gray16_png(scratch / "deep.png"), deep);
    EXPECT_THROW(static_cast<void>(read_gray_png(scratch / "deep.png")), Error);
    EXPECT_THROW(static_cast<void>(read_gray16_png(scratch / "color.png")), Error);
}

TEST(ImageIo, JpegOfHighQualityIsCloseInEveryChannel) {
    const ScratchFolder scratch;
    ColorImage smooth(64, 48);
    for (int y = 0; y < 48; ++y) {
        for (int x = 0; x < 64; ++x) {
            smooth(x, y) = {static_cast<std::uint8_t>(3 * x), static_cast<std::uint8_t>(4 * y),
                            static_cast<std::uint8_t>(200 - x - y)};
        }
    }
    write_jpeg(scratch / "smooth.jpg", smooth, 98);
    EXPECT_LE(largest_difference(read_color_image(scratch / "smooth.jpg"), smooth), 4);
}

TEST(ImageIo, ReadsEveryKindOfPngAsEightBitColour) {
    const ScratchFolder scratch;
    const auto pixel = [&](const cv::Mat& matrix) {
        scratch.put("picture.png", encoded(".png", matrix));
        return read_color_image(scratch / "picture.png")(0, 0);
    };
    EXPECT_EQ(pixel(cv::Mat(4, 4, CV_8UC3, cv::Scalar(30, 20, 10))), (Rgb8{10, 20, 30}));
    EXPECT_EQ(pixel(cv::Mat(4, 4, CV_8UC4, cv::Scalar(30, 20, 10, 255))), (Rgb8{10, 20, 30}));
    EXPECT_EQ(pixel(cv::Mat(4, 4, CV_8UC1, cv::Scalar(50))), (Rgb8{50, 50, 50}));
    EXPECT_EQ(pixel(cv::Mat(4, 4, CV_16UC1, cv::Scalar(50 * 257))), (Rgb8{50, 50, 50}));
    EXPECT_EQ(pixel(cv::Mat(4, 4, CV_16UC3, cv::Scalar(30 * 257, 20 * 257, 10 * 257))),
              (Rgb8{10, 20, 30}));
}

TEST(ImageIo, ATransparentPngIsSeenBeforeBlack) {
    const ScratchFolder scratch;
    const auto pixel = [&](int type, const cv::Scalar& color) {
        scratch.put("picture.png", encoded(".png", cv::Mat(4, 4, type, color)));
        return read_color_image(scratch / "picture.png")(0, 0);
    };
    EXPECT_EQ(pixel(CV_8UC4, cv::Scalar(200, 100, 50, 0)), (Rgb8{0, 0, 0}));
    EXPECT_EQ(pixel(CV_8UC4, cv::Scalar(200, 100, 50, 102)), (Rgb8{20, 40, 80}));
    EXPECT_EQ(pixel(CV_16UC4, cv::Scalar(200 * 257, 100 * 257, 50 * 257, 102 * 257)),
              (Rgb8{20, 40, 80}));
}

TEST(ImageIo, ReadsEveryKindOfTiffAsEightBitColour) {
    const ScratchFolder scratch;
    constexpr int kNone = 1;
    constexpr int kLzw = 5;
    for (const int compression : {kNone, kLzw}) {
        const auto pixel = [&](const cv::Mat& matrix) {
            scratch.put("picture.tif",
                        encoded(".tiff", matrix, {cv::IMWRITE_TIFF_COMPRESSION, compression}));
            return read_color_image(scratch / "picture.tif")(1, 2);
        };
        EXPECT_EQ(pixel(cv::Mat(4, 4, CV_8UC3, cv::Scalar(30, 20, 10))), (Rgb8{10, 20, 30}));
        EXPECT_EQ(pixel(cv::Mat(4, 4, CV_8UC4, cv::Scalar(30, 20, 10, 255))), (Rgb8{10, 20, 30}));
        EXPECT_EQ(pixel(cv::Mat(4, 4, CV_8UC1, cv::Scalar(50))), (Rgb8{50, 50, 50}));
        EXPECT_EQ(pixel(cv::Mat(4, 4, CV_16UC3, cv::Scalar(30 * 257, 20 * 257, 10 * 257))),
                  (Rgb8{10, 20, 30}));
    }
}

TEST(ImageIo, ReadsGrayAndCmykJpeg) {
    const ScratchFolder scratch;
    scratch.put("gray.jpg", encoded(".jpg", cv::Mat(16, 16, CV_8UC1, cv::Scalar(90))));
    EXPECT_EQ(read_color_image(scratch / "gray.jpg")(3, 3), (Rgb8{90, 90, 90}));

    // Inverted inks as Adobe stores them: no cyan, all magenta and yellow, no black: red.
    Bytes inks;
    for (int i = 0; i < 16 * 16; ++i) inks.insert(inks.end(), {255, 0, 0, 255});
    unsigned char* buffer = nullptr;
    unsigned long size = 0;
    void* encoder = tjInitCompress();
    ASSERT_EQ(
        tjCompress2(encoder, inks.data(), 16, 0, 16, TJPF_CMYK, &buffer, &size, TJSAMP_444, 98, 0),
        0);
    scratch.put("cmyk.jpg", {buffer, size});
    tjFree(buffer);
    tjDestroy(encoder);
    const Rgb8 red = read_color_image(scratch / "cmyk.jpg")(3, 3);
    EXPECT_GT(red.r, 250);
    EXPECT_LT(red.g, 5);
    EXPECT_LT(red.b, 5);
}

TEST(ImageIo, RefusesEveryTruncationOfEveryFormat) {
    const ScratchFolder scratch;
    const cv::Mat pixels = test_matrix(CV_8UC3);
    const std::vector<std::pair<std::string, Bytes>> files{
        {"baseline JPEG", encoded(".jpg", pixels)},
        {"progressive JPEG", encoded(".jpg", pixels, {cv::IMWRITE_JPEG_PROGRESSIVE, 1})},
        {"JPEG with restarts", encoded(".jpg", pixels, {cv::IMWRITE_JPEG_RST_INTERVAL, 2})},
        {"PNG", encoded(".png", pixels)},
        {"deep PNG", encoded(".png", test_matrix(CV_16UC1))},
        {"TIFF", encoded(".tiff", pixels, {cv::IMWRITE_TIFF_COMPRESSION, 1})},
        {"compressed TIFF", encoded(".tiff", pixels)}};
    for (const auto& [name, whole] : files) {
        ASSERT_EQ(code_for(whole, scratch), "none") << name;
        for (std::size_t length = 0; length < whole.size(); ++length) {
            const Bytes part(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length));
            EXPECT_THAT(code_for(part, scratch), AnyOf("E-IMAGE-TRUNCATED", "E-IMAGE-FORMAT"))
                << name << " cut to " << length << " of " << whole.size() << " bytes";
        }
    }
}

/// `whole` with bytes between its last scan line and its end marker, as telephones pad files.
Bytes padded_before_end_marker(const Bytes& whole, std::size_t count) {
    Bytes padded(whole.begin(), whole.end() - 2);
    padded.insert(padded.end(), count, 0x00);
    padded.insert(padded.end(), {0xff, 0xd9});
    return padded;
}

TEST(ImageIo, AJpegPaddedBeforeItsEndMarkerIsReadToTheSamePixels) {
    const ScratchFolder scratch;
    const Bytes whole = encoded(".jpg", test_matrix(CV_8UC3));
    scratch.put("whole.jpg", whole);
    scratch.put("padded.jpg", padded_before_end_marker(whole, 40));
    EXPECT_EQ(read_color_image(scratch / "padded.jpg"), read_color_image(scratch / "whole.jpg"));
}

/// As some telephones write it: the scan's header does not say which coefficients it holds.
Bytes without_spectral_selection(Bytes jpeg) {
    const std::array<std::uint8_t, 2> marker{0xff, 0xda};
    const auto scan = std::search(jpeg.begin(), jpeg.end(), marker.begin(), marker.end());
    const auto length = static_cast<std::ptrdiff_t>(scan[2]) << 8 | scan[3];
    std::fill_n(scan + 2 + length - 3, 3, std::uint8_t{0});
    return jpeg;
}

TEST(ImageIo, AJpegWhoseScanHeaderIsEmptyIsReadToTheSamePixelsUnlessItEndsEarly) {
    const ScratchFolder scratch;
    const Bytes whole = encoded(".jpg", test_matrix(CV_8UC3));
    const Bytes odd = without_spectral_selection(whole);
    ASSERT_NE(odd, whole);
    scratch.put("whole.jpg", whole);
    scratch.put("odd.jpg", odd);
    EXPECT_EQ(read_color_image(scratch / "odd.jpg"), read_color_image(scratch / "whole.jpg"));
    EXPECT_EQ(code_for(Bytes(odd.begin(), odd.end() - 100), scratch), "E-IMAGE-TRUNCATED");
}

TEST(ImageIo, AJpegThatIsPaddedAndDamagedIsRefused) {
    const ScratchFolder scratch;
    // Without its restart marker half the picture is taken for bytes too many.
    Bytes whole = encoded(".jpg", test_matrix(CV_8UC3), {cv::IMWRITE_JPEG_RST_INTERVAL, 2});
    const std::array<std::uint8_t, 2> marker{0xff, 0xd0};
    const auto lost = std::search(whole.begin(), whole.end(), marker.begin(), marker.end());
    ASSERT_NE(lost, whole.end());
    whole.erase(lost, lost + 2);
    EXPECT_EQ(code_for(whole, scratch), "E-IMAGE-TRUNCATED");
    EXPECT_EQ(code_for(padded_before_end_marker(whole, 40), scratch), "E-IMAGE-TRUNCATED");
}

TEST(ImageIo, APngWithADamagedByteIsRefusedOrUnharmed) {
    const ScratchFolder scratch;
    const Bytes whole = encoded(".png", test_matrix(CV_8UC3));
    scratch.put("whole.png", whole);
    const ColorImage truth = read_color_image(scratch / "whole.png");
    std::size_t refused = 0;
    for (std::size_t i = 8; i < whole.size(); ++i) {
        Bytes damaged = whole;
        damaged[i] ^= 0x10;
        if (code_for(damaged, scratch) == "none") {
            EXPECT_EQ(read_color_image(scratch / "picture"), truth) << "byte " << i;
        } else {
            ++refused;
        }
    }
    EXPECT_GT(refused, whole.size() / 2);
}

/// Bit by bit, as the PNG specification defines it.
std::uint32_t crc_of(std::span<const std::uint8_t> bytes) {
    std::uint32_t crc = 0xffffffffU;
    for (const std::uint8_t byte : bytes) {
        crc ^= byte;
        for (int bit = 0; bit < 8; ++bit) crc = (crc & 1) != 0 ? crc >> 1 ^ 0xedb88320U : crc >> 1;
    }
    return ~crc;
}

TEST(ImageIo, RefusesHugeClaimsBeforeDecoding) {
    const ScratchFolder scratch;
    // A few hundred bytes that claim to be 40 000 x 40 000 pixels.
    Bytes png = encoded(".png", test_matrix(CV_8UC3));
    png[18] = 0x9c;  // Width and height, big-endian, at 16 and 20.
    png[19] = 0x40;
    png[22] = 0x9c;
    png[23] = 0x40;
    const std::uint32_t crc = crc_of(std::span(png).subspan(12, 17));
    for (unsigned i = 0; i < 4; ++i) png[29 + i] = static_cast<std::uint8_t>(crc >> (24 - 8 * i));
    EXPECT_EQ(code_for(png, scratch), "E-IMAGE-TOOBIG");
    Bytes jpeg = encoded(".jpg", test_matrix(CV_8UC3));
    const std::uint8_t start_of_frame[2] = {0xff, 0xc0};
    const auto frame = std::search(jpeg.begin(), jpeg.end(), start_of_frame, start_of_frame + 2);
    ASSERT_NE(frame, jpeg.end());
    std::fill(frame + 5, frame + 9, std::uint8_t{0xf0});
    EXPECT_EQ(code_for(jpeg, scratch), "E-IMAGE-TOOBIG");
    for (const std::string ending : {".png", ".jpg", ".tiff"}) {
        const Bytes whole = encoded(ending, test_matrix(CV_8UC3));
        EXPECT_EQ(code_for(whole, scratch, 24 * 32), "none") << ending;
        EXPECT_EQ(code_for(whole, scratch, 24 * 32 - 1), "E-IMAGE-TOOBIG") << ending;
    }
}

/// What no program that lumi builds on decodes, though nothing is damaged.
TEST(ImageIo, AnUnusualFormIsNotSupportedRatherThanDamaged) {
    const ScratchFolder scratch;
    Bytes lossless = encoded(".jpg", test_matrix(CV_8UC3));
    constexpr std::array<std::uint8_t, 2> kStartOfFrame{0xff, 0xc0};
    const auto frame =
        std::search(lossless.begin(), lossless.end(), kStartOfFrame.begin(), kStartOfFrame.end());
    ASSERT_NE(frame, lossless.end());
    Bytes of_12_bits = lossless;
    of_12_bits[static_cast<std::size_t>(frame - lossless.begin()) + 4] = 12;
    frame[1] = 0xc3;
    EXPECT_EQ(code_for(lossless, scratch), "E-IMAGE-FORMAT");
    EXPECT_EQ(code_for(of_12_bits, scratch), "E-IMAGE-FORMAT");
    // The compression that its directory names: of DNG, with a loss.
    Bytes tiff = encoded(".tiff", test_matrix(CV_8UC3), {cv::IMWRITE_TIFF_COMPRESSION, 1});
    constexpr std::array<std::uint8_t, 8> kCompression{0x03, 0x01, 3, 0, 1, 0, 0, 0};
    const auto entry =
        std::search(tiff.begin(), tiff.end(), kCompression.begin(), kCompression.end());
    ASSERT_NE(entry, tiff.end());
    entry[8] = 34892 % 256;
    entry[9] = 34892 / 256;
    EXPECT_EQ(code_for(tiff, scratch), "E-IMAGE-FORMAT");
}

TEST(ImageIo, RefusesWhatIsNoPicture) {
    const ScratchFolder scratch;
    EXPECT_EQ(code_for({}, scratch), "E-IMAGE-FORMAT");
    EXPECT_EQ(code_for({'G', 'I', 'F', '8', '9', 'a'}, scratch), "E-IMAGE-FORMAT");
    try {
        static_cast<void>(read_color_image(scratch / "not there.png"));
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-FILE-READ");
    }
}

TEST(ImageIo, FloatTiffKeepsEveryBit) {
    const ScratchFolder scratch;
    FloatImage image(5, 3);
    const std::vector<float> special{0.0F,
                                     -0.0F,
                                     1.5F,
                                     -3.25e-30F,
                                     std::numeric_limits<float>::denorm_min(),
                                     std::numeric_limits<float>::max(),
                                     std::numeric_limits<float>::infinity(),
                                     std::numeric_limits<float>::quiet_NaN()};
    std::copy(special.begin(), special.end(), image.pixels().begin());
    write_float_tiff(scratch / "depth.tiff", image);
    const FloatImage again = read_float_tiff(scratch / "depth.tiff");
    ASSERT_EQ(again.width(), 5);
    ASSERT_EQ(again.height(), 3);
    const auto equal = [](const FloatImage& a, const FloatImage& b) {
        return a.pixels().size() == b.pixels().size() &&
               std::memcmp(a.row(0), b.row(0), a.pixels().size() * sizeof(float)) == 0;
    };
    EXPECT_TRUE(equal(again, image));
    // Its last four bytes only say that no further picture follows.
    const Bytes whole = read_whole_file(scratch / "depth.tiff");
    std::size_t refused = 0;
    for (std::size_t length = 0; length < whole.size(); ++length) {
        scratch.put("part.tiff", std::span(whole).first(length));
        try {
            EXPECT_TRUE(equal(read_float_tiff(scratch / "part.tiff"), image)) << length;
        } catch (const Error&) {
            ++refused;
        }
    }
    EXPECT_GE(refused, whole.size() - 4);
}

TEST(ImageIo, HalvingAveragesFourPixels) {
    ColorImage image(4, 2);
    for (int x = 0; x < 4; ++x) {
        image(x, 0) = {static_cast<std::uint8_t>(40 * x), 10, 0};
        image(x, 1) = {static_cast<std::uint8_t>(40 * x + 20), 30, 0};
    }
    const ColorImage half = resized(image, 2, 1);
    EXPECT_EQ(half(0, 0), (Rgb8{30, 20, 0}));
    EXPECT_EQ(half(1, 0), (Rgb8{110, 20, 0}));
}

}  // namespace
}  // namespace lumi
