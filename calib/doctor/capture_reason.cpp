#include "calib/doctor/capture_reason.h"

#include <algorithm>
#include <array>

#include "calib/work/error.h"

namespace lumi {
namespace {

struct ReasonEntry {
    CaptureReason reason;
    std::string_view code;
    std::string_view advice;
};

constexpr std::array<ReasonEntry, 18> kReasons{{
    {CaptureReason::kNoParallax, "E-POSES-ROTATION",
     "step sideways between photographs, about a tenth of the distance to the subject"},
    {CaptureReason::kPlanar, "E-POSES-PLANAR",
     "include something that stands out of the plane, or give the lens ([calibration])"},
    {CaptureReason::kTexture, "E-POSES-TEXTURE",
     "get things with a pattern into the picture (a newspaper, a patterned cloth) or more light "
     "from the side; walls in one colour and glass show nothing to hold on to"},
    {CaptureReason::kNoise, "E-POSES-NOISE",
     "add light, or use a lower ISO with a longer exposure on a rest or tripod"},
    {CaptureReason::kBlur, "E-POSES-BLUR",
     "focus on the subject and hold still, with a shorter exposure or more light"},
    {CaptureReason::kShutter, "E-POSES-SHUTTER",
     "stand still for each photograph, or use a mechanical shutter: the rows of these pictures "
     "were not taken at one moment"},
    {CaptureReason::kShifted, "E-POSES-SHIFTED",
     "use photographs as they came from the camera, neither cropped nor straightened, with the "
     "focus locked and, where that can be chosen, without a stabiliser in the lens"},
    {CaptureReason::kExposure, "E-POSES-EXPOSURE",
     "lock exposure and white balance, so that neither shadows nor highlights are cut off"},
    {CaptureReason::kClutter, "E-POSES-CLUTTER",
     "photograph when nothing moves, or get so close that what stands still fills the frame"},
    {CaptureReason::kSplit, "E-POSES-SPLIT",
     "add photographs between the groups, so that each overlaps by two thirds with the next"},
    {CaptureReason::kRepeated, "E-POSES-REPEATED",
     "put things that differ next to the sides that look alike, or step back so that the "
     "surroundings are in view, and walk around in small steps, with files named in that order"},
    {CaptureReason::kFocal, "E-POSES-FOCAL",
     "give the lens ([calibration]), keep EXIF data in the photographs, or photograph the subject "
     "from more sides"},
    {CaptureReason::kZoom, "E-POSES-ZOOM",
     "use one zoom setting for all photographs, keep their EXIF data, or set [poses] shared_lens "
     "= false"},
    {CaptureReason::kDuplicates, "E-POSES-DUPLICATES",
     "take photographs from more places: the same view twice adds nothing"},
    {CaptureReason::kForward, "E-POSES-FORWARD",
     "do not only walk towards the subject: step sideways between photographs"},
    {CaptureReason::kNoPair, "E-POSES-NOPAIR",
     "take sharp photographs that overlap by two thirds with the next one; surfaces without any "
     "texture need something with a pattern in view"},
    {CaptureReason::kFew, "E-POSES-FEW",
     "add photographs, so that each overlaps by two thirds with the next; two alone need a lens "
     "that is known ([calibration])"},
    {CaptureReason::kUncertain, "E-POSES-UNCERTAIN",
     "add photographs of the same things from places in between and further to the sides"},
}};

const ReasonEntry& entry_of(CaptureReason reason) {
    return *std::find_if(kReasons.begin(), kReasons.end(),
                         [&](const ReasonEntry& entry) { return entry.reason == reason; });
}

}  // namespace

std::string_view code_of(CaptureReason reason) { return entry_of(reason).code; }

std::optional<CaptureReason> reason_with_code(std::string_view code) {
    const auto* const entry =
        std::find_if(kReasons.begin(), kReasons.end(),
                     [&](const ReasonEntry& candidate) { return candidate.code == code; });
    if (entry == kReasons.end()) return std::nullopt;
    return entry->reason;
}

std::string_view advice_for(CaptureReason reason) { return entry_of(reason).advice; }

bool is_cause(CaptureReason reason) {
    return reason != CaptureReason::kNoPair && reason != CaptureReason::kFew &&
           reason != CaptureReason::kUncertain;
}

void refuse_capture(CaptureReason reason, const std::string& what) {
    throw Error(ErrorKind::kDegenerateCapture, std::string(code_of(reason)), what,
                std::string(advice_for(reason)));
}

}  // namespace lumi
