#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace lumi {

/// Why photographs do not tell where they were taken: the one vocabulary of the doctor, who looks
/// at them before the long step, and of the refusals of the pose stage.
enum class CaptureReason {
    kNoParallax,  ///< The camera turned on the spot, or hardly moved.
    kPlanar,      ///< Everything lies in one plane.
    kTexture,     ///< Too little detail or contrast.
    kNoise,       ///< The pictures are noisy.
    kBlur,        ///< The pictures are blurred.
    kShutter,     ///< The camera moved while the rows were read out.
    kShifted,     ///< The middle of the lens lies elsewhere in each picture.
    kExposure,    ///< Brightness jumps, or the pictures are mostly black or white.
    kClutter,     ///< Much of what is seen moved or changed between the photographs.
    kSplit,       ///< The photographs fall into groups that do not overlap.
    kRepeated,    ///< Things that look alike were taken for one another.
    kFocal,       ///< The focal length that was told, or came out, is wrong.
    kZoom,        ///< Several focal lengths where one was assumed.
    kDuplicates,  ///< Too few different places.
    kForward,     ///< The camera moved along its line of sight only.
    kNoPair,      ///< No two photographs show the same things.
    kFew,         ///< Too few photographs were given, or could be placed.
    kUncertain,   ///< The places come out too uncertain, for no single cause.
};

/// Stable, such as "E-POSES-ROTATION".
[[nodiscard]] std::string_view code_of(CaptureReason reason);
[[nodiscard]] std::optional<CaptureReason> reason_with_code(std::string_view code);

/// False for what names the effect only: that no pair, or too few photographs, could be used.
[[nodiscard]] bool is_cause(CaptureReason reason);

/// What to do next, in the words of a photographer.
[[nodiscard]] std::string_view advice_for(CaptureReason reason);

/// Throws Error of kind kDegenerateCapture with the code and the advice of `reason`.
[[noreturn]] void refuse_capture(CaptureReason reason, const std::string& what);

}  // namespace lumi
