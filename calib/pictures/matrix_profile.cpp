#include "calib/pictures/matrix_profile.h"

#include <lcms2.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <memory>

#include "calib/capture/nearest_byte.h"
#include "calib/pictures/srgb_curve.h"

namespace lumi {
namespace {

constexpr std::size_t kValues = 65536;
constexpr float kMaxValue = 65535.0F;

/// Its columns are the primaries of the profile, in XYZ relative to its white.
std::optional<Eigen::Matrix3d> xyz_from_light(cmsHPROFILE profile) {
    constexpr std::array kTags{cmsSigRedColorantTag, cmsSigGreenColorantTag, cmsSigBlueColorantTag};
    Eigen::Matrix3d matrix;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const auto* primary = static_cast<const cmsCIEXYZ*>(cmsReadTag(profile, kTags[channel]));
        if (primary == nullptr) return std::nullopt;
        matrix.col(static_cast<Eigen::Index>(channel)) << primary->X, primary->Y, primary->Z;
    }
    return matrix;
}

Eigen::Matrix3d srgb_light_from_xyz() {
    const std::unique_ptr<void, int (*)(void*)> srgb(cmsCreate_sRGBProfile(), cmsCloseProfile);
    return xyz_from_light(srgb.get()).value().inverse();
}

std::optional<std::vector<float>> light_of_curve(cmsHPROFILE profile, cmsTagSignature tag) {
    const auto* curve = static_cast<const cmsToneCurve*>(cmsReadTag(profile, tag));
    if (curve == nullptr) return std::nullopt;
    std::vector<float> light(kValues);
    for (std::size_t value = 0; value < kValues; ++value) {
        const float there = cmsEvalToneCurveFloat(curve, static_cast<float>(value) / kMaxValue);
        light[value] = std::isfinite(there) ? std::clamp(there, 0.0F, 1.0F) : 0.0F;
    }
    return light;
}

/// Of every 16-bit light; the steps of black are a twentieth of a level.
const std::vector<std::uint8_t>& srgb_bytes_of_light() {
    static const std::vector<std::uint8_t> kBytes = [] {
        std::vector<std::uint8_t> bytes(kValues);
        for (std::size_t value = 0; value < kValues; ++value) {
            bytes[value] = nearest_byte(
                255.0 * srgb_of_light(static_cast<double>(value) / static_cast<double>(kMaxValue)));
        }
        return bytes;
    }();
    return kBytes;
}

}  // namespace

std::optional<MatrixProfile> MatrixProfile::of(void* profile) {
    // Little CMS too prefers tables where a profile has both.
    constexpr std::array kTables{cmsSigAToB0Tag, cmsSigAToB1Tag, cmsSigDToB0Tag, cmsSigDToB1Tag};
    const bool has_tables = std::any_of(kTables.begin(), kTables.end(), [&](cmsTagSignature tag) {
        return cmsIsTag(profile, tag) != 0;
    });
    if (has_tables || cmsIsMatrixShaper(profile) == 0) return std::nullopt;
    constexpr std::array kCurves{cmsSigRedTRCTag, cmsSigGreenTRCTag, cmsSigBlueTRCTag};
    MatrixProfile result;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        auto light = light_of_curve(profile, kCurves[channel]);
        if (!light || light->front() > 0) return std::nullopt;
        result.light_[channel] = std::move(*light);
    }
    const auto xyz = xyz_from_light(profile);
    if (!xyz) return std::nullopt;
    result.srgb_from_profile_ = (srgb_light_from_xyz() * *xyz).cast<float>();
    return result;
}

Rgb8 MatrixProfile::srgb_of(std::uint16_t r, std::uint16_t g, std::uint16_t b) const {
    static const std::uint8_t* const kSrgb = srgb_bytes_of_light().data();
    const Eigen::Vector3f light =
        srgb_from_profile_ * Eigen::Vector3f(light_[0][r], light_[1][g], light_[2][b]);
    const auto encoded = [](float value) {
        return kSrgb[static_cast<int>(std::clamp(value, 0.0F, 1.0F) * kMaxValue + 0.5F)];
    };
    return {encoded(light.x()), encoded(light.y()), encoded(light.z())};
}

}  // namespace lumi
