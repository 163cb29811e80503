#pragma once

#include <lcms2.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

#include "calib/work/whole_file.h"

namespace lumi {

/// The bytes of a profile; it is closed.
[[nodiscard]] inline Bytes bytes_of_profile(cmsHPROFILE profile) {
    cmsUInt32Number size = 0;
    cmsSaveProfileToMem(profile, nullptr, &size);
    Bytes bytes(size);
    cmsSaveProfileToMem(profile, bytes.data(), &size);
    cmsCloseProfile(profile);
    return bytes;
}

inline void name_profile(cmsHPROFILE profile, const char* name) {
    cmsMLU* text = cmsMLUalloc(nullptr, 1);
    cmsMLUsetASCII(text, "en", "US", name);
    cmsWriteTag(profile, cmsSigProfileDescriptionTag, text);
    cmsMLUfree(text);
}

/// An RGB profile of three primaries, x and y of red, green and blue, and one curve.
[[nodiscard]] inline Bytes rgb_profile_of(const char* name, const std::array<double, 6>& xy,
                                          cmsToneCurve* curve,
                                          cmsCIExyY white = {0.3127, 0.3290, 1.0}) {
    const cmsCIExyYTRIPLE primaries{{xy[0], xy[1], 1}, {xy[2], xy[3], 1}, {xy[4], xy[5], 1}};
    const std::array<cmsToneCurve*, 3> curves{curve, curve, curve};
    cmsHPROFILE profile = cmsCreateRGBProfile(&white, &primaries, curves.data());
    cmsFreeToneCurve(curve);
    name_profile(profile, name);
    return bytes_of_profile(profile);
}

[[nodiscard]] inline cmsToneCurve* srgb_tone_curve() {
    const std::array<double, 5> parameters{2.4, 1 / 1.055, 0.055 / 1.055, 1 / 12.92, 0.04045};
    return cmsBuildParametricToneCurve(nullptr, 4, parameters.data());
}

inline constexpr std::array<double, 6> kSrgbPrimaries{0.64, 0.33, 0.30, 0.60, 0.15, 0.06};
inline constexpr std::array<double, 6> kDisplayP3Primaries{0.680, 0.320, 0.265,
                                                           0.690, 0.150, 0.060};
inline constexpr std::array<double, 6> kAdobePrimaries{0.64, 0.33, 0.21, 0.71, 0.15, 0.06};

[[nodiscard]] inline Bytes display_p3_profile() {
    return rgb_profile_of("Display P3", kDisplayP3Primaries, srgb_tone_curve());
}

[[nodiscard]] inline Bytes jpeg_with_segment(const Bytes& jpeg, std::uint8_t marker,
                                             const Bytes& segment) {
    const std::size_t length = segment.size() + 2;
    Bytes whole(jpeg.begin(), jpeg.begin() + 2);
    whole.insert(whole.end(), {0xff, marker, static_cast<std::uint8_t>(length >> 8),
                               static_cast<std::uint8_t>(length & 0xff)});
    whole.insert(whole.end(), segment.begin(), segment.end());
    whole.insert(whole.end(), jpeg.begin() + 2, jpeg.end());
    return whole;
}

/// In as many segments as asked, the last one first.
[[nodiscard]] inline Bytes jpeg_with_profile(Bytes jpeg, const Bytes& profile, int segments = 1) {
    constexpr std::string_view kHeader("ICC_PROFILE\0", 12);
    const std::size_t step = (profile.size() + static_cast<std::size_t>(segments) - 1) /
                             static_cast<std::size_t>(segments);
    for (int i = 0; i < segments; ++i) {
        Bytes segment(kHeader.begin(), kHeader.end());
        segment.push_back(static_cast<std::uint8_t>(i + 1));
        segment.push_back(static_cast<std::uint8_t>(segments));
        const std::size_t begin = std::min(profile.size(), static_cast<std::size_t>(i) * step);
        const std::size_t end = std::min(profile.size(), begin + step);
        segment.insert(segment.end(), profile.begin() + static_cast<std::ptrdiff_t>(begin),
                       profile.begin() + static_cast<std::ptrdiff_t>(end));
        jpeg = jpeg_with_segment(jpeg, 0xe2, segment);
    }
    return jpeg;
}

}  // namespace lumi
