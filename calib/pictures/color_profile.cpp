#include "calib/pictures/color_profile.h"

#include <lcms2.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <mutex>

#include "calib/work/printable.h"

namespace lumi {
namespace {

using ProfileHandle = std::unique_ptr<void, int (*)(void*)>;

ProfileHandle owned(cmsHPROFILE handle) { return {handle, cmsCloseProfile}; }

std::string name_of_profile(cmsHPROFILE profile) {
    std::array<char, 128> name{};
    cmsGetProfileInfoASCII(profile, cmsInfoDescription, "en", "US", name.data(), name.size());
    name.back() = '\0';
    return name.front() == '\0' ? "an unnamed colour profile" : printable(name.data());
}

/// How Little CMS finds the numbers in rasters of `bytes` per sample. The one channel of a grey
/// picture stands three times.
cmsUInt32Number format_of(ColorProfile::Numbers numbers, unsigned bytes) {
    switch (numbers) {
        case ColorProfile::Numbers::kGrey:
            return COLORSPACE_SH(PT_GRAY) | CHANNELS_SH(1) | EXTRA_SH(2) | BYTES_SH(bytes);
        case ColorProfile::Numbers::kCmyk:
            return TYPE_CMYK_8_REV;
        case ColorProfile::Numbers::kRgb:
            break;
    }
    return COLORSPACE_SH(PT_RGB) | CHANNELS_SH(3) | BYTES_SH(bytes);
}

std::optional<ColorProfile::Numbers> numbers_of(cmsHPROFILE profile) {
    switch (cmsGetColorSpace(profile)) {
        case cmsSigRgbData:
            return ColorProfile::Numbers::kRgb;
        case cmsSigGrayData:
            return ColorProfile::Numbers::kGrey;
        case cmsSigCmykData:
            return ColorProfile::Numbers::kCmyk;
        default:
            return std::nullopt;
    }
}

std::shared_ptr<void> transform_from(cmsHPROFILE profile, cmsUInt32Number format,
                                     cmsUInt32Number flags) {
    const ProfileHandle srgb = owned(cmsCreate_sRGBProfile());
    // Without its cache a transform has no state that threads could disturb.
    const cmsHTRANSFORM transform =
        cmsCreateTransform(profile, format, srgb.get(), TYPE_RGB_8, INTENT_RELATIVE_COLORIMETRIC,
                           flags | cmsFLAGS_BLACKPOINTCOMPENSATION | cmsFLAGS_NOCACHE);
    if (transform == nullptr) return nullptr;
    return {transform, cmsDeleteTransform};
}

/// Makers of sRGB profiles round curves and primaries differently, by up to 1.4 levels where a
/// channel is nearly black; a gamma of 2.2 instead of the curve of sRGB is off by 8.
bool keeps_colors(const ColorProfile& profile) {
    constexpr int kTolerance = 2;
    constexpr int kStep = 15;
    constexpr int kSteps = 255 / kStep + 1;
    Image<Rgb16> grid(kSteps,
                      profile.numbers() == ColorProfile::Numbers::kGrey ? 1 : kSteps * kSteps);
    const auto level = [](int step) { return static_cast<std::uint16_t>(257 * kStep * step); };
    for (int y = 0; y < grid.height(); ++y) {
        for (int x = 0; x < grid.width(); ++x) {
            grid(x, y) = {level(x), level(y % kSteps), level(y / kSteps)};
            if (grid.height() == 1) grid(x, y) = {level(x), level(x), level(x)};
        }
    }
    const ColorImage converted = profile.srgb_of(grid);
    for (std::size_t i = 0; i < grid.pixels().size(); ++i) {
        const Rgb16& before = grid.pixels()[i];
        const Rgb8& after = converted.pixels()[i];
        if (std::abs(before.r / 257 - after.r) > kTolerance ||
            std::abs(before.g / 257 - after.g) > kTolerance ||
            std::abs(before.b / 257 - after.b) > kTolerance) {
            return false;
        }
    }
    return true;
}

using ToneCurve = std::unique_ptr<cmsToneCurve, void (*)(cmsToneCurve*)>;

ToneCurve gamma_curve(double gamma) { return {cmsBuildGamma(nullptr, gamma), cmsFreeToneCurve}; }

/// IEC 61966-2-1.
ToneCurve srgb_curve() {
    constexpr int kPowerAndLine = 4;
    constexpr std::array<double, 5> kParameters{2.4, 1 / 1.055, 0.055 / 1.055, 1 / 12.92, 0.04045};
    return {cmsBuildParametricToneCurve(nullptr, kPowerAndLine, kParameters.data()),
            cmsFreeToneCurve};
}

ProfileHandle rgb_profile(const cmsCIExyYTRIPLE& primaries, const ToneCurve& curve) {
    constexpr cmsCIExyY kD65{0.3127, 0.3290, 1.0};
    const std::array<cmsToneCurve*, 3> curves{curve.get(), curve.get(), curve.get()};
    return owned(cmsCreateRGBProfile(&kD65, &primaries, curves.data()));
}

constexpr cmsCIExyYTRIPLE kSrgbPrimaries{{0.64, 0.33, 1.0}, {0.30, 0.60, 1.0}, {0.15, 0.06, 1.0}};

/// ITU-T H.273, table 2: those with the white of D65 that pictures are made with.
struct CodedPrimaries {
    int code;
    const char* name;
    cmsCIExyYTRIPLE primaries;
};
constexpr std::array<CodedPrimaries, 7> kCodedPrimaries{{
    {1, "BT.709", kSrgbPrimaries},
    {2, "unspecified primaries", kSrgbPrimaries},
    {5, "BT.470 BG", {{0.64, 0.33, 1.0}, {0.29, 0.60, 1.0}, {0.15, 0.06, 1.0}}},
    {6, "BT.601", {{0.630, 0.340, 1.0}, {0.310, 0.595, 1.0}, {0.155, 0.070, 1.0}}},
    {7, "SMPTE ST 240", {{0.630, 0.340, 1.0}, {0.310, 0.595, 1.0}, {0.155, 0.070, 1.0}}},
    {9, "BT.2020", {{0.708, 0.292, 1.0}, {0.170, 0.797, 1.0}, {0.131, 0.046, 1.0}}},
    {12, "Display P3", {{0.680, 0.320, 1.0}, {0.265, 0.690, 1.0}, {0.150, 0.060, 1.0}}},
}};

/// H.273, table 3.
std::optional<ToneCurve> coded_curve(int transfer) {
    switch (transfer) {
        case 1:   // BT.709.
        case 2:   // Unspecified.
        case 6:   // BT.601.
        case 13:  // sRGB.
        case 14:  // BT.2020 in 10 bits.
        case 15:  // In 12.
        case kHlgTransfer:
            return srgb_curve();
        case 4:
            return gamma_curve(2.2);
        case 5:
            return gamma_curve(2.8);
        case 8:
            return gamma_curve(1.0);
        default:
            return std::nullopt;
    }
}

}  // namespace

std::shared_ptr<const ColorProfile> ColorProfile::from(void* handle, std::string name) {
    const auto numbers = numbers_of(handle);
    if (!numbers) return nullptr;
    std::shared_ptr<ColorProfile> profile(new ColorProfile());
    profile->name_ = std::move(name);
    profile->numbers_ = *numbers;
    if (*numbers == Numbers::kRgb) profile->matrix_ = MatrixProfile::of(handle);
    if (!profile->matrix_) {
        // Grey has curves alone, which its shortcut would coarsen.
        const cmsUInt32Number from_8 = *numbers == Numbers::kGrey ? cmsFLAGS_NOOPTIMIZE : 0;
        profile->from_8_bits_ = transform_from(handle, format_of(*numbers, 1), from_8);
        profile->from_16_bits_ =
            transform_from(handle, format_of(*numbers, 2), cmsFLAGS_NOOPTIMIZE);
        if (!profile->from_8_bits_ || !profile->from_16_bits_) return nullptr;
    }
    profile->is_srgb_ = *numbers != Numbers::kCmyk && keeps_colors(*profile);
    return profile;
}

std::shared_ptr<const ColorProfile> ColorProfile::of(const Bytes& icc_profile) {
    constexpr std::size_t kMostKept = 8;
    static std::mutex mutex;
    static std::map<Bytes, std::shared_ptr<const ColorProfile>> kept;
    const std::scoped_lock lock(mutex);
    if (const auto known = kept.find(icc_profile); known != kept.end()) return known->second;
    const ProfileHandle handle = owned(cmsOpenProfileFromMem(
        icc_profile.data(), static_cast<cmsUInt32Number>(icc_profile.size())));
    auto profile = handle ? from(handle.get(), name_of_profile(handle.get())) : nullptr;
    if (kept.size() == kMostKept) kept.clear();
    kept.emplace(icc_profile, profile);
    return profile;
}

std::shared_ptr<const ColorProfile> ColorProfile::of(const CodedColors& coded) {
    const auto known = std::find_if(
        kCodedPrimaries.begin(), kCodedPrimaries.end(),
        [&](const CodedPrimaries& primaries) { return primaries.code == coded.primaries; });
    const std::optional<ToneCurve> curve = coded_curve(coded.transfer);
    if (known == kCodedPrimaries.end() || !curve) return nullptr;
    static std::mutex mutex;
    static std::map<std::array<int, 2>, std::shared_ptr<const ColorProfile>> kept;
    const std::scoped_lock lock(mutex);
    std::shared_ptr<const ColorProfile>& profile = kept[{coded.primaries, coded.transfer}];
    const std::string name = known->name;
    if (!profile)
        profile = from(rgb_profile(known->primaries, *curve).get(),
                       coded.transfer == kHlgTransfer ? "HLG (" + name + ")" : name);
    return profile;
}

std::shared_ptr<const ColorProfile> ColorProfile::adobe_rgb() {
    static const auto kProfile = [] {
        constexpr cmsCIExyYTRIPLE kPrimaries{
            {0.64, 0.33, 1.0}, {0.21, 0.71, 1.0}, {0.15, 0.06, 1.0}};
        constexpr double kGamma = 563.0 / 256.0;
        return from(rgb_profile(kPrimaries, gamma_curve(kGamma)).get(), "Adobe RGB (by EXIF)");
    }();
    return kProfile;
}

std::shared_ptr<const ColorProfile> ColorProfile::linear_light() {
    static const auto kProfile = [] {
        return from(rgb_profile(kSrgbPrimaries, gamma_curve(1.0)).get(), "linear light");
    }();
    return kProfile;
}

ColorImage ColorProfile::srgb_of(ColorImage picture) const {
    std::vector<Rgb8>& pixels = picture.pixels();
    if (matrix_) {
        constexpr int k16BitsOf8 = 257;
        const auto deep = [](std::uint8_t value) {
            return static_cast<std::uint16_t>(k16BitsOf8 * value);
        };
        for (Rgb8& pixel : pixels) {
            pixel = matrix_->srgb_of(deep(pixel.r), deep(pixel.g), deep(pixel.b));
        }
    } else {
        cmsDoTransform(from_8_bits_.get(), pixels.data(), pixels.data(),
                       static_cast<cmsUInt32Number>(pixels.size()));
    }
    return picture;
}

ColorImage ColorProfile::srgb_of(const Image<Rgb16>& picture) const {
    ColorImage srgb(picture.width(), picture.height());
    if (matrix_) {
        std::transform(
            picture.pixels().begin(), picture.pixels().end(), srgb.pixels().begin(),
            [this](const Rgb16& pixel) { return matrix_->srgb_of(pixel.r, pixel.g, pixel.b); });
    } else {
        cmsDoTransform(from_16_bits_.get(), picture.pixels().data(), srgb.pixels().data(),
                       static_cast<cmsUInt32Number>(picture.pixels().size()));
    }
    return srgb;
}

ColorImage ColorProfile::srgb_of(const Image<InvertedCmyk8>& picture) const {
    ColorImage srgb(picture.width(), picture.height());
    cmsDoTransform(from_8_bits_.get(), picture.pixels().data(), srgb.pixels().data(),
                   static_cast<cmsUInt32Number>(picture.pixels().size()));
    return srgb;
}

}  // namespace lumi
