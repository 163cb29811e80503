#include <map>
#include <tuple>

#include "calib/known_poses/known_poses.h"
#include "calib/known_poses/lens_for_photograph.h"
#include "calib/known_poses/name_matching.h"
#include "calib/poses/model_check.h"
#include "calib/poses/pose_stage.h"
#include "calib/work/counted.h"
#include "calib/work/error.h"
#include "calib/work/printable.h"

namespace lumi {
namespace {

using PhotographOfView = std::vector<std::optional<std::size_t>>;

/// A picture that was there when the poses were found, though it is none of the photographs.
bool may_have_a_pose(const LeftOut& left_out) { return left_out.code != "E-INGEST-OWN"; }

[[noreturn]] void refuse_count(const KnownPoses& known, const std::vector<Photograph>& photographs,
                               const std::vector<std::string>& left_out,
                               const std::filesystem::path& path) {
    std::string what = path.string() + ": " + counted(known.views.size(), "pose") +
                       " without names for " + counted(photographs.size(), "photograph");
    if (!left_out.empty()) {
        what += " and " + counted(left_out.size(), "picture") + " that were left out, such as " +
                left_out.front();
    }
    throw Error(ErrorKind::kBadInput, "E-IMPORT-COUNT", what,
                "give exactly the photographs that the poses were found with: this format "
                "pairs them by order");
}

/// Poses of all pictures in the order of their names. Those that were left out had theirs, too.
PhotographOfView match_in_order(const KnownPoses& known, const std::vector<Photograph>& photographs,
                                const std::vector<LeftOut>& left_out,
                                const std::filesystem::path& path) {
    std::vector<std::string> names_left_out;
    std::map<std::string, std::optional<std::size_t>> pictures;
    for (const LeftOut& picture : left_out) {
        if (!may_have_a_pose(picture)) continue;
        names_left_out.push_back(picture.name);
        pictures.emplace(picture.name, std::nullopt);
    }
    for (std::size_t i = 0; i < photographs.size(); ++i) pictures[photographs[i].name] = i;
    if (known.views.size() != pictures.size()) {
        refuse_count(known, photographs, names_left_out, path);
    }
    PhotographOfView matches;
    for (const auto& [name, photograph] : pictures) matches.push_back(photograph);
    return matches;
}

PhotographOfView match_photographs(const KnownPoses& known,
                                   const std::vector<Photograph>& photographs,
                                   const std::vector<LeftOut>& left_out,
                                   const std::filesystem::path& path) {
    if (!known.has_names) return match_in_order(known, photographs, left_out, path);
    std::vector<std::string> wanted;
    std::vector<std::string> available;
    for (const View& view : known.views) wanted.push_back(view.name);
    for (const Photograph& photograph : photographs) available.push_back(photograph.name);
    PhotographOfView matches = matched_names(wanted, available);
    for (const auto& match : matches) {
        if (match) return matches;
    }
    const auto example = [](const std::vector<std::string>& names) {
        return names.empty() ? std::string("nothing") : "'" + printable(names.front()) + "'";
    };
    throw Error(ErrorKind::kBadInput, "E-IMPORT-NAMES",
                path.string() + ": it names none of the photographs; it has " + example(wanted) +
                    ", the folder has " + example(available),
                "name the photographs as they were named when the poses were found");
}

/// Builds the capture of the photographs that have a pose, in the pixels of their working copies.
class CaptureImport {
 public:
    CaptureImport(const KnownPoses& known, const std::vector<Photograph>& photographs,
                  const PhotographOfView& photograph_of_view)
        : known_(known), photographs_(photographs), photograph_of_view_(photograph_of_view) {
        add_views();
        add_points();
    }
    Capture take() { return std::move(capture_); }

 private:
    void add_views() {
        std::vector<std::optional<std::size_t>> view_of_photograph(photographs_.size());
        for (std::size_t i = 0; i < photograph_of_view_.size(); ++i) {
            if (photograph_of_view_[i]) view_of_photograph[*photograph_of_view_[i]] = i;
        }
        new_index_.resize(known_.views.size());
        for (std::size_t i = 0; i < photographs_.size(); ++i) {
            if (!view_of_photograph[i]) continue;
            const View& view = known_.views[*view_of_photograph[i]];
            new_index_[*view_of_photograph[i]] = static_cast<int>(capture_.views.size());
            capture_.views.push_back(
                {photographs_[i].name, camera_index(view, photographs_[i]), view.cam_from_world});
        }
    }

