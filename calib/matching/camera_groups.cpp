#include "calib/matching/camera_groups.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <string>
#include <tuple>

#include "calib/work/error.h"
#include "calib/work/median.h"

namespace lumi {
namespace {

double longer_side_px(const Photograph& photograph) {
    return std::max(photograph.width_px, photograph.height_px);
}

/// A guess for a lens that nothing is known of.
double guessed_focal_length_px(const std::vector<Photograph>& photographs,
                               const Photograph& photograph) {
    std::vector<double> of_same_size;
    for (const Photograph& other : photographs) {
        if (other.width_px == photograph.width_px && other.height_px == photograph.height_px &&
            other.focal_length_px && *other.focal_length_px > 0) {
            of_same_size.push_back(*other.focal_length_px);
        }
    }
    if (!of_same_size.empty()) return median_of(of_same_size);
    constexpr double kFocalLengthPerLongerSide = 1.2;
    constexpr double kSameCamera = 0.1;
    std::vector<double> sides;
    for (const Photograph& other : photographs) sides.push_back(longer_side_px(other));
    const double usual = median_of(sides);
    const double own = longer_side_px(photograph);
    const bool is_crop = std::abs(own - usual) <= kSameCamera * usual;
    return kFocalLengthPerLongerSide * (is_crop ? usual : own);
}

Camera lens_with_focal_length(const Photograph& photograph, LensModel model, double focal_px) {
    Camera camera{photograph.width_px, photograph.height_px, model,
                  std::vector<double>(parameter_count(model), 0.0)};
    std::size_t next = 0;
    camera.parameters[next++] = focal_px;
    if (!has_one_focal_length(model)) camera.parameters[next++] = focal_px;
    camera.parameters[next++] = 0.5 * photograph.width_px;
    camera.parameters[next] = 0.5 * photograph.height_px;
    return camera;
}

Camera given_for(const Camera& lens, const Photograph& photograph) {
    // Sizes are rounded to whole pixels, so that equal shapes may differ by one pixel.
    const double expected_height_px =
        static_cast<double>(photograph.width_px) * lens.height_px / lens.width_px;
    if (std::abs(expected_height_px - photograph.height_px) > 1.0 + 1e-9) {
        throw Error(ErrorKind::kBadInput, "E-POSES-LENS",
                    photograph.name + ": is " + std::to_string(photograph.width_px) + "x" +
                        std::to_string(photograph.height_px) + ", but the given lens is for " +
                        std::to_string(lens.width_px) + "x" + std::to_string(lens.height_px),
                    "calibrate with photographs of the same shape, or let lumi estimate the lens");
    }
    return resized(lens, photograph.width_px, photograph.height_px);
}

ColmapCamera camera_for(const std::vector<Photograph>& photographs, const std::vector<int>& group,
                        const std::optional<Camera>& given_lens, const LensGrouping& options) {
    const Photograph& photograph = photographs[static_cast<std::size_t>(group.front())];
    if (given_lens) return {given_for(*given_lens, photograph), true};
    std::vector<double> focal_lengths;
    for (const int index : group) {
        const auto& focal_length = photographs[static_cast<std::size_t>(index)].focal_length_px;
        if (focal_length && *focal_length > 0) focal_lengths.push_back(*focal_length);
    }
    // What "auto" will choose is not known before there are poses: the usual lens is a start.
    const LensModel model = lens_model_named(options.lens_model).value_or(LensModel::kSimpleRadial);
    const double focal_px = focal_lengths.empty() ? guessed_focal_length_px(photographs, photograph)
                                                  : median_of(focal_lengths);
    return {lens_with_focal_length(photograph, model, focal_px), !focal_lengths.empty()};
}

}  // namespace

CameraGroups group_cameras(const std::vector<Photograph>& photographs,
                           const std::optional<Camera>& given_lens, const LensGrouping& options) {
    using Key = std::tuple<std::string, int, int, std::size_t>;
    std::map<Key, std::size_t> group_of_key;
    std::vector<std::vector<int>> groups;
    CameraGroups result;
    for (std::size_t index = 0; index < photographs.size(); ++index) {
        const Photograph& photograph = photographs[index];
        const Key key{photograph.camera_key, photograph.width_px, photograph.height_px,
                      options.shared_lens ? 0 : index};
        const auto [entry, is_new] = group_of_key.emplace(key, groups.size());
        if (is_new) groups.emplace_back();
        groups[entry->second].push_back(static_cast<int>(index));
        result.camera_of_photograph.push_back(static_cast<int>(entry->second));
    }
    for (const std::vector<int>& group : groups) {
        result.cameras.push_back(camera_for(photographs, group, given_lens, options));
    }
    return result;
}

bool focal_lengths_are_known(const CameraGroups& groups) {
    return std::all_of(groups.cameras.begin(), groups.cameras.end(),
                       [](const ColmapCamera& camera) { return camera.focal_length_is_known; });
}

}  // namespace lumi
