#pragma once

#include <memory>
#include <optional>
#include <string>

#include "calib/pictures/matrix_profile.h"
#include "calib/pictures/stored_picture.h"

namespace lumi {

/// What numbers mean, by an ICC profile, and their way to sRGB: relative colorimetric, with black
/// point compensation. Threads can share it.
class ColorProfile {
 public:
    enum class Numbers { kRgb, kGrey, kCmyk };

    /// As embedded in a file. Each is parsed once: the answer is kept by its bytes. Null when it is
    /// damaged, or of numbers that are none of these.
    [[nodiscard]] static std::shared_ptr<const ColorProfile> of(const Bytes& icc_profile);
    /// By code points. Curves of television count as that of sRGB, as all programs show them, and
    /// HLG, too, which was made to be seen so on ordinary screens (BT.2100). Null where they are
    /// none that pictures are made with, and for PQ.
    [[nodiscard]] static std::shared_ptr<const ColorProfile> of(const CodedColors& coded);
    /// Adobe RGB (1998).
    [[nodiscard]] static std::shared_ptr<const ColorProfile> adobe_rgb();
    /// Light by the primaries of sRGB.
    [[nodiscard]] static std::shared_ptr<const ColorProfile> linear_light();

    /// What it calls itself, fit for printing.
    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] Numbers numbers() const { return numbers_; }
    /// Whether its numbers are those of sRGB, give or take how profiles are rounded.
    [[nodiscard]] bool is_srgb() const { return is_srgb_; }

    /// In place of the picture, which is grey where the profile is one of grey numbers.
    [[nodiscard]] ColorImage srgb_of(ColorImage picture) const;
    [[nodiscard]] ColorImage srgb_of(const Image<Rgb16>& picture) const;
    /// Of a profile of inks.
    [[nodiscard]] ColorImage srgb_of(const Image<InvertedCmyk8>& picture) const;

 private:
    ColorProfile() = default;
    /// `handle`: a cmsHPROFILE. Null when it leads nowhere.
    static std::shared_ptr<const ColorProfile> from(void* handle, std::string name);

    std::string name_;
    Numbers numbers_ = Numbers::kRgb;
    bool is_srgb_ = false;
    std::optional<MatrixProfile> matrix_;
    // Of Little CMS, for whatever is no matrix.
    std::shared_ptr<void> from_8_bits_;
    std::shared_ptr<void> from_16_bits_;
};

}  // namespace lumi