    int camera_index(const View& view, const Photograph& photograph) {
        const std::tuple key{view.camera_index, photograph.original_width_px,
                             photograph.original_height_px, photograph.width_px,
                             photograph.height_px};
        const auto [entry, is_new] =
            camera_indices_.emplace(key, static_cast<int>(capture_.cameras.size()));
        if (is_new) capture_.cameras.push_back(lens_for_working_copy(lens_of(view), photograph));
        return entry->second;
    }

    void add_points() {
        for (const ScenePoint& known_point : known_.points) {
            ScenePoint point = known_point;
            point.track.clear();
            for (const Observation& observation : known_point.track) {
                const auto view = static_cast<std::size_t>(observation.view_index);
                if (!new_index_[view]) continue;
                point.track.push_back(
                    {*new_index_[view], pixel_in_working_copy(known_.views[view], observation)});
            }
            const bool lost_its_track = point.track.empty() && !known_point.track.empty();
            if (!lost_its_track) capture_.points.push_back(std::move(point));
        }
    }

    [[nodiscard]] Eigen::Vector2d pixel_in_working_copy(const View& known_view,
                                                        const Observation& observation) const {
        const Camera& stated = lens_of(known_view).camera;
        const View& view = capture_.views[static_cast<std::size_t>(
            *new_index_[static_cast<std::size_t>(observation.view_index)])];
        const Camera& camera = camera_of(capture_, view);
        return observation.pixel.cwiseProduct(
            Eigen::Vector2d(static_cast<double>(camera.width_px) / stated.width_px,
                            static_cast<double>(camera.height_px) / stated.height_px));
    }

    [[nodiscard]] const KnownLens& lens_of(const View& view) const {
        return known_.lenses[static_cast<std::size_t>(view.camera_index)];
    }

    const KnownPoses& known_;
    const std::vector<Photograph>& photographs_;
    const PhotographOfView& photograph_of_view_;
    std::vector<std::optional<int>> new_index_;
    std::map<std::tuple<int, int, int, int, int>, int> camera_indices_;
    Capture capture_;
};

std::vector<LeftOut> unmatched(const KnownPoses& known, const std::vector<Photograph>& photographs,
                               const PhotographOfView& photograph_of_view) {
    std::vector<LeftOut> left_out;
    std::vector<bool> has_pose(photographs.size(), false);
    for (std::size_t i = 0; i < photograph_of_view.size(); ++i) {
        if (photograph_of_view[i]) {
            has_pose[*photograph_of_view[i]] = true;
        } else {
            left_out.push_back({printable(known.views[i].name), "E-IMPORT-NOPHOTO",
                                "it has a pose, but no photograph of that name was taken in"});
        }
    }
    for (std::size_t i = 0; i < photographs.size(); ++i) {
        if (has_pose[i]) continue;
        left_out.push_back(
            {photographs[i].name, "E-IMPORT-NOPOSE", "the imported poses do not name it"});
    }
    return left_out;
}

/// Over all observations of points in front of their camera; 0 without any.
double mean_reprojection_error_px(const Capture& capture) {
    double sum_px = 0;
    std::size_t count = 0;
    for (const ScenePoint& point : capture.points) {
        for (const Observation& observation : point.track) {
            const View& view = capture.views[static_cast<std::size_t>(observation.view_index)];
            const auto pixel =
                project(camera_of(capture, view), view.cam_from_world * point.position_in_world);
            if (!pixel) continue;
            sum_px += (*pixel - observation.pixel).norm();
            ++count;
        }
    }
    return count > 0 ? sum_px / static_cast<double>(count) : 0.0;
}

}  // namespace

PoseResult import_poses(const std::vector<Photograph>& photographs,
                        const std::vector<LeftOut>& left_out, const std::filesystem::path& poses) {
    const KnownPoses known = read_known_poses(poses);
    const PhotographOfView photograph_of_view =
        match_photographs(known, photographs, left_out, poses);
    refuse_other_pictures(known, photographs, photograph_of_view, poses);
    PoseResult result;
    result.capture = CaptureImport(known, photographs, photograph_of_view).take();
    validate(result.capture, poses.string());
    result.not_registered = unmatched(known, photographs, photograph_of_view);

    PoseEvidence& evidence = result.evidence;
    evidence.photographs_total = static_cast<int>(photographs.size());
    evidence.photographs_registered = static_cast<int>(result.capture.views.size());
    evidence.points = static_cast<int>(result.capture.points.size());
    for (const ScenePoint& point : result.capture.points) {
        evidence.observations += static_cast<int>(point.track.size());
    }
    evidence.mean_reprojection_error_px = mean_reprojection_error_px(result.capture);
    evidence.median_triangulation_angle_deg = median_triangulation_angle_deg(result.capture);
    evidence.models_found = 1;
    evidence.start = "imported " + known.format;
    return result;
}

}  // namespace lumi
