#include "calib/known_poses/lens_for_photograph.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "calib/work/error.h"

namespace lumi {
namespace {

struct Size {
    int width_px = 0;
    int height_px = 0;

    friend auto operator<=>(const Size&, const Size&) = default;
};

std::string text(Size size) {
    return std::to_string(size.width_px) + "x" + std::to_string(size.height_px);
}

Size size_on_disk(const Photograph& photograph) {
    return {photograph.original_width_px, photograph.original_height_px};
}

/// True when one size is the other scaled, up to one pixel of rounding at the smaller of the two.
bool are_one_shape(Size a, Size b) {
    const double height_px = static_cast<double>(a.height_px) * b.width_px / a.width_px;
    const double tolerance_px = std::max(1.0, static_cast<double>(b.width_px) / a.width_px);
    return std::abs(height_px - b.height_px) <= tolerance_px;
}

[[noreturn]] void refuse_size(const std::string& what) {
    throw Error(ErrorKind::kBadInput, "E-IMPORT-SIZE", what,
                "give the photographs that the poses were found with, or poses of these "
                "photographs, or let lumi estimate the poses");
}

void refuse_another_shape(Size stated, const Photograph& photograph,
                          const std::filesystem::path& path) {
    const Size on_disk = size_on_disk(photograph);
    if (are_one_shape(stated, on_disk)) return;
    const bool turned = are_one_shape({stated.height_px, stated.width_px}, on_disk);
    refuse_size(path.string() + ": its lens is for pictures of " + text(stated) + ", but " +
                photograph.name + " has " + text(on_disk) +
                (turned ? ": the other program turned it upright (EXIF orientation), lumi does not"
                        : ": it was cropped or undistorted since"));
}

void refuse_principal_point_outside(const KnownLens& lens, const Photograph& photograph,
                                    const std::filesystem::path& path) {
    const Camera camera = lens_for_original(lens, photograph);
    if (is_inside(camera, principal_point_px(camera))) return;
    refuse_size(path.string() + ": its lens has the principal point beyond " + photograph.name +
                " (" + text(size_on_disk(photograph)) + "): the photograph was scaled or cropped");
}

/// Pictures that were all scaled alike keep one size; after undistortion each has its own.
void refuse_several_sizes(Size stated, const std::vector<const Photograph*>& photographs,
                          const std::filesystem::path& path) {
    const auto by_size = [](const Photograph* a, const Photograph* b) {
        return size_on_disk(*a) < size_on_disk(*b);
    };
    const auto [smallest, largest] =
        std::minmax_element(photographs.begin(), photographs.end(), by_size);
    if (size_on_disk(**smallest) == size_on_disk(**largest)) return;
    refuse_size(path.string() + ": its lenses are all for pictures of " + text(stated) +
                ", but those on disk have several sizes, from " + text(size_on_disk(**smallest)) +
                " (" + (**smallest).name + ") to " + text(size_on_disk(**largest)) + " (" +
                (**largest).name + "): they were cropped or undistorted since");
}

}  // namespace

void refuse_other_pictures(const KnownPoses& known, const std::vector<Photograph>& photographs,
                           const std::vector<std::optional<std::size_t>>& photograph_of_view,
                           const std::filesystem::path& path) {
    std::map<Size, std::vector<const Photograph*>> by_stated_size;
    for (std::size_t i = 0; i < known.views.size(); ++i) {
        if (!photograph_of_view[i]) continue;
        const Photograph& photograph = photographs[*photograph_of_view[i]];
        const auto lens = static_cast<std::size_t>(known.views[i].camera_index);
        if (known.lenses[lens].of_any_size) {
            refuse_principal_point_outside(known.lenses[lens], photograph, path);
            continue;
        }
        const Camera& camera = known.lenses[lens].camera;
        by_stated_size[{camera.width_px, camera.height_px}].push_back(&photograph);
    }
    for (const auto& [stated, of_size] : by_stated_size) {
        refuse_several_sizes(stated, of_size, path);
        refuse_another_shape(stated, *of_size.front(), path);
    }
}

Camera lens_for_original(const KnownLens& lens, const Photograph& photograph) {
    const Size size = size_on_disk(photograph);
    if (lens.of_any_size) return lens_for_size(*lens.of_any_size, size.width_px, size.height_px);
    return resized(lens.camera, size.width_px, size.height_px);
}

Camera lens_for_working_copy(const KnownLens& lens, const Photograph& photograph) {
    // In one step where the file states a size: a lens of that very size is kept to the bit.
    if (!lens.of_any_size) {
        return resized(lens.camera, photograph.width_px, photograph.height_px);
    }
    return resized(lens_for_original(lens, photograph), photograph.width_px, photograph.height_px);
}

}  // namespace lumi
